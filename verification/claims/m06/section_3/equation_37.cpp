// SPDX-License-Identifier: GPL-3.0-or-later

// (37) without its factor is the sum over j = 0, 1, 2 of the integrals of |v_i - Q|^-j over S less the node's
// element. In the plane, over h < |v_i - Q| < 1: pi (1 - h^2) + 2 pi (1 - h) + 2 pi |log h|. The page has "of
// order h^2 + h + log h" instead, what is missing from the first two; that is smaller than |log h| + 1 for
// small h only by bounded terms, so that O(h^(r+3) |log h|) stands.
//
// Checked      the three integrals, enclosed, against their closed forms, h = 1/4 to 2^-16; their sum over
//              |log h| falls to 2 pi, and over h^2 + h + |log h| is below 8 pi, h <= 1/4; the printed first
//              term h^2 alone is no bound of the first integral.
// Not checked  other shapes of the element that is left out, and the local representation of the surface:
// both change constants.

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// 2 pi Int_h^1 distance^(1-j).
Ball integral(int j, const Rational& h) {
  const auto f = line_function([j]<class R>(const R& x) -> R {
    return j == 0 ? x : j == 1 ? R(1) : R(1) / x;
  });
  return Ball(2) * Ball::pi() * ac98::known(integral_on_interval(f, Ball(h), Ball(1), {.radius = 1e-25}));
}

}  // namespace

Finding equation_37(const Bench&) {
  const BallPrecision precision(128);
  Finding finding;
  for (const int k : {2, 4, 8, 16}) {
    const Rational h = 1 / power(Rational(2), k);
    const std::string at = ", h = 2^-" + std::to_string(k);
    const Ball log_h = -log(Ball(h));
    const Ball sum = integral(0, h) + integral(1, h) + integral(2, h);
    const AgreesWith closed{.value = Ball::pi() * (Ball(1 - h * h) + Ball(2 - 2 * h) + Ball(2) * log_h),
                            .within = 1e-20};
    finding.require("sum of the three integrals" + at, closed, sum);
    finding.control("the same without the third" + at, closed, integral(0, h) + integral(1, h));
    const AtMost order{.value = 0, .slack = 0, .why = ""};
    finding.require("sum less 8 pi |log h|" + at, order, ac98::proved(sum - Ball(8) * Ball::pi() * log_h));
    finding.control("first integral less 8 pi h^2" + at, order,
                    ac98::proved(integral(0, h) - Ball(8) * Ball::pi() * Ball(h * h)));
  }
  return finding;
}

}  // namespace radcert::verification::m06
