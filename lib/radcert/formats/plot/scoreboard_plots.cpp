// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/scoreboard_plots.h"

#include <algorithm>
#include <string>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

std::string error_words(std::size_t error) {
  if (error == 0) return "largest error over a sample of S";
  return error == 1 ? "error in the mean square" : "largest error of the mean of a piece";
}

std::string cost_words(std::size_t cost) {
  if (cost == 0) return "unknowns";
  return cost == 1 ? "bytes as planned" : "seconds";
}

bool is_known(const BoardProblem& problem, std::size_t error) {
  return std::any_of(problem.cells.begin(), problem.cells.end(), [&](const BoardCell& cell) {
    return std::any_of(cell.points.begin(), cell.points.end(),
                       [&](const BoardPoint& point) { return point.errors[error].has_value(); });
  });
}

}  // namespace

Plot scoreboard_plot(const BoardProblem& problem, std::size_t error, std::size_t cost) {
  expects(error < board_errors.size() && cost < board_costs.size(), "an error and a cost",
          named("error", error), named("cost", cost));
  Plot plot{.title = "Scoreboard: " + problem.name,
            .description = "All methods on " + problem.words +
                           ". Both axes are logarithmic. A curve a method, a marker a level; the thick line "
                           "is the frontier: no method has a smaller error at no more cost.",
            .x = {.name = cost_words(cost)},
            .y = {.name = error_words(error)}};
  PlotCurve frontier{.name = "frontier", .style = CurveStyle::bold};
  std::vector<PlotCurve> curves;
  for (std::size_t k = 0; k < problem.cells.size(); ++k) {
    PlotCurve curve{.name = problem.cells[k].method, .number = k};
    for (const BoardPoint& point : problem.cells[k].points) {
      const std::optional<double>& value = point.errors[error];
      if (!value || !(*value > 0) || !(point.cost(cost) > 0)) continue;
      curve.points.push_back({.x = point.cost(cost), .y = *value});
      if (point.on_frontier[error][cost]) frontier.points.push_back(curve.points.back());
    }
    if (!curve.points.empty()) curves.push_back(std::move(curve));
  }
  std::sort(frontier.points.begin(), frontier.points.end());
  if (frontier.points.size() > 1) plot.curves.push_back(std::move(frontier));
  for (PlotCurve& curve : curves) plot.curves.push_back(std::move(curve));
  return plot;
}

std::vector<NamedPlot> scoreboard_plots(const std::vector<BoardProblem>& problems) {
  constexpr std::size_t seconds = 2;
  std::vector<NamedPlot> out;
  for (const BoardProblem& problem : problems)
    for (std::size_t error = 0; error < board_errors.size(); ++error) {
      if (!is_known(problem, error)) continue;
      for (std::size_t cost = 0; cost < seconds; ++cost)
        out.push_back({problem.name + "_" + board_errors[error] + "_against_" + board_costs[cost],
                       scoreboard_plot(problem, error, cost)});
      break;
    }
  return out;
}

}  // namespace radcert
