// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "radcert/reference/operator_integral.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"
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

Problem interpolated(Problem problem, int degree, DataPoints data = DataPoints::surface) {
  problem.geometry = InterpolatedGeometry{.degree = degree, .data = data};
  return problem;
}

/// The problem of Table 3 of [ac98] with exact geometry, on S(p).
Problem two_piece_problem(int p) {
  Problem problem = with_solution(sample_problem("two_piece", {{"p", p}}), "x^2 + y^2 + z^2");
  problem.reflectivity = everywhere("1");
  return problem;
}

TEST(InterpolatedGeometry, IsTheExactOneWhereTheSurfaceIsPolynomial) {
  for (const auto& [p, degree] : {std::pair(1, 1), {2, 2}, {3, 3}, {3, 5}})
    for (const DataPoints data : {DataPoints::surface, DataPoints::interpolant}) {
      const Problem problem = two_piece_problem(p);
      const LevelOutcome exact = solve_level(problem, 1, reference::applied_operator);
      const LevelOutcome other =
          solve_level(interpolated(problem, degree, data), 1, reference::applied_operator);
      ASSERT_EQ(other.nodes.size(), exact.nodes.size());
      for (std::size_t i = 0; i < exact.nodes.size(); ++i) {
        EXPECT_NEAR(other.nodes[i].u_n.value, exact.nodes[i].u_n.value, 1e-6) << p << " " << degree;
        EXPECT_NEAR(norm(other.nodes[i].point - exact.nodes[i].point), 0, 1e-14);
        EXPECT_NEAR(norm(other.nodes[i].normal - exact.nodes[i].normal), 0, 1e-13);
      }
      for (const auto figure : {&LevelResult::discretisation_error, &LevelResult::node_error}) {
        const Approximation mine = (other.result.*figure).value();
        const Approximation truth = (exact.result.*figure).value();
        EXPECT_NEAR(mine.value, truth.value, mine.radius + truth.radius) << p << " " << degree;
      }
      EXPECT_EQ(other.result.mesh_size, exact.result.mesh_size);
    }
}

TEST(InterpolatedGeometry, TakesItsDataOnTheSurfaceUnlessToldOtherwise) {
  const Problem problem = with_emission(sample_problem("sphere"), "1 + x*x + y*y + z*z");
  for (const NodeValue& node : solve_level(interpolated(problem, 2), 0, no_route).nodes) {
    EXPECT_NEAR(norm(node.point), 1, 1e-15);
    EXPECT_NEAR(node.emission, 2, 1e-14);
  }
  for (const NodeValue& node :
       solve_level(interpolated(problem, 2, DataPoints::interpolant), 0, no_route).nodes) {
    EXPECT_GT(std::abs(norm(node.point) - 1), 1e-3);
    EXPECT_NEAR(node.emission, 1 + dot(node.point, node.point), 1e-14);
  }
}

TEST(InterpolatedGeometry, IsAFurnaceWhereTheInterpolantIsAConvexPolyhedron) {
  // Degree 1 makes convex polyhedra of the sphere: Int G = pi on them, and u = 1 for E = 1 - rho.
  for (const int level : {0, 1})
    for (int degree = 0; degree <= 2; ++degree)
      for (const DataPoints data : {DataPoints::surface, DataPoints::interpolant}) {
        const Problem problem =
            with_emission(with_basis(sample_problem("sphere"), degree, Rational(1, 8)), "1/2");
        const LevelOutcome outcome = solve_level(interpolated(problem, 1, data), level, no_route);
        for (const NodeValue& node : outcome.nodes) EXPECT_NEAR(node.u_n.value, 1, 1e-12);
        EXPECT_NEAR(outcome.result.norm_K.value, 0.5, 1e-12);
        EXPECT_FALSE(outcome.result.norm_K.guaranteed);
      }
}

