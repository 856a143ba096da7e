// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "radcert/core/parallel.h"

namespace radcert {

/// A uniform number in (0, 1), the same on every machine.
inline double uniform_number(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
}

/// A search from random starts for candidates of the least norm, of which the `kept` best are improved at
/// last.
/// Requires  search.from_start(seed): a candidate with a norm, or nothing, from several threads at once;
///           search.improved(candidate, steps, seed); look_at_best(candidates by their norms) after each
///           batch and at the end; goes_on(result) then: whether to go on. `result` counts starts and
///           solutions; `effort` has starts, steps and seed
/// Result    the same for any number of threads
template <class Search, class Effort, class Result, class Look, class GoesOn>
void search_from_starts(const Search& search, const Effort& effort, std::size_t kept, Result& result,
                        const Look& look_at_best, const GoesOn& goes_on) {
  using Candidate = typename decltype(search.from_start(std::uint64_t{}))::value_type;
  constexpr std::size_t batch = 32;  // starts between two questions whether to go on
  const auto by_norm = [](const Candidate& a, const Candidate& b) { return a.norm < b.norm; };
  std::vector<Candidate> best;
  bool on = true;
  while (on && result.starts < effort.starts) {
    const auto count = std::min(batch, static_cast<std::size_t>(effort.starts - result.starts));
    std::vector<std::optional<Candidate>> found(count);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        found[k] = search.from_start(effort.seed + static_cast<std::uint64_t>(result.starts) + k);
    });
    result.starts += static_cast<int>(count);
    for (std::optional<Candidate>& one : found)
      if (one) {
        ++result.solutions;
        best.push_back(*std::move(one));
      }
    std::stable_sort(best.begin(), best.end(), by_norm);
    if (best.size() > kept) best.resize(kept);
    look_at_best(best);
    on = goes_on(result);
  }
  if (best.empty()) return;
  parallel_for(best.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      best[k] = search.improved(std::move(best[k]), effort.steps, effort.seed + k);
  });
  std::stable_sort(best.begin(), best.end(), by_norm);
  look_at_best(best);
  goes_on(result);
}

}  // namespace radcert
