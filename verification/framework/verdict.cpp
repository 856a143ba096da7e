// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/verdict.h"

#include <algorithm>
#include <vector>

namespace radcert::verification {
namespace {

constexpr std::array<std::string_view, 8> verdict_names{
    "certified", "reproduced", "supported", "contradicted", "undecided", "definition", "unchecked", "failed"};
constexpr std::array<std::string_view, 3> scope_names{"all", "family", "instances"};
constexpr std::array<std::string_view, 3> budget_names{"quick", "standard", "full"};

template <class T, std::size_t count>
std::optional<T> named_in(const std::array<std::string_view, count>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<T>(found - names.begin());
}

}  // namespace

std::string_view name(Verdict verdict) { return verdict_names.at(static_cast<std::size_t>(verdict)); }
std::optional<Verdict> verdict_named(std::string_view name) { return named_in<Verdict>(verdict_names, name); }

std::span<const std::string> recordable_verdicts() {
  static const std::vector<std::string> names(verdict_names.begin(), verdict_names.end() - 1);
  return names;
}

std::string_view name(Scope scope) { return scope_names.at(static_cast<std::size_t>(scope)); }
std::optional<Scope> scope_named(std::string_view name) { return named_in<Scope>(scope_names, name); }

std::string reach_text(Scope scope, std::size_t instances) {
  switch (scope) {
    case Scope::all: return "for all";
    case Scope::family: return "for a family";
    case Scope::instances: break;
  }
  return "at " + std::to_string(instances) + (instances == 1 ? " instance" : " instances");
}

std::string_view name(Budget budget) { return budget_names.at(static_cast<std::size_t>(budget)); }
std::optional<Budget> budget_named(std::string_view name) { return named_in<Budget>(budget_names, name); }

}  // namespace radcert::verification
