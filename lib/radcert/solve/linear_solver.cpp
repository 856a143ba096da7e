// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/text.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

const LinearSolver* find_linear_solver(std::string_view name) {
  for (const LinearSolver& solver : linear_solvers())
    if (solver.name == name) return &solver;
  return nullptr;
}

const LinearSolver& chosen(const LinearSolver& solver, bool contracts) {
  return solver.choose ? *find_linear_solver(solver.choose(contracts)) : solver;
}

std::vector<std::string> solver_names(const std::function<bool(const LinearSolver&)>& condition) {
  std::vector<std::string> names;
  for (const LinearSolver& solver : linear_solvers())
    if (condition(solver)) names.push_back(solver.name);
  return names;
}

std::vector<double> defects(const LinearSystem& system, std::span<const double> v,
                            std::vector<double> residual_sizes) {
  const double size = system.k.parts().size_of(v);
  for (std::size_t i = 0; i < v.size(); ++i)
    residual_sizes[i] = residual_sizes[i] + system.row_radius[i] * size + system.e_radius[i];
  return residual_sizes;
}

Outcome<LinearSolution> solution_of(const LinearSystem& system, const LinearSolver& solver,
                                    std::optional<double> tolerance, KeptNumbers* kept) {
  if (!solver.iterates()) return solver.eliminate(system);
  const Contraction& contraction = *system.contraction;
  auto solution = solver.iterate(system.k, contraction, system.e, tolerance, kept);
  if (!solution) {
    const NotReached& best = solution.reason();
    const std::string demanded =
        tolerance ? "the tolerance " + shortest(*tolerance) : "an error bound as small as double holds";
    return because(demanded + " is not reached: after " + std::to_string(best.iterations) +
                   " iterations the error bound is " + upper_text(best.error_bound) +
                   " where |u_n| <= " + upper_text(best.size));
  }
  LinearSolution result{.values = std::move(solution->values),
                        .iteration = IterationReport{.iterations = solution->iterations,
                                                     .contraction = contraction.theta(),
                                                     .error_bound = solution->error_bound}};
  std::vector<double> residual(result.values.size());
  system.k.accurate_residual(result.values, system.e, residual);
  std::vector<double> bounds = residual_bounds(system.k, contraction, result.values, system.e, residual);
  result.radius =
      contraction.inverse_bound(contraction.norm(defects(system, result.values, std::move(bounds))));
  return result;
}

}  // namespace radcert
