// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert::bench {

/// What a plain ray caster found of a row of configuration factors.
struct PlainRow {
  std::vector<double> factors;  ///< to each group of the mesh
  std::vector<double> errors;   ///< their standard errors
};

/// Configuration factors of a group of a mesh by a plain program: what ray_factors is compared with.
/// Maths     F_IJ is the probability that a ray from a point of I, uniform in area, in a direction
///           distributed as the cosine, first meets the front of a triangle of J; the standard error is that
///           of a binomial
/// Source    Monte Carlo as in textbooks; Moeller & Trumbore, 1997
/// Requires  triangles that look to the side from which their corners run counterclockwise
/// Result    unoptimised on purpose: pseudo-random numbers, one thread, each ray tries every triangle
/// Limits    shares nothing with the library but the mesh
PlainRow plain_factor_row(const TriangleMesh& mesh, std::size_t group, std::size_t rays);

}  // namespace radcert::bench
