// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/neumann.h"

#include "radcert/solve/linear_solver.h"

namespace radcert {

Outcome<IterativeSolution, NotReached> solve_by_neumann(const SystemProducts& k,
                                                        const Contraction& contraction,
                                                        std::span<const double> e,
                                                        std::optional<double> tolerance, KeptNumbers* kept) {
  const auto residual_itself = [](std::span<double>, double) { return std::size_t{1}; };
  return iterate(k, contraction, e, tolerance, {.apply = residual_itself}, kept);
}

LinearSolver neumann_entry() {
  return {.name = "neumann",
          .summary = "reflection by reflection, the Neumann series; a proved bound stops it",
          .iterate = solve_by_neumann,
          .plan = [](MemoryPlan&, std::uint64_t) {}};
}

}  // namespace radcert
