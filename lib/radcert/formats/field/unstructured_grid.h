// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"

namespace radcert {

/// Cells of one kind with numbers at their points and on them, as VTK knows them.
struct UnstructuredGrid {
  enum class Cell { vertex = 1, triangle = 5, quadrilateral = 9 };  ///< VTK's numbers
  using Data = std::vector<std::pair<std::string, std::vector<double>>>;

  Cell cell = Cell::triangle;
  std::vector<Vector<double>> points;  ///< those of one cell after those of another, shared with none
  std::vector<std::string> piece_names;
  std::vector<std::size_t> pieces;  ///< of each cell
  Data at_points;                   ///< the first is what is shown
  Data on_cells;
  std::size_t appended_from =
      10'000;  ///< from so many cells on the arrays are compressed and stand at the end
};

/// The grid as a file of VTK.
/// Maths     VTK's XML format UnstructuredGrid: arrays as text, or of many cells in base64 at the end,
///           deflated by zlib in blocks of a MiB
/// Requires  as many points and numbers as the cells have; finite numbers, else ContractViolation
/// Result    a .vtu text; a field array "piece 3: floor" for each piece, which holds its number: a legend
///           that programs without arrays of strings read as well
std::string vtu_text(const UnstructuredGrid& grid);

}  // namespace radcert
