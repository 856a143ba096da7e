// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/level_description.h"

#include <optional>
#include <utility>

#include "radcert/study/collocation/level_errors.h"

namespace radcert {
namespace {

std::optional<double> value_at(std::span<const double> values, std::size_t i) {
  return values.empty() ? std::nullopt : std::optional(values[i]);
}

}  // namespace

void describe_level(const Problem& problem, const NodedSurface& data, const TriangleBasis<double>& basis,
                    const LevelValues& values, LevelOutcome& outcome) {
  const NodalFunction function(data.surface, data.triangulation, basis, values.u_n);
  if (problem.solution) outcome.result.uniform_error = uniform_error(function, *problem.solution);
  outcome.result.piece_means = piece_means(function);
  outcome.result.solution_radius = values.solution_radius;
  if (values.solution_radius) outcome.result.means_radius = means_radius(function, *values.solution_radius);
  for (std::size_t i = 0; i < data.nodes.size(); ++i)
    outcome.nodes.push_back({.piece = data.surface.charts[data.nodes[i].at.chart].facts().piece,
                             .element = i / basis.size(),
                             .index_in_element = i % basis.size(),
                             .point = data.nodes[i].point,
                             .normal = data.nodes[i].normal,
                             .u_n = values.u_n[i],
                             .radius = value_at(values.radius, i),
                             .emission = values.emission[i],
                             .u = value_at(values.u, i)});
  for (std::size_t k = 0; k < data.triangulation.triangles.size(); ++k) {
    const ParameterTriangle& triangle = data.triangulation.triangles[k];
    const Chart& chart = data.surface.charts[triangle.chart];
    ElementValue element{.piece = chart.facts().piece, .corners = {}, .corner_values = {}};
    for (std::size_t c = 0; c < 3; ++c) {
      Barycentric<double> corner{{0, 0, 0}};
      corner.x[c] = 1;
      element.corners[c] = chart.in<double>().frame(triangle.vertices[c]).point;
      element.corner_values[c] = function.at(k, corner);
    }
    outcome.elements.push_back(std::move(element));
  }
}

}  // namespace radcert
