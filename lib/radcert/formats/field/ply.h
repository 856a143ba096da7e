// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "radcert/formats/field/element_errors.h"
#include "radcert/study/study.h"

namespace radcert {

/// The computed function as a PLY file of triangles.
/// Maths     each element as the triangle through its corners, u_n linear between its values there
/// Source    the PLY format 1.0, ASCII
/// Requires  finite numbers, else ContractViolation; an error for every corner, or none at all
/// Result    three vertices a triangle, shared with none, so that jumps across edges stay; vertex properties
///           x, y, z, radiosity, and error where it is known, and with the iterated solution iterated and
///           iterated_error; of a face its vertices and `piece`, the number
///           of the piece in the order of the comments
/// Limits    curved elements are drawn flat; double in decimal, exact
std::string ply_text(std::span<const ElementValue> elements,
                     const std::optional<CornerErrors>& errors = std::nullopt,
                     const std::optional<CornerErrors>& iterated_errors = std::nullopt);

}  // namespace radcert
