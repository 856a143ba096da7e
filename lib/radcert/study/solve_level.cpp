// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/study.h"

#include "radcert/core/contract.h"

namespace radcert {

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route) {
  expects(static_cast<bool>(route), "a second route: reference::applied_operator, as a rule");
  return std::visit([&](const auto& method) { return solve(problem, method, level, route); }, problem.method);
}

}  // namespace radcert
