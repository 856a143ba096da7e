// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/plan.h"

#include <algorithm>
#include <limits>

#include "radcert/core/checked.h"
#include "radcert/solve/gmres.h"

namespace radcert {

MemoryPlan level_plan(std::uint64_t elements, std::uint64_t functions_per_element, SolverName solver,
                      const std::optional<InterpolatedGeometry>& geometry) {
  constexpr std::uint64_t beyond = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t unknowns = checked_multiply(elements, functions_per_element).value_or(beyond);
  const std::uint64_t squared = checked_multiply(unknowns, unknowns).value_or(beyond);
  constexpr std::uint64_t chunks = 64;
  constexpr std::uint64_t vectors_of_rows = 2 * chunks + 16;
  constexpr std::uint64_t bytes_per_node_record = 256;
  MemoryPlan plan;
  plan.add("collocation matrix", squared, sizeof(double));
  if (solver == SolverName::verified)
    plan.add("radii, inverse and defect of I - K, and a copy to work on",
             checked_multiply(squared, 4).value_or(beyond), sizeof(double));
  if (solver == SolverName::direct) plan.add("factors of I - K", squared, sizeof(double));
  if (solver == SolverName::gmres)
    plan.add("Krylov vectors", unknowns,
             (std::min<std::uint64_t>(unknowns, krylov_dimension.count()) + 1) * sizeof(double));
  plan.add("row sums and vectors", unknowns, vectors_of_rows * sizeof(double));
  plan.add("nodes", unknowns, bytes_per_node_record);
  plan.add("triangles", elements, bytes_per_node_record);
  if (geometry) {
    constexpr std::uint64_t bytes_per_interpolated_chart =
        8192;  // the coefficients of degree 6, names, expressions
    plan.add("interpolated charts", elements, bytes_per_interpolated_chart);
    plan.add("interpolated nodes", unknowns, bytes_per_node_record);
  }
  return plan;
}

}  // namespace radcert
