// SPDX-License-Identifier: GPL-3.0-or-later

// glTF 2.0 of Khronos, with its buffers inside: .glb, or .gltf with data in base64.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/base64.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

using Json = nlohmann::json;

/// A map of space, x -> columns[0] x + columns[1] y + columns[2] z + columns[3].
struct Placement {
  std::array<Vector<double>, 4> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  [[nodiscard]] Vector<double> linear(const Vector<double>& v) const {
    return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
  }
  [[nodiscard]] Vector<double> operator()(const Vector<double>& v) const { return linear(v) + columns[3]; }
  [[nodiscard]] Placement after(const Placement& inner) const {
    return {{linear(inner.columns[0]), linear(inner.columns[1]), linear(inner.columns[2]),
             (*this)(inner.columns[3])}};
  }
  [[nodiscard]] bool mirrors() const { return dot(cross(columns[0], columns[1]), columns[2]) < 0; }
};

constexpr std::uint32_t magic = 0x46546C67;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;

template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// What a chunk of a .glb has; the place of the next one is put into `at`.
struct Chunk {
  std::uint32_t type = 0;
  std::string_view content;
};

Chunk chunk_at(std::string_view bytes, std::size_t& at) {
  constexpr std::size_t head = 8;
  const std::string place = "byte " + std::to_string(at);
  if (bytes.size() - at < head)
    refuse_mesh(place, std::nullopt, "is the end, within the head of a chunk", "chunks of GLB");
  const auto length = little_endian<std::uint32_t>(bytes, at);
  const Chunk chunk{.type = little_endian<std::uint32_t>(bytes, at + 4),
                    .content = bytes.substr(at + head, length)};
  if (chunk.content.size() < length)
    refuse_mesh(place, std::to_string(length), "is more than is left of the file", "chunks of GLB");
  at += head + length;
  return chunk;
}

class GltfReader {
public:
  explicit GltfReader(std::string_view bytes) {
    constexpr std::size_t head = 12;
    std::string_view json = bytes;
    binary_ = bytes.size() >= 4 && little_endian<std::uint32_t>(bytes, 0) == magic;
    if (binary_) {
      if (bytes.size() < head || little_endian<std::uint32_t>(bytes, 4) != 2)
        refuse_mesh("byte 4", std::nullopt, "is no version of glTF that is read", "version 2");
      std::size_t at = head;
      const Chunk first = chunk_at(bytes, at);
      if (first.type != json_chunk)
        refuse_mesh("byte 12", std::nullopt, "begins no JSON chunk", "a chunk JSON");
      json = first.content;
      if (at < bytes.size())
        if (const Chunk second = chunk_at(bytes, at); second.type == binary_chunk) chunk_ = second.content;
    }
    document_ = Json::parse(json, nullptr, false);
    if (!document_.is_object())
      refuse_mesh(binary_ ? "byte 20" : "byte 0", std::nullopt, "begins no JSON object", "glTF 2.0");
  }

  MeshFile read() {
    check_head();
    for (const std::size_t root : roots()) node(root, {}, 0);
    mesh_.join_vertices();
    return mesh_.finish(binary_ ? "glTF, binary" : "glTF", 24);
  }

private:
  [[noreturn]] static void refuse(const std::string& pointer, const std::string& problem,
                                  const std::string& allowed) {
    throw InputError({.pointer = pointer, .problem = problem, .allowed = allowed});
  }

  /// The member of an object, or null.
  static const Json& member(const Json& object, const char* key) {
    static const Json none;
    if (!object.is_object()) return none;
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
  }

  static std::uint64_t number(const Json& value, const std::string& pointer,
                              std::optional<std::uint64_t> absent = std::nullopt) {
    if (value.is_null() && absent) return *absent;
    if (!value.is_number_unsigned())
      refuse(pointer, "is no whole number", "a whole number that is not negative");
    return value.get<std::uint64_t>();
  }

  /// An element of a list of the document by its number.
  const Json& element(const char* list, std::uint64_t place, const std::string& from) const {
    const Json& all = member(document_, list);
    if (!all.is_array() || place >= all.size())
      refuse(from, "names " + std::string(list) + "/" + std::to_string(place) + ", which is not there",
             "numbers of elements of " + std::string(list));
    return all[place];
  }

