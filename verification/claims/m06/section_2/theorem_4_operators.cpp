// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 4: "for n >= n_0 the operators I - P_n K on C(S) have inverses, which are uniformly bounded".
//
// On the unit sphere K f = rho M(f), M the mean, as G = 1/4 (lemma_1_d). With R = P_n rho and q = M(R) the
// inverse of I - P_n K takes f to f + R M(f)/(1 - q): M of that is M(f)/(1 - q). For a constant rho R = q =
// rho, whatever n, r and alpha are, and the norm is at most 1 + rho/(1 - rho) = 1/(1 - rho), which f = 1
// reaches.
//
// On C(S) they do not act for alpha > 0: P_n K f has a jump across sides. On the unit sphere with rho = (2 +
// z^3)/4 and f = 1, K f = rho. r = 1, alpha = 1/6, each octant one element: on the side z = 0 the l_j are
// -1/3 for the node near the pole, with z^3 = 16 sqrt 2/27, and have the sum 4/3 for the two others, with z^3
// = sqrt 2/108. So P_n rho is 1/2 - 5 sqrt 2/108 from above and 1/2 + 5 sqrt 2/108 from below.
//
// Checked      theorem_4_inverses: the inverse and its norm as identities in f, R, M(f), q and rho. Rejected:
//              1 + q for 1 - q; the norm for rho + q with q other than rho. theorem_4_continuous: the jump at
//              points of the side, by the library's charts and basis, enclosed; at alpha = 0, and for a
//              constant rho, there is none. Rejected: a rho that jumps itself, alpha = 0.
// Not checked  other surfaces; rho that varies, as far as the inverses go.

#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "verification/claims/m06/rank_one_inverse.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// (1 - q) [1 + R/(1 - q)] - 1: zero for R = q.
Rational terms_of_norm(bool constant) {
  const Polynomial q = Polynomial::variable("q");
  const Polynomial r = constant ? q : Polynomial::variable("R");
  return differing_terms((1 - q) + r, 1);
}

// rho = (2 + z^3)/4, a constant 1/2, or 1/4 above and 1/2 below z = 0.
enum class Reflectivity { varying, constant, jumping };

// P_n rho on the side z = 0 of the octant above it less that of the octant below, at x + y = 1 and y = t
// before both are taken to the sphere.
Ball jump(Reflectivity kind, const Rational& alpha, const Rational& t) {
  const Surface surface = sphere();
  const InsetBasis<Ball> basis(1, Ball(alpha));
  std::vector<Ball> values(basis.size());
  // (s,t) of a chart is (y,z), which are the coordinates x_3 and x_2.
  basis.values(Barycentric<Ball>{{Ball(1 - t), Ball(0), Ball(t)}}, std::span<Ball>(values));
  const auto interpolant = [&](std::size_t chart) {
    Ball sum = 0;
    const std::vector<Barycentric<Ball>> nodes = basis.nodes();
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Ball z = surface.charts[chart].in<Ball>().frame({nodes[j].x[2], nodes[j].x[1]}).point.z;
      Ball rho = Ball(Rational(1, 2));
      if (kind == Reflectivity::varying) rho += z * z * z / Ball(4);
      if (kind == Reflectivity::jumping && chart == 0) rho = Ball(Rational(1, 4));
      sum += rho * values[j];
    }
    return sum;
  };
  constexpr std::size_t below = 4;  // octant_ppm, as octant_ppp is the first
  return interpolant(0) - interpolant(below);
}

}  // namespace

Finding theorem_4_inverses(const Bench&) {
  const IsExactly none{0};
  Finding finding;
  finding.require("terms of (I - P_n K)(f + R M(f)/(1 - q)) - f, unit sphere", none,
                  terms_of_right_inverse(-1));
  finding.control("the same for f + R M(f)/(1 + q)", none, terms_of_right_inverse(1));
  finding.require("terms of Y (I - P_n K) f - f, Y g = g + R M(g)/(1 - q)", none, terms_of_left_inverse(-1));
  finding.control("the same for Y g = g + R M(g)/(1 + q)", none, terms_of_left_inverse(1));
  finding.require("terms of (1 - rho)(1 + rho/(1 - rho)) - 1", none, terms_of_norm(true));
  finding.control("terms of (1 - q)(1 + R/(1 - q)) - 1, R other than q", none, terms_of_norm(false));
  return finding;
}

Finding theorem_4_continuous(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith zero{.value = Ball(0), .within = 1e-25};
  const Rational sixth(1, 6);
  Finding finding;
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(3, 4)}) {
    const std::string at = ", t = " + t.to_text();
    finding.require("jump of P_n K 1 across z = 0, rho = (2 + z^3)/4, alpha = 1/6" + at, zero,
                    jump(Reflectivity::varying, sixth, t));
    finding.instead("that jump and 5 sqrt 2/54" + at, zero,
                    jump(Reflectivity::varying, sixth, t) + Ball(5) * sqrt(Ball(2)) / Ball(54));
    finding.instead("jump of P_n K 1, rho = (2 + z^3)/4, alpha = 0" + at, zero,
                    jump(Reflectivity::varying, 0, t));
  }
  finding.instead("jump of P_n K 1, rho = 1/2, alpha = 1/6", zero,
                  jump(Reflectivity::constant, sixth, Rational(1, 2)));
  finding.control("jump of P_n K 1, alpha = 0, rho = 1/4 above and 1/2 below", zero,
                  jump(Reflectivity::jumping, 0, Rational(1, 2)));
  finding.show(proved(jump(Reflectivity::varying, sixth, Rational(1, 2))));
  return finding;
}

}  // namespace radcert::verification::m06
