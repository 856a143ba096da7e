// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/iterated_solution.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "radcert/core/parallel.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/collocation/solution_level.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::everywhere;
using testing::fault_of;
using testing::no_route;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

const std::string smooth = "exp(x/2 + y/3 - z/4)";

Problem ellipsoid() {
  Problem problem = with_solution(
      sample_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 4)}, {"c", Rational(1, 2)}}), smooth);
  problem.iterated = true;
  return problem;
}

Problem box() {
  Problem problem = with_solution(sample_problem("box", {{"a", 1}, {"b", 2}, {"c", 3}}), smooth);
  problem.iterated = true;
  return problem;
}

/// The L-shaped room, whose arms hide each other.
Problem l_room() {
  const TriangleMesh mesh = sample::mesh_of(sample::l_shaped_room());
  const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
  Problem problem = sample_problem("l_room");
  problem.surface.mesh.emplace();
  problem.surface.mesh->surface = std::make_shared<const Surface>(mesh_surface(
      "l_room", mesh, components.of_piece, piece_names(mesh, components),
      {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = false}));
  problem.iterated = true;
  return problem;
}

LevelOutcome solved(const Problem& problem, int level) {
  return solve_level(problem, level, reference::applied_operator);
}

std::vector<Approximation> values_of(const LevelOutcome& outcome) {
  std::vector<Approximation> out;
  for (const NodeValue& node : outcome.nodes) out.push_back(node.u_n);
  return out;
}

/// All that an iterated solution refers to.
struct Setting {
  Problem problem;
  LevelOutcome outcome;
  TriangleBasis<double> basis;
  LevelGeometry geometry;
  OperatorRoute route = reference::applied_operator;

  Setting(Problem of, int level)
      : problem(std::move(of)),
        outcome(solved(problem, level)),
        basis(triangle_basis(triangle_basis_of(problem.method))),
        geometry(problem, level, basis) {}
  [[nodiscard]] IteratedSolution iterated(std::span<const Approximation> u_n) const {
    return {problem, geometry.data(), basis, u_n, route};
  }
};

TEST(IteratedSolution, HasTheValuesOfTheComputedFunctionAtTheNodes) {
  // u_n(v) = E(v) + K u_n(v) is the equation that was solved.
  std::vector<Problem> problems = {ellipsoid(), box(), with_basis(ellipsoid(), 2, Rational(1, 10)),
                                   with_emission(box(), "z"), with_emission(l_room(), "z")};
  problems.push_back(box());
  problems.back().solver.name = "verified";
  for (const Problem& problem : problems) {
    const Setting setting(problem, problem.solver.name == "verified" ? 0 : 1);
    const std::vector<Approximation> u_n = values_of(setting.outcome);
    const std::vector<IteratedValue> found = setting.iterated(u_n).at(setting.geometry.data().nodes);
    ASSERT_EQ(found.size(), u_n.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_LE(std::abs(found[i].value.value - u_n[i].value), found[i].value.radius + u_n[i].radius)
          << problem.surface.name << " " << i;
      EXPECT_LT(found[i].value.radius, 1e-9) << problem.surface.name;
    }
    if (problem.solution) {
      const LevelResult& result = setting.outcome.result;
      EXPECT_NEAR(result.iterated->node_error->value, result.node_error->value,
                  result.iterated->node_error->radius + result.node_error->radius);
    }
  }
}

