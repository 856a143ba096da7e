// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/mean_enclosure.h"
#include "radcert/continuous/residual.h"
#include "radcert/surface/catalogue.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The means over the faces of a tetrahedron of which one emits.
Answer means_of_a_tetrahedron(double width) {
  PolyhedronProblem problem{.panels = convex_panels(default_surface(*find_surface("tetrahedron"))).value(),
                            .reflectivity = std::vector<Rational>(4, Rational(1, 2)),
                            .emission = {1, 0, 0, 0}};
  const MeanEnclosure found = enclose_means(problem, width);
  std::vector<Ball> balls;
  for (const Approximation& mean : found.means) balls.push_back(number(mean.value, mean.radius));
  return numbers(std::move(balls), found.hindrance);
}

/// Int w t of a furnace whose trial function is off by a quarter.
Answer product_of_a_furnace() {
  const SectorScene scene(convex_panels(default_surface(*find_surface("cube"))).value());
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  const PanelData data{.reflectivity = std::vector<double>(6, 0.5),
                       .emissions = {std::vector<double>(6, 0.5)}};
  SectorFunctions q(elements.size(), 1, 0);
  for (double& c : q.all()) c = 1.25;
  const SectorFunctions w = densities(scene, elements, data, q);
  const Smoothness smoothness(scene, elements, w, q);
  const CellDemand demand{.interpolation = 1e-2, .quadrature = 1e-3};
  const ResidualSums sums = residual_sums(scene, elements, data, w, q, smoothness,
                                          observer_cells(scene, elements, smoothness, demand), demand);
  return numbers({number(sums.products[0].value, sums.products[0].radius)});
}

}  // namespace

std::vector<Case> continuous_cases() {
  return {{.limit = "continuous/mean_enclosure: layers of elements",
           .answer = [] { return means_of_a_tetrahedron(3e-4); },
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
