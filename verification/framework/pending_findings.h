// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>

#include "verification/framework/check.h"

namespace radcert::verification {

/// A statement whose check in code has not been run.
struct PendingFinding {
  std::string statement;  ///< "ac98/lemma_2_1"
  const Check* check = nullptr;
};

/// Runs checks, as many at a time as there are threads, and keeps what they find: stored_finding() then has
/// it.
/// Requires  checks that outlive the call and may run beside each other; `starting` is called by one thread
///           at a time
/// Result    the same findings in any order, as each depends on itself alone. Levels are asked of the bench
///           one at a time. Interrupted, InputError and EnvironmentError leave once the checks that run have
///           ended; another exception leaves its statement pending, and a store that switches itself off
///           leaves all that have not begun
void find_pending(std::span<const PendingFinding> pending, const Bench& bench,
                  const std::function<void(const PendingFinding&)>& starting);

}  // namespace radcert::verification
