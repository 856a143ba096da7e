// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "radcert/clusters/certified/chart_growth.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/chart.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A cluster on a chart, and complex neighbourhoods of it.
/// Maths     on E_g = {lambda in C^3: sum lambda_i = 1, sum |lambda_i| <= g} the chart's point, at the
///           parameters sum lambda_i v_i, is A + e, A = sum lambda_i q_i with real corners q_i within
///           `radius` of the centre, so that L(A - centre) <= g radius, and L(e) <= bend; its unit normal is
///           m + f, m real, |m| <= 1 + 2^-40, and L(f) <= turn; the area element times the cluster's area in
///           the parameter plane is at most `weight` in size. All three are analytic there
/// Source    Lie's norm L(u + iv)^2 = |u|^2 + |v|^2 + 2 |u x v|, u and v real, is the largest |u + n x v|
///           over unit vectors n and so subadditive, L(z w) = |z| L(w) since w.conj(w) and w x conj(w)
///           determine it, L(u) = |u|, and |w| <= L(w). Theorem. Homogeneous polynomials p of degree k with
///           real coefficients and |p(v)| <= d |v|^k for real v have L(p(w)) <= d L(w)^k. Proof. Times a
///           number of size 1, w is u + iv with u.v = 0, L(w) = |u| + |v|. In the plane of u and v, p is a
///           polynomial in z = x + iy and z' = x - iy, both at most L(w) in size at w; on |z| = |z'| = L(w)
///           it is p(v') times a number of size 1, v' real and |v'| = L(w), so that the maximum principle
///           gives it. For k = 1: L(T w) <= |T| L(w).
///           Octants: F = T e/|e|, T = diag of the half axes with their signs, e = (1-s-t, s, t) = c + w, c
///           the centre of a circle about the corners of e, r its radius, L(w) <= g r; x = g r/|c| < 1. For
///           real v and |c| = 1, (c + tv)/|c + tv| is in the plane of c and v ((1 + tz)/(1 + tz'))^(1/2),
///           |z| = |z'| = |v|, whose coefficients are at most those of (2 - (1-y)^(1/2)) (1-y)^(-1/2) = 2
///           (1-y)^(-1/2) - 1, y = t|v|. The first two orders make A, (c + w - c (c.w)/|c|^2)/|c|; the others
///           bend it by at most |T| (2 (1-x)^(-1/2) - 2 - x). The inner normal is -T^-1 e/|T^-1 e|, with x'
///           of T^-1 c and T^-1 w in the same way: turn is 2 (1-x')^(-1/2) - 2. Where (c + tw).(c + tw) = 0,
///           |t| >= |c| / L(w), as kernel_bound has it, so that the roots are analytic, and |e.e| >= |c|^2 (1
///           - x)^2; as e.(e_s x e_t) = 1, D_s F x D_t F = det(T) T^-1 e/(e.e)^2, and the area element is at
///           most |det T| |T^-1 c| (1 + x')/(|c| (1 - x))^4.  Other charts: A is F to the first order about
///           the middle of the parameters, m the normal there, and the rest is as ChartGrowth has it
/// Requires  a chart that is known in balls, else ContractViolation
/// Result    bounds rounded outwards. at(g): infinite unless g < limit()
class ClusterRegion {
public:
  struct Neighbourhood {
    double g = 1;
    double bend = 0;
    double turn = 0;
    double weight = 0;
  };

  ClusterRegion(const Chart& chart, const ParameterTriangle& triangle);

  [[nodiscard]] Neighbourhood at(double g) const;
  [[nodiscard]] double limit() const;
  [[nodiscard]] const Vector<double>& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const std::array<Vector<double>, 3>& corners() const { return corners_; }
  [[nodiscard]] const Vector<double>& normal() const { return normal_; }
  /// At most the distance of a point from all points of the cluster.
  [[nodiscard]] double least_distance(const Vector<double>& from) const;
  /// At least |(q - c).m| for the corners q of this cluster, and the centre c and m of another, or the same.
  [[nodiscard]] double largest_height(const ClusterRegion& above) const;

private:
  void be_plane(const Chart& chart, const ParameterTriangle& triangle);
  void be_octant(const Vector<Ball>& axes, const ParameterTriangle& triangle);
  void be_curved(const Chart& chart, const ParameterTriangle& triangle);
  void take_corners(const std::array<Vector<Ball>, 3>& corners);
  void take_normal(const Vector<Ball>& normal);

  std::array<Vector<double>, 3> corners_;
  double corner_error_ = 0;
  Vector<double> centre_;
  double radius_ = 0;
  Vector<double> normal_;
  double normal_error_ = 0;
  double weight_ = 0;                  ///< at g = 0
  double size_ = 0;                    ///< |T|
  double rate_ = 0;                    ///< x / g
  double normal_rate_ = 0;             ///< x' / g
  std::optional<ChartGrowth> growth_;  ///< of a chart that is neither plane nor an octant
};

/// What bounds |G|, one of the points in a complex neighbourhood.
/// Maths     P in the cluster of `from`, Q on E_g of `seen`, c the centre of `seen`, w = Q - c, so that L(w)
///           <= g radius + bend; D <= |c - P|: |(Q - P).(Q - P)| >= (D - L(w))^2. For d = c - P, where (d +
///           w).(d + w) = 0, w = u + iv, the real vector a = d + u has |a| = |v| and a.v = 0, so that |d|^2 =
///           |u|^2 + |v|^2 - 2 u.a <= L(w)^2; the two zeros t of the quadratic (d + t w).(d + t w) then have
///           |t| >= D / L(w), and at t = 1 it is at least D^2 (1 - L(w)/D)^2.
///           (Q - P).n_P: with the corners q_i of Q's cluster, the p_j of P's, and the centre and m of P's,
///           sum lambda_i (q_i - centre).m is at most g times its largest, sum mu_j (p_j - centre).m at most
///           its largest; what bends Q and P adds bend each, and n_P - m, |.| <= turn, adds |Q - P| turn.
///           (P - Q).n_Q in the same way with the centre and m of Q's cluster; the factor g then stands with
///           the q_i, which are near to their own plane
/// Requires  1 <= g, else ContractViolation
/// Result    |(Q - P).(Q - P)| >= nearest^2 where nearest > 0, |(Q - P).n_P| <= over_p, |(P - Q).n_Q| <=
///           over_q; rounded outwards
struct KernelFactors {
  double nearest = 0;
  double over_p = 0;
  double over_q = 0;
};
[[nodiscard]] KernelFactors kernel_factors(const ClusterRegion& seen, const ClusterRegion& from, double g);

/// The bound of |G| that follows; infinite where there is none.
[[nodiscard]] double kernel_bound(const ClusterRegion& seen, const ClusterRegion& from, double g);

}  // namespace radcert
