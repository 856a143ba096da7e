// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/coarser_inverses.h"

#include <algorithm>

#include "radcert/collocation/assembly.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/events/event_triangulation.h"

namespace radcert {

std::vector<double> inverse_norms_of_coarser_levels(const Problem& problem, int level,
                                                    const TriangleBasis<double>& basis) {
  constexpr std::size_t wanted = 2;
  const Surface surface = surface_of(problem);
  const TriangulationOptions options = triangulation_options(problem, surface);
  std::vector<double> norms;
  for (int coarser = level - 1; coarser >= 0 && norms.size() < wanted; --coarser) {
    if (triangle_count(surface, coarser, options).value() * basis.size() > most_unknowns_of_inverses)
      continue;
    const LevelGeometry geometry(problem, coarser, basis);
    const std::vector<double> rho =
        reflectivity_at_nodes(problem.reflectivity, geometry.data().surface, geometry.data().nodes);
    const NodedSurface& integrals = geometry.integrals();
    const Tolerance tolerance(problem.quadrature.tolerance.to_double());
    const CollocationMatrix<double> matrix =
        assemble<double>(integrals.surface, integrals.triangulation, basis, integrals.nodes, rho, tolerance);
    norms.push_back(DirectSolver(matrix.entries).inverse_norm());
  }
  std::reverse(norms.begin(), norms.end());
  return norms;
}

}  // namespace radcert
