// SPDX-License-Identifier: GPL-3.0-or-later

// Gmsh's MSH files, versions 2.2 and 4.1, as text.
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

using Words = std::vector<std::string_view>;

/// Elements of Gmsh by their number: how many nodes they have, and whether they are faces of a surface.
struct ElementType {
  long long number;
  std::size_t nodes;
  bool face;
};
constexpr std::array<ElementType, 9> element_types{{{15, 1, false},
                                                    {1, 2, false},
                                                    {8, 3, false},
                                                    {2, 3, true},
                                                    {3, 4, true},
                                                    {4, 4, false},
                                                    {5, 8, false},
                                                    {6, 6, false},
                                                    {7, 5, false}}};

class GmshReader {
public:
  explicit GmshReader(std::string_view bytes) : lines_(bytes, '\0') {}

  MeshFile read() {
    if (next("$MeshFormat").front() != "$MeshFormat")
      refuse_mesh(lines_.place(), std::string(lines_.line().substr(0, 40)), "begins no MSH file",
                  "$MeshFormat");
    const Words format = next("the version, 0 for text, and the size of a double");
    const std::string version(format[0]);
    if (version != "2.2" && version != "4.1")
      refuse_mesh(lines_.place(), version, "is no version that is read", "2.2 and 4.1");
    if (format.size() < 2 || format[1] != "0")
      refuse_mesh(lines_.place(), std::nullopt, "announces a binary file, which is not read",
                  "text, which Gmsh writes with Mesh.Binary = 0");
    version_4_ = version == "4.1";
    end("$EndMeshFormat");
    bool has_nodes = false;
    bool has_elements = false;
    while (const auto words = lines_.next()) {
      const std::string section(words->front());
      if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities" && version_4_) {
        read_entities();
      } else if (section == "$Nodes") {
        has_nodes = true;
        version_4_ ? read_node_blocks() : read_nodes();
      } else if (section == "$Elements") {
        if (!has_nodes)
          refuse_mesh(lines_.place(), section, "comes before the nodes", "$Nodes, then $Elements");
        has_elements = true;
        version_4_ ? read_element_blocks() : read_elements();
      } else if (section.starts_with('$')) {
        skip("$End" + section.substr(1));
      } else {
        refuse_mesh(lines_.place(), section, "stands between two sections", "$Nodes, $Elements, ...");
      }
    }
    if (!has_elements) refuse_mesh(lines_.place(), std::nullopt, "is the last line", "a section $Elements");
    return mesh_.finish("MSH " + version, std::nullopt);
  }

