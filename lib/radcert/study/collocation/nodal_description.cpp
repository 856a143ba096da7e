// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_description.h"

#include "radcert/study/collocation/nodal_function.h"
#include "radcert/study/computed_function.h"

namespace radcert {

void describe_collocation(const Problem& problem, const NodedSurface& data,
                          const TriangleBasis<double>& basis, const CollocationValues& values,
                          LevelOutcome& outcome) {
  const NodalFunction u_n(data.surface, data.triangulation, basis, values.u_n);
  describe_level(problem, u_n.computed(),
                 {.nodes = data.nodes,
                  .nodes_per_element = basis.size(),
                  .u_n = values.u_n,
                  .radius = values.radius,
                  .emission = values.emission,
                  .u = values.u},
                 nodal_mean_order, outcome);
  outcome.result.solution_radius = values.solution_radius;
  if (values.solution_radius) outcome.result.means_radius = means_radius(u_n, *values.solution_radius);
}

}  // namespace radcert