TEST(IteratedSolution, IsWhatTheSecondRouteSays) {
  // K u_n by the cubature of `reference` over each element, which shares no rule with the matrix.
  for (const Problem& problem : {with_emission(ellipsoid(), smooth), with_emission(box(), smooth)}) {
    const Setting setting(problem, 0);
    const NodedSurface& level = setting.geometry.data();
    const std::vector<Approximation> u_n = values_of(setting.outcome);
    const std::vector<CollocationPoint<double>> points = check_points_of(level);
    const std::vector<IteratedValue> found = setting.iterated(u_n).at(points);
    for (std::size_t i = 0; i < points.size(); i += 7) {
      double sum = 0;
      double radius = 0;
      for (std::size_t k = 0; k < level.triangulation.triangles.size(); ++k) {
        const ParameterTriangle& triangle = level.triangulation.triangles[k];
        const auto density = [&](const SurfacePoint<double>& q, const Vector<double>&) {
          const auto& v = triangle.vertices;
          const double whole = cross(v[1] - v[0], v[2] - v[0]);
          const double b = cross(q.at - v[0], v[2] - v[0]) / whole;
          const double c = cross(v[1] - v[0], q.at - v[0]) / whole;
          std::vector<double> l(setting.basis.size());
          setting.basis.values(Barycentric<double>{{1 - b - c, b, c}}, l);
          double value = 0;
          for (std::size_t j = 0; j < l.size(); ++j) value += l[j] * u_n[k * l.size() + j].value;
          return value;
        };
        const Approximation part = reference::operator_integral(level.surface, points[i].at, triangle.chart,
                                                                triangle.vertices, density);
        sum += part.value;
        radius += part.radius;
      }
      const Vector<double>& p = points[i].point;
      const double expected = std::exp(p.x / 2 + p.y / 3 - p.z / 4) + 0.5 / std::numbers::pi * sum;
      EXPECT_NEAR(found[i].value.value, expected, found[i].value.radius + radius + 1e-14)
          << problem.surface.name << " " << i;
    }
  }
}

TEST(IteratedSolution, IsOneInAFurnaceAroundACorner) {
  const Setting setting(with_emission(l_room(), "1/2"), 1);
  const std::vector<Approximation> u_n = values_of(setting.outcome);
  for (const IteratedValue& value : setting.iterated(u_n).at(check_points_of(setting.geometry.data()))) {
    EXPECT_NEAR(value.value.value, 1, value.value.radius);
    EXPECT_LT(value.value.radius, 1e-11);
  }
}

TEST(IteratedSolution, SumsTheTermsOfItsRadius) {
  const Setting setting(box(), 0);
  const std::vector<Approximation> u_n = values_of(setting.outcome);
  for (const IteratedValue& at : setting.iterated(u_n).at(check_points_of(setting.geometry.data()))) {
    const auto& [quadrature, nodes, data, rounding] = at.terms;
    EXPECT_DOUBLE_EQ(at.value.radius, quadrature + nodes + data + rounding);
    for (const double term : {quadrature, nodes, data, rounding}) EXPECT_GT(term, 0);
    EXPECT_GE(at.error->radius, at.value.radius);
  }
}

TEST(IteratedSolution, MovesWithTheNodesByNoMoreThanItsTermSays) {
  // The worst change of nodal values within r, for one point: each by r with the sign of its integral; found
  // by moving one node after the other. The term is that and the radii of the integrals. Quadratic functions
  // have integrals of both signs.
  const Setting setting(with_emission(with_basis(box(), 2, Rational(1, 100)), smooth), 0);
  const double r = 0.25;
  std::vector<Approximation> u_n = values_of(setting.outcome);
  for (Approximation& value : u_n) value = Approximation::estimated(value.value, r);
  const std::array<CollocationPoint<double>, 1> point = {check_points_of(setting.geometry.data())[5]};
  const IteratedValue before = setting.iterated(u_n).at(point).front();
  double moved = 0;
  for (Approximation& value : u_n) {
    const Approximation kept = value;
    value = Approximation::estimated(kept.value + r, r);
    moved += std::abs(setting.iterated(u_n).at(point).front().value.value - before.value.value);
    value = kept;
  }
  EXPECT_LE(moved, before.terms.nodes * (1 + 1e-12));
  EXPECT_GE(moved, before.terms.nodes * (1 - 1e-9));
}

