// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/expected_seconds.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {

void ExpectedSeconds::finished(double work, double seconds) {
  expects(work > 0 && seconds >= 0, "a positive work and its seconds", named("work", work),
          named("seconds", seconds));
  const auto at = std::lower_bound(levels_.begin(), levels_.end(), work,
                                   [](const Finished& level, double w) { return level.work < w; });
  if (at == levels_.end() || at->work != work) {
    levels_.insert(at, {.work = work, .seconds = seconds, .count = 1});
    return;
  }
  at->seconds += (seconds - at->seconds) / (at->count + 1);
  ++at->count;
}

double ExpectedSeconds::of(std::span<const double> works) const {
  if (levels_.empty()) return 0;
  constexpr double least = 0.5;
  constexpr double usual = 0.75;
  const Finished& largest = levels_.back();
  double slope = usual;
  if (levels_.size() > 1) {
    const Finished& before = levels_[levels_.size() - 2];
    if (before.seconds > 0 && largest.seconds > 0)
      slope = std::clamp(std::log(largest.seconds / before.seconds) / std::log(largest.work / before.work),
                         least, 1.0);
  }
  double sum = 0;
  for (const double work : works) sum += largest.seconds * std::pow(work / largest.work, slope);
  return sum;
}

}  // namespace radcert
