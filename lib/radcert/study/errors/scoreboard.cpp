// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/errors/scoreboard.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// The largest |mean - known| over the pieces whose means are known; nothing without any.
template <class Means>
std::optional<double> error_of_means(const Means& means, const KnownMeans& known) {
  std::optional<double> largest;
  for (const auto& [piece, truth] : known) {
    const auto found =
        std::find_if(means.begin(), means.end(), [&](const auto& mean) { return mean.first == piece; });
    expects(found != means.end(), "means of pieces of the surface", named("piece", piece));
    double mean = 0;
    if constexpr (std::is_same_v<std::decay_t<decltype(found->second)>, Approximation>)
      mean = found->second.value;
    else
      mean = found->second;
    largest = std::max(largest.value_or(0), std::abs(mean - truth.value));
  }
  return largest;
}

BoardPoint costs_of(const LevelResult& level, const LevelTiming& timing) {
  return {.level = level.level,
          .unknowns = level.unknowns,
          .bytes = level.planned_bytes,
          .seconds = timing.assembly_seconds + timing.solve_seconds};
}

}  // namespace

std::vector<bool> pareto_frontier(std::span<const CostPoint> points) {
  const auto is_better = [](const CostPoint& a, const CostPoint& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
  };
  std::vector<bool> out;
  for (const CostPoint& point : points)
    out.push_back(std::none_of(points.begin(), points.end(),
                               [&](const CostPoint& other) { return is_better(other, point); }));
  return out;
}

BoardPoint board_point(const LevelResult& level, const LevelTiming& timing, const KnownMeans& known) {
  BoardPoint out = costs_of(level, timing);
  if (level.uniform_error) out.errors[0] = level.uniform_error->value;
  if (level.l2_error) out.errors[1] = level.l2_error->value;
  if (!known.empty())
    out.errors[2] = error_of_means(level.piece_means, known);
  else if (level.mean_error)
    out.errors[2] = level.mean_error->value;
  return out;
}

BoardPoint iterated_board_point(const LevelResult& level, const LevelTiming& timing,
                                const KnownMeans& known) {
  expects(level.iterated.has_value(), "a level with the iterated solution", named("level", level.level));
  BoardPoint out = costs_of(level, timing);
  out.seconds += timing.iterated_seconds;
  if (level.iterated_error) out.errors[0] = level.iterated_error->value;
  out.errors[1] = level.iterated->l2_error;
  out.errors[2] =
      known.empty() ? level.iterated->mean_error : error_of_means(level.iterated->piece_means, known);
  return out;
}

void mark_frontiers(BoardProblem& problem) {
  for (std::size_t error = 0; error < board_errors.size(); ++error)
    for (std::size_t cost = 0; cost < board_costs.size(); ++cost) {
      std::vector<BoardPoint*> with_error;
      std::vector<CostPoint> points;
      for (BoardCell& cell : problem.cells)
        for (BoardPoint& point : cell.points) {
          point.on_frontier[error][cost] = false;
          if (!point.errors[error]) continue;
          with_error.push_back(&point);
          points.push_back({.cost = point.cost(cost), .error = *point.errors[error]});
        }
      const std::vector<bool> on_frontier = pareto_frontier(points);
      for (std::size_t i = 0; i < points.size(); ++i)
        with_error[i]->on_frontier[error][cost] = on_frontier[i];
    }
}

}  // namespace radcert
