// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "verification/framework/check.h"

namespace radcert::verification {

/// The checks that are compiled in, a list a paper.
/// Source    verification/claims/<key>/contents.cpp
/// Requires  nothing
/// Result    every claim with a check function has exactly one, and every one here has a claim: a test counts
///           them
[[nodiscard]] std::vector<PaperChecks> all_checks();

namespace ac98 {
[[nodiscard]] PaperChecks contents();
}
namespace m06 {
[[nodiscard]] PaperChecks contents();
}
namespace psg10 {
[[nodiscard]] PaperChecks contents();
}

}  // namespace radcert::verification
