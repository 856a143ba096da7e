// SPDX-License-Identifier: GPL-3.0-or-later

// On the unit sphere K P_n g = rho M_n(g), M_n(g) = sum w_i g(v_i) the mean of P_n g. The weights of an
// element T of the plane x + y + z = 1, which x/|x| takes to the octant, are positive multiples of Int_T (x_j
// - alpha) |x|^-3 dA, x_j a barycentric coordinate of T. In the octant 1 <= |x|^-3 <= 3 sqrt 3. Over a
// triangle of area 1 the values of x_j have the density 2(1 - x), so that the negative part of x_j - alpha
// has the integral N = Int_0^alpha (alpha - x) 2(1 - x) dx = alpha^2 - alpha^3/3 and the positive one 1/3 -
// alpha + N: every weight is positive where
//     1/3 - alpha + (1 - 3 sqrt 3) N > 0,
// which all 0 <= alpha <= 1/6 fulfil, whatever the triangles and their number. So |M_n(g)| <= norm of g, and
// M_n(rho) <= norm of rho: I - K P_n has the inverse g + rho M_n(g)/(1 - M_n(rho)), whose norm is at most
// 1/(1 - norm of rho), for every n, and equal to it for constant rho.
//
// Checked      the inequality, for all alpha of [0, 1/6] by Sturm's theorem, with 1733/1000 > sqrt 3; it
//              fails before alpha = 1/4. N by its second derivative. The inverse and its norm, as identities
//              of rational functions, sphere_algebra.h, with M_n in the place of the mean. By the closed
//              forms of the weights, in balls: the norm for rho = 9/10 on six levels.
// Not checked  surfaces other than the sphere; alpha > 1/6, where the norm may exceed 1/(1 - rho).

#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/polynomial/real_zeros.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/ac98/surfaces/sphere_algebra.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// 0 where p > 0 on the whole of 0 <= alpha <= last, else 1.
Rational not_positive(const RationalPolynomial& p, const Rational& last) {
  return {zeros_between(p, 0, last) == 0 && p(0).sign() > 0 ? 0 : 1};
}

}  // namespace

Finding theorem_3_1_inverses(const Bench&) {
  const BallPrecision precision(256);
  Finding finding;
  require_solution_on_the_sphere(finding);
  require_norm_of_the_solution(finding);
  const RationalPolynomial alpha = RationalPolynomial::variable();
  const RationalPolynomial negative = alpha * alpha - Rational(1, 3) * alpha * alpha * alpha;
  const bool is_that_integral = negative(0).sign() == 0 && negative.derivative()(0).sign() == 0 &&
                                negative.derivative().derivative() == 2 * (1 - alpha);
  finding.require("1 where N is not the integral of the negative part of x_j - alpha", IsExactly{0},
                  Rational(is_that_integral ? 0 : 1));
  const Rational root(1733, 1000);
  const auto below_the_root = [](const Rational& bound) { return Rational(bound * bound > 3 ? 0 : 1); };
  finding.require("1 where 1733/1000 is not above sqrt 3", IsExactly{0}, below_the_root(root));
  finding.control("1 where 1732/1000 is not above sqrt 3", IsExactly{0},
                  below_the_root(Rational(1732, 1000)));
  const RationalPolynomial least = Rational(1, 3) - alpha + (1 - 3 * root) * negative;
  finding.require("1 where a weight may be negative for 0 <= alpha <= 1/6", IsExactly{0},
                  not_positive(least, Rational(1, 6)));
  finding.control("1 where a weight may be negative for 0 <= alpha <= 1/4", IsExactly{0},
                  not_positive(least, Rational(1, 4)));
  const Rational rho(9, 10);
  const auto norm_of_inverse = [&](int level, const Rational& inset) {
    return Ball(1) + Ball(rho / (1 - rho)) * SphereCollocation(symmetric_octant(level), inset).weight_sum();
  };
  const AgreesWith bound{.value = Ball(1 / (1 - rho)), .within = 1e-30};
  for (const Rational& inset : {Rational(1, 6), Rational(1, 10), Rational(0)})
    for (int level = 0; level <= 5; ++level)
      finding.require("norm of (I - K P_n)^-1, sphere, rho = 9/10, alpha = " + inset.to_text() + ", level " +
                          std::to_string(level),
                      bound, norm_of_inverse(level, inset));
  finding.control("the same, alpha = 333/1000, level 2", bound, norm_of_inverse(2, Rational(333, 1000)));
  finding.show(proved(norm_of_inverse(5, Rational(1, 6))));
  return finding;
}

}  // namespace radcert::verification::ac98
