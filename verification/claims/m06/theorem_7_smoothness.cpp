// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 7 asks for u in C^(r+2), Lemma 5, on which it rests, for C^(r+3). On a square cut into cells with
// sides h let u_h = h^(r+2) cos(2 pi x/h): its derivatives up to the order r + 2 are bounded by (2 pi)^(r+2),
// whatever h. In every cell (I - L) u_h has the same integral, h^2 h^(r+2) m, and so the error at a node v of
// another piece is h^(r+2) m Int G(v,Q) dS_Q + O(h^(r+3)). Were the error O(h^(r+3) |log h|) for each u in
// C^(r+2), with h = 1/2, 1/4, ..., it would be so uniformly on the unit ball of C^(r+2), by the theorem of
// Banach and Steinhaus. So there is a u in C^(r+2) for which (36) fails.
//
// Checked      m is not zero, r = 1 and 3 at alpha_0, and the integrals of (I - L) u_h over the square for h
//              = 1/4 to 1/32 fall like h^(r+2), enclosed; likewise h^(r+1) for the functions with r + 1
//              bounded derivatives. With r + 3 they fall like h^(r+3).
// Not checked  such a u itself: it is not named.

#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// The integral over the unit square of (I - L) u, u = h^k cos(2 pi x/h), h = 1/cells: of u it is zero.
Ball left_over(int r, const Rational& alpha, int k, long cells) {
  const InsetFamily family(r);
  const Ball two_pi = Ball(2) * Ball::pi();
  Ball of_a_cell = 0;
  for (std::size_t j = 0; j < family.size(); ++j) {
    const Rational s = family.node(j)[2](alpha);
    const Ball weight(family.weight(j)(alpha));
    // The node s of one half and 1 - s of the other, in units of h.
    of_a_cell -= weight * (cos(two_pi * Ball(s)) + cos(two_pi * Ball(1 - s)));
  }
  return of_a_cell * power(Ball(Rational(1, cells)), k);
}

Approximation order(int r, const Rational& alpha, int k, long cells) {
  return ac98::proved(log(left_over(r, alpha, k, cells) / left_over(r, alpha, k, 2 * cells)) / log(Ball(2)));
}

}  // namespace

Finding theorem_7_smoothness(const Bench&) {
  const BallPrecision precision(192);
  Finding finding;
  for (const int r : {1, 3}) {
    const Rational alpha = superconvergent_inset(r, 1 / power(Rational(10), 40)).value().value;
    const Bound printed{
        .order = static_cast<double>(r + 3), .slack = 0.5, .why = "|log h| is less than any power of 1/h"};
    const std::string of = ", r = " + std::to_string(r);
    for (const long cells : {4L, 8L, 16L}) {
      const std::string at = of + ", h = 1/" + std::to_string(cells);
      finding.require("order of the error over functions with r + 2 bounded derivatives" + at, printed,
                      order(r, alpha, r + 2, cells));
      finding.require("order of the error over functions with r + 3 bounded derivatives" + at, printed,
                      order(r, alpha, r + 3, cells));
      finding.control("order of the error over functions with r + 1 bounded derivatives" + at, printed,
                      order(r, alpha, r + 1, cells));
    }
    finding.remark("m" + of, ac98::proved(left_over(r, alpha, 0, 1)));
  }
  return finding;
}

}  // namespace radcert::verification::m06
