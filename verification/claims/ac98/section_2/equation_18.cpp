// SPDX-License-Identifier: GPL-3.0-or-later

// G >= 0, so that (I - K)^-1 = sum K^n is positive and its norm is that of (I - K)^-1 1.
//
// Checked      on the sphere, where K u = rho M(u) with the mean M: (I - K)^-1 1 = 1 + rho/(1 - M(rho))
//              exactly, with 1/(1 - norm of rho) reached by every constant rho and not by one that varies:
//              the bound is sharp. On two_piece(2), rho = 1, with the norm of K enclosed: the norm of the
//              inverse is at least that of 1 + K 1, so that 1 + norm of K <= it <= (18). That these solve the
//              equation of the library's charts is the check of (1).
// Not checked  other surfaces.

#include "verification/claims/ac98/collocation/sphere_solution.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding equation_18(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-3 : bench.budget == Budget::standard ? 1e-4 : 1e-6;
  const BallPrecision precision(128);
  Finding finding;
  const RationalPolynomial w = RationalPolynomial::variable();
  const auto inverse_norm = [](const RationalPolynomial& rho) {
    return largest_of_linear(sphere_solution("", 1, rho).solution);
  };
  for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(999, 1000)}) {
    const std::string with = ", sphere, rho = " + rho.to_text();
    const Rational norm = inverse_norm(rho);
    finding.require("norm of the inverse" + with, IsExactly{1 / (1 - rho)}, norm);
    finding.require("norm of the inverse - 1/(1 - norm of K)" + with, AtMost{},
                    proved(Ball(norm - 1 / (1 - rho))));
    finding.control("norm of the inverse, against 1 + norm of K" + with, IsExactly{1 + rho}, norm);
    finding.control("norm of the inverse - (1 + norm of K)" + with, AtMost{}, proved(Ball(norm - 1 - rho)));
  }
  const RationalPolynomial varying = Rational(1, 4) * (1 + w);
  finding.require("norm of the inverse - 1/(1 - norm of K), sphere, rho = (1 + z^2)/4", AtMost{},
                  proved(Ball(inverse_norm(varying) - 1 / (1 - largest_of_linear(varying)))));
  const Ball norm = largest_total(2, radius) / Ball::pi();
  finding.require("1 + norm of K - 1/(1 - norm of K), two_piece(2), rho = 1", AtMost{},
                  proved(Ball(1) + norm - Ball(1) / (Ball(1) - norm)));
  finding.show(proved(Ball(1) / (Ball(1) - norm)));
  return finding;
}

}  // namespace radcert::verification::ac98
