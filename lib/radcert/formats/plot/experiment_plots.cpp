// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/experiment_plots.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/plot/error_points.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_words.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"

namespace radcert {

namespace {

std::string numbers(const std::vector<int>& levels) {
  std::string out;
  for (const int level : levels) out += " " + std::to_string(level);
  return out;
}

std::string order_text(const OrderFit& fit) {
  const auto order = fitted_order_text(fit, " \u00b1 ");
  std::string out = order ? "order " + *order : "no order fitted";
  if (order && (fit.levels.size() < 3 || !fit.halfwidth)) out += " from two levels";
  if (!fit.left_out.empty()) out += ", left out:" + numbers(fit.left_out);
  return out;
}

Plot against(const Experiment& experiment, std::span<const Result> results,
             const std::vector<std::vector<OrderFit>>& orders, const ErrorKind& kind, PlotAxis axis) {
  Plot plot{.title = experiment.name + ": " + error_words(kind.name),
            .description =
                "Both axes are logarithmic. A line a combination; the order is the exponent of " +
                axis_name(axis) +
                " fitted to its levels, its uncertainty the spread of the slopes between levels. Bars: what "
                "quadrature and rounding may have changed, where more than a marker.",
            .x_name = axis_name(axis),
            .y_name = error_words(kind.name),
            .series = {}};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const OrderFit fit = fitted_order(results[i].levels, orders[i], kind, axis);
    plot.series.push_back({experiment.combinations[i].name + ": " + order_text(fit),
                           error_points(results[i].levels, kind, axis)});
  }
  return plot;
}

bool has_alpha(const Problem& problem) {
  return problem.basis.family == BasisFamily::inset && problem.basis.degree > 0 && problem.basis.alpha;
}

/// The combinations that differ in alpha alone, three of them at least; in the order of the first of each.
std::vector<std::vector<std::size_t>> alpha_sweeps(std::span<const Result> results) {
  std::map<std::string, std::size_t> place;
  std::vector<std::vector<std::size_t>> sweeps;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!has_alpha(results[i].problem)) continue;
    Problem without = results[i].problem;
    without.basis.alpha = std::nullopt;
    const auto [found, is_new] = place.emplace(problem_json(without).compact(), sweeps.size());
    if (is_new) sweeps.emplace_back();
    sweeps[found->second].push_back(i);
  }
  std::erase_if(sweeps, [](const auto& sweep) { return sweep.size() < 3; });
  return sweeps;
}

/// What the members of a sweep share of what is varied.
std::string sweep_name(const Experiment& experiment, const Problem& problem) {
  Problem without = problem;
  without.basis.alpha = std::nullopt;
  std::vector<std::string> words;
  for (const std::string& key : experiment.varied)
    if (const std::string part = listed(part_words(without, key)); !part.empty()) words.push_back(part);
  return listed(words);
}

std::vector<PlotMark> superconvergent_marks(const std::set<int>& degrees) {
  std::vector<PlotMark> marks;
  for (const int degree : degrees)
    // A plot shows three digits.
    if (const auto inset = superconvergent_inset(degree, Rational(1, 1000000)))
      marks.push_back({inset->value.to_double(), "superconvergent at degree " + std::to_string(degree)});
  return marks;
}

Plot against_alpha(const Experiment& experiment, std::span<const Result> results,
                   const std::vector<std::vector<std::size_t>>& sweeps, const ErrorKind& kind) {
  Plot plot{.title = experiment.name + ": " + error_words(kind.name),
            .description =
                "The vertical axis is logarithmic. A line a level: the error as the nodes are pulled in "
                "from the corners by alpha.",
            .x_name = "alpha",
            .y_name = error_words(kind.name),
            .linear_x = true,
            .series = {}};
  std::set<int> degrees;
  for (const std::vector<std::size_t>& sweep : sweeps) {
    const Result& first = results[sweep.front()];
    degrees.insert(first.problem.basis.degree);
    for (std::size_t k = 0; k < first.levels.size(); ++k) {
      PlotSeries series{
          sweep_name(experiment, first.problem) + ", level " + std::to_string(first.levels[k].level), {}};
      for (const std::size_t i : sweep)
        if (const auto at =
                error_point(results[i].problem.basis.alpha->to_double(), results[i].levels[k].*kind.figure))
          series.points.push_back(*at);
      std::sort(series.points.begin(), series.points.end());
      plot.series.push_back(std::move(series));
    }
  }
  plot.marks = superconvergent_marks(degrees);
  return plot;
}

}  // namespace

std::vector<NamedPlot> experiment_plots(const Experiment& experiment, std::span<const Result> results) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  std::vector<std::vector<OrderFit>> in_h;
  std::vector<std::vector<OrderFit>> in_unknowns;
  for (const Result& result : results) {
    in_h.push_back(result.orders);
    in_unknowns.push_back(orders_in_unknowns(result));
  }
  const bool several_levels = std::any_of(results.begin(), results.end(),
                                          [](const Result& result) { return result.levels.size() > 1; });
  const std::vector<std::vector<std::size_t>> sweeps = alpha_sweeps(results);

  std::vector<NamedPlot> plots;
  for (const ErrorKind& kind : error_kinds()) {
    if (several_levels) {
      plots.push_back(
          {kind.name + "_against_h", against(experiment, results, in_h, kind, PlotAxis::mesh_size)});
      plots.push_back({kind.name + "_against_unknowns",
                       against(experiment, results, in_unknowns, kind, PlotAxis::unknowns)});
    }
    if (!sweeps.empty())
      plots.push_back({kind.name + "_against_alpha", against_alpha(experiment, results, sweeps, kind)});
  }
  return plots;
}

}  // namespace radcert
