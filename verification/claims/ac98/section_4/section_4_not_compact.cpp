// SPDX-License-Identifier: GPL-3.0-or-later

// No power of K is compact on (20). Let rho = 1 and f_e = 1 on the strip e <= eta <= 2e of either square, 0
// elsewhere. Functions of the distance from the edge alone are taken, up to the ends, by the kernel of the
// infinite wedge,
//     (1/pi) Int z eta dxi/[(xi-x)^2 + eta^2 + z^2]^2 <= (1/2) z eta/(eta^2 + z^2)^(3/2),
// under which eta^a becomes lambda(a) z^a, lambda(a) = B((a+2)/2,(1-a)/2)/4, and lambda(1/2) < 1.
// From above: f_e <= (eta/e)^(1/2), so that K^j f_e <= lambda^j (z/e)^(1/2): at z = d with d much less than e
// it is small, and so it is far from K^j f_d, as from below: on the strip of e, for |x - 1/2| <= 1/2 - jL,
// K^j f_e >= c^j with
//     c = min over e <= z <= 2e of (1/pi) Int_e^2e Int_(|xi-x| <= L) G,
// which for e <= e_0 is at least what it is at e_0, by (xi, eta, z) = e (...): L/e grows. With e_k = e_0
// 2^(-Mk) no two of the functions K^j f_(e_k), all bounded by 1, are nearer than c^j - lambda^j 2^(-M/2) > 0
// for M large: no subsequence converges. For rho > 0 constant both sides carry rho^j.
//
// Checked      lambda(1/2) and c by balls, c for all z of the strip at once and L/e = 16; the distances for
//              all j at once, with M = 16 j, as c > lambda/256; and that between two parallel squares at the
//              distance 1 the same strips do give what tends to 0, as where K is compact.
// Not checked  closed surfaces: beside an edge their K has this part.

#include <string>

#include "radcert/closed_form/two_squares.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/functions/beta_function.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Int eta z dxi/(xi^2 + r^2)^2 over |xi| <= L, r^2 = eta^2 + z^2: xi/(2 r^2 (xi^2 + r^2)) + atan(xi/r)/(2
// r^3) is the antiderivative.
Ball strip_kernel(const Ball& eta, const Ball& z, const Ball& reach) {
  const Ball square = eta * eta + z * z;
  const Ball r = sqrt(square);
  return eta * z * (reach / (square * (reach * reach + square)) + atan(reach / r) / (square * r));
}

// The same between two parallel planes at the distance 1: G = 1/(xi^2 + (eta - z)^2 + 1)^2.
Ball parallel_kernel(const Ball& eta, const Ball& z, const Ball& reach) {
  const Ball square = (eta - z) * (eta - z) + Ball(1);
  const Ball r = sqrt(square);
  return reach / (square * (reach * reach + square)) + atan(reach / r) / (square * r);
}

// (1/pi) Int over 1 <= eta <= 2 of the kernel scaled to e = 1, for z in a ball: panels with the hull of the
// values.
template <class Kernel>
Ball over_the_strip(const Kernel& kernel, const Ball& z) {
  constexpr long panels = 64;
  Ball sum(0);
  for (long i = 0; i < panels; ++i)
    sum = sum + kernel(hull(Ball(1 + Rational(i, panels)), Ball(1 + Rational(i + 1, panels))), z);
  return sum / (Ball(panels) * Ball::pi());
}

// The least over 1 <= z <= 2.
template <class Kernel>
Ball least_on_the_strip(const Kernel& kernel) {
  constexpr long parts = 64;
  Ball least = over_the_strip(kernel, hull(Ball(1), Ball(1 + Rational(1, parts)))).lower();
  for (long i = 1; i < parts; ++i)
    least = min(
        least,
        over_the_strip(kernel, hull(Ball(1 + Rational(i, parts)), Ball(1 + Rational(i + 1, parts)))).lower());
  return least;
}

}  // namespace

