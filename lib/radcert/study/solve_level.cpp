// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/study.h"

#include "radcert/core/contract.h"

namespace radcert {

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route, const Ranks& ranks,
                         KeptNumbers* kept) {
  expects(static_cast<bool>(route), "a second route: reference::applied_operator, as a rule");
  if (const auto* collocation = std::get_if<Collocation>(&problem.method))
    return solve(problem, *collocation, level, route, ranks, kept);
  if (!ranks.is_first()) return {};
  return std::visit([&](const auto& method) { return solve(problem, method, level, route); }, problem.method);
}

}  // namespace radcert
