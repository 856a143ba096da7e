// SPDX-License-Identifier: GPL-3.0-or-later

// lemma_2_3_kernel_derivative: on a curved piece |P-Q| |dG/dP| is bounded, though G itself has no limit as Q
// nears P. section_2_compact: with the C of lipschitz_bound, |Ku(P) - Ku(P')| <= (C/pi) |P - P'| norm of u on
// each piece, for rho = 1: the images of the unit ball of C(S) are bounded and equicontinuous, so that K is
// compact on C(S), by Arzela and Ascoli; multiplication by a continuous rho is bounded. On L^2(S), Int Int
// G^2 <= c^2 area^2 with the c of (6): K is a Hilbert-Schmidt operator. equation_46_operator: K P_n g = sum
// g(v_i) w_i with w_i = K l_i, l_i being 0 beyond its element: the same C bounds the differences of w_i, as
// it does for every bounded function, continuous or not, so that K P_n takes C(S) into C(S).
// theorem_3_1_collectively_compact: |K P_n g(P) - K P_n g(P')| <= (C/pi) norm of P_n |P - P'| for all n and
// all g of the unit ball, norm of P_n = (1 + alpha)/(1 - 3 alpha) by equation_37. As P_n takes constants to
// themselves, |g - P_n g| <= (1 + norm of P_n) omega, omega the largest difference of values of g within one
// element, which tends to 0 with h for continuous g: K P_n g tends to K g. Not so in the norm: with g = 1 at
// the nodes and -1 but close to them norm of K P_n - K is at least that of K.
//
// Checked      on two_piece(p), p = 2, 3: the derivatives of G as typed in, against those of the kernel by
//              differences; their bounds, for all pairs, and at pairs as close as 2^-40; the quotients of K 1
//              at pairs of points against C. Across the edge of (20), where |dG/dP| is 1/(4 z^3) and K 1 has
//              no limit at the ends of the edge, the same bounds are exceeded; and |P-Q|^(1/2) |dG/dP| is not
//              bounded.
// Not checked  other surfaces.

#include <array>

#include "radcert/closed_form/two_squares.h"
#include "verification/claims/ac98/compactness/kernel_derivative.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/roof_pair.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

struct Pair {
  Rational x;
  Rational d;
  Rational e;
};

// G on the roof at (x + s, y + t), by (2) with the coordinates of the points alone.
Ball kernel_of_points(int p, const Pair& at, const Rational& s, const Rational& t) {
  const Ball x(at.x + s);
  const Ball xi(at.x + at.d);
  const Ball rise = power(x, p) - power(xi, p);
  const auto outward = [p](const Ball& where) { return Ball(p) * power(where, p - 1); };
  const Ball d = xi - x;
  const Ball e(at.e - t);
  const Ball square = d * d + e * e + rise * rise;
  const Ball from_p = -(d * outward(x) + rise);
  const Ball from_q = d * outward(xi) + rise;
  return from_p * from_q / (RoofPair<Ball>::stretch(p, x) * RoofPair<Ball>::stretch(p, xi) * square * square);
}

RoofKernel at_pair(int p, const Pair& at) {
  return roof_kernel(p, Ball(at.x), Ball(at.x + at.d), Ball(at.e));
}

// |P-Q|, in the parameters.
Ball distance(const Pair& at) { return sqrt(Ball(at.d * at.d + at.e * at.e)); }

Ball steepness(const RoofKernel& k) { return abs(k.by_x) + abs(k.by_y); }

void require_derivatives(Finding& finding, int p, const std::string& of) {
  const BallPrecision precision(512);
  const Rational step = 1 / power(Rational(2), 80);
  const Pair at{.x = Rational(1, 3), .d = Rational(2, 5), .e = Rational(-1, 7)};
  const RoofKernel typed = at_pair(p, at);
  const auto difference = [&](int exponent, const Rational& s, const Rational& t) {
    return (kernel_of_points(exponent, at, s, t) - kernel_of_points(exponent, at, -s, -t)) / Ball(2 * step);
  };
  const auto shift = [&](const Rational& t) {
    return (at_pair(p, {.x = at.x, .d = at.d, .e = at.e - t}).by_x -
            at_pair(p, {.x = at.x, .d = at.d, .e = at.e + t}).by_x) /
           Ball(2 * step);
  };
  const auto close = [](const Ball& value) { return AgreesWith{.value = value, .within = 1e-30}; };
  finding.require("G of roof_pair.h, against (2) with the points' coordinates" + of, close(typed.g),
                  kernel_of_points(p, at, 0, 0));
  finding.require("its derivative by x, against differences" + of, close(typed.by_x), difference(p, step, 0));
  finding.require("its derivative by y, against differences" + of, close(typed.by_y), difference(p, 0, step));
  finding.require("its mixed derivative, against differences of that by x" + of, close(typed.by_x_and_y),
                  shift(step));
  finding.control("the derivative by x, against differences for the roof of two_piece(p + 2)" + of,
                  close(typed.by_x), difference(p + 2, step, 0));
}

