// SPDX-License-Identifier: GPL-3.0-or-later

// (22) is the norm of both sides of u - u_n = (I - P_n K)^-1 (u - P_n u), which holds for every linear K and
// P_n with that inverse Y: by (20) u_n = Y P E, and E = u - K u.
//
// Checked      the identity, and (I - P K)(u - u_n) = u - P u before it, by rewriting with (I - P K) Y = Y (I
//              - P K) = I. Any u_n = W P E, W not the inverse, is rejected, and so is u - P u without the
//              inverse.
// Not checked  that the inverses exist for n >= n_0 and are uniformly bounded.

#include "verification/claims/operator_identities.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding theorem_4(const Bench&) {
  Finding finding;
  require_error_by_inverse(finding);
  return finding;
}

}  // namespace radcert::verification::m06
