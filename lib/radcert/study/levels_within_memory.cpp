// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/levels_within_memory.h"

#include <limits>
#include <optional>

#include "radcert/core/errors.h"
#include "radcert/study/events/event_triangulation.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

void check_levels(const Problem& problem, const Surface& surface, std::uint64_t memory_limit,
                  const std::function<LevelSize(int level, std::uint64_t triangles)>& size_of) {
  const std::vector<int>& levels = problem.triangulation.levels;
  if (levels.empty()) refuse_input("/triangulation/levels", "[]", "is empty", "at least one level");
  // To the byte: what is needed and what there is may be the same in larger units.
  const auto exactly = [](std::uint64_t bytes) {
    return bytes < 1024 ? byte_text(bytes) : byte_text(bytes) + " (" + std::to_string(bytes) + " bytes)";
  };
  const std::string allowed = "a plan within " + exactly(memory_limit);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string pointer = "/triangulation/levels/" + std::to_string(i);
    const std::string value = std::to_string(levels[i]);
    if (levels[i] < 0) refuse_input(pointer, value, "is not allowed", "a whole number >= 0");
    if (i > 0 && levels[i] <= levels[i - 1])
      refuse_input(pointer, value, "does not exceed the level before it",
                   "levels in ascending order, each once");
    const std::optional<std::uint64_t> triangles =
        triangle_count(surface, levels[i], triangulation_options(problem, surface));
    if (!triangles)
      refuse_input(pointer, value, "needs more than 2^64 bytes (more than 2^53 triangles)", allowed);
    const LevelSize size = size_of(levels[i], *triangles);
    const std::uint64_t needed = size.memory.total();
    if (needed <= memory_limit) continue;
    const bool fits = needed != std::numeric_limits<std::uint64_t>::max();
    refuse_input(pointer, value,
                 "needs " + (fits ? exactly(needed) : "more than 2^64 bytes") + " of memory (" +
                     std::to_string(size.count) + " " + size.counted + ")",
                 allowed);
  }
}

}  // namespace radcert
