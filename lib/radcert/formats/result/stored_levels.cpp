// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/stored_levels.h"

#include <optional>
#include <string>
#include <utility>

#include "radcert/core/files/result_store.h"
#include "radcert/core/ranks/krylov_engine.h"
#include "radcert/formats/result/level_record.h"
#include "radcert/formats/result/stored_numbers.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/surface/own_surface.h"

namespace radcert {

namespace {

/// Under what a level is kept: PETSc's options say how its solver goes.
std::string key_of(const Problem& problem, int level, const Ranks& ranks) {
  const KrylovEngine* engine = ranks.krylov_engine();
  const bool has_options = engine != nullptr && find_linear_solver(problem.solver.name)->on_ranks;
  return level_key(problem, level) + (has_options ? "\n" + engine->options() : std::string());
}

/// Whether the text of a problem says all that its numbers depend on.
bool is_told_by_its_text(const Problem& problem) {
  if (problem.surface.mesh && !is_known_in_balls(*problem.surface.mesh->surface)) return false;
  for (const auto* data : {&problem.solution, &problem.emission})
    if (*data && (*data)->has_own()) return false;
  const auto* meshless = std::get_if<Meshless>(&problem.method);
  if (meshless != nullptr && meshless->basis.mother.kind == MotherKind::own) return false;
  return !problem.reflectivity.has_own();
}

}  // namespace

LevelOutcome StoredLevels::kept_or_computed(const Problem& problem, int level) {
  const bool is_told = is_told_by_its_text(problem);
  const std::string key = is_told ? key_of(problem, level, *ranks_) : std::string();
  std::optional<LevelOutcome> kept;
  if (is_told && ranks_->is_first())
    if (const std::optional<std::string> text = store_->get(key))
      if (Outcome<LevelOutcome> outcome = read_level_record(*text);
          outcome && (!fields_ || !outcome->is_without_fields()))
        kept = std::move(outcome).value();
  if (!ranks_->all(!ranks_->is_first() || !kept)) return std::move(kept).value_or(LevelOutcome());
  LevelOutcome outcome = solve_(problem, level);
  ++computed_;
  if (is_told && ranks_->is_first()) static_cast<void>(store_->put(key, level_record(outcome)));
  return outcome;
}

LevelOutcome StoredLevels::level(const Problem& problem, int level) {
  LevelOutcome outcome = kept_or_computed(problem, level);
  if (ranks_->count() == 1) return outcome;
  const LevelOutcome numbers{.result = outcome.result, .timing = outcome.timing, .nodes = {}, .elements = {}};
  const std::string record = ranks_->from_first(level_record(numbers));
  return ranks_->is_first() ? std::move(outcome) : read_level_record(record).value();
}

StoredLevels::Solve solve_with(OperatorRoute route, std::uint64_t memory_limit, const LevelSharing& sharing,
                               ResultStore* store) {
  return [route = std::move(route), memory_limit, sharing, store](const Problem& problem, int level) {
    check(problem, memory_limit);
    if (store == nullptr || !is_told_by_its_text(problem)) return solve_level(problem, level, route, sharing);
    StoredNumbers kept(*store, "on the way\n" + key_of(problem, level, sharing.ranks));
    return solve_level(problem, level, route, sharing, &kept);
  };
}

}  // namespace radcert
