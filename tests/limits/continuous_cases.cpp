// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <utility>
#include <vector>

#include "radcert/continuous/ellipsoid/ellipsoid_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/continuous/residual.h"
#include "radcert/continuous/trial_functions.h"
#include "radcert/expression/parse.h"
#include "radcert/surface/catalogue.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The means over the faces of a tetrahedron of which one emits.
Answer means_of_a_tetrahedron(std::vector<PanelReflectivity> reflectivity, double width) {
  PolyhedronProblem problem{.panels = convex_panels(default_surface(*find_surface("tetrahedron"))).value(),
                            .reflectivity = std::move(reflectivity),
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
                            .reflectivity = std::vector<PanelReflectivity>(4, Rational(1, 2)),
                            .emission = std::vector(4, constant_polynomial(Rational(1, 2)))};
  const GoalEnclosure found = enclose_values(problem, {{2, problem.panels[2].centre}}, 1.5);
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
  const CellDemand demand{.interpolation = 3e-2, .quadrature = 3e-3};
  const ResidualSums sums = residual_sums(trial, observer_cells(trial, demand), demand);
  return numbers({number(sums.products[0].value, sums.products[0].radius)});
}

/// sup rho of 9/10 + s/9 - s^2/3 - t^2/7 on a square with the corners (0,0), (1,0), (0,1), (-1,1).
Answer reflectivity_of_a_square() {
  const Panel square = convex_panels(default_surface(*find_surface("cube"))).value()[0];
  PlanePolynomial<Rational> rho(2);
  rho(0, 0) = Rational(9, 10);
  rho(1, 0) = Rational(1, 9);
  rho(2, 0) = Rational(-1, 3);
  rho(0, 2) = Rational(-1, 7);
  const Outcome<PanelReflectivity> found = reflectivity_of(square, rho);
  if (!found) return refusal(found.reason());
  return numbers({hull(Ball(found->seen), Ball(found->largest))});
}
/// At s = 1/6, t = 0.
std::vector<Ball> top_of_the_reflectivity() { return {Ball(Rational(9, 10) + Rational(1, 108))}; }

/// The mean of u, and its value at a point.
Answer solution_on_an_ellipsoid(const std::string& emission) {
  const EllipsoidProblem problem{.half_axes = {1, Rational(6, 5), Rational(3, 2)},
                                 .reflectivity = parse_expression("1/2 + x*y/5").value(),
                                 .emission = parse_expression(emission).value()};
  const EllipsoidEnclosure found = enclose_on_ellipsoid(problem, 1e-3).value();
  if (!(found.bound < std::numeric_limits<double>::infinity())) return refusal(found.hindrance);
  const Approximation value = found.at({0.6, 0, -0.8});
  return numbers({number(found.mean.value, found.mean.radius), number(value.value, value.radius)},
                 found.hindrance);
}
/// E = 2 (1 - rho): u = 2, which no part of the search knows.
Answer furnace_on_an_ellipsoid() { return solution_on_an_ellipsoid("1 - x*y*2/5"); }
std::vector<Ball> twice_two() { return {Ball(2), Ball(2)}; }

}  // namespace

std::vector<Case> continuous_cases() {
  return {{.limit = "continuous/ellipsoid_enclosure: degree of harmonics",
           .answer = [] { return solution_on_an_ellipsoid("x^2 - z"); }},
          {.limit = "continuous/ellipsoid_enclosure: millions of products",
           .answer = furnace_on_an_ellipsoid,
           .truth = twice_two},
          {.limit = "continuous/ellipsoid_transport: nodes of a rule",
           .answer = furnace_on_an_ellipsoid,
           .truth = twice_two},
          {.limit = "continuous/goal_enclosure: layers of elements",
           // Faces that reflect much need small elements soon, and black ones have no residuals.
           .answer =
               [] {
                 const Rational much(9, 10);
                 return means_of_a_tetrahedron({much, much, Rational(0), Rational(0)}, 5e-3);
               },
           .is_long = true},
          {.limit = "continuous/panel_reflectivity: triangles of a panel",
           .answer = reflectivity_of_a_square,
           .truth = top_of_the_reflectivity},
          {.limit = "continuous/point_values: elements for the kernels of points",
           .answer = value_in_a_furnace,
           .truth = [] { return std::vector<Ball>{Ball(1)}; },
           .is_long = true},
          {.limit = "continuous/trial_functions: Krylov vectors",
           .answer =
               [] { return means_of_a_tetrahedron(std::vector<PanelReflectivity>(4, Rational(1, 2)), 0.5); },
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
