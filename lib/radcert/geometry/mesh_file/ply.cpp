// SPDX-License-Identifier: GPL-3.0-or-later

// PLY, ASCII and binary.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

struct NumberType {
  std::array<std::string_view, 2> names;
  std::size_t bytes;
  bool is_signed;
  bool floating;
};

constexpr std::array<NumberType, 8> number_types{{{{"char", "int8"}, 1, true, false},
                                                  {{"uchar", "uint8"}, 1, false, false},
                                                  {{"short", "int16"}, 2, true, false},
                                                  {{"ushort", "uint16"}, 2, false, false},
                                                  {{"int", "int32"}, 4, true, false},
                                                  {{"uint", "uint32"}, 4, false, false},
                                                  {{"float", "float32"}, 4, true, true},
                                                  {{"double", "float64"}, 8, true, true}}};

struct Property {
  std::string name;
  NumberType type;
  std::optional<NumberType> length;  ///< of a list: the type of its length
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

NumberType type_of(std::string_view name, const std::string& place) {
  for (const NumberType& type : number_types)
    if (type.names[0] == name || type.names[1] == name) return type;
  refuse_mesh(place, std::string(name), "is no type of a PLY file",
              "char, uchar, short, ushort, int, uint, float, double");
}

Header read_header(TextLines& lines) {
  const std::string allowed = "a header: ply, format, element, property, end_header";
  Header header;
  bool formatted = false;
  for (bool first = true;; first = false) {
    const auto words = lines.next();
    if (!words) refuse_mesh(lines.place(), std::nullopt, "is the end, within the header", allowed);
    const std::string place = lines.place();
    const std::string_view key = words->front();
    const auto refuse_line = [&] {
      refuse_mesh(place, std::string(lines.line()), "is no line of the header of a PLY file", allowed);
    };
    if (first) {
      if (key != "ply") refuse_line();
    } else if (key == "format" && words->size() == 3) {
      const std::string_view name = (*words)[1];
      if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian") refuse_line();
      header.encoding = name == "ascii"                  ? Encoding::ascii
                        : name == "binary_little_endian" ? Encoding::little_endian
                                                         : Encoding::big_endian;
      formatted = true;
    } else if (key == "element" && words->size() == 3) {
      const long long count = whole_number((*words)[2], place, "a number of elements");
      if (count < 0) refuse_line();
      header.elements.push_back({std::string((*words)[1]), static_cast<std::size_t>(count), {}});
    } else if (key == "property" && !header.elements.empty() && words->size() == 3) {
      header.elements.back().properties.push_back(
          {std::string((*words)[2]), type_of((*words)[1], place), std::nullopt});
    } else if (key == "property" && !header.elements.empty() && words->size() == 5 && (*words)[1] == "list") {
      header.elements.back().properties.push_back(
          {std::string((*words)[4]), type_of((*words)[3], place), type_of((*words)[2], place)});
    } else if (key == "end_header") {
      if (!formatted) refuse_line();
      return header;
    } else if (key != "comment" && key != "obj_info") {
      refuse_line();
    }
  }
}

/// The numbers of the body one after the other, in whichever encoding.
class Body {
public:
  Body(Encoding encoding, TextLines& lines, std::size_t file_size)
      : encoding_(encoding), lines_(&lines), bytes_(lines.rest()), file_size_(file_size) {}

  void begin_element() {
    if (encoding_ != Encoding::ascii) return;
    end_element();
    const auto words = lines_->next();
    if (!words)
      refuse_mesh(lines_->place(), std::nullopt, "is the last line: the file ends too early",
                  "as many elements as the header announces");
    words_ = *words;
    word_ = 0;
  }

  /// Refuses what follows the last property on a line.
  void end_element() const {
    if (word_ == words_.size()) return;
    refuse_mesh(place(), std::string(words_[word_]), "follows the last property of the element",
                "one line an element, all its properties and nothing else");
  }

  [[nodiscard]] std::string place() const {
    return encoding_ == Encoding::ascii ? lines_->place()
                                        : "byte " + std::to_string(file_size_ - bytes_.size());
  }

  double coordinate(const NumberType& type, MeshBuilder& mesh) {
    if (encoding_ == Encoding::ascii) return mesh.coordinate(word(), place());
    const std::string at = place();
    return mesh.coordinate(number(type), at);
  }

  /// An index or a length.
  std::size_t whole(const NumberType& type) {
    const std::string allowed = "a whole number >= 0";
    const std::string at = place();
    if (encoding_ == Encoding::ascii) {
      const std::string_view text = word();
      const long long value = whole_number(text, at, allowed);
      if (value < 0) refuse_mesh(at, std::string(text), "is negative", allowed);
      return static_cast<std::size_t>(value);
    }
    if (type.floating) refuse_mesh(at, std::nullopt, "is an index given as a floating-point number", allowed);
    const double value = number(type);
    if (value < 0) refuse_mesh(at, std::to_string(static_cast<long long>(value)), "is negative", allowed);
    return static_cast<std::size_t>(value);
  }

