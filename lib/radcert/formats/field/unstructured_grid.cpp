// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/unstructured_grid.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>

#include "radcert/core/base64.h"
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

/// The numbers as they are in memory, which is the order of bytes that the file names.
template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  static_assert(std::endian::native == std::endian::little);
  std::string out(numbers.size() * sizeof(T), '\0');
  if (!numbers.empty()) std::memcpy(out.data(), numbers.data(), out.size());
  return out;
}

/// Bytes as VTK packs them: the number of blocks, their size, that of a last smaller one, the sizes of the
/// deflated blocks, in base64; then these, in base64.
std::string deflated(std::string_view bytes) {
  constexpr std::size_t block = std::size_t{1} << 20U;
  std::vector<std::uint64_t> head = {(bytes.size() + block - 1) / block, block, bytes.size() % block};
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    const std::string_view plain = bytes.substr(at, block);
    uLongf length = compressBound(plain.size());
    std::string one(length, '\0');
    const int status = compress(reinterpret_cast<Bytef*>(one.data()), &length,
                                reinterpret_cast<const Bytef*>(plain.data()), plain.size());
    if (status != Z_OK) throw std::bad_alloc();  // the buffer is as large as zlib asks for
    head.push_back(length);
    packed.append(one, 0, length);
  }
  return base64(bytes_of(head)) + base64(packed);
}

std::string number_text(double value) { return shortest(value); }
template <class T>
std::string number_text(T value) {
  return std::to_string(value);
}

/// The data arrays of a file: as text where they stand, or all together at its end.
class DataArrays {
public:
  explicit DataArrays(bool appended) : is_appended_(appended) {}

  template <class T>
  void add(std::string& out, const std::string& type, const std::string& attributes,
           const std::vector<T>& numbers) {
    out += "<DataArray type=\"" + type + "\"" + attributes;
    if (is_appended_) {
      out += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      appended_ += deflated(bytes_of(numbers));
      return;
    }
    out += " format=\"ascii\">\n";
    for (std::size_t k = 0; k < numbers.size(); ++k)
      out += number_text(numbers[k]) + (k % 12 == 11 ? "\n" : " ");
    out += "\n</DataArray>\n";
  }

  void add(std::string& out, const UnstructuredGrid::Data& data, std::size_t size) {
    for (const auto& [name, values] : data) {
      expects(values.size() == size, "a number for every point or cell", named("numbers", values.size()));
      for (const double value : values)
        expects(std::isfinite(value), "a finite number", named("value", value));
      add(out, "Float64", " Name=\"" + svg::escaped(name) + "\"", values);
    }
  }

  [[nodiscard]] std::string at_the_end() const {
    return is_appended_ ? "<AppendedData encoding=\"base64\">\n_" + appended_ + "\n</AppendedData>\n"
                        : std::string();
  }

private:
  bool is_appended_;
  std::string appended_;
};

/// The names of pieces as the names of arrays with their numbers: few readers but VTK's know arrays of
/// strings.
void legend(std::string& out, const std::vector<std::string>& names, DataArrays& arrays) {
  for (std::size_t k = 0; k < names.size(); ++k)
    arrays.add(
        out, "Int32",
        " Name=\"piece " + std::to_string(k) + ": " + svg::escaped(names[k]) + "\" NumberOfTuples=\"1\"",
        std::vector<std::int32_t>{static_cast<std::int32_t>(k)});
}

/// 0, 1, 2, ... times a step, from a start.
std::vector<std::int64_t> steps(std::size_t count, std::size_t start, std::size_t step) {
  std::vector<std::int64_t> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(static_cast<std::int64_t>(start + step * k));
  return out;
}

}  // namespace

std::string vtu_text(const UnstructuredGrid& grid) {
  const std::size_t points_a_cell = points_of(grid.cell);
  const std::size_t cells = grid.pieces.size();
  expects(grid.points.size() == cells * points_a_cell, "the points of every cell",
          named("points", grid.points.size()));
  const bool appended = cells >= grid.appended_from;
  DataArrays arrays(appended);
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"" +
      std::string(appended ? " compressor=\"vtkZLibDataCompressor\"" : "") +
      ">\n<UnstructuredGrid>\n<FieldData>\n";
  legend(out, grid.piece_names, arrays);
  out += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) +
         "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n<PointData";
  if (!grid.at_points.empty()) out += " Scalars=\"" + grid.at_points.front().first + "\"";
  out += ">\n";
  arrays.add(out, grid.at_points, grid.points.size());
  out += "</PointData>\n<CellData Scalars=\"piece\">\n";
  arrays.add(out, "Int32", " Name=\"piece\"",
             std::vector<std::int32_t>(grid.pieces.begin(), grid.pieces.end()));
  arrays.add(out, grid.on_cells, cells);
  out += "</CellData>\n<Points>\n";
  std::vector<double> coordinates;
  for (const Vector<double>& point : grid.points)
    for (const double x : {point.x, point.y, point.z}) {
      expects(std::isfinite(x), "a finite number", named("coordinate", x));
      coordinates.push_back(x);
    }
  arrays.add(out, "Float64", " Name=\"points\" NumberOfComponents=\"3\"", coordinates);
  out += "</Points>\n<Cells>\n";
  arrays.add(out, "Int64", " Name=\"connectivity\"", steps(grid.points.size(), 0, 1));
  arrays.add(out, "Int64", " Name=\"offsets\"", steps(cells, points_a_cell, points_a_cell));
  arrays.add(out, "UInt8", " Name=\"types\"",
             std::vector<std::uint8_t>(cells, static_cast<std::uint8_t>(grid.cell)));
  out += "</Cells>\n</Piece>\n</UnstructuredGrid>\n" + arrays.at_the_end() + "</VTKFile>\n";
  return out;
}

}  // namespace radcert
