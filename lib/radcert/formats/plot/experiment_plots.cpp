// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/experiment_plots.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_words.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"

namespace radcert {

namespace {

bool has_alpha(const Problem& problem) {
  const TriangleBasisChoice* basis = find_triangle_basis(problem.method);
  return basis != nullptr && basis->family == NodeFamily::inset && basis->degree > 0 && basis->alpha;
}

/// The combinations that differ in alpha alone, three of them at least; in the order of the first of each.
std::vector<std::vector<std::size_t>> alpha_sweeps(std::span<const Result> results) {
  std::map<std::string, std::size_t> place;
  std::vector<std::vector<std::size_t>> sweeps;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!has_alpha(results[i].problem)) continue;
    Problem without = results[i].problem;
    triangle_basis_of(without.method).alpha = std::nullopt;
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
  triangle_basis_of(without.method).alpha = std::nullopt;
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
  Plot plot{.title = experiment.name + ": " + in_words(kind),
            .description =
                "The vertical axis is logarithmic. A line a level: the error as the nodes are pulled in "
                "from the corners by alpha.",
            .x = {.name = "alpha", .latex = "$\\alpha$", .logarithmic = false},
            .y = {.name = in_words(kind), .latex = in_latex(kind)}};
  std::set<int> degrees;
  for (const std::vector<std::size_t>& sweep : sweeps) {
    const Result& first = results[sweep.front()];
    degrees.insert(triangle_basis_of(first.problem.method).degree);
    for (std::size_t k = 0; k < first.levels.size(); ++k) {
      PlotCurve curve{.name = sweep_name(experiment, first.problem) + ", level " +
                              std::to_string(first.levels[k].level)};
      for (const std::size_t i : sweep)
        if (const auto at = plot_point(triangle_basis_of(results[i].problem.method).alpha->to_double(),
                                       results[i].levels[k].*kind.figure))
          curve.points.push_back(*at);
      std::sort(curve.points.begin(), curve.points.end());
      plot.curves.push_back(std::move(curve));
    }
  }
  plot.marks = superconvergent_marks(degrees);
  return plot;
}

}  // namespace

Plot combinations_plot(const Experiment& experiment, std::span<const Result> results,
                       std::span<const std::size_t> places, const ErrorKind& kind, ErrorAgainst against) {
  std::vector<std::vector<OrderFit>> orders;
  for (const std::size_t i : places)
    orders.push_back(against == ErrorAgainst::mesh_size ? results[i].orders : orders_in_unknowns(results[i]));
  std::vector<ErrorHistory> problems;
  for (std::size_t k = 0; k < places.size(); ++k)
    problems.push_back({.name = experiment.combinations[places[k]].name,
                        .levels = results[places[k]].levels,
                        .orders = orders[k]});
  return convergence_plot(experiment.name + ": " + in_words(kind), kind, against, problems);
}

std::vector<NamedPlot> experiment_plots(const Experiment& experiment, std::span<const Result> results) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  std::vector<std::size_t> all(results.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::vector<std::size_t>> sweeps = alpha_sweeps(results);
  std::vector<NamedPlot> plots;
  for (const ErrorKind& kind : error_kinds()) {
    const bool is_drawn = std::any_of(results.begin(), results.end(), [&](const Result& result) {
      return is_for_plots(kind, result.levels);
    });
    if (!is_drawn) continue;
    for (const auto& [name, against] :
         {std::pair("_against_h", ErrorAgainst::mesh_size), {"_against_unknowns", ErrorAgainst::unknowns}})
      if (Plot plot = combinations_plot(experiment, results, all, kind, against); !plot.curves.empty())
        plots.push_back({kind.name + name, std::move(plot)});
    if (!sweeps.empty())
      plots.push_back({kind.name + "_against_alpha", against_alpha(experiment, results, sweeps, kind)});
  }
  return plots;
}

}  // namespace radcert
