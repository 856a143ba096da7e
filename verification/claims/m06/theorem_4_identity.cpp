// SPDX-License-Identifier: GPL-3.0-or-later

// (22) is the norm of both sides of u - u_n = (I - P_n K)^-1 (u - P_n u), which holds for every linear K and
// P_n with that inverse Y: by (20) u_n = Y P E, and E = u - K u.
//
// Checked      the identity, and (I - P K)(u - u_n) = u - P u before it, by rewriting with (I - P K) Y = Y (I
//              - P K) = I. Any u_n = W P E, W not the inverse, is rejected, and so is u - P u without the
//              inverse.
// Not checked  that the inverses exist for n >= n_0 and are uniformly bounded.

#include "verification/claims/operator_algebra.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding theorem_4(const Bench&) {
  const Operator one(1);
  const Operator k("K");
  const Operator p("P");
  const Operator y("Y");
  const OperatorRelations inverse({{.product = "PKY", .replacement = y - one},  //
                                   {.product = "YPK", .replacement = y - one}});
  const OperatorRelations none({});
  const Operator u_n = y * p * (one - k);  // of u
  const Operator before = (one - p * k) * (one - u_n);
  Finding finding;
  finding.require("words of (I - P K)(u - u_n) - (u - P u)", IsExactly{0},
                  inverse.differing_words(before, one - p));
  finding.require("words of u - u_n - (I - P K)^-1 (u - P u)", IsExactly{0},
                  inverse.differing_words(one - u_n, y * (one - p)));
  finding.control("words of the first for u_n = W P E with any W", IsExactly{0},
                  none.differing_words(before, one - p));
  finding.control("words of u - u_n - (u - P u)", IsExactly{0}, inverse.differing_words(one - u_n, one - p));
  finding.control("words of u - u_n - (I - P K)^-1 K(u - P u)", IsExactly{0},
                  inverse.differing_words(one - u_n, y * k * (one - p)));
  return finding;
}

}  // namespace radcert::verification::m06
