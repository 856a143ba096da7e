// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// A triangle of the plane x + y + z = 1, x, y, z >= 0, which F(x) = x/|x| takes to the first octant of the
/// unit sphere.
struct OctantTriangle {
  std::array<Vector<Rational>, 3> corners;
  bool upright = true;  ///< moved and shrunk only, against the octant; else turned by half a turn as well
};

/// The symmetric triangulation of the octant: 4^level triangles.
[[nodiscard]] std::vector<OctantTriangle> symmetric_octant(int level);

/// The same with every upright triangle divided into three at its centroid: conforming, of one shape at every
/// level, and not symmetric.
[[nodiscard]] std::vector<OctantTriangle> upright_divided_octant(int level);

/// Integrals of the barycentric coordinates over the image of a triangle.
/// Maths     W_j = Int x_j dS = d Int x_j |x|^-3 dA, d = 3^(-1/2) the distance of the plane. V = Int x |x|^-3
///           dA = sum (W_j/d) v_j has the part Omega n along the normal, Omega the solid angle, and
///           -sum_sides nu Int dl/|x| in the plane, nu the outer normal of a side, Int dl/|x| = log((r + r' +
///           l)/(r + r' - l))
/// Source    the divergence theorem; van Oosterom and Strackee for Omega
/// Requires  a triangle with an area
/// Result    enclosed
/// Limits    loses about twice the bits of 1/size
[[nodiscard]] std::array<Ball, 3> coordinate_integrals(const OctantTriangle& triangle);

/// Collocation on the unit sphere by linear interpolation, in balls.
/// Maths     G = 1/4: K u = rho M u, K P_n u = rho M_n u, M the mean over the sphere, M_n u = M P_n u = sum
///           w_i u(v_i). With E: u = E + rho M(E)/(1 - M rho), hat u_n = E + rho M_n(E)/(1 - M_n rho). All
///           eight octants have the triangles of the first, reflected
/// Source    [ac98, (33)-(46)]; G: [m06, Lemma 1 (d)]
/// Requires  0 <= alpha < 1/3
/// Result    enclosed
/// Limits    no quadrature anywhere: the weights have closed forms
class SphereCollocation {
public:
  using Function = std::function<Ball(const Vector<Ball>&)>;
  SphereCollocation(const std::vector<OctantTriangle>& octant, const Rational& alpha);

  /// M_n f.
  [[nodiscard]] Ball mean(const Function& f) const;
  /// sum |w_i|.
  [[nodiscard]] Ball weight_sum() const;

private:
  std::vector<Vector<Ball>> nodes_;  ///< in the first octant
  std::vector<Ball> weights_;        ///< of an octant, over 4 pi
};

}  // namespace radcert::verification::ac98
