// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/solve_request.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/operator_integral.h"
#include "requests/store.h"

namespace radcert::app {

namespace {

/// The entries of the matrix at a level, in units of those at level 0.
double work(int level) { return std::pow(16.0, level); }

}  // namespace

Solution solved(const Problem& problem, const std::string& source, const std::string& store, Progress& told) {
  const std::uint64_t memory = available_memory();
  return with_source(source, [&] {
    check(problem, memory);
    ResultStore kept = store_named(store);
    StoredLevels all_levels(kept, solve_with(reference::applied_operator, memory));
    double all = 0;
    for (const int level : problem.triangulation.levels) all += work(level);
    double done = 0;
    std::vector<LevelOutcome> levels;
    std::vector<LevelResult> results;
    std::vector<LevelTiming> timing;
    for (const int level : problem.triangulation.levels) {
      told.say(done / all, "level " + std::to_string(level));
      levels.push_back(all_levels.level(problem, level));
      results.push_back(levels.back().result);
      timing.push_back(levels.back().timing);
      done += work(level);
    }
    warn_where_nothing_is_kept(kept, store, told);
    told.say(1, "done");
    return Solution{collect(problem, std::move(results), std::move(timing)), std::move(levels)};
  });
}

}  // namespace radcert::app
