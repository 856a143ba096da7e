// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// Where a cluster lies, and where its chart takes a complex neighbourhood of it.
/// Maths     on E_g = {lambda in C^3: sum lambda_i = 1, sum |lambda_i| <= g} the chart is c + l + e, c the
///           centre, l = sum lambda_i l_i with real |l_i| <= radius, e complex, |e| <= rest; |n| <= normal
///           and |area normal| times the cluster's area in the parameter plane <= weight there, with n the
///           unit inner normal continued analytically
/// Source    l is the tangent plane at the centroid: with J the tangents there, F(y) - F(y_0) - J (y - y_0)
///           is the mean over the segment of (J(y') - J)(y - y_0), and J(y_0 + t d) - J, analytic for |t| <=
///           1 and zero at t = 0, is at most |t| times its bound on the bidisc |s - s_0| <= g max |s_i -
///           s_0|, |t - t_0| <= g max |t_i - t_0|, which contains E_g since s - s_0 = sum lambda_i (s_i -
///           s_0): hence half of it. L(l) <= g radius for Lie's norm L(u + iv)^2 = |u|^2 + |v|^2 + 2 |u x v|,
///           u and v real: it is the largest |u + n x v| over unit vectors n and so subadditive, L(z w) = |z|
///           L(w) since w.conj(w) and w x conj(w) determine it, and L(u) = |u|
/// Requires  a chart with formulas in balls
/// Result    rounded up; where a formula is not proved to be analytic, no neighbourhood. Plane charts have e
///           = 0 on every E_g
class ClusterRegion {
public:
  ClusterRegion(const Chart& chart, const ParameterTriangle& triangle);

  /// The neighbourhoods that are looked at; the first is the triangle itself.
  static constexpr std::array<double, 20> sizes{1,    1.1,  1.2, 1.3, 1.45, 1.6, 1.8, 2,   2.25, 2.5,
                                                2.85, 3.25, 3.7, 4.2, 4.8,  5.5, 6.4, 7.5, 9,    12};
  struct Neighbourhood {
    double rest;
    double normal;
    double weight;
  };

  [[nodiscard]] const Vector<double>& centre() const { return centre_; }
  /// Of the plane part.
  [[nodiscard]] double radius() const { return radius_; }
  /// All points of the cluster are within it of the centre.
  [[nodiscard]] double real_radius() const { return radius_ + neighbourhoods_.front().rest; }
  /// By `sizes`, as far as there are any: at least that of the triangle.
  [[nodiscard]] const std::vector<Neighbourhood>& neighbourhoods() const { return neighbourhoods_; }
  /// On E_g for every g, of a plane chart; none of another.
  [[nodiscard]] bool is_plane() const { return plane_; }
  /// At most the distance of a point from all points of the cluster.
  [[nodiscard]] double least_distance(const Vector<double>& from) const;
  /// For plane charts: at least the height of each corner above the plane of another plane cluster.
  [[nodiscard]] double largest_height(const ClusterRegion& above) const;

private:
  bool plane_;
  Vector<double> centre_;
  double radius_ = 0;
  std::array<Vector<double>, 3> corners_;  ///< of the plane part, each within corner_error_
  double corner_error_ = 0;
  Vector<double> unit_normal_;  ///< of a plane chart, within 2^-50
  std::vector<Neighbourhood> neighbourhoods_;
};

/// A bound of |G| times an area element, one of the points in a complex neighbourhood.
/// Maths     P in the cluster of `from`, Q = c + l + e on E_g of `seen`, g = sizes[size]: with w = c + l + e
///           - P and D the least |c - P|, |(d + l).(d + l)| >= (D - g r)^2 for d = c - P: where (d + w).(d +
///           w) = 0, w = u + iv, the real vector a = d + u has |a| = |v| and a.v = 0, so that |d|^2 = |u|^2 +
///           |v|^2 - 2 u.a <= L(w)^2; the two zeros t of the quadratic (d + t l).(d + t l) then have |t| >= D
///           / L(l). So |w.w| >= S = (D - g r)^2 - 2 (D + g r) E - E^2, |w| <= D + g r + E, and |G| <= |w|^2
///           |n_P| |n_Q| / S^2, which falls with D where S > 0. On two planes the scalar products are
///           heights: (Q - P).n_P is that of Q above P's plane, at most g times the largest of its corners',
///           and (P - Q).n_Q that of P above Q's
/// Result    the bound without |n_P| |n_Q| and area elements, rounded up; infinite where there is none
[[nodiscard]] double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, std::size_t size);

}  // namespace radcert
