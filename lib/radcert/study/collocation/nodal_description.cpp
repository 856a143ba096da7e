// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_description.h"

#include <algorithm>
#include <vector>

#include "radcert/study/collocation/nodal_function.h"
#include "radcert/study/computed_function.h"

namespace radcert {

void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome) {
  std::vector<double> at_nodes;
  double radius = 0;
  bool known = true;
  for (const Approximation& value : values.u_n) {
    at_nodes.push_back(value.value);
    known = known && value.has_radius();
    radius = std::max(radius, value.radius);
  }
  const NodalFunction u_n(data.surface, data.triangulation, basis, at_nodes);
  describe_level(problem, u_n.computed(),
                 {.nodes = data.nodes,
                  .nodes_per_element = basis.size(),
                  .u_n = values.u_n,
                  .emission = values.emission,
                  .u = values.u},
                 nodal_mean_order, outcome);
  if (!known) return;
  outcome.result.solution_radius = radius;
  const double of_means = radius_of_means(u_n, radius);
  for (auto& [piece, mean] : outcome.result.piece_means)
    mean = Approximation::estimated(mean.value, of_means);
}

}  // namespace radcert
