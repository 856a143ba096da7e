// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <string_view>
#include <vector>

namespace radcert {

/// A limit of work: how deep, how often, with how many digits something is tried before it is left.
/// Source    lib/limits.md is the list of all of them, held against work_limits() by a test
/// Requires  a variable of a namespace, whose name is "<layer>/<file>: <what is counted>" and not that of
///           another; smallest <= usual; texts that outlive it
/// Result    value(): usual, unless a test has lowered it. `at_the_limit` says what happens there: a refusal,
///           "undecided", or a radius that covers what was not looked at
/// Limits    read it once a call, not in an inner loop; not before main() begins. A bound of what is taken as
///           input is none
class WorkLimit {
public:
  WorkLimit(std::string_view name, long usual, long smallest, std::string_view at_the_limit) noexcept;
  WorkLimit(const WorkLimit&) = delete;
  WorkLimit& operator=(const WorkLimit&) = delete;

  [[nodiscard]] long value() const noexcept { return value_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t count() const noexcept { return static_cast<std::size_t>(value()); }

  [[nodiscard]] std::string_view name() const noexcept { return name_; }
  [[nodiscard]] long usual() const noexcept { return usual_; }
  /// The least with which the computation is the same but for what it reaches.
  [[nodiscard]] long smallest() const noexcept { return smallest_; }
  [[nodiscard]] std::string_view at_the_limit() const noexcept { return at_the_limit_; }

private:
  friend class LoweredWorkLimit;
  friend std::vector<const WorkLimit*> work_limits();
  std::string_view name_;
  long usual_;
  long smallest_;
  std::string_view at_the_limit_;
  const WorkLimit* next_;
  mutable std::atomic<long> value_;
};

/// All limits of the sources that are linked, by name.
[[nodiscard]] std::vector<const WorkLimit*> work_limits();

/// A limit at another value for the time of a scope, for tests: ContractViolation unless smallest <= value <=
/// usual.
class LoweredWorkLimit {
public:
  LoweredWorkLimit(const WorkLimit& limit, long value);
  ~LoweredWorkLimit();
  LoweredWorkLimit(const LoweredWorkLimit&) = delete;
  LoweredWorkLimit& operator=(const LoweredWorkLimit&) = delete;

private:
  const WorkLimit& limit_;
  long before_;
};

}  // namespace radcert
