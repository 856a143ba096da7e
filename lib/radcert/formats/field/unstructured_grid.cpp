// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/unstructured_grid.h"

#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/formats/plot/svg_elements.h"

namespace radcert {

namespace {

std::size_t points_of(UnstructuredGrid::Cell cell) {
  switch (cell) {
    case UnstructuredGrid::Cell::vertex: return 1;
    case UnstructuredGrid::Cell::triangle: return 3;
    case UnstructuredGrid::Cell::quadrilateral: break;
  }
  return 4;
}

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

void data_arrays(std::string& out, const UnstructuredGrid::Data& data, std::size_t size) {
  for (const auto& [name, values] : data) {
    expects(values.size() == size, "a number for every point or cell", named("numbers", values.size()));
    data_array(out, "Float64", " Name=\"" + name + "\"", [&, &numbers = values] {
      for (const double value : numbers) out += decimal(value) + " ";
    });
  }
}

/// The names of pieces as the names of arrays with their numbers: few readers but VTK's know arrays of
/// strings.
void legend(std::string& out, const std::vector<std::string>& names) {
  for (std::size_t k = 0; k < names.size(); ++k)
    data_array(
        out, "Int32",
        " Name=\"piece " + std::to_string(k) + ": " + svg::escaped(names[k]) + "\" NumberOfTuples=\"1\"",
        [&] { out += std::to_string(k); });
}

}  // namespace

std::string vtu_text(const UnstructuredGrid& grid) {
  const std::size_t points_a_cell = points_of(grid.cell);
  const std::size_t cells = grid.pieces.size();
  expects(grid.points.size() == cells * points_a_cell, "the points of every cell",
          named("points", grid.points.size()));
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<FieldData>\n";
  legend(out, grid.piece_names);
  out += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) +
         "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n<PointData";
  if (!grid.at_points.empty()) out += " Scalars=\"" + grid.at_points.front().first + "\"";
  out += ">\n";
  data_arrays(out, grid.at_points, grid.points.size());
  out += "</PointData>\n<CellData Scalars=\"piece\">\n";
  data_array(out, "Int32", " Name=\"piece\"", [&] {
    for (const std::size_t piece : grid.pieces) out += std::to_string(piece) + " ";
  });
  data_arrays(out, grid.on_cells, cells);
  out += "</CellData>\n<Points>\n";
  data_array(out, "Float64", " Name=\"points\" NumberOfComponents=\"3\"", [&] {
    for (const Vector<double>& point : grid.points)
      out += decimal(point.x) + " " + decimal(point.y) + " " + decimal(point.z) + "\n";
  });
  out += "</Points>\n<Cells>\n";
  data_array(out, "Int64", " Name=\"connectivity\"", [&] {
    for (std::size_t point = 0; point < grid.points.size(); ++point) out += std::to_string(point) + " ";
  });
  data_array(out, "Int64", " Name=\"offsets\"", [&] {
    for (std::size_t cell = 1; cell <= cells; ++cell) out += std::to_string(points_a_cell * cell) + " ";
  });
  data_array(out, "UInt8", " Name=\"types\"", [&] {
    for (std::size_t cell = 0; cell < cells; ++cell) out += std::to_string(static_cast<int>(grid.cell)) + " ";
  });
  out += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

}  // namespace radcert
