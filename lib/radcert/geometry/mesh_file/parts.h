// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "radcert/geometry/mesh_file/mesh_file.h"

namespace radcert {

/// A MeshFile under construction by a reader, checked as it grows.
/// Result    place: "line 12" or "byte 84"; every refusal is an InputError without a source
class MeshBuilder {
public:
  /// A coordinate from text: a decimal number with one sign at most. Refuses everything else, what is not
  /// finite, beyond the largest or lost to underflow, and counts its digits.
  double coordinate(std::string_view text, const std::string& place);
  /// A coordinate from a binary file.
  double coordinate(double value, const std::string& place) const;
  void vertex(const Vector<double>& at) { mesh_.vertices.push_back(at); }
  /// The group of the faces that follow.
  void group(const std::string& name) { group_ = name; }
  void corner(std::size_t vertex) { mesh_.corner.push_back(vertex); }
  /// Ends a face; its corners may name vertices that come later in the file.
  void end_face(const std::string& place);
  /// Joins vertices with equal coordinates.
  void join_vertices();
  /// Checks the whole; `bits` of a float's mantissa, none for text.
  MeshFile finish(const std::string& format, std::optional<int> bits);

  [[nodiscard]] std::size_t vertex_count() const { return mesh_.vertices.size(); }
  [[nodiscard]] std::size_t face_count() const { return mesh_.face_count(); }

private:
  MeshFile mesh_;
  std::size_t most_digits_ = 0;
  std::string group_;
  std::unordered_map<std::string, std::size_t> group_places_;
};

/// A text's words, line by line.
/// Requires  the text outlives the reader
/// Result    lines end at LF or CRLF; words are parted by blanks and tabs; `#` begins a comment where asked
class TextLines {
public:
  explicit TextLines(std::string_view text, char comment) : rest_(text), comment_(comment) {}
  /// The words of the next line that has any; no value at the end.
  std::optional<std::vector<std::string_view>> next();
  [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }
  /// The text after the lines read.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  /// The last line read, as it stands.
  [[nodiscard]] std::string_view line() const { return line_; }

private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
  char comment_;
};

/// A number that is read past, as that of a colour: InputError where it is no decimal number.
void require_number(std::string_view text, const std::string& place);

/// A whole number of a text; InputError with what is allowed otherwise.
long long whole_number(std::string_view text, const std::string& place, const std::string& allowed);

/// A defect of a mesh file.
[[noreturn]] void refuse_mesh(const std::string& place, std::optional<std::string> value,
                              const std::string& problem, const std::string& allowed);

/// The formats.
MeshFile parse_off(std::string_view bytes);
MeshFile parse_obj(std::string_view bytes);
MeshFile parse_ply(std::string_view bytes);
MeshFile parse_stl(std::string_view bytes);
MeshFile parse_msh(std::string_view bytes);
MeshFile parse_vtk(std::string_view bytes);
MeshFile parse_vs3(std::string_view bytes);
MeshFile parse_vtu(std::string_view bytes);
MeshFile parse_gltf(std::string_view bytes);

}  // namespace radcert
