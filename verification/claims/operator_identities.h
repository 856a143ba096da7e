// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification {

/// Requires what Neumann's series rests on, for every linear operator T and every k.
/// Maths     S_k = I + T + ... + T^k:  (I - T) S_k = S_k (I - T) = I - T^(k+1). By induction on k: K is T, Z
///           is S_k, Y is T^(k+1), the rules are what k gives, K Z = Z K = Z + Y - I and Y K = K Y, and from
///           them follows the same for Z + Y and K Y; at k = 0 Z = I and Y = K
/// Source    ours; rewriting as in OperatorRelations
/// Result    exact. Where the norm of T is at most q < 1 that of T^(k+1) is at most q^(k+1), and the sums are
///           Cauchy: on a complete space I - T has the inverse lim S_k, whose norm is at most lim (1 -
///           q^(k+1))/(1 - q) = 1/(1 - q), the same identity for the number q
/// Limits    that the space is complete, |a + b| <= |a| + |b| and |A a| <= |A| |a| are not checked
void require_neumann_series(Finding& finding);

/// Requires that k + 1 steps of x <- e + T x from 0 give S_k e, for every linear operator T and every k.
/// Maths     by induction as above: I + T S_k = S_(k+1); at k = 0 I + T 0 = I
/// Source    ours
/// Result    exact
void require_steps_of_neumann_series(Finding& finding);

/// Requires u - u_n = (I - P K)^-1 (u - P u) for the solution u_n of (I - P K) u_n = P E, where E = u - K u,
/// for every linear K and P with that inverse.
/// Source    [ac98, (81)]; [m06, (22)]
/// Result    exact, by rewriting with (I - P K) Y = Y (I - P K) = I
void require_error_by_inverse(Finding& finding);

}  // namespace radcert::verification
