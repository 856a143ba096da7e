// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/vtu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {

namespace {

constexpr int triangle_type = 5;  // VTK_TRIANGLE

std::string decimal(double value) {
  expects(std::isfinite(value), "a finite number", named("value", value));
  return shortest(value);
}

/// A data array whose content `write` appends.
template <class Write>
void data_array(std::string& out, const std::string& type, const std::string& attributes,
                const Write& write) {
  out += "<DataArray type=\"" + type + "\"" + attributes + " format=\"ascii\">\n";
  write();
  out += "\n</DataArray>\n";
}

/// VTK's ASCII string arrays: the codes of the letters, each name ended by 0.
std::string letter_codes(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) {
    for (const char c : name) out += std::to_string(static_cast<unsigned char>(c)) + " ";
    out += "0 ";
  }
  return out;
}

}  // namespace

std::string vtu_text(std::span<const ElementValue> elements, const std::optional<CornerErrors>& errors) {
  expects(!errors || errors->size() == elements.size(), "errors for every element",
          named("elements", elements.size()));
  const std::vector<std::string> pieces = pieces_of(elements);
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<FieldData>\n";
  data_array(out, "String", " Name=\"piece_names\" NumberOfTuples=\"" + std::to_string(pieces.size()) + "\"",
             [&] { out += letter_codes(pieces); });
  out += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(3 * elements.size()) +
         "\" NumberOfCells=\"" + std::to_string(elements.size()) + "\">\n<PointData Scalars=\"radiosity\">\n";
  data_array(out, "Float64", " Name=\"radiosity\"", [&] {
    for (const ElementValue& element : elements)
      for (const double value : element.corner_values) out += decimal(value) + " ";
  });
  if (errors)
    data_array(out, "Float64", " Name=\"error\"", [&] {
      for (const std::array<double, 3>& corners : *errors)
        for (const double value : corners) out += decimal(value) + " ";
    });
  out += "</PointData>\n<CellData Scalars=\"piece\">\n";
  data_array(out, "Int32", " Name=\"piece\"", [&] {
    for (const ElementValue& element : elements)
      out += std::to_string(std::find(pieces.begin(), pieces.end(), element.piece) - pieces.begin()) + " ";
  });
  out += "</CellData>\n<Points>\n";
  data_array(out, "Float64", " Name=\"points\" NumberOfComponents=\"3\"", [&] {
    for (const ElementValue& element : elements)
      for (const Vector<double>& corner : element.corners)
        out += decimal(corner.x) + " " + decimal(corner.y) + " " + decimal(corner.z) + "\n";
  });
  out += "</Points>\n<Cells>\n";
  data_array(out, "Int64", " Name=\"connectivity\"", [&] {
    for (std::size_t point = 0; point < 3 * elements.size(); ++point) out += std::to_string(point) + " ";
  });
  data_array(out, "Int64", " Name=\"offsets\"", [&] {
    for (std::size_t cell = 1; cell <= elements.size(); ++cell) out += std::to_string(3 * cell) + " ";
  });
  data_array(out, "UInt8", " Name=\"types\"", [&] {
    for (std::size_t cell = 0; cell < elements.size(); ++cell) out += std::to_string(triangle_type) + " ";
  });
  out += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

}  // namespace radcert