private:
  Words next(const std::string& allowed) {
    if (auto words = lines_.next()) return *words;
    refuse_mesh(lines_.place(), std::nullopt, "is the last line: the file ends too early", allowed);
  }
  void end(const std::string& word) {
    if (next(word).front() != word)
      refuse_mesh(lines_.place(), std::string(lines_.line().substr(0, 40)), "stands where a section ends",
                  word);
  }
  void skip(const std::string& word) {
    while (next(word).front() != word) {
    }
  }
  long long number(const Words& words, std::size_t at, const std::string& allowed) {
    if (at >= words.size()) refuse_mesh(lines_.place(), std::nullopt, "has too few numbers", allowed);
    return whole_number(words[at], lines_.place(), allowed);
  }
  long long count(const Words& words, std::size_t at, const std::string& allowed) {
    const long long found = number(words, at, allowed);
    if (found < 0) refuse_mesh(lines_.place(), std::to_string(found), "is negative", allowed);
    return found;
  }

  void read_names() {
    const long long names = count(next("the number of names"), 0, "the number of names");
    for (long long k = 0; k < names; ++k) {
      const std::string allowed = "dimension, number and \"name\"";
      const Words words = next(allowed);
      const long long dimension = number(words, 0, allowed);
      const long long tag = number(words, 1, allowed);
      const std::string_view line = lines_.line();
      const std::size_t first = line.find('"');
      const std::size_t last = line.rfind('"');
      if (first == std::string_view::npos || first == last)
        refuse_mesh(lines_.place(), std::string(line), "has no name", allowed);
      if (dimension == 2) names_[tag] = std::string(line.substr(first + 1, last - first - 1));
    }
    end("$EndPhysicalNames");
  }

  void read_entities() {
    const std::string allowed = "the numbers of points, curves, surfaces and volumes";
    const Words counts = next(allowed);
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      for (long long k = count(counts, dimension, allowed); k > 0; --k) {
        const Words words = next("an entity a line");
        if (dimension != 2) continue;
        const std::string of_surface = "a tag, a box of 6 numbers, the number of groups and their tags";
        const long long groups = count(words, 7, of_surface);
        if (groups > 1)
          refuse_mesh(lines_.place(), std::to_string(groups), "are the groups of a surface",
                      "one physical group at most");
        if (groups == 1) group_of_entity_[number(words, 0, of_surface)] = number(words, 8, of_surface);
      }
    end("$EndEntities");
  }

  void node(long long tag, const Words& words, std::size_t first) {
    if (words.size() < first + 3)
      refuse_mesh(lines_.place(), std::nullopt, "has fewer than three coordinates", "x y z");
    const Vector<double> at{mesh_.coordinate(words[first], lines_.place()),
                            mesh_.coordinate(words[first + 1], lines_.place()),
                            mesh_.coordinate(words[first + 2], lines_.place())};
    if (!nodes_.emplace(tag, Node{at, unused}).second)
      refuse_mesh(lines_.place(), std::to_string(tag), "is the number of two nodes", "different numbers");
  }
  void read_nodes() {
    const std::string allowed = "the number of nodes, then number x y z a line";
    for (long long k = count(next(allowed), 0, allowed); k > 0; --k) {
      const Words words = next(allowed);
      node(number(words, 0, allowed), words, 1);
    }
    end("$EndNodes");
  }
  void read_node_blocks() {
    const std::string allowed = "the number of blocks, then blocks of tags and x y z a line";
    for (long long block = count(next(allowed), 0, allowed); block > 0; --block) {
      const long long nodes = count(next(allowed), 3, allowed);
      std::vector<long long> tags;
      for (long long k = 0; k < nodes; ++k) tags.push_back(number(next(allowed), 0, allowed));
      for (const long long tag : tags) node(tag, next(allowed), 0);
    }
    end("$EndNodes");
  }

  void element(long long type, long long group, const Words& words, std::size_t first) {
    for (const ElementType& known : element_types)
      if (known.number == type) {
        if (words.size() != first + known.nodes)
          refuse_mesh(lines_.place(), std::to_string(words.size() - std::min(first, words.size())),
                      "is not the number of its nodes", std::to_string(known.nodes));
        if (known.face) face(group, words, first);
        return;
      }
    refuse_mesh(
        lines_.place(), std::to_string(type), "is the type of an element that is not read",
        "triangles (2) and quadrangles (3) of first order; points, lines and volumes are passed over");
  }
  void face(long long group, const Words& words, std::size_t first) {
    if (group < 0)
      refuse_mesh(lines_.place(), std::to_string(group), "is a group with its orientation reversed",
                  "positive physical tags");
    const auto named = names_.find(group);
    mesh_.group(named != names_.end() ? named->second
                : group == 0          ? ""
                                      : "physical_" + std::to_string(group));
    for (std::size_t k = first; k < words.size(); ++k) {
      const long long tag = number(words, k, "numbers of nodes");
      const auto found = nodes_.find(tag);
      if (found == nodes_.end())
        refuse_mesh(lines_.place(), std::to_string(tag), "is the number of a node that is not there",
                    "numbers of $Nodes");
      if (found->second.vertex == unused) {
        found->second.vertex = mesh_.vertex_count();
        mesh_.vertex(found->second.at);
      }
      mesh_.corner(found->second.vertex);
    }
    mesh_.end_face(lines_.place());
  }
  void read_elements() {
    const std::string allowed = "number, type, number of tags, tags, nodes";
    for (long long k = count(next(allowed), 0, allowed); k > 0; --k) {
      const Words words = next(allowed);
      const long long tags = count(words, 2, allowed);
      const long long group = tags > 0 ? number(words, 3, allowed) : 0;
      element(number(words, 1, allowed), group, words, 3 + static_cast<std::size_t>(tags));
    }
    end("$EndElements");
  }
  void read_element_blocks() {
    const std::string allowed = "the number of blocks; dimension, tag, type and number of elements; elements";
    for (long long block = count(next(allowed), 0, allowed); block > 0; --block) {
      const Words head = next(allowed);
      const long long type = number(head, 2, allowed);
      const auto found = group_of_entity_.find(number(head, 1, allowed));
      const bool surface = number(head, 0, allowed) == 2;
      const long long group = surface && found != group_of_entity_.end() ? found->second : 0;
      for (long long k = count(head, 3, allowed); k > 0; --k) element(type, group, next(allowed), 1);
    }
    end("$EndElements");
  }

  static constexpr std::size_t unused = static_cast<std::size_t>(-1);
  struct Node {
    Vector<double> at;
    std::size_t vertex;
  };
  TextLines lines_;
  MeshBuilder mesh_;
  bool version_4_ = false;
  std::map<long long, std::string> names_;
  std::map<long long, long long> group_of_entity_;
  std::map<long long, Node> nodes_;
};

}  // namespace

MeshFile parse_msh(std::string_view bytes) { return GmshReader(bytes).read(); }

}  // namespace radcert
