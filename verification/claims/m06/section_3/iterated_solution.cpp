// SPDX-License-Identifier: GPL-3.0-or-later

// Section 3: hat u_n = E + K u_n is at least as near to u as u_n, and converges where u_n does. As u = E + K
// u, u - hat u_n = K (u - u_n), for every method: norm of u - hat u_n <= norm of K times norm of u - u_n, and
// the norm of K is below 1 by (6).
//
// Checked      this identity, linear in K, with letters for E, u, u_n and what K does to them: any values.
//              Rejected: hat u_n with twice the K of the problem, which leaves K u_n over.
// Not checked  the norm of K: equation_6.

#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// u - hat u_n - K (u - u_n), with u = E + K u, hat u_n = E + factor K u_n; K u and K u_n are letters of their
// own, as K is linear.
Rational terms_of_iterate(int factor) {
  const Polynomial emission = Polynomial::variable("emission");
  const Polynomial k_u = Polynomial::variable("k_u");
  const Polynomial k_u_n = Polynomial::variable("k_u_n");
  const Polynomial u = emission + k_u;
  const Polynomial iterate = emission + factor * k_u_n;
  return differing_terms(u - iterate - (k_u - k_u_n), 0);
}

}  // namespace

Finding section_3_iterated_solution(const Bench&) {
  Finding finding;
  finding.require("terms of u - hat u_n - K (u - u_n)", IsExactly{0}, terms_of_iterate(1));
  finding.control("the same for E + 2 K u_n", IsExactly{0}, terms_of_iterate(2));
  return finding;
}

}  // namespace radcert::verification::m06
