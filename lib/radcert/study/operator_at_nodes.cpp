// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/operator_at_nodes.h"

#include "radcert/core/parallel.h"
#include "radcert/surface/surface_function.h"

namespace radcert {

OperatorAtNodes apply_operator(const Problem& problem, const Surface& surface, const OperatorRoute& route,
                               std::span<const CollocationPoint<double>> nodes, std::span<const double> rho) {
  const SurfaceFunction u(*problem.solution, surface);
  const AppliedOperator integral_at = route(surface, u);
  OperatorAtNodes result{std::vector<double>(nodes.size()), std::vector<double>(nodes.size())};
  constexpr std::size_t grain = 8;
  parallel_for(nodes.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Approximation integral = integral_at(nodes[i].at);
      result.value[i] = rho[i] / pi<double>() * integral.value;
      result.radius[i] = rho[i] / pi<double>() * integral.radius;
    }
  });
  return result;
}

}  // namespace radcert