  void check_head() const {
    const Json& version = member(member(document_, "asset"), "version");
    if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2."))
      refuse("/asset/version", "is no version that is read", "\"2.0\"");
    const Json& required = member(document_, "extensionsRequired");
    if (required.is_array())
      for (const Json& extension : required) {
        const std::string name = extension.is_string() ? extension.get<std::string>() : std::string();
        // These are about materials alone.
        if (name.starts_with("KHR_materials_") || name == "KHR_texture_transform" ||
            name == "KHR_texture_basisu")
          continue;
        refuse("/extensionsRequired", "asks for " + name + ", which is not read",
               "files without it: uncompressed triangles of floats");
      }
  }

  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> out;
    const Json& scenes = member(document_, "scenes");
    if (scenes.is_array() && !scenes.empty()) {
      const Json& scene = element("scenes", number(member(document_, "scene"), "/scene", 0), "/scene");
      const Json& nodes = member(scene, "nodes");
      if (nodes.is_array())
        for (const Json& each : nodes) out.push_back(number(each, "/scenes"));
      return out;
    }
    // Without a scene: the nodes that are no children.
    const Json& nodes = member(document_, "nodes");
    std::vector<bool> is_child(nodes.is_array() ? nodes.size() : 0, false);
    for (std::size_t k = 0; k < is_child.size(); ++k) {
      const Json& children = member(nodes[k], "children");
      if (!children.is_array()) continue;
      for (const Json& child : children)
        if (const std::uint64_t place = number(child, "/nodes"); place < is_child.size())
          is_child[place] = true;
    }
    for (std::size_t k = 0; k < is_child.size(); ++k)
      if (!is_child[k]) out.push_back(k);
    return out;
  }

  static std::vector<double> numbers(const Json& list, std::size_t count, const std::string& pointer) {
    std::vector<double> out;
    if (list.is_array())
      for (const Json& each : list)
        if (each.is_number()) out.push_back(each.get<double>());
    if (out.size() != count)
      refuse(pointer, "has not " + std::to_string(count) + " numbers", "a list of numbers");
    return out;
  }

  static Placement placement(const Json& node, const std::string& pointer) {
    Placement out;
    if (const Json& matrix = member(node, "matrix"); !matrix.is_null()) {
      for (const char* key : {"translation", "rotation", "scale"})
        if (!member(node, key).is_null())
          refuse(pointer + "/" + key, "stands beside a matrix",
                 "a matrix, or translation, rotation and scale");
      const std::vector<double> m = numbers(matrix, 16, pointer + "/matrix");
      if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
        refuse(pointer + "/matrix", "is not affine", "a last row of 0, 0, 0, 1");
      for (std::size_t k = 0; k < 4; ++k) out.columns[k] = {m[4 * k], m[4 * k + 1], m[4 * k + 2]};
      return out;
    }
    const auto part = [&](const char* key, std::vector<double> absent) {
      const Json& given = member(node, key);
      return given.is_null() ? absent : numbers(given, absent.size(), pointer + "/" + key);
    };
    const std::vector<double> t = part("translation", {0, 0, 0});
    const std::vector<double> q = part("rotation", {0, 0, 0, 1});
    const std::vector<double> s = part("scale", {1, 1, 1});
    const auto [x, y, z, w] = std::array{q[0], q[1], q[2], q[3]};
    const double size = x * x + y * y + z * z + w * w;
    constexpr double rounded = 1e-4;
    if (!(std::abs(size - 1) < rounded)) refuse(pointer + "/rotation", "is no unit quaternion", "x, y, z, w");
    // The quaternion is divided by its length: single precision leaves 1e-7 of it.
    const double f = 2 / size;
    out.columns[0] = s[0] * Vector<double>{1 - f * (y * y + z * z), f * (x * y + w * z), f * (x * z - w * y)};
    out.columns[1] = s[1] * Vector<double>{f * (x * y - w * z), 1 - f * (x * x + z * z), f * (y * z + w * x)};
    out.columns[2] = s[2] * Vector<double>{f * (x * z + w * y), f * (y * z - w * x), 1 - f * (x * x + y * y)};
    out.columns[3] = {t[0], t[1], t[2]};
    return out;
  }

  void node(std::size_t place, const Placement& around, std::size_t depth) {
    constexpr std::size_t deepest = 200;
    const std::string pointer = "/nodes/" + std::to_string(place);
    const Json& here = element("nodes", place, "/nodes");
    if (depth > deepest) refuse(pointer, "is deeper than 200 nodes", "a tree of nodes");
    if (seen_.size() <= place) seen_.resize(place + 1, false);
    if (seen_[place]) refuse(pointer, "has two parents", "a tree of nodes");
    seen_[place] = true;
    const Placement whole = around.after(placement(here, pointer));
    if (const Json& mesh = member(here, "mesh"); !mesh.is_null()) {
      if (!member(here, "skin").is_null()) refuse(pointer + "/skin", "is not read", "meshes without a skin");
      primitives(number(mesh, pointer + "/mesh"), name_of(here), whole, pointer);
    }
    const Json& children = member(here, "children");
    if (children.is_array())
      for (const Json& child : children) node(number(child, pointer + "/children"), whole, depth + 1);
  }

  static std::string name_of(const Json& object) {
    const Json& name = member(object, "name");
    return name.is_string() ? name.get<std::string>() : std::string();
  }

  void primitives(std::uint64_t place, const std::string& node_name, const Placement& whole,
                  const std::string& from) {
    const Json& mesh = element("meshes", place, from + "/mesh");
    const std::string pointer = "/meshes/" + std::to_string(place) + "/primitives";
    const Json& list = member(mesh, "primitives");
    if (!list.is_array()) refuse(pointer, "is no list", "primitives");
    std::string group = !node_name.empty() ? node_name : name_of(mesh);
    if (group.empty()) group = "mesh " + std::to_string(place);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Json& material = member(list[k], "material");
      std::string name = group;
      if (!material.is_null()) {
        const std::string words = name_of(element("materials", number(material, pointer), pointer));
        if (!words.empty()) name += "/" + words;
      }
      mesh_.group(name);
      primitive(list[k], whole, pointer + "/" + std::to_string(k));
    }
  }

  void primitive(const Json& primitive, const Placement& whole, const std::string& pointer) {
    constexpr std::uint64_t triangles = 4;
    constexpr std::uint64_t strip = 5;
    constexpr std::uint64_t fan = 6;
    const std::uint64_t mode = number(member(primitive, "mode"), pointer + "/mode", triangles);
    if (mode < triangles) return;  // points and lines
    if (mode > fan) refuse(pointer + "/mode", "is no kind of a primitive", "numbers from 0 to 6");
    if (!member(primitive, "targets").is_null())
      refuse(pointer + "/targets", "are shapes that change, which are not read",
             "primitives without targets");
    const Json& extensions = member(primitive, "extensions");
    for (const char* packed : {"KHR_draco_mesh_compression"})
      if (!member(extensions, packed).is_null())
        refuse(pointer + "/extensions", "has " + std::string(packed) + ", which is not read",
               "uncompressed triangles");
    const std::size_t first = mesh_.vertex_count();
    const std::uint64_t points =
        positions(member(member(primitive, "attributes"), "POSITION"), whole, pointer);
    const std::vector<std::uint64_t> corner = indices(member(primitive, "indices"), points, pointer);
    const std::size_t step = mode == triangles ? 3 : 1;
    for (std::size_t k = 0; k + 3 <= corner.size(); k += step) {
      std::array<std::uint64_t, 3> face{corner[k], corner[k + 1], corner[k + 2]};
      if (mode == strip && k % 2 == 1) std::swap(face[0], face[1]);
      if (mode == fan) face[0] = corner[0];
      if (whole.mirrors()) std::swap(face[1], face[2]);
      for (const std::uint64_t each : face) {
        if (each >= points)
          refuse(pointer + "/indices", "names the point " + std::to_string(each) + ", which is not there",
                 "numbers below " + std::to_string(points));
        mesh_.corner(first + each);
      }
      constexpr std::size_t most_triangles = std::size_t{1}
                                             << 26U;  // which nodes that share meshes may exceed
      if (mesh_.face_count() >= most_triangles)
        refuse(pointer, "makes more than " + std::to_string(most_triangles) + " triangles", "smaller scenes");
      mesh_.end_face("triangle " + std::to_string(mesh_.face_count()));
    }
  }

  /// The bytes of an accessor's numbers, and how far apart its elements begin.
  struct Elements {
    std::string_view bytes;
    std::uint64_t count = 0;
    std::uint64_t stride = 0;
  };

  Elements elements(const Json& accessor, std::uint64_t size, const std::string& pointer) {
    if (!member(accessor, "sparse").is_null())
      refuse(pointer, "is sparse, which is not read", "whole accessors");
    Elements out{.bytes = {}, .count = number(member(accessor, "count"), pointer + "/count"), .stride = size};
    const std::uint64_t place = number(member(accessor, "bufferView"), pointer + "/bufferView");
    const Json& view = element("bufferViews", place, pointer);
    const std::string at = "/bufferViews/" + std::to_string(place);
    if (!member(member(view, "extensions"), "EXT_meshopt_compression").is_null())
      refuse(at, "has EXT_meshopt_compression, which is not read", "uncompressed buffers");
    const std::string_view buffer = buffer_of(number(member(view, "buffer"), at + "/buffer"));
    const std::uint64_t offset = number(member(view, "byteOffset"), at + "/byteOffset", 0);
    const std::uint64_t length = number(member(view, "byteLength"), at + "/byteLength");
    if (offset > buffer.size() || length > buffer.size() - offset)
      refuse(at, "reaches beyond its buffer", "at most " + std::to_string(buffer.size()) + " bytes");
    const std::uint64_t skip = number(member(accessor, "byteOffset"), pointer + "/byteOffset", 0);
    out.stride = number(member(view, "byteStride"), at + "/byteStride", size);
    const bool fits = out.count > 0 && skip <= length && out.stride >= size && size <= length - skip &&
                      (out.count - 1) <= (length - skip - size) / out.stride;
    if (!fits) refuse(pointer, "reaches beyond its view", "at most " + std::to_string(length) + " bytes");
    out.bytes = buffer.substr(offset + skip, length - skip);
    return out;
  }

  std::uint64_t positions(const Json& reference, const Placement& whole, const std::string& from) {
    if (reference.is_null()) refuse(from, "has no POSITION", "attributes with POSITION");
    const std::uint64_t place = number(reference, from + "/attributes/POSITION");
    const Json& accessor = element("accessors", place, from);
    const std::string pointer = "/accessors/" + std::to_string(place);
    constexpr std::uint64_t single = 5126;
    if (number(member(accessor, "componentType"), pointer + "/componentType") != single ||
        member(accessor, "type") != "VEC3")
      refuse(pointer, "is no place in space in single precision", "VEC3 of 5126, 32-bit floats");
    const Elements found = elements(accessor, 3 * sizeof(float), pointer);
    for (std::uint64_t k = 0; k < found.count; ++k) {
      std::array<double, 3> x{};
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = mesh_.coordinate(
            static_cast<double>(little_endian<float>(found.bytes, k * found.stride + i * sizeof(float))),
            pointer);
      const Vector<double> at = whole({x[0], x[1], x[2]});
      mesh_.vertex({mesh_.coordinate(at.x, pointer), mesh_.coordinate(at.y, pointer),
                    mesh_.coordinate(at.z, pointer)});
    }
    return found.count;
  }

  std::vector<std::uint64_t> indices(const Json& reference, std::uint64_t points, const std::string& from) {
    std::vector<std::uint64_t> out;
    if (reference.is_null()) {
      for (std::uint64_t k = 0; k < points; ++k) out.push_back(k);
      return out;
    }
    const std::uint64_t place = number(reference, from + "/indices");
    const Json& accessor = element("accessors", place, from);
    const std::string pointer = "/accessors/" + std::to_string(place);
    const std::uint64_t type = number(member(accessor, "componentType"), pointer + "/componentType");
    const std::uint64_t size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
    if ((type != 5121 && type != 5123 && type != 5125) || member(accessor, "type") != "SCALAR")
      refuse(pointer, "is no list of indices", "SCALAR of 5121, 5123 or 5125");
    const Elements found = elements(accessor, size, pointer);
    for (std::uint64_t k = 0; k < found.count; ++k) {
      const std::uint64_t at = k * found.stride;
      out.push_back(size == 1   ? little_endian<std::uint8_t>(found.bytes, at)
                    : size == 2 ? little_endian<std::uint16_t>(found.bytes, at)
                                : little_endian<std::uint32_t>(found.bytes, at));
    }
    return out;
  }

  std::string_view buffer_of(std::uint64_t place) {
    if (buffers_.size() <= place) buffers_.resize(place < 1000 ? place + 1 : 0);
    const std::string pointer = "/buffers/" + std::to_string(place);
    const Json& buffer = element("buffers", place, pointer);
    const Json& uri = member(buffer, "uri");
    if (uri.is_null()) {
      if (place != 0 || !chunk_) refuse(pointer, "has no data", "a chunk BIN, or data:...;base64,");
      return *chunk_;
    }
    constexpr std::string_view mark = ";base64,";
    const std::string_view text = uri.is_string() ? std::string_view(uri.get_ref<const std::string&>()) : "";
    const std::size_t at = text.find(mark);
    if (!text.starts_with("data:") || at == std::string_view::npos)
      refuse(pointer + "/uri", "is another file, which is not read",
             "data within the file: .glb, or .gltf with data:...;base64,");
    if (place >= buffers_.size()) refuse(pointer, "is one of more than 1000 buffers", "fewer buffers");
    if (!buffers_[place]) {
      buffers_[place] = from_base64(text.substr(at + mark.size()));
      if (!buffers_[place]) refuse(pointer + "/uri", "is no base64", "data:...;base64,");
    }
    return *buffers_[place];
  }

  Json document_;
  bool binary_ = false;
  std::optional<std::string_view> chunk_;
  std::vector<std::optional<std::string>> buffers_;
  std::vector<bool> seen_;  ///< of each node
  MeshBuilder mesh_;
};

}  // namespace

MeshFile parse_gltf(std::string_view bytes) { return GltfReader(bytes).read(); }

}  // namespace radcert