// |P-Q| |dG/dP| for P = (1/2,0,z), Q = (1/2,z,0) of (20): G_z = -1/(4 z^3).
Ball across_the_edge(const Rational& z) { return sqrt(Ball(2)) / Ball(4 * z * z); }

std::vector<Pair> close_pairs() {
  std::vector<Pair> pairs;
  for (const int halvings : {1, 10, 40}) {
    const Rational r = 1 / power(Rational(2), halvings);
    for (const auto& [c, s] : {std::array<Rational, 2>{1, 0},
                               {Rational(3, 5), Rational(4, 5)},
                               {Rational(4, 5), Rational(-3, 5)},
                               {0, 1}})
      pairs.push_back({.x = Rational(1, 3), .d = r * c, .e = r * s});
  }
  return pairs;
}

// That the image of the unit ball is equicontinuous, with C.
void require_equicontinuity(Finding& finding) {
  for (const int p : {2, 3}) {
    const std::string of = ", two_piece(" + std::to_string(p) + ")";
    require_derivatives(finding, p, of);
    const Ball bound = lipschitz_bound(p);
    for (const auto& [x, other] : {std::array<Rational, 2>{Rational(1, 3), Rational(1, 2)},
                                   {Rational(1, 3), Rational(1, 3) + Rational(1, 1024)},
                                   {0, 1}}) {
      const std::string at = ", x = " + x.to_text() + " and " + other.to_text() + of;
      const Ball apart(other - x);
      finding.require("difference of Int G over the distance, on the roof, less C" + at, AtMost{},
                      proved(abs(total_of_roof(p, x, 1e-7) - total_of_roof(p, other, 1e-7)) / apart - bound));
      finding.require(
          "the same on the square" + at, AtMost{},
          proved(abs(total_of_square(p, x, 1e-7) - total_of_square(p, other, 1e-7)) / apart - bound));
    }
    // (22) tends to (pi - atan k)/2 along z = k x: the values at (x, z) and (x, 4z) stay apart.
    const Rational x = 1 / power(Rational(2), 40);
    const auto one = [&](const Rational& z) { return TwoSquares<Ball>(Ball(x), Ball(z)).one(); };
    finding.control("the same between (x,0,x) and (x,0,4x) of (20), x = 2^-40, less C" + of, AtMost{},
                    proved(abs(one(x) - one(4 * x)) / Ball(3 * x) - bound));
    finding.remark("C" + of, proved(bound));
  }
}

}  // namespace

Finding lemma_2_3_kernel_derivative(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  for (const int p : {2, 3}) {
    const std::string of = ", two_piece(" + std::to_string(p) + ")";
    require_derivatives(finding, p, of);
    const Ball bound = roof_derivative_bounds(p).first;
    for (const Pair& at : close_pairs())
      finding.require("|P-Q| |dG/dP| at d = " + at.d.to_text() + ", e = " + at.e.to_text() +
                          ", less its bound for all pairs" + of,
                      AtMost{}, proved(distance(at) * steepness(at_pair(p, at)) - bound));
    const Pair closest = close_pairs().at(9);
    finding.control("|P-Q|^(1/2) |dG/dP| at the distance 2^-40, less that bound" + of, AtMost{},
                    proved(sqrt(distance(closest)) * steepness(at_pair(p, closest)) - bound));
    finding.control("|P-Q| |dG/dP| across the edge of (20), z = 2^-10, less that bound" + of, AtMost{},
                    proved(across_the_edge(Rational(1, 1024)) - bound));
    finding.remark("bound of |P-Q| |dG/dP| for all pairs" + of, proved(bound));
  }
  finding.show(proved(roof_derivative_bounds(2).first));
  return finding;
}

Finding section_2_compact(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  require_equicontinuity(finding);
  finding.show(proved(lipschitz_bound(2)));
  return finding;
}

Finding equation_46_operator(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  require_equicontinuity(finding);
  return finding;
}

Finding theorem_3_1_collectively_compact(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  require_equicontinuity(finding);
  // P_n takes constants to themselves: sum (x_i - alpha) = 1 - 3 alpha where the x_i sum to 1.
  using Three = std::array<Rational, 3>;
  const auto sum = [](long insets) {
    return [insets](const Three& x) { return x[0] + x[1] + (1 - x[0] - x[1]) - insets * x[2]; };
  };
  const auto denominator = [](const Three& x) { return 1 - 3 * x[2]; };
  finding.require("points where the numerators of the l_i do not sum to 1 - 3 alpha", IsExactly{0},
                  differing_on_grid<3>(3, sum(3), denominator));
  finding.control("points where two of them and the third coordinate do not", IsExactly{0},
                  differing_on_grid<3>(3, sum(2), denominator));
  // g = 1 at the nodes and -1 but close to them: K P_n g - K g = 2 K 1, up to as little as is wanted.
  for (const int p : {2, 3})
    finding.control("norm of K P_n - K, at least K 1 in the middle of the roof, less 1/100, two_piece(" +
                        std::to_string(p) + ")",
                    AtMost{},
                    proved(total_of_roof(p, Rational(1, 2), 1e-7) / Ball::pi() - Ball(Rational(1, 100))));
  return finding;
}

}  // namespace radcert::verification::ac98
