// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (7) on the cube, a box, the sphere and the ellipsoid (1,2,5): the least and the largest
//              integral over collocation nodes and over random points, some near the edges, by cubature that
//              knows no triangulation. The same through the pipeline: with the emission 1 - rho the
//              collocation solution is the constant 1 exactly if every row of the matrix sums to rho. G >= 0
//              on all pairs of a sample.
// Not checked  points closer to an edge than a hundredth of its face, and G >= 0 off the sample.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "radcert/expression/expression.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "verification/claims/ac98/surfaces/sample_points.h"
#include "verification/claims/ac98/surfaces/total_factor.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

struct NamedSurface {
  std::string name;
  Surface surface;
};

std::vector<NamedSurface> closed_surfaces() {
  return {{"cube", cube()},
          {"box(1,2,5)", box(1, 2, 5)},
          {"sphere", sphere()},
          {"ellipsoid(1,2,5)", ellipsoid(1, 2, 5)}};
}

// The cube without its ceiling: an integral that is short by what the ceiling covers.
Surface open_cube() {
  Surface surface = cube();
  surface.charts.pop_back();
  surface.diagonals.pop_back();
  surface.closed = false;
  return surface;
}

// The cube with the ceiling's normal pointing out of it.
Surface cube_with_a_wrong_normal() {
  Surface surface = open_cube();
  surface.charts.push_back(make_rectangle(
      {.name = "ceiling", .piece = "ceiling", .orientation = Orientation::along_the_cross_product}, {0, 0, 1},
      {1, 0, 0}, {0, 1, 0}));
  surface.diagonals.push_back(Diagonal::main);
  return surface;
}

const Equals& integral_is_pi() {
  static const Equals pi{.value = std::numbers::pi,
                         .slack = 1e-10,
                         .why =
                             "above the cubature's 1e-13 of the sum, even near an edge, and far below what "
                             "any face contributes"};
  return pi;
}

const AtMost& never_negative() {
  static const AtMost zero{
      .value = 0, .slack = 1e-8, .why = "rounding of the coordinates of points that are 1e-3 apart"};
  return zero;
}

Approximation negated(const Approximation& m) {
  return {.value = 0 - m.value, .radius = m.radius, .guaranteed = m.guaranteed};
}

PiecewiseExpression everywhere(const Rational& value) {
  return {.cases = {{"*", Expression::constant(value)}}};
}

// The problem with the emission 1 - rho, whose solution (7) makes 1 everywhere.
Problem constant_problem(const Surface& surface) {
  Problem problem;
  problem.surface = {.name = surface.name, .parameters = surface.parameters};
  problem.triangulation.levels = {0, 1};
  problem.method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}};
  problem.reflectivity = everywhere(Rational(1, 2));
  problem.emission = everywhere(Rational(1, 2));
  return problem;
}

// u_n - 1, furthest from 0 over the nodes.
Approximation furthest_from_one(const LevelOutcome& level) {
  Approximation worst{.value = 0, .radius = 0};
  for (const NodeValue& node : level.nodes)
    if (std::abs(node.u_n.value - 1) > std::abs(worst.value)) worst.value = node.u_n.value - 1;
  return worst;
}

}  // namespace

Finding lemma_2_1(const Bench& bench) {
  const std::size_t per_chart = bench.budget == Budget::quick      ? 6
                                : bench.budget == Budget::standard ? 40
                                                                   : 200;
  const int node_level = bench.budget == Budget::quick ? 0 : 1;
  Finding finding;
  double furthest = 0;
  for (const NamedSurface& each : closed_surfaces()) {
    std::vector<SurfacePoint<double>> points = collocation_points(each.surface, node_level, Rational(1, 6));
    for (const SurfacePoint<double>& p : random_points(each.surface, per_chart, 21)) points.push_back(p);
    const std::string at = ", " + each.name + ", " + std::to_string(points.size()) + " points";
    const Extremes extremes = total_factors(each.surface, points);
    finding.require("least integral of G" + at, integral_is_pi(), extremes.least);
    finding.require("largest integral of G" + at, integral_is_pi(), extremes.largest);
    furthest = std::max({furthest, std::abs(extremes.least.value - std::numbers::pi) + extremes.least.radius,
                         std::abs(extremes.largest.value - std::numbers::pi) + extremes.largest.radius});
    finding.require("-G, largest over the pairs" + at, never_negative(),
                    negated(least_kernel(each.surface, points)));
    const Equals zero{.value = 0,
                      .slack = 1e-10,
                      .why = "entries are integrated to 1e-12 of their row, and 1/(1 - rho) is 2"};
    for (const int level : constant_problem(each.surface).triangulation.levels)
      finding.require(
          "u_n - 1 for E = 1 - rho, furthest from 0, " + each.name + ", level " + std::to_string(level), zero,
          furthest_from_one(bench.levels.level(constant_problem(each.surface), level)));
  }
  const Surface open = open_cube();
  const Surface wrong = cube_with_a_wrong_normal();
  const std::vector<SurfacePoint<double>> of_open = random_points(open, 2, 22);
  const std::vector<SurfacePoint<double>> of_wrong = random_points(wrong, 2, 23);
  finding.control("largest integral of G, the cube without its ceiling", integral_is_pi(),
                  total_factors(open, of_open).largest);
  finding.control("largest integral of G, the cube with a normal that points outwards", integral_is_pi(),
                  total_factors(wrong, of_wrong).largest);
  finding.control("-G, the cube with a normal that points outwards", never_negative(),
                  negated(least_kernel(wrong, of_wrong)));
  finding.show({.value = std::numbers::pi, .radius = furthest});
  return finding;
}

}  // namespace radcert::verification::ac98
