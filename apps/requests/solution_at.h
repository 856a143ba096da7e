// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "requests/solve_request.h"

namespace radcert::app {

/// What is known of a solution at a point of the surface.
struct ValueAt {
  Vector<double> point;  ///< of S, nearest to the one that was asked for
  double distance = 0;   ///< between the two
  std::string piece;
  Approximation u_n = Approximation::without_radius(0);
  std::optional<Approximation> iterated = std::nullopt;
};

/// How points of a surface are looked up.
struct AtChoice {
  double tolerance = 1e-9;  ///< how far from S a point may be, relative to the extent of S
  bool iterated = true;
};

/// The computed function and its iterate at points of the surface.
/// Maths     u_n = sum_j u_n(v_j) l_j; the iterate E + K u_n, with E = u - Ku where u is given. The point of
///           S nearest to P is sought in each element that may hold one nearer than the best, by
///           reference::nearest_to; of several elements the first is taken
/// Source    ours; K u_n by the adaptive cubature of `reference` over each element, which knows nothing of
///           the matrix's quadrature
/// Requires  place < solution.levels.size()
/// Result    u_n with the radius of its nodal values times sum |l_j|. The iterate's radius holds that of the
///           cubatures, and rho times the largest radius of u_n; estimated. At a collocation node both are
///           the same number but for these. InputError at "points/3" for a point that is off S or is not
///           finite, and, for the iterate, on an edge at which charts meet at an angle; at "at" for a method
///           without functions on triangles, an interpolated geometry, or, for the iterate, an occluded
///           surface
/// Limits    the nearest point of a curved element may be a local one: its distance is then too large, and
///           the point refused. u_n has two values on the sides of elements
[[nodiscard]] std::vector<ValueAt> solution_at(const Solution& solution, std::size_t place,
                                               std::span<const Vector<double>> points, const AtChoice& choice,
                                               Progress& told);

}  // namespace radcert::app
