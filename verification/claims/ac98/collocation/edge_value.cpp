// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/edge_value.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/reference/reference_value.h"
#include "verification/claims/ac98/collocation/known_problems.h"

namespace radcert::verification::ac98 {

Problem constant_emission_on_two_squares(const Rational& reflectivity, const Rational& grading) {
  Problem problem = linear_problem("two_squares", {}, reflectivity.to_text());
  problem.triangulation.grading = grading;
  problem.emission = on_all_pieces("1");
  problem.solver = {.name = "gmres", .tolerance = std::nullopt};
  return problem;
}

EdgeError edge_error(const LevelOutcome& level, const Rational& reflectivity) {
  // Corners are computed from rounded parameters, and vertices on the edge are at least a graded element
  // apart.
  constexpr double on_the_edge = 1e-12;
  // Entries to 1e-13 of their row, times the norm of the inverse, at most 2 here, and 7/3 for u_n at a
  // vertex.
  constexpr double accuracy = 1e-11;
  const double exact = solution_on_the_edge(reflectivity).to_double();
  EdgeError error{.at_midpoint = {.value = 0, .radius = accuracy},
                  .anywhere = {.value = 0, .radius = accuracy}};
  bool found = false;
  for (const ElementValue& element : level.elements)
    for (std::size_t i = 0; i < element.corners.size(); ++i) {
      const Vector<double>& p = element.corners.at(i);
      if (std::abs(p.y) + std::abs(p.z) > on_the_edge) continue;
      if (p.x < on_the_edge || p.x > 1 - on_the_edge) continue;
      const double distance = std::abs(element.corner_values.at(i) - exact);
      error.anywhere.value = std::max(error.anywhere.value, distance);
      if (std::abs(2 * p.x - 1) > on_the_edge) continue;
      error.at_midpoint.value = std::max(error.at_midpoint.value, distance);
      found = true;
    }
  expects(found, "a level with a vertex in the middle of the edge", named("level", level.result.level));
  return error;
}

double edge_exponent(const Rational& reflectivity) {
  const reference::ValueFamily* family = reference::find_family("edge_exponent_90");
  expects(family != nullptr, "the family edge_exponent_90");
  return reference::enclose(*family, {reflectivity}, 8).value().first.value.to_double();
}

}  // namespace radcert::verification::ac98
