// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// The surface near its vertices, where a solution is no smooth function of the place.
/// Maths     B(a): the points of the surface within a of a vertex. T 1_B(a)(P) for P at least r > a from
///           every vertex, P on the panel i. A vertex V in the plane of i and a panel j with the angle Theta
///           there: for Q on j, |Q-V| = q <= a, n_i.(Q-V) <= q sin and n_j.(P-V) <= |P-V| sin, sin that of
///           the angle of the planes, |P-Q| >= |P-V| - q, and  Int_0^a q^2/(r-q)^4 dq = a^3/(3r (r-a)^3):  at
///           most Theta sin^2/(3 pi) (a/(r-a))^3. One vertex at most is nearer than half the least distance
///           of two. A vertex that is not in the plane of i, d from the panel: Theta/(2 pi) (a/(d-a))^2
/// Requires  the scene outlives it
/// Result    bounds rounded to the safe side
class VertexDisks {
public:
  explicit VertexDisks(const SectorScene& scene);

  /// Up to which a disk meets no panel but those of its vertex.
  [[nodiscard]] double largest_radius() const { return largest_radius_; }
  /// sup T 1_B(radius) at points that are at least `distance` from every vertex.
  /// Requires  radius <= largest_radius(), else ContractViolation
  [[nodiscard]] double mass(double radius, double distance) const;

  /// Bounds of the distance of a box' points from the vertex that is nearest to them.
  [[nodiscard]] double distance_at_most(const Sector& sector, const SectorBox& box) const;
  [[nodiscard]] double distance_at_least(const Sector& sector, const SectorBox& box) const;

private:
  /// What the panels at the vertices send to one panel.
  struct Receiver {
    double largest_at_vertex = 0;  ///< of sum Theta sin^2/(3 pi) over the vertices in its plane
    double all_at_vertices = 0;    ///< their sum
    struct Beyond {
      double angles = 0;    ///< sum Theta/(2 pi)
      double distance = 0;  ///< d
    };
    std::vector<Beyond> beyond;
  };

  double slack_;
  std::vector<Vector<double>> vertices_;
  std::vector<Receiver> receivers_;  ///< by panel
  double half_distance_ = 0;         ///< of two vertices
  double largest_radius_ = 0;
};

/// A bound of u - w by the distance from the vertices.
/// Maths     shells m = 0, ..., n: distance radii[m] or more, and below radii[m-1]; the last one ends at the
///           vertices. |u - K u - (w - K w)| <= R_m on shell m, R growing towards the vertices. Where z >=
///           K(R+z) almost everywhere, (I-K)(R+z) >= R, and (I-K)^-1 = sum K^k >= 0 makes |u-w| <= R + z.
///           With Y = R + z, K Y <= s (Y_0 + sum_m (Y_m - Y_(m-1)) T 1_B(radii[m-1])): z_0 = s/(1-s) max R
///           and its images under the right side, each with the one before for its bound
/// Source    ordered positive operators: L. Collatz, "Functional Analysis and Numerical Mathematics", 1966
/// Requires  radii descending, at most disks.largest_radius(), one fewer than residuals; residuals ascending;
///           s = 1 - gap, 0 < gap <= 1
/// Result    z, by shell, rounded up
[[nodiscard]] std::vector<double> supersolution(const VertexDisks& disks, std::span<const double> radii,
                                                std::span<const double> residuals, double gap);

}  // namespace radcert
