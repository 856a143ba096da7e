// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace radcert {

/// An array of a VTK file: its attributes and, where it stands there, its text.
struct VtkArray {
  std::string section;  ///< the element that it is in: Points, Cells, CellData, PointData, FieldData
  std::map<std::string, std::string> attributes;
  std::string text;
  std::string place;  ///< "line 12"

  /// Empty where there is none.
  [[nodiscard]] std::string attribute(const std::string& name) const;
  [[nodiscard]] bool is_text() const { return attribute("format") == "ascii"; }
};

/// A piece of the grid.
struct VtkPiece {
  std::uint64_t points = 0;
  std::uint64_t cells = 0;
  std::vector<VtkArray> arrays;
  std::string place;
};

/// A text's words, parted by white space.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text);

/// The arrays of a VTK XML file of an unstructured grid.
/// Source    VTK's file formats; XML is read by Expat, compressed blocks by zlib
/// Requires  the bytes outlive the object
/// Result    numbers of the forms ascii, binary (base64) and appended (base64 or raw), plain or compressed by
///           zlib, in either order of bytes; InputError without a source for everything else, by name
/// Limits    no other compressor, no other kind of grid
class VtkXmlFile {
public:
  explicit VtkXmlFile(std::string_view bytes);

  [[nodiscard]] const std::vector<VtkPiece>& pieces() const { return pieces_; }
  /// The arrays of the whole file.
  [[nodiscard]] const std::vector<VtkArray>& fields() const { return fields_; }

  /// The numbers of an array of integers.
  [[nodiscard]] std::vector<std::int64_t> whole_numbers(const VtkArray& array) const;
  /// The numbers of an array of 32-bit or 64-bit floats that is no text.
  [[nodiscard]] std::vector<double> coordinates(const VtkArray& array) const;
  [[nodiscard]] std::size_t bytes_of_number(const VtkArray& array) const;

private:
  friend class VtkXmlHandler;
  /// The bytes of an array, in the order of this machine.
  [[nodiscard]] std::string binary(const VtkArray& array) const;
  /// The bytes that a block begins with: from text in base64, or as they are.
  class Source;

  std::vector<VtkPiece> pieces_;
  std::vector<VtkArray> fields_;
  std::string_view appended_;  ///< what follows the underscore
  bool appended_is_raw_ = false;
  std::size_t header_bytes_ = 4;
  bool compressed_ = false;
  bool big_endian_ = false;
};

}  // namespace radcert
