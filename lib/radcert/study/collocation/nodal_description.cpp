// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_description.h"

#include <algorithm>
#include <vector>

#include "radcert/study/computed_function.h"

namespace radcert {

void describe_numbers(const Problem& problem, const NodalFunction& u_n, const std::optional<double>& radius,
                      LevelResult& result) {
  describe_numbers(problem, u_n.computed(), nodal_mean_order, result);
  if (!radius) return;
  result.solution_radius = radius;
  const double of_means = radius_of_means(u_n, *radius);
  for (auto& [piece, mean] : result.piece_means) mean = Approximation::estimated(mean.value, of_means);
}

void describe_fields(const NodedSurface& data, const TriangleBasis<double>& basis,
                     const CollocationValues& values, LevelOutcome& outcome) {
  std::vector<double> at_nodes;
  for (const Approximation& value : values.u_n) at_nodes.push_back(value.value);
  const NodalFunction u_n(data.surface, data.triangulation, basis, at_nodes);
  describe_fields(u_n.computed(),
                  {.nodes = data.nodes,
                   .nodes_per_element = basis.size(),
                   .u_n = values.u_n,
                   .emission = values.emission,
                   .u = values.u},
                  outcome);
}

void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome) {
  std::vector<double> at_nodes;
  std::optional<double> radius = 0;
  for (const Approximation& value : values.u_n) {
    at_nodes.push_back(value.value);
    radius = radius && value.has_radius() ? std::optional(std::max(*radius, value.radius)) : std::nullopt;
  }
  describe_numbers(problem, NodalFunction(data.surface, data.triangulation, basis, at_nodes), radius,
                   outcome.result);
  describe_fields(data, basis, values, outcome);
}

}  // namespace radcert
