// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/surface/catalogue.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The means over the faces of a tetrahedron of which one emits.
Answer means_of_a_tetrahedron(double width) {
  PolyhedronProblem problem{.panels = convex_panels(default_surface(*find_surface("tetrahedron"))).value(),
                            .reflectivity = std::vector<Rational>(4, Rational(1, 2)),
                            .emission = std::vector(4, constant_polynomial(Rational(0)))};
  problem.emission[0] = constant_polynomial(Rational(1));
  const GoalEnclosure found = enclose_means(problem, width);
  std::vector<Ball> balls;
  for (const Approximation& mean : found.numbers) balls.push_back(number(mean.value, mean.radius));
  return numbers(std::move(balls), found.hindrance);
}

/// The value at the centre of a face of a furnace, u = 1.
Answer value_in_a_furnace() {
  PolyhedronProblem problem{.panels = convex_panels(default_surface(*find_surface("tetrahedron"))).value(),
                            .reflectivity = std::vector<Rational>(4, Rational(1, 2)),
                            .emission = std::vector(4, constant_polynomial(Rational(1, 2)))};
  const GoalEnclosure found = enclose_values(problem, {{2, problem.panels[2].centre}}, 0.1);
  return numbers({number(found.numbers[0].value, found.numbers[0].radius)}, found.hindrance);
}

/// Int w t of a furnace whose trial function is off by a quarter.
Answer product_of_a_furnace() {
  const SectorScene scene(convex_panels(default_surface(*find_surface("cube"))).value());
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const std::vector<double> reflectivity(6, 0.5);
  SectorFunctions q(elements.size(), 1, 0);
  for (double& c : q.all()) c = 1.25;
  const Trial trial(scene, reflectivity, elements,
                    panel_functions(scene, elements, {std::vector<double>(6, 0.5)}, 0), q);
  const CellDemand demand{.interpolation = 1e-2, .quadrature = 1e-3};
  const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
  return numbers({number(sums.products[0].value, sums.products[0].radius)});
}

}  // namespace

std::vector<Case> continuous_cases() {
  return {{.limit = "continuous/goal_enclosure: layers of elements",
           .answer = [] { return means_of_a_tetrahedron(3e-4); },
           .is_long = true},
          {.limit = "continuous/point_values: elements for the kernels of points",
           .answer = value_in_a_furnace,
           .truth = [] { return std::vector<Ball>{Ball(1)}; },
           .is_long = true},
          {.limit = "continuous/trial_functions: Krylov vectors",
           .answer = [] { return means_of_a_tetrahedron(0.1); },
           .is_long = true},
          {.limit = "continuous/observer_cells: cells of an element",
           .answer = product_of_a_furnace,
           .truth = [] { return std::vector<Ball>{Ball(Rational(-54, 64))}; }},
          {.limit = "continuous/observer_cells: halvings of an element",
           .answer = product_of_a_furnace,
           // w = 9/8, t = -1/8, over the area 6
           .truth = [] { return std::vector<Ball>{Ball(Rational(-54, 64))}; }}};
}

}  // namespace radcert::limits
