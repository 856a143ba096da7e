// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"
#include "verification/framework/reading/claim.h"
#include "verification/framework/reading/paper.h"

namespace radcert::verification {

/// Refuses what is wrong with an enclosure's files and names before any work.
/// Requires  a claim with an enclosure
/// Result    returns, or InputError: a problem file that cannot be read, one whose solver is not `verified`,
///           errors asked of a problem without `solution`, a reference value, parameter or argument that
///           there is not
/// Limits    whether a proof succeeds is seen when it is tried
void check_names(const Paper& paper, const Claim& claim);

/// A proved number held against an interval.
/// Maths     x in [least, largest]: the enclosure of x inside holds, outside violates, anything else is open
/// Source    figures by the solver `verified`; reference values by enclose()
/// Requires  a claim that check_names lets pass
/// Result    a finding whose verdict is certified, contradicted or undecided, or failed where the control is
///           not proved to lie outside. A reference value is enclosed with more digits until that settles it,
///           160 at most. A proof that is not to be had leaves the statement open and says why
/// Limits    a number on the edge of the interval stays undecided
[[nodiscard]] Finding check_enclosure(const Paper& paper, const Claim& claim, const Bench& bench);

}  // namespace radcert::verification
