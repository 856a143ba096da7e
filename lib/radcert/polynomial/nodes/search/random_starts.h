// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// What a search finds.
/// Result    data alone; the norm is what is made least
struct Candidate {
  std::vector<double> x;  ///< weights, then coordinates
  double norm = std::numeric_limits<double>::infinity();
};

/// Random steps of the coordinates from a candidate, while they lead to a lesser norm: longer ones after each
/// that does, shorter ones after each that does not, so that about one in six does.
/// Requires  search.weights(): how many weights stand in front; search.solution(start): the candidate near a
///           start, or nothing
template <class Search>
Candidate improved(const Search& search, Candidate best, int steps, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  double size = 0.02;
  for (int k = 0; k < steps && size > 1e-6; ++k) {
    Candidate next = best;
    for (std::size_t i = search.weights(); i < next.x.size(); ++i)
      next.x[i] += size * (2 * uniform_number(random) - 1);
    std::optional<Candidate> found = search.solution(std::move(next));
    const bool is_better = found && found->norm < best.norm;
    size *= is_better ? 1.5 : 0.92;
    if (is_better) best = *std::move(found);
  }
  return best;
}

/// A search from random starts for candidates of the least norm, of which the `kept` best are improved at
/// last.
/// Requires  search as improved; search.from_start(seed): a candidate, or nothing; both from several threads
///           at once; look_at_best(candidates by their norms) after each batch and at the end;
///           goes_on(result) then: whether to go on. `result` counts starts and solutions; `effort` has
///           starts, steps and seed
/// Result    the same for any number of threads
template <class Search, class Effort, class Result, class Look, class GoesOn>
void search_from_starts(const Search& search, const Effort& effort, std::size_t kept, Result& result,
                        const Look& look_at_best, const GoesOn& goes_on) {
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
      best[k] = improved(search, std::move(best[k]), effort.steps, effort.seed + k);
  });
  std::stable_sort(best.begin(), best.end(), by_norm);
  look_at_best(best);
  goes_on(result);
}

}  // namespace radcert
