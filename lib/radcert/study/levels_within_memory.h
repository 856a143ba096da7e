// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "radcert/core/memory_plan.h"
#include "radcert/study/problem.h"

namespace radcert {

/// How large a level is: a count, of what, and the memory that it needs.
struct LevelSize {
  std::uint64_t count = 0;
  std::string counted;
  MemoryPlan memory;
};

/// Refuses levels that are none and those that do not fit into memory.
/// Maths     levels >= 0, strictly ascending, at most 2^53 triangles, size_of(level, triangles) within
///           `memory_limit` bytes
/// Result    returns, or throws InputError below /triangulation/levels
void check_levels(const Problem& problem, const Surface& surface, std::uint64_t memory_limit,
                  const std::function<LevelSize(int level, std::uint64_t triangles)>& size_of);

}  // namespace radcert
