// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "radcert/formats/field/element_errors.h"
#include "radcert/study/study.h"

namespace radcert {

/// The computed function as a VTK file of unstructured triangles, for ParaView.
/// Maths     each element as the triangle through its corners, u_n linear between its values there
/// Source    VTK's XML format UnstructuredGrid, cell type 5; text, or compressed from 10,000 elements on
/// Requires  finite numbers, else ContractViolation; an error for every corner, or none at all
/// Result    a .vtu text: three points a triangle, shared with none, so that jumps across edges show; point
///           data radiosity, and error where it is known, and with the iterated solution iterated and
///           iterated_error; cell data piece (the number of the piece in order
///           of appearance; the names are in a field array)
/// Limits    curved elements are drawn flat; Float64, exact in either form
std::string vtu_text(std::span<const ElementValue> elements,
                     const std::optional<CornerErrors>& errors = std::nullopt,
                     const std::optional<CornerErrors>& iterated_errors = std::nullopt);

/// What is proved of a solution, as such a file.
/// Maths     of a function its patches, with point data radiosity, v at the corners, and cell data bound, of
///           |u - v| on the patch; of values their points, with radiosity and radius of the problem's own
///           emission, and "radiosity, NAME" and "radius, NAME" of each further one
/// Requires  an enclosure of a function or of values
/// Result    quadrilaterals, or vertices; all else as above
std::string vtu_text(const SolutionEnclosure& enclosure);

}  // namespace radcert
