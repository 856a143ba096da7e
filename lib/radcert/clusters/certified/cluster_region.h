// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A cluster on a plane chart, and complex neighbourhoods of it.
/// Maths     on E_g = {lambda in C^3: sum lambda_i = 1, sum |lambda_i| <= g} the point sum lambda_i v_i of
///           the corners v_i is centre + l, l = sum lambda_i (v_i - centre) with |v_i - centre| <= radius
/// Source    Lie's norm L(u + iv)^2 = |u|^2 + |v|^2 + 2 |u x v|, u and v real, has L(l) <= g radius: it is
///           the largest |u + n x v| over unit vectors n and so subadditive, L(z w) = |z| L(w) since
///           w.conj(w) and w x conj(w) determine it, and L(u) = |u|
/// Requires  a plane chart with a formula in balls, else ContractViolation
/// Result    bounds rounded outwards
class ClusterRegion {
public:
  ClusterRegion(const Chart& chart, const ParameterTriangle& triangle);

  [[nodiscard]] const Vector<double>& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }
  /// At least the area element times the cluster's area in the parameter plane.
  [[nodiscard]] double weight() const { return weight_; }
  /// At most the distance of a point from all points of the cluster.
  [[nodiscard]] double least_distance(const Vector<double>& from) const;
  /// At least the height of each corner above or below the plane of another cluster.
  [[nodiscard]] double largest_height(const ClusterRegion& above) const;

private:
  Vector<double> centre_;
  double radius_ = 0;
  double weight_ = 0;
  std::array<Vector<double>, 3> corners_;  ///< each within corner_error_
  double corner_error_ = 0;
  Vector<double> unit_normal_;  ///< within 2^-50
};

/// A bound of |G|, one of the points in a complex neighbourhood.
/// Maths     P in the cluster of `from`, Q = c + l on E_g of `seen`, r its radius, D <= |c - P|: |(Q - P).(Q
///           - P)| >= (D - g r)^2. For d = c - P, where (d + w).(d + w) = 0, w = u + iv, the real vector a =
///           d + u has |a| = |v| and a.v = 0, so that |d|^2 = |u|^2 + |v|^2 - 2 u.a <= L(w)^2; the two zeros
///           t of the quadratic (d + t l).(d + t l) then have |t| >= D / L(l), and at t = 1 it is at least
///           D^2 (1 - L(l)/D)^2. (Q - P).n_P is the height of Q above P's plane, at most g times the largest
///           of its corners', and (P - Q).n_Q, the height of P above Q's plane, does not depend on Q
/// Requires  1 <= g, else ContractViolation
/// Result    rounded up; infinite where there is none
[[nodiscard]] double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, double g);

}  // namespace radcert