TEST(InterpolatedGeometry, MakesNoErrorForALinearSolutionOnFlatElements) {
  // u is linear on each flat element, so P_n u = u where the problem is posed on the interpolant; on S it is
  // not.
  const Problem problem = with_solution(sample_problem("sphere"), "3 + x - 2*y + z/2");
  const LevelResult posed_on_it =
      solve_level(interpolated(problem, 1, DataPoints::interpolant), 0, reference::applied_operator).result;
  EXPECT_LE(posed_on_it.discretisation_error->value, posed_on_it.discretisation_error->radius);
  EXPECT_LE(posed_on_it.node_error->value, posed_on_it.node_error->radius);
  EXPECT_LT(posed_on_it.uniform_error->value, 1e-7);
  const LevelResult posed_on_s = solve_level(interpolated(problem, 1), 0, reference::applied_operator).result;
  EXPECT_GT(posed_on_s.node_error->value, 0.01);
}

TEST(InterpolatedGeometry, HasTheErrorsThatAnotherProgramFound) {
  // S(3), degree 2: products of Gauss rules on triangles divided towards the node, a system of its own.
  struct Case {
    int level;
    double discretisation_error;
    double node_error;
    double posed_on_the_interpolant;
  };
  for (const Case& row : {Case{0, 2.1730e-1, 2.2677e-1, 8.097e-3}, Case{1, 3.2498e-2, 3.2544e-2, 6.124e-4}}) {
    const LevelResult on_s =
        solve_level(interpolated(two_piece_problem(3), 2), row.level, reference::applied_operator).result;
    EXPECT_NEAR(on_s.discretisation_error->value, row.discretisation_error, 2e-4 * row.discretisation_error);
    EXPECT_NEAR(on_s.node_error->value, row.node_error, 2e-4 * row.node_error);
    const LevelResult on_it = solve_level(interpolated(two_piece_problem(3), 2, DataPoints::interpolant),
                                          row.level, reference::applied_operator)
                                  .result;
    EXPECT_NEAR(on_it.discretisation_error->value, row.posed_on_the_interpolant,
                1e-3 * row.posed_on_the_interpolant);
  }
}

TEST(InterpolatedGeometry, PlansForItsCharts) {
  const Problem problem = with_emission(two_piece_problem(3), "1");
  const auto planned = [&](const Problem& of) { return solve_level(of, 1, no_route).result.planned_bytes; };
  // 28 coefficients of degree 6 in double and in packs of eight, for each of 16 elements; and the nodes once
  // more.
  EXPECT_GE(planned(interpolated(problem, 2)), planned(problem) + 16 * 28 * 3 * 9 * sizeof(double));
  EXPECT_LE(planned(interpolated(problem, 2)), planned(problem) + 16 * 10000);
}

constexpr std::uint64_t plenty = std::uint64_t{1} << 40U;

TEST(Check, RefusesInterpolantsOfDegreesOutOfRange) {
  for (const int degree : {-1, 0, 7, 1000}) {
    const InputFault fault = fault_of([&] { check(interpolated(two_piece_problem(3), degree), plenty); });
    EXPECT_EQ(fault.pointer, "/geometry/interpolated");
    EXPECT_EQ(fault.value, std::to_string(degree));
  }
  for (int degree = 1; degree <= 6; ++degree)
    EXPECT_NO_THROW(check(interpolated(two_piece_problem(3), degree), plenty));
}

TEST(Check, RefusesNodesOnSidesOfInterpolatedElements) {
  for (const char* surface : {"sphere", "two_piece"}) {
    Problem problem = with_basis(sample_problem(surface), 1, Rational(0));
    if (problem.surface.name == "two_piece") problem.surface.parameters = {{"p", 2}};
    EXPECT_NO_THROW(check(problem, plenty));
    const InputFault fault = fault_of([&] { check(interpolated(problem, 3), plenty); });
    EXPECT_EQ(fault.pointer, "/basis/alpha");
    EXPECT_NE(fault.problem.find("sides where interpolated elements meet"), std::string::npos);
  }
  // Flat charts are their own interpolants: nothing meets at an angle.
  const Problem flat = with_basis(sample_problem("two_piece", {{"p", 1}}), 1, Rational(0));
  EXPECT_NO_THROW(check(interpolated(flat, 3), plenty));
}

}  // namespace
}  // namespace radcert
