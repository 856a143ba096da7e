// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/fine_levels.h"

#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/core/contract.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "verification/framework/stored_number.h"

namespace radcert::verification {
namespace {

LevelOutcome solved(const Bench& bench, const Problem& problem, int level) {
  // Each takes all threads, and much of the memory.
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return solve_with(bench.route, available_memory())(problem, level);
}

}  // namespace

Rational tolerance_at(const FineStudy& study, int level) {
  expects(study.first <= level, "a level of the study", named("level", level));
  expects(study.tolerance.sign() > 0, "a tolerance above 0");
  const Rational wanted = study.tolerance / power(Rational(2), study.order * (level - study.first));
  const Rational finest(1, 10000000000000);
  expects(finest.to_double() == ClusterTolerance::finest, "the finest tolerance of the operator");
  Rational tolerance(1, 1000);
  while (tolerance > wanted && tolerance > finest) tolerance = tolerance / Rational(10);
  return tolerance;
}

LevelFigure node_error_figure() {
  return {"node_error", [](const LevelOutcome& level) { return level.result.node_error.value(); }};
}

LevelFigure discretisation_error_figure() {
  return {"discretisation_error",
          [](const LevelOutcome& level) { return level.result.discretisation_error.value(); }};
}

std::vector<LevelErrors> fine_levels(const Bench& bench, const FineStudy& study,
                                     const std::vector<LevelFigure>& figures) {
  std::vector<LevelErrors> of_figures(figures.size());
  for (int level = study.first; level <= study.last; ++level) {
    Problem problem = study.problem;
    problem.triangulation.levels = {level};
    problem.matrix = {.name = "auto", .tolerance = tolerance_at(study, level)};
    const std::string key = problem_text(problem);
    std::optional<LevelOutcome> outcome;
    for (std::size_t i = 0; i < figures.size(); ++i) {
      of_figures[i].mesh_sizes.push_back(std::ldexp(std::numbers::sqrt2, -level));
      of_figures[i].errors.push_back(stored(bench.store, key + "\n" + figures[i].name, [&] {
        if (!outcome) outcome = solved(bench, problem, level);
        return figures[i].of(*outcome);
      }));
    }
  }
  return of_figures;
}

}  // namespace radcert::verification
