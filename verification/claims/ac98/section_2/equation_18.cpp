// SPDX-License-Identifier: GPL-3.0-or-later

// G >= 0, so that (I - K)^-1 = sum K^n is positive and its norm N is the largest value of U = (I - K)^-1 1 =
// 1 + KU <= 1/(1 - k), k the norm of K. On two_piece(p) with rho = 1: let m be the largest value of K1 on the
// square, less than k, and f the largest over the roof of the part of K1 that comes from the roof. The square
// sees the roof alone, U <= c = 1 + m/(1 - k) there, and on the roof
//     U <= 1 + c (K1 - its part from the roof) + (its part from the roof)/(1 - k)
//       <= 1 + c k + (1/(1 - k) - c) f,
// which is less than 1/(1 - k): (18) is no equality there. From below N >= max of 1 + K1 + K(K1) >=
// 1 + k + k l, l the least value of K1, at least half of the least one at y = 1/2.
//
// Checked      two_piece(2), rho = 1: N between these bounds, against (18), and against 1 + norm of K, which
//              is too little; against (18) with m for k, which leaves out the roof's own light. On the
//              sphere, where K u = rho M(u) with the mean M: (I - K)^-1 1 = 1 + rho/(1 - M(rho)) exactly,
//              with 1/(1 - norm of rho) reached by every constant rho and not by one that varies: the bound
//              is sharp. That these solve the equation of the library's charts is the check of (1).
// Not checked  other surfaces.

#include <algorithm>

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// The norm of (I - K)^-1 on two_piece(p) for rho = 1.
Ball norm_of_the_inverse(int p, const Ball& norm, double radius) {
  const Ball one(1);
  const Ball of_square = largest_total_of_square(p, radius) / Ball::pi();
  const Ball to_itself = largest_roof_to_roof(p, radius) / Ball::pi();
  const Ball least = least_total_in_the_middle(p, radius) / (Ball(2) * Ball::pi());
  const Ball most = reciprocal(one - norm);
  const Ball on_square = one + of_square * most;
  const Ball on_roof = one + on_square * norm + (most - on_square) * to_itself;
  return hull((one + norm + norm * least).lower(), max(on_square, on_roof).upper());
}

}  // namespace

Finding equation_18(const Bench& bench) {
  // The bounds are 0.02 apart from each other and 0.0025 from (18).
  const double radius = bench.budget == Budget::full ? 1e-6 : 1e-4;
  const BallPrecision precision(128);
  Finding finding;
  const Ball norm = largest_total(2, radius) / Ball::pi();
  const Ball inverse = norm_of_the_inverse(2, norm, radius);
  const std::string on_two_piece = ", two_piece(2), rho = 1";
  finding.require("norm of the inverse - 1/(1 - norm of K)" + on_two_piece, AtMost{},
                  proved(inverse - Ball(1) / (Ball(1) - norm)));
  finding.control("norm of the inverse - (1 + norm of K)" + on_two_piece, AtMost{},
                  proved(inverse - (Ball(1) + norm)));
  const Ball of_square = largest_total_of_square(2, radius) / Ball::pi();
  finding.control("norm of the inverse - 1/(1 - the largest value of K1 on the square)" + on_two_piece,
                  AtMost{}, proved(inverse - Ball(1) / (Ball(1) - of_square)));
  const RationalPolynomial w = RationalPolynomial::variable();
  const auto inverse_norm = [](const RationalPolynomial& rho) {
    return largest_of_linear(sphere_solution("", 1, rho).solution);
  };
  for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(999, 1000)})
    finding.require("norm of the inverse, sphere, rho = " + rho.to_text(), IsExactly{1 / (1 - rho)},
                    inverse_norm(rho));
  const RationalPolynomial varying = Rational(1, 4) * (1 + w);
  const Rational bound = 1 / (1 - largest_of_linear(varying));
  finding.require("norm of the inverse - 1/(1 - norm of K), sphere, rho = (1 + z^2)/4", AtMost{},
                  proved(Ball(inverse_norm(varying) - bound)));
  finding.control("norm of the inverse, sphere, rho = (1 + z^2)/4, against equality", IsExactly{bound},
                  inverse_norm(varying));
  finding.show(proved(inverse));
  return finding;
}

}  // namespace radcert::verification::ac98
