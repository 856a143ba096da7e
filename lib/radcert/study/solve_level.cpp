// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/study.h"

namespace radcert {

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route) {
  return std::visit([&](const auto& method) { return solve(problem, method, level, route); }, problem.method);
}

}  // namespace radcert
