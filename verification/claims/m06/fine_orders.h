// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::m06 {

/// Orders at the nodes from solutions with more unknowns than a matrix has room for, for Theorems 7 and 9.
/// Maths     max |K(I - P_n)u| over the nodes is of the order p at least, told from p - 1/25: the whole
///           interval of the exponent, without a logarithm, lies above p - 1/50; max |u - u_n| from p - 1/10;
///           for r = 2 on two_piece(2) both from p - 1/5
/// Result    requirements, and controls at alpha = 1/10 and r = 1, where the order is two
/// Limits    minutes
void require_fine_orders_of_theorem_7(Finding& finding, const Bench& bench);
void require_fine_orders_of_theorem_9(Finding& finding, const Bench& bench);

}  // namespace radcert::verification::m06
