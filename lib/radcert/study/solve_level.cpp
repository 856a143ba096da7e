// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>

#include "radcert/core/contract.h"
#include "radcert/study/study.h"

namespace radcert {

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route,
                         const LevelSharing& sharing, KeptNumbers* kept) {
  expects(static_cast<bool>(route), "a second route: reference::applied_operator, as a rule");
  const auto by = [&](const auto& method) -> LevelOutcome {
    if constexpr (std::is_same_v<decltype(method), const Collocation&>) {
      return solve(problem, method, level, route, sharing, kept);
    } else {
      return sharing.ranks.is_first() ? solve(problem, method, level, route) : LevelOutcome();
    }
  };
  return std::visit(by, problem.method);
}

}  // namespace radcert