TEST(IteratedSolution, KnowsWhatACoarseQuadratureLeavesOut) {
  Problem problem = with_emission(ellipsoid(), smooth);
  const Setting fine(problem, 1);
  const std::vector<Approximation> u_n = values_of(fine.outcome);
  const std::vector<CollocationPoint<double>> points = check_points_of(fine.geometry.data());
  const std::vector<IteratedValue> accurate = fine.iterated(u_n).at(points);
  problem.quadrature.tolerance = Rational(1, 10000);
  const std::vector<IteratedValue> rough =
      IteratedSolution(problem, fine.geometry.data(), fine.basis, u_n, fine.route).at(points);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double difference = std::abs(rough[i].value.value - accurate[i].value.value);
    EXPECT_LE(difference, rough[i].terms.quadrature + accurate[i].value.radius);
    worst = std::max(worst, difference);
  }
  EXPECT_GT(worst, 1e-11);
}

TEST(IteratedSolution, KnowsTheRadiusOfTheSecondRoute) {
  // A route that is off by as much as it says moves E, and the iterated solution with it.
  const Setting setting(box(), 0);
  const std::vector<Approximation> u_n = values_of(setting.outcome);
  const double off = 1e-3;
  const OperatorRoute wrong = [off](const Surface& surface, const SurfaceFunction& u) {
    return [right = reference::applied_operator(surface, u), off](const SurfacePoint<double>& p) {
      const Approximation ku = right(p);
      return Approximation::estimated(ku.value + off, ku.radius + off);
    };
  };
  const std::vector<CollocationPoint<double>> points = check_points_of(setting.geometry.data());
  const std::vector<IteratedValue> right = setting.iterated(u_n).at(points);
  const std::vector<IteratedValue> moved =
      IteratedSolution(setting.problem, setting.geometry.data(), setting.basis, u_n, wrong).at(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double by = off * 0.5 / std::numbers::pi;
    EXPECT_NEAR(right[i].value.value - moved[i].value.value, by, 1e-12);
    EXPECT_LE(by, moved[i].terms.data);
    EXPECT_LE(std::abs(moved[i].error->value - right[i].error->value), moved[i].error->radius);
  }
}

TEST(IteratedSolution, HasTheErrorOfItsValue) {
  // Two ways to the error: K u_n - K u, and the difference from u itself.
  const Setting setting(ellipsoid(), 1);
  const std::vector<Approximation> u_n = values_of(setting.outcome);
  const std::vector<CollocationPoint<double>> points = check_points_of(setting.geometry.data());
  const std::vector<IteratedValue> found = setting.iterated(u_n).at(points);
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector<double>& p = points[i].point;
    const double u = std::exp(p.x / 2 + p.y / 3 - p.z / 4);
    EXPECT_NEAR(found[i].error->value, std::abs(u - found[i].value.value), found[i].error->radius);
    largest = std::max(largest, found[i].error->value);
  }
  const LevelResult& result = setting.outcome.result;
  EXPECT_EQ(result.iterated->check_points, points.size());
  EXPECT_EQ(result.iterated_error->value, largest);
  EXPECT_LT(largest, result.iterated->u_n_error->value / 4);
  EXPECT_LE(result.iterated->u_n_error->value, 2 * result.uniform_error->value);
}

TEST(IteratedSolution, HasOrdersOfItsOwn) {
  // alpha = 1/6: four everywhere for the iterated solution, two for u_n.
  Problem problem = with_solution(sample_problem("sphere"), smooth);
  problem.iterated = true;
  std::vector<LevelResult> levels;
  for (int level = 0; level <= 2; ++level) levels.push_back(solved(problem, level).result);
  const Result result = collect(problem, levels, std::vector<LevelTiming>(3));
  EXPECT_GT(*result.levels[2].iterated->order, 3.4);
  EXPECT_LT(*result.levels[2].iterated->u_n_order, 2.5);
  EXPECT_FALSE(result.levels[0].iterated->order);
  ASSERT_EQ(result.orders.size(), 4);
  EXPECT_EQ(result.orders[2].quantity, "iterated_error");
  EXPECT_GT(*result.orders[2].order, *result.orders[3].order + 1);
}