  void skip(const NumberType& type) {
    if (encoding_ == Encoding::ascii)
      require_number(word(), place());
    else
      take(type.bytes);
  }

  /// Whether anything but blanks is left.
  bool at_end() {
    end_element();
    if (encoding_ == Encoding::ascii) return !lines_->next();
    return bytes_.empty();
  }

private:
  std::string_view word() {
    if (word_ == words_.size())
      refuse_mesh(place(), std::nullopt, "has too few numbers", "one line an element, all its properties");
    return words_[word_++];
  }

  std::string_view take(std::size_t count) {
    if (bytes_.size() < count)
      refuse_mesh("byte " + std::to_string(file_size_), std::nullopt, "is the end of a file that is cut off",
                  "as many elements as the header announces");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_ = bytes_.substr(count);
    return taken;
  }

  double number(const NumberType& type) {
    const std::string_view raw = take(type.bytes);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t from = encoding_ == Encoding::big_endian ? i : type.bytes - 1 - i;
      bits = bits << 8U | static_cast<unsigned char>(raw[from]);
    }
    if (type.floating)
      return type.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                             : std::bit_cast<double>(bits);
    const std::uint64_t half = std::uint64_t{1} << (8 * type.bytes - 1);
    if (type.is_signed && bits >= half) return static_cast<double>(bits) - 2 * static_cast<double>(half);
    return static_cast<double>(bits);
  }

  Encoding encoding_;
  TextLines* lines_;
  std::string_view bytes_;
  std::size_t file_size_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

void read_vertex(Body& body, const Element& element, MeshBuilder& mesh) {
  Vector<double> at;
  for (const Property& property : element.properties) {
    if (property.length) {
      const std::size_t length = body.whole(*property.length);
      for (std::size_t i = 0; i < length; ++i) body.skip(property.type);
    } else if (property.name == "x") {
      at.x = body.coordinate(property.type, mesh);
    } else if (property.name == "y") {
      at.y = body.coordinate(property.type, mesh);
    } else if (property.name == "z") {
      at.z = body.coordinate(property.type, mesh);
    } else {
      body.skip(property.type);
    }
  }
  mesh.vertex(at);
}

bool is_corner_list(const Property& property) {
  return property.length && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_face(Body& body, const Element& element, MeshBuilder& mesh) {
  const std::string place = body.place();
  for (const Property& property : element.properties) {
    const std::size_t length = property.length ? body.whole(*property.length) : 1;
    for (std::size_t i = 0; i < length; ++i) {
      if (is_corner_list(property))
        mesh.corner(body.whole(property.type));
      else
        body.skip(property.type);
    }
  }
  mesh.end_face(place);
}

/// The bits of the mantissa of the coordinates, where all three are there.
int coordinate_bits(const Header& header) {
  for (const Element& element : header.elements) {
    if (element.name != "vertex") continue;
    int found = 0;
    int bits = 53;
    for (const Property& property : element.properties)
      if (!property.length && (property.name == "x" || property.name == "y" || property.name == "z")) {
        ++found;
        if (property.type.floating && property.type.bytes == 4) bits = 24;
      }
    if (found == 3) return bits;
  }
  refuse_mesh("", std::nullopt, "has no element vertex with the properties x, y and z", "a mesh with faces");
}

}  // namespace

MeshFile parse_ply(std::string_view bytes) {
  TextLines lines(bytes, '\0');
  const Header header = read_header(lines);
  const int bits = coordinate_bits(header);
  MeshBuilder mesh;
  Body body(header.encoding, lines, bytes.size());
  for (const Element& element : header.elements)
    for (std::size_t k = 0; k < element.count; ++k) {
      if (element.properties.empty()) break;
      body.begin_element();
      if (element.name == "vertex") {
        read_vertex(body, element, mesh);
      } else if (element.name == "face") {
        read_face(body, element, mesh);
      } else {
        for (const Property& property : element.properties) {
          const std::size_t length = property.length ? body.whole(*property.length) : 1;
          for (std::size_t i = 0; i < length; ++i) body.skip(property.type);
        }
      }
    }
  if (!body.at_end())
    refuse_mesh(body.place(), std::nullopt, "is beyond the last element",
                "as many elements as the header announces");
  if (header.encoding == Encoding::ascii) return mesh.finish("PLY, ASCII", std::nullopt);
  return mesh.finish("PLY, binary", bits);
}

}  // namespace radcert
