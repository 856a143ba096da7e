// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/transport/transport.h"

namespace radcert {

/// The nodes of a tensor Gauss rule on a part of an element, and what T f at them may be off by, relative to
/// the size of the functions.
struct CellNodes {
  SectorBox box;
  int nodes_s = 0;
  int nodes_t = 0;
  double tolerance = 0;
};

/// T f at the nodes of cells of one element, on a surface no part of which hides another.
/// Maths     T f = sum over parts e of elements of T_e f. About a family of cells, the parts that are far
///           beside its size are summed at the Gauss nodes of a box about all of them, and interpolated from
///           there, by as few nodes as FarBound asks for; larger parts are cut, and what is left is summed
///           for half of the family, at last for a single cell. Of each cell the radius has what interpolants
///           leave, FarError, and l_s l_t times that of the values at the nodes
/// Requires  the transport's scene is open (PanelSight), else ContractViolation
/// Result    by cell, as Transport gives them; the radius holds at all nodes of the cell
[[nodiscard]] std::vector<Transport::Values> transport_to_cells(
    const Transport& transport, std::size_t element, std::span<const CellNodes> cells,
    std::optional<std::size_t> without = std::nullopt);

}  // namespace radcert
