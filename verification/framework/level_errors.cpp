// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/level_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "radcert/core/contract.h"

namespace radcert::verification {
namespace {

using FigureOfLevel = std::optional<Approximation> LevelResult::*;

Approximation figure_of(const LevelOutcome& level, FigureOfLevel figure) {
  const std::optional<Approximation>& given = level.result.*figure;
  expects(given.has_value(), "a problem with a known solution", named("level", level.result.level));
  return as_sampled(*given);
}

template <class Error>
LevelErrors of_levels(const Bench& bench, const Problem& problem, const std::vector<int>& levels,
                      const Error& error) {
  LevelErrors errors;
  for (const int level : levels) {
    const LevelOutcome outcome = bench.levels.level(problem, level);
    errors.mesh_sizes.push_back(outcome.result.mesh_size);
    errors.errors.push_back(error(outcome));
  }
  return errors;
}

}  // namespace

std::vector<int> levels_from(int first, int last) {
  std::vector<int> levels;
  for (int level = first; level <= last; ++level) levels.push_back(level);
  return levels;
}

LevelErrors over_levels(const std::vector<int>& levels, const std::function<Approximation(int)>& error) {
  LevelErrors errors;
  for (const int level : levels) {
    errors.mesh_sizes.push_back(std::ldexp(std::numbers::sqrt2, -level));
    errors.errors.push_back(error(level));
  }
  return errors;
}

bool touches_the_border(const Surface& surface, const ParameterTriangle& element) {
  const bool square = surface.charts.at(element.chart).facts().domain == ChartDomain::unit_square;
  return std::any_of(element.vertices.begin(), element.vertices.end(), [square](const auto& v) {
    return v.s == 0 || v.t == 0 || (square ? v.s == 1 || v.t == 1 : v.s + v.t == 1);
  });
}

LevelErrors node_errors(const Bench& bench, const Problem& problem, const std::vector<int>& levels,
                        const NodeChoice& choice) {
  return of_levels(bench, problem, levels, [&](const LevelOutcome& level) {
    Approximation error = figure_of(level, &LevelResult::node_error);
    if (!choice) return error;
    const std::vector<ParameterTriangle> elements =
        triangulate(surface_of(problem), level.result.level).triangles;
    error.value = 0;
    for (const NodeValue& node : level.nodes)
      if (choice(node, elements.at(node.element)))
        error.value = std::max(error.value, std::abs(node.u.value() - node.u_n.value));
    return error;
  });
}

LevelErrors uniform_errors(const Bench& bench, const Problem& problem, const std::vector<int>& levels) {
  return of_levels(bench, problem, levels,
                   [](const LevelOutcome& level) { return figure_of(level, &LevelResult::uniform_error); });
}

LevelErrors discretisation_errors(const Bench& bench, const Problem& problem,
                                  const std::vector<int>& levels) {
  return of_levels(bench, problem, levels, [](const LevelOutcome& level) {
    return figure_of(level, &LevelResult::discretisation_error);
  });
}

}  // namespace radcert::verification