Finding section_4_not_compact(const Bench&) {
  const BallPrecision precision(96);
  Finding finding;
  const AtMost apart{
      .value = -1e-6, .slack = 0, .why = "functions that stay apart have no convergent subsequence"};
  const Ball reach(16);  // L/e: any e <= e_0 = L/16
  const Ball c =
      least_on_the_strip([&](const Ball& eta, const Ball& z) { return strip_kernel(eta, z, reach); });
  const Ball lambda = beta_function(Ball(Rational(5, 4)), Ball(Rational(1, 4))) / Ball(4);
  finding.require("lambda(1/2) - 1", AtMost{}, proved(lambda - Ball(1)));
  finding.control("lambda(9/10) - 1", AtMost{},
                  proved(beta_function(Ball(Rational(29, 20)), Ball(Rational(1, 20))) / Ball(4) - Ball(1)));
  // c > lambda 2^-8 >= 0 gives c^j > (lambda 2^-8)^j for every power j.
  finding.require("-(c - lambda(1/2) 2^-8), the distance of K^j f_e and K^j f_d for d = e 2^(-16 j), j = 1",
                  apart, proved(-(c - lambda * power(Ball(2), -8))));
  for (int j = 1; j <= 4; ++j)
    finding.remark("the lower bound c^j of K^j f_e on its strip, j = " + std::to_string(j),
                   proved(power(c, j)));
  // Between parallel squares the strip of width e has the value e c at most: nothing is left as e -> 0.
  const Ball thin = power(Ball(2), -60);
  finding.control("-(the value on the strip for parallel squares), e = 2^-60", apart,
                  proved(-(thin * parallel_kernel(Ball(0), Ball(0), Ball(1)) / Ball::pi())));
  finding.show(proved(c));
  return finding;
}

Finding section_2_2_unbounded_kernel(const Bench&) {
  Finding finding;
  const Vector<Rational> up_y{0, 1, 0};
  const Vector<Rational> up_z{0, 0, 1};
  // G by (2) at P = (1/2,0,z), Q = (1/2,eta,0), and times |P-Q|^2, which leaves the first fraction.
  const auto kernel = [&](const Rational& eta, const Rational& z) {
    const Rational half(1, 2);
    return geometric_kernel<Rational>({half, 0, z}, up_y, {half, eta, 0}, up_z);
  };
  const auto first_fraction = [&](const Rational& eta, const Rational& z) {
    return kernel(eta, z) * (eta * eta + z * z);
  };
  const auto quarter = [](const Rational&, const Rational&, const Rational& z) { return 1 / (4 * z * z); };
  const auto half = [](const Rational&, const Rational&, const Rational&) { return Rational(1, 2); };
  finding.require(
      "points z = eta where G differs from 1/(4 z^2)", IsExactly{0},
      differing_points([&](const Rational&, const Rational&, const Rational& z) { return kernel(z, z); },
                       quarter));
  finding.require(
      "points z = eta where the first fraction differs from 1/2", IsExactly{0},
      differing_points(
          [&](const Rational&, const Rational&, const Rational& z) { return first_fraction(z, z); }, half));
  // 1/(4 z^2) exceeds M at z = 1/(2M + 1), as (2M + 1)^2 - 4M = 4M^2 + 1.
  finding.require(
      "points where 1/(4 z^2) - M at z = 1/(2M + 1) differs from M^2 + 1/4", IsExactly{0},
      differing_points(
          [&](const Rational&, const Rational& m, const Rational&) {
            const Rational z = 1 / (2 * m + 1);
            return kernel(z, z) - m;
          },
          [](const Rational&, const Rational& m, const Rational&) { return m * m + Rational(1, 4); }));
  finding.control(
      "points where G at eta = 2z differs from 1/(4 z^2)", IsExactly{0},
      differing_points([&](const Rational&, const Rational&, const Rational& z) { return kernel(2 * z, z); },
                       quarter));
  finding.control("points where the first fraction at eta = 2z differs from 1/2", IsExactly{0},
                  differing_points([&](const Rational&, const Rational&,
                                       const Rational& z) { return first_fraction(2 * z, z); },
                                   half));
  return finding;
}

}  // namespace radcert::verification::ac98
