// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 2 is [ac98, Lemma 2.3], and Theorem 3 (b) is [ac98, Theorem 2.4 (b)]: both fail where a curved piece
// has a corner, for m = 1 and m = 2, and corner_derivative.h says how.

#include "verification/claims/ac98/surfaces/corner_derivative.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding lemma_2(const Bench&) { return ac98::mixed_derivative_at_a_corner(); }

Finding theorem_3_b(const Bench&) { return ac98::mixed_derivative_of_the_solution_at_a_corner(); }

}  // namespace radcert::verification::m06
