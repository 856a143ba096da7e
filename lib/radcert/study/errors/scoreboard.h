// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/study/efficiency.h"
#include "radcert/study/result.h"

namespace radcert {

/// Which points no other is better than.
/// Maths     point i is on the frontier if no j has cost_j <= cost_i and error_j <= error_i with one of the
///           two smaller
/// Source    V. Pareto's order
/// Result    a truth value a point; equal points are on it together or not at all
[[nodiscard]] std::vector<bool> pareto_frontier(std::span<const CostPoint> points);

/// What a scoreboard compares: errors, and what they cost. Names as in radcert/scoreboard/1.
inline constexpr std::array<const char*, 3> board_errors = {"max_error", "l2_error", "mean_error"};
inline constexpr std::array<const char*, 3> board_costs = {"unknowns", "bytes", "seconds"};

/// One level of a method on one problem.
struct BoardPoint {
  int level = 0;
  std::uint64_t unknowns = 0;
  std::uint64_t bytes = 0;  ///< as planned
  double seconds = 0;       ///< of assembly and solution; of the iterated solution, K u_n at its points too
  /// In the order of board_errors: the maximum over a sample of S, the root of the integral of the square,
  /// and the largest error of the mean over a piece; absent where the truth is not known so far
  std::array<std::optional<double>, 3> errors = {};
  /// By error and cost, in the order of board_errors and board_costs: no method of the problem has at some
  /// level a smaller error at no more cost
  std::array<std::array<bool, 3>, 3> on_frontier = {};

  [[nodiscard]] double cost(std::size_t kind) const {
    return kind == 0 ? static_cast<double>(unknowns) : kind == 1 ? static_cast<double>(bytes) : seconds;
  }
};

/// A method on a problem: its levels, or why there are none.
struct BoardCell {
  std::string method;
  std::string refusal = {};
  std::vector<BoardPoint> points = {};
};

/// A problem of a scoreboard with all methods.
struct BoardProblem {
  std::string name;
  std::string words;                   ///< the problem in a sentence
  std::string truth;                   ///< what is known of its solution
  std::optional<double> truth_radius;  ///< of enclosed means
  std::vector<BoardCell> cells = {};   ///< a method each, in the same order for all problems
};

/// Means of the solution itself over pieces, known within radii.
using KnownMeans = std::vector<std::pair<std::string, Approximation>>;

/// A level of u_n as a point of a scoreboard, and its iterated solution as another.
/// Maths     errors from the level where u is given; else, with known means, the largest |mean - known|
/// Requires  known means of pieces of the surface; for the iterated one a level that has it
/// Limits    the iterated solution's maximum is over its check points, its means are by a rule of degree 2
[[nodiscard]] BoardPoint board_point(const LevelResult& level, const LevelTiming& timing,
                                     const KnownMeans& known);
[[nodiscard]] BoardPoint iterated_board_point(const LevelResult& level, const LevelTiming& timing,
                                              const KnownMeans& known);

/// Marks the frontier of a problem, for each error against each cost.
/// Result    fills on_frontier; points without that error are not on it
void mark_frontiers(BoardProblem& problem);

}  // namespace radcert
