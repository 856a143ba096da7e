// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/formats/table/factor_comparison.h"

namespace radcert {

/// The result of `radcert factors`: the matrix and what a report shows beside it.
struct FactorReport {
  std::string command;
  std::string name;
  std::string by;  ///< "triangle", "piece", "group"
  std::size_t triangles = 0;
  bool open = false;
  std::optional<std::string> unit = std::nullopt;  ///< of lengths, where it is known
  /// Of a mesh: from which side light leaves its triangles, "right-hand" or "left-hand"
  std::optional<std::string> front = std::nullopt;
  bool facets_only = false;  ///< the mesh may stand for something round: the numbers are those of its facets
  std::vector<std::string> names;
  FactorMatrix matrix;
  std::vector<std::string> warnings;
  std::optional<std::vector<FactorComparison>> comparison;
};

/// How far the row sums as given are from 1 at most.
/// Maths     max_I |sum_I - 1| of the doubles sum_I
/// Result    rounded up
[[nodiscard]] double closure_bound(const FactorMatrix& matrix);

/// The same as JSON.
/// Source    the file format radcert/factors/1
/// Result    comparison: counts and the factors_json_worst largest differences; null where none was asked for
[[nodiscard]] JsonValue factors_report(const FactorReport& report);

/// How many of the largest differences a report lists.
inline constexpr std::size_t factors_json_worst = 100;

}  // namespace radcert
