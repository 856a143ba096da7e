// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "radcert/geometry/mesh_file/mesh_file.h"

namespace radcert {

/// Triangles that a program holds as arrays.
/// Maths     triangle k has the corners points[triangles[3 k]], ..., points[triangles[3 k + 2]], where
///           points[i] = (coordinates[3 i], coordinates[3 i + 1], coordinates[3 i + 2]), and is of the group
///           groups[k]
/// Requires  the lengths of coordinates and triangles are multiples of 3
/// Result    places counted from 0
struct MeshArrays {
  std::span<const double> coordinates;
  std::span<const std::int64_t> triangles;
  std::span<const std::string> groups = {};  ///< a name a triangle, or none: all are of one without a name
};

/// The same as a file would have it, and with the same refusals.
/// Source    read_mesh_file
/// Requires  as MeshArrays, else ContractViolation; `name` stands in messages
/// Result    groups in the order in which triangles first show them; digest: of the numbers and names.
///           InputError with this name and the place "point 3" or "triangle 7" for a coordinate that is not
///           finite or beyond 1e60, for a corner that is not there or is repeated, and where there is no
///           triangle
/// Limits    every double is taken as it is: precision is that of doubles
[[nodiscard]] MeshFile mesh_of_arrays(const MeshArrays& arrays, const std::string& name);

}  // namespace radcert
