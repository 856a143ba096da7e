// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace radcert::verification {

/// What a check says of a statement.
/// Maths     certified: exact or ball arithmetic proves it for the stated inputs; reproduced: our value with
///           its radius rounds to the printed digits; supported: floating-point evidence with a control that
///           was rejected; contradicted: proved or measured otherwise; undecided: the evidence does not
///           settle it; definition: nothing to verify; unchecked: not looked at yet; failed: the check threw,
///           or it could not reject what it must reject
/// Source    verification/README.md
/// Requires  nothing
/// Result    `failed` is never recorded
/// Limits    `contradicted` speaks of the paper, `failed` of the check
enum class Verdict {
  certified,
  reproduced,
  supported,
  contradicted,
  undecided,
  definition,
  unchecked,
  failed
};

/// "certified", "reproduced", ...
[[nodiscard]] std::string_view name(Verdict verdict);
/// The verdict of that name.
[[nodiscard]] std::optional<Verdict> verdict_named(std::string_view name);
/// The names of the verdicts that a record may hold: all but `failed`.
[[nodiscard]] std::span<const std::string> recordable_verdicts();

/// How far a verdict reaches.
/// Maths     all: everything that the statement quantifies over; family: a named family with free parameters;
///           instances: the listed ones
/// Source    verification/README.md
enum class Scope { all, family, instances };

/// "all", "family", "instances".
[[nodiscard]] std::string_view name(Scope scope);
[[nodiscard]] std::optional<Scope> scope_named(std::string_view name);
/// The reach of a verdict as part of a sentence: "for all", "for a family", "at 5 instances".
[[nodiscard]] std::string reach_text(Scope scope, std::size_t instances);

/// How much work a verification may do.
/// Source    apps/radcert/README.md
/// Requires  nothing
/// Result    quick: a paper in under two minutes on two cores; standard, full: more evidence of the same
///           kind. No statement is left out at any of them, and tables are complete at each
/// Limits    a wish, not a limit: no check is stopped by the clock
enum class Budget { quick, standard, full };

inline constexpr std::array<Budget, 3> all_budgets{Budget::quick, Budget::standard, Budget::full};

/// "quick", "standard", "full".
[[nodiscard]] std::string_view name(Budget budget);
[[nodiscard]] std::optional<Budget> budget_named(std::string_view name);

/// One value for each budget.
template <class T>
struct PerBudget {
  std::array<T, 3> values{};
  [[nodiscard]] const T& at(Budget budget) const { return values[static_cast<std::size_t>(budget)]; }
  [[nodiscard]] T& at(Budget budget) { return values[static_cast<std::size_t>(budget)]; }
  [[nodiscard]] static PerBudget same(const T& value) { return {{value, value, value}}; }
};

}  // namespace radcert::verification
