// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/finding.h"

namespace radcert::verification::m06 {

/// Requires l_k(q_m) = delta_km for the nodes (13) and the functions l_k that belong to them, for every
///          degree
/// r >= 1 and every alpha but 1/3.
/// Maths     c_m = (m + (r-3m) alpha)/r is a coordinate of q_m, and y = (x - alpha)/(1 - 3 alpha): r y(c_m) =
///           m. l_k = prod over the three coordinates of prod_{0 <= a < k_i} (r y_i - a)/(k_i - a), so that
///           l_k(q_m) is a product of factors (m_i - a)/(k_i - a): all are 1 for k = m, and for k != m some
///           m_i < k_i, as both have the sum r, and the factor of a = m_i is 0. The f_r functions are
///           independent, and span P_r, which has that dimension
/// Source    [m06, (13)-(15)]
/// Result    exact: identities in r, m and alpha; all pairs k, m once more for r = 1 to 8
/// Limits    that some m_i < k_i is in words
void require_delta_at_the_nodes(Finding& finding);

/// Requires |l_k| <= (2r/(1 - 3 alpha))^r on sigma, for every r >= 1 and every 0 <= alpha < 1/3.
/// Maths     with d = 1 - 3 alpha, 0 <= x <= 1 and 0 <= a < k <= r: -1/d <= y <= 1/d, and |r y - a| <= r/d +
///           a <= 2r/d, k - a >= 1; l_k has r such factors. So the norm of P_n is at most f_r (2r/d)^r
/// Result    exact: what is left of each inequality has no negative coefficient in numbers that are not
///           negative
void require_bound_of_the_functions(Finding& finding);

}  // namespace radcert::verification::m06
