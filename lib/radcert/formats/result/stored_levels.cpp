// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/stored_levels.h"

#include <optional>
#include <string>
#include <utility>

#include "radcert/core/files/result_store.h"
#include "radcert/formats/result/level_record.h"
#include "radcert/surface/own_surface.h"

namespace radcert {

namespace {

/// Whether the text of a problem says all that its numbers depend on.
bool is_told_by_its_text(const Problem& problem) {
  if (problem.surface.mesh && !is_known_in_balls(*problem.surface.mesh->surface)) return false;
  for (const auto* data : {&problem.solution, &problem.emission})
    if (*data && (*data)->has_own()) return false;
  return !problem.reflectivity.has_own();
}

}  // namespace

LevelOutcome StoredLevels::level(const Problem& problem, int level) {
  if (!is_told_by_its_text(problem)) {
    ++computed_;
    return solve_(problem, level);
  }
  const std::string key = level_key(problem, level);
  if (const std::optional<std::string> kept = store_->get(key))
    if (Outcome<LevelOutcome> outcome = read_level_record(*kept)) return std::move(outcome).value();
  LevelOutcome outcome = solve_(problem, level);
  ++computed_;
  static_cast<void>(store_->put(key, level_record(outcome)));
  return outcome;
}

StoredLevels::Solve solve_with(OperatorRoute route, std::uint64_t memory_limit) {
  return [route = std::move(route), memory_limit](const Problem& problem, int level) {
    check(problem, memory_limit);
    return solve_level(problem, level, route);
  };
}

}  // namespace radcert