TEST(IteratedSolution, IsDrawnAtTheCornersOfSmoothSurfaces) {
  const LevelOutcome outcome = solved(ellipsoid(), 2);
  for (const ElementValue& element : outcome.elements)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector<double>& p = element.corners[c];
      const double u = std::exp(p.x / 2 + p.y / 3 - p.z / 4);
      EXPECT_NEAR(element.iterated.value()[c], u, 2 * outcome.result.iterated_error->value);
    }
}

TEST(IteratedSolution, IsDrawnNearItsValuesAtEdges) {
  // There is no one value: what is drawn is continued from inside the face.
  const LevelOutcome outcome = solved(box(), 1);
  for (const ElementValue& element : outcome.elements)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector<double>& p = element.corners[c];
      EXPECT_NEAR(element.iterated.value()[c], std::exp(p.x / 2 + p.y / 3 - p.z / 4), 0.1);
    }
}

TEST(IteratedSolution, HasCheckPointsThatMakeARuleOfDegreeTwo) {
  const std::vector<Barycentric<Rational>> points = check_points();
  ASSERT_EQ(points.size(), 6);
  for (const Barycentric<Rational>& x : points) {
    EXPECT_EQ(x.x[0] + x.x[1] + x.x[2], Rational(1));
    for (const Rational& coordinate : x.x) EXPECT_GT(coordinate, Rational(0));
  }
  EXPECT_TRUE(static_cast<bool>(lagrange_functions(points)));
}

TEST(IteratedSolution, TakesMeansByARuleOfDegreeTwo) {
  // Where nothing is reflected it is E, and the rule is exact for polynomials of degree 2 on plane faces.
  Problem problem = with_emission(box(), "x^2 + x*y - 3*z");
  problem.reflectivity = everywhere("0");
  const LevelOutcome outcome = solved(problem, 0);
  const auto& means = outcome.result.iterated->piece_means;
  ASSERT_EQ(means.size(), 6);
  // West, east, south, north, floor, ceiling of [0,1] x [0,2] x [0,3].
  const std::array<double, 6> exact = {-4.5,          1 + 1 - 4.5,      1.0 / 3 - 4.5, 1.0 / 3 + 1 - 4.5,
                                       1.0 / 3 + 0.5, 1.0 / 3 + 0.5 - 9};
  for (std::size_t i = 0; i < means.size(); ++i)
    EXPECT_NEAR(means[i].second, exact[i], 1e-12) << means[i].first;
}

TEST(IteratedSolution, HasTheErrorsInTheMeanOfAConstantOffset) {
  // u = E + Ku with a route that is off by a constant: the iterated solution is off by that at every point.
  Problem problem = with_solution(box(), "1 + x");
  const double off = 0.5;
  const OperatorRoute wrong = [off](const Surface& surface, const SurfaceFunction& u) {
    return [right = reference::applied_operator(surface, u), off](const SurfacePoint<double>& p) {
      const Approximation ku = right(p);
      return Approximation::estimated(ku.value + off, ku.radius);
    };
  };
  // u_n solves with E - rho off/pi, and 1 - K is 1/2 on constants: u - u_n = rho off/pi/(1 - rho).
  const LevelOutcome outcome = solve_level(problem, 1, wrong);
  const LevelOutcome right = solved(problem, 1);
  const double by = 0.5 * off / std::numbers::pi / 0.5;
  EXPECT_NEAR(outcome.result.mean_error->value, by, 1e-3);
  EXPECT_NEAR(*outcome.result.iterated->mean_error, by, 1e-3);
  // The area of the box is 22.
  EXPECT_NEAR(*outcome.result.iterated->l2_error, by * std::sqrt(22), 2e-3);
  EXPECT_NEAR(outcome.result.l2_error->value, by * std::sqrt(22), 2e-3);
  EXPECT_LT(right.result.mean_error->value, by / 50);
}

