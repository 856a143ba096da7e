// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// The surface near its vertices, where a solution is no smooth function of the place.
/// Maths     B(a): the points of the surface within a of a vertex. T 1_B(a)(P) is Int cos/pi over the
///           directions from P in which a point of B(a) is seen. A vertex V at the distance D from P: they
///           lie in the cone about V of half the angle alpha, sin alpha = a/D. V in the plane of P: before it
///           lies half of the cone, whose orthogonal projection is the part x >= cos alpha of the unit disk:
///           phi = (alpha - sin alpha cos alpha)/pi, 1/2 at most for a <= D, and 1 where a > D. phi <=
///           (a/D)^3/2, since phi/sin^3 alpha grows with alpha. V at the height H of that plane, on either
///           side: no set of directions of that size brings more than the cone about the normal: (a/D)^2 <=
///           (a/H)^2. One vertex at most is nearer than half the least distance of two
/// Source    Nusselt's projection
/// Requires  the scene outlives it
/// Result    bounds rounded to the safe side
class VertexDisks {
public:
  explicit VertexDisks(const SectorScene& scene);

  /// A quarter of half the least distance of two vertices.
  [[nodiscard]] double largest_radius() const { return 0.25 * half_distance_; }
  /// sup T 1_B(radius) at points that are at least `distance` from every vertex; at most 1.
  /// Requires  0 <= radius, 0 < distance
  [[nodiscard]] double mass(double radius, double distance) const;

  /// Bounds of the distance of a box' points from the vertex that is nearest to them.
  [[nodiscard]] double distance_at_most(const Sector& sector, const SectorBox& box) const;
  [[nodiscard]] double distance_at_least(const Sector& sector, const SectorBox& box) const;

private:
  /// The vertices as seen from a panel's plane.
  struct Receiver {
    int in_plane = 0;
    double inverse_squares = 0;  ///< sum 1/H^2 over the others
  };

  double slack_;
  std::vector<Vector<double>> vertices_;
  std::vector<Receiver> receivers_;  ///< by panel
  double half_distance_ = 0;         ///< of two vertices
};

/// A bound of u - w by the distance from the vertices.
/// Maths     shells m = 0, ..., n: distance radii[m] or more, and below radii[m-1]; the last one ends at the
///           vertices. |u - K u - (w - K w)| <= R_m on shell m, R growing towards the vertices. Where z >=
///           K(R+z) almost everywhere, (I-K)(R+z) >= R, and (I-K)^-1 = sum K^k >= 0 makes |u-w| <= R + z.
///           With Y = R + z, K Y <= s (Y_0 + sum_m (Y_m - Y_(m-1)) T 1_B(radii[m-1])): z_0 = s/(1-s) max R
///           and its images under the right side, each with the one before for its bound
/// Source    ordered positive operators: L. Collatz, "Functional Analysis and Numerical Mathematics", 1966
/// Requires  radii descending, positive, one fewer than residuals; residuals ascending; s = 1 - gap, 0 < gap
///           <= 1
/// Result    z, by shell, rounded up
[[nodiscard]] std::vector<double> supersolution(const VertexDisks& disks, std::span<const double> radii,
                                                std::span<const double> residuals, double gap);

}  // namespace radcert
