// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "radcert/core/checked.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/linear_solver.h"

namespace radcert {

Outcome<double> estimated_inverse_norm(std::span<const double> of_coarser_levels) {
  if (of_coarser_levels.size() < 2) return because("there are fewer than two coarser levels to tell it from");
  for (const double norm : of_coarser_levels)
    if (!std::isfinite(norm)) return because("a coarser level has no inverse");
  const double last = of_coarser_levels.back();
  const double before = of_coarser_levels[of_coarser_levels.size() - 2];
  constexpr double settled = 0.2;
  if (std::abs(last - before) > settled * std::max(last, before))
    return because("its norms on the two finest of the coarser levels, " +
                   nearest_text(before, DecimalForm::general(4)) + " and " +
                   nearest_text(last, DecimalForm::general(4)) + ", differ by more than a fifth");
  return std::max(1.0, 2 * *std::max_element(of_coarser_levels.begin(), of_coarser_levels.end()));
}

/// GMRES, and where nothing contracts GMRES by an estimate: the coarser levels' matrices are planned too.
LinearSolver gmres_by_estimate_entry() {
  return {.name = std::string(gmres_by_estimate),
          .summary = "gmres; where no error bound is found, stopped by an estimate from coarser levels",
          .iterate = solve_by_gmres,
          .choose = [](bool contracts) { return contracts ? std::string_view("gmres") : gmres_by_estimate; },
          .plan =
              [](MemoryPlan& plan, std::uint64_t n) {
                find_linear_solver("gmres")->plan(plan, n);
                const std::uint64_t coarse = std::min<std::uint64_t>(n, most_unknowns_of_inverses);
                plan.add("a coarser level's matrix, its factors and inverse",
                         saturated_product(coarse, coarse), 3 * sizeof(double));
              }};
}

}  // namespace radcert
