// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/study/operator_route.h"
#include "verification/framework/finding.h"

namespace radcert {
class LevelSource;
class ResultStore;
struct Problem;
}  // namespace radcert

namespace radcert::verification {

/// What a check works with.
/// Requires  everything outlives the bench
/// Result    route: Ku without the pipeline's quadrature; levels: solved levels; store: for numbers that take
///           long
struct Bench {
  Budget budget = Budget::quick;
  OperatorRoute route;
  LevelSource& levels;
  ResultStore& store;
};

/// The code that checks one statement.
using Check = std::function<Finding(const Bench& bench)>;

/// A figure of one level by a computation that shares neither quadrature nor assembly nor solver with the
/// pipeline.
/// Maths     "discretisation_error" or "node_error" of a problem at a level
/// Requires  a problem with `solution`
/// Result    the figure with its radius
/// Limits    may take minutes
using SecondRoute = std::function<Approximation(const Bench& bench, const Problem& problem, int level,
                                                const std::string& figure)>;

/// The checks of one paper, by the labels of its claims.
struct PaperChecks {
  std::string key;
  std::vector<std::pair<std::string, Check>> checks;
  SecondRoute second_route;  ///< may be empty

  [[nodiscard]] const Check* find(const std::string& label) const {
    for (const auto& [name, check] : checks)
      if (name == label) return &check;
    return nullptr;
  }
};

/// The checks that are compiled in, a list a paper.
/// Source    generated from verification/claims by verification/checks.cmake
/// Result    every claim with a check function has exactly one, and every one here has a claim: a test counts
///           them
[[nodiscard]] std::vector<PaperChecks> all_checks();

}  // namespace radcert::verification
