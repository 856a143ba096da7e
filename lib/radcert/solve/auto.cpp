// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/linear_solver.h"

namespace radcert {

/// GMRES where a contraction is found, else elimination. The plan is that of GMRES: who takes elimination
/// instead adds its plan then.
LinearSolver auto_entry() {
  return {.name = "auto",
          .summary = "gmres where an error bound for it is found, else direct",
          .choose = [](bool contracts) -> std::string_view { return contracts ? "gmres" : "direct"; },
          .plan = [](MemoryPlan& plan, std::uint64_t n) { find_linear_solver("gmres")->plan(plan, n); }};
}

}  // namespace radcert
