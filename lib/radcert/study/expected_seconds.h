// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace radcert {

/// How long levels may take, told by those that are finished.
/// Maths     t(w) = t_1 (w/w_1)^p, w_1 the largest work so far and t_1 the mean of its seconds; p is the
///           slope of log t over log w from the next smaller work to w_1, but no less than 1/2 and no more
///           than 1, and 3/4 as long as there is one work alone
/// Requires  positive works, seconds that are not negative, else ContractViolation
/// Result    an estimate for people who wait
/// Limits    works are in any unit, the same for all
class ExpectedSeconds {
public:
  void finished(double work, double seconds);
  /// The seconds of levels of these works together; 0 before any is finished.
  [[nodiscard]] double of(std::span<const double> works) const;

private:
  struct Finished {
    double work = 0;
    double seconds = 0;
    double count = 0;
  };
  std::vector<Finished> levels_;  ///< by ascending work
};

}  // namespace radcert
