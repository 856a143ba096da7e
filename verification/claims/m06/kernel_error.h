// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/m06/interpolation_remainder.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

/// What interpolation leaves under the integral at a point.
/// Maths     Int G(P,Q) (u - P_n u)(Q) dS over the elements, of one chart or of all: K(I - P_n)u at P for rho
///           = pi
/// Source    [m06, before (25)]; no matrix is made, so that levels can be reached for which there is no room
///           for one
/// Requires  P inside an element or on another piece, not on a side; u smooth
/// Result    by conical rules, collapsed at P on its own element, on triangles that are divided until they
///           are further from P than they are wide; the radius is the distance of two orders of the rule
/// Limits    the radius is an estimate; charts other than P's own are taken by their distance from P in space
[[nodiscard]] Approximation kernel_error(const Surface& surface,
                                         const std::vector<ParameterTriangle>& elements,
                                         const TriangleBasis<double>& basis, Solution u,
                                         const SurfacePoint<double>& p,
                                         std::optional<std::size_t> only_chart = {});

/// The largest of it over the nodes of one element; the largest radius.
[[nodiscard]] Approximation kernel_error_at_nodes(const Surface& surface,
                                                  const std::vector<ParameterTriangle>& elements,
                                                  const ParameterTriangle& of,
                                                  const TriangleBasis<double>& basis, Solution u,
                                                  std::optional<std::size_t> only_chart = {});

}  // namespace radcert::verification::m06