TEST(IteratedSolution, IsTheSameForAnyNumberOfThreads) {
  const Setting setting(ellipsoid(), 1);
  const std::vector<Approximation> u_n = values_of(setting.outcome);
  const std::vector<CollocationPoint<double>> points = check_points_of(setting.geometry.data());
  const std::vector<IteratedValue> many = setting.iterated(u_n).at(points);
  const ThreadLimit one(1);
  const std::vector<IteratedValue> alone = setting.iterated(u_n).at(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(many[i].value.value, alone[i].value.value);
    EXPECT_EQ(many[i].value.radius, alone[i].value.radius);
  }
}

TEST(IteratedSolution, IsRefusedWhereThereIsNone) {
  Problem interpolated = ellipsoid();
  interpolated.geometry.emplace();
  constexpr std::uint64_t enough = std::uint64_t{1} << 32U;
  EXPECT_EQ(fault_of([&] { check(interpolated, enough); }).pointer, "/iterated");
  Problem meshless = ellipsoid();
  meshless.method = Meshless{};
  EXPECT_EQ(fault_of([&] { check(meshless, enough); }).pointer, "/iterated");
}

TEST(SolutionLevel, SpreadsPointsByArea) {
  const Problem problem = with_emission(box(), "1/2");
  const LevelOutcome outcome = solved(problem, 0);
  const SolutionLevel level(problem, outcome);
  const std::vector<SurfacePlace> places = level.spread(2200);
  ASSERT_EQ(places.size(), 2200);
  std::array<int, 6> of_piece{};
  for (const SurfacePlace& place : places) {
    const ParameterTriangle& triangle = level.surface().triangulation.triangles[place.element];
    ++of_piece[level.surface().surface.piece_of(triangle.chart)];
    EXPECT_FALSE(level.is_on_edge(place));
    EXPECT_EQ(level.place_of(triangle.chart, place.at)->element, place.element);
  }
  // The faces of 1 x 2 x 3 have the areas 6, 6, 3, 3, 2, 2 of 22.
  EXPECT_EQ(of_piece, (std::array<int, 6>{600, 600, 300, 300, 200, 200}));
}

TEST(SolutionLevel, MeansOverTheSpreadAreThoseOfThePieces) {
  const Problem problem = with_emission(box(), "z/4");
  const LevelOutcome outcome = solved(problem, 1);
  const SolutionLevel level(problem, outcome);
  const std::vector<SurfacePlace> places = level.spread(4400);
  const std::vector<ValueAt> values = level.values_at(places, false, no_route);
  double sum = 0;
  for (const ValueAt& value : values) {
    EXPECT_FALSE(value.iterated || value.u);
    sum += value.u_n.value;
  }
  const std::array<double, 6> areas = {6, 6, 3, 3, 2, 2};
  double expected = 0;
  for (std::size_t i = 0; i < areas.size(); ++i)
    expected += areas[i] / 22 * outcome.result.piece_means[i].second.value;
  EXPECT_NEAR(sum / 4400, expected, 1e-3);
}

TEST(SolutionLevel, GivesAllThatIsKnownAtAPlace) {
  const Problem problem = ellipsoid();
  const LevelOutcome outcome = solved(problem, 1);
  const SolutionLevel level(problem, outcome);
  const std::vector<SurfacePlace> places = level.spread(20);
  for (const ValueAt& at : level.values_at(places, true, reference::applied_operator)) {
    EXPECT_NEAR(at.u->value, std::exp(at.point.x / 2 + at.point.y / 3 - at.point.z / 4), at.u->radius);
    EXPECT_EQ(at.u_n_error->value, std::abs(at.u->value - at.u_n.value));
    EXPECT_LT(at.iterated->error->value, 1e-2);
  }
}

}  // namespace
}  // namespace radcert
