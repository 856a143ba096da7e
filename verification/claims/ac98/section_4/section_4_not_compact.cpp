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
// Checked      lambda(1/2) and c by balls, c for all z of the strip at once and L/e = 16; the distances for j
//              = 1 to 4, with M = 16 j; and that between two parallel squares at the distance 1 the same
//              strips do give what tends to 0, as where K is compact.
// Not checked  closed surfaces: beside an edge their K has this part.

#include <string>

#include "radcert/closed_form/two_squares.h"
#include "radcert/scalar/functions/beta_function.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
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
  for (int j = 1; j <= 4; ++j) {
    const Ball distance = power(c, j) - power(lambda, j) * power(Ball(2), -8 * j);
    finding.require(
        "-(distance of K^j f_e and K^j f_d in the maximum norm), d = e 2^(-16 j), j = " + std::to_string(j),
        apart, proved(-distance));
    finding.remark("the lower bound c^j of K^j f_e on its strip, j = " + std::to_string(j),
                   proved(power(c, j)));
  }
  // Between parallel squares the strip of width e has the value e c at most: nothing is left as e -> 0.
  const Ball thin = power(Ball(2), -60);
  finding.control("-(the value on the strip for parallel squares), e = 2^-60", apart,
                  proved(-(thin * parallel_kernel(Ball(0), Ball(0), Ball(1)) / Ball::pi())));
  finding.show(proved(c));
  return finding;
}

Finding section_2_2_unbounded_kernel(const Bench&) {
  Finding finding;
  const Rational half(1, 2);
  Rational differing = 0;
  Rational differing_fraction = 0;
  for (long k = 1; k <= 60; k += 7) {
    const Rational z = 1 / power(Rational(2), k);
    const Rational g = two_squares_kernel<Rational>(half, z, half, z);
    if (g != 1 / (4 * z * z)) differing += 1;
    if (z * z / (z * z + z * z) != half) differing_fraction += 1;
  }
  finding.require("z = eta for which G is not 1/(4 z^2)", IsExactly{0}, differing);
  finding.require("z = eta for which z eta/(eta^2 + z^2) is not 1/2", IsExactly{0}, differing_fraction);
  Rational elsewhere = 0;
  for (long k = 1; k <= 60; k += 7) {
    const Rational z = 1 / power(Rational(2), k);
    if (two_squares_kernel<Rational>(half, z, half, half) != 1 / (4 * z * z)) elsewhere += 1;
  }
  finding.control("z for which G at eta = 1/2 is not 1/(4 z^2)", IsExactly{0}, elsewhere);
  return finding;
}

}  // namespace radcert::verification::ac98
