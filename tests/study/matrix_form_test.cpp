// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/matrix_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/collocation/nodes.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/study/collocation/collocation.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/study.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::no_route;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

Problem held_as(Problem problem, const std::string& name, const std::string& solver = "gmres") {
  problem.matrix.name = name;
  problem.matrix.tolerance = Rational(1, 100000000);
  problem.solver.name = solver;
  return problem;
}

Problem on_ellipsoid() {
  return with_emission(
      with_basis(sample_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}}), 1, Rational(1, 6)),
      "1 + x*y + exp(z)");
}

InputFault refused(const Problem& problem) {
  return fault_of([&] { check(problem, std::numeric_limits<std::uint64_t>::max() - 1); });
}

TEST(MatrixForm, LeavesTheSolutionWithinItsRadius) {
  constexpr int level = 4;
  const LevelOutcome dense = solve_level(held_as(on_ellipsoid(), "dense"), level, no_route);
  for (const std::string& solver :
       solver_names([](const LinearSolver& each) { return each.takes_products() && !each.on_ranks; })) {
    const LevelOutcome clusters = solve_level(held_as(on_ellipsoid(), "h2", solver), level, no_route);
    ASSERT_EQ(dense.nodes.size(), clusters.nodes.size());
    EXPECT_EQ(clusters.result.norm_K.value, dense.result.norm_K.value);
    double largest = 0;
    for (std::size_t i = 0; i < dense.nodes.size(); ++i) {
      const Approximation& u = clusters.nodes[i].u_n;
      ASSERT_TRUE(u.has_radius());
      EXPECT_FALSE(u.guaranteed);
      EXPECT_NEAR(u.value, dense.nodes[i].u_n.value, u.radius + dense.nodes[i].u_n.radius) << i;
      largest = std::max(largest, u.radius);
    }
    EXPECT_LT(largest, 1e-6);
    ASSERT_TRUE(clusters.result.iteration);
    EXPECT_EQ(clusters.result.matrix_form, "h2");
    EXPECT_EQ(clusters.result.solver, solver == "auto" || solver == gmres_by_estimate ? "gmres" : solver);
    EXPECT_LT(clusters.result.iteration->contraction, 1);
    for (std::size_t i = 0; i < dense.result.piece_means.size(); ++i)
      EXPECT_NEAR(clusters.result.piece_means[i].second.value, dense.result.piece_means[i].second.value,
                  clusters.result.piece_means[i].second.radius);
  }
}

TEST(MatrixForm, LeavesTheSolutionOnAGradedTriangulationWithinItsRadius) {
  for (const Problem& surface :
       {sample_problem("two_squares", {}), sample_problem("two_piece", {{"p", 2}})}) {
    Problem problem = with_emission(with_basis(surface, 1, Rational(1, 6)), "1 + x*y");
    problem.reflectivity = everywhere("3/4 - z/8");
    problem.triangulation.grading = Rational(5, 2);
    const LevelOutcome dense = solve_level(held_as(problem, "dense"), 4, no_route);
    const LevelOutcome clusters = solve_level(held_as(problem, "h2"), 4, no_route);
    EXPECT_EQ(clusters.result.matrix_form, "h2");
    ASSERT_EQ(dense.nodes.size(), clusters.nodes.size());
    for (std::size_t i = 0; i < dense.nodes.size(); ++i) {
      const Approximation& u = clusters.nodes[i].u_n;
      EXPECT_LT(u.radius, 1e-7);
      EXPECT_NEAR(u.value, dense.nodes[i].u_n.value, u.radius + dense.nodes[i].u_n.radius) << i;
    }
  }
}

TEST(MatrixForm, FallsBackToEntriesWhereNothingContracts) {
  Problem problem =
      with_emission(with_basis(sample_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}}), 3,
                               Rational(3, 10)),
                    "1 + x*y");
  problem.reflectivity = everywhere("19/20");
  const LevelOutcome open = solve_level(held_as(problem, "h2", "auto"), 1, no_route);
  EXPECT_EQ(open.result.matrix_form, "dense");
  EXPECT_EQ(open.result.solver, "direct");
  const LevelOutcome dense = solve_level(held_as(problem, "dense", "direct"), 1, no_route);
  ASSERT_EQ(open.nodes.size(), dense.nodes.size());
  for (std::size_t i = 0; i < dense.nodes.size(); ++i) {
    EXPECT_EQ(open.nodes[i].u_n.value, dense.nodes[i].u_n.value);
    EXPECT_EQ(open.nodes[i].u_n.radius, dense.nodes[i].u_n.radius);
  }
  const InputFault fault =
      fault_of([&] { static_cast<void>(solve_level(held_as(problem, "h2", "gmres"), 1, no_route)); });
  EXPECT_EQ(fault.pointer, "/solver/name");
  EXPECT_THAT(fault.problem, HasSubstr("contracts"));
}

TEST(MatrixForm, GoesOnByAnEstimateWhereNothingContracts) {
  Problem problem =
      with_emission(with_basis(sample_problem("ellipsoid", {{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}}), 4,
                               Rational(1, 10)),
                    "1 + x*y");
  problem.reflectivity = everywhere("19/20");
  const std::string by_estimate(gmres_by_estimate);
  const LevelOutcome dense = solve_level(held_as(problem, "dense", "direct"), 2, no_route);
  for (const char* form : {"h2", "dense"}) {
    const LevelOutcome found = solve_level(held_as(problem, form, by_estimate), 2, no_route);
    EXPECT_EQ(found.result.matrix_form, form);
    EXPECT_EQ(found.result.solver, by_estimate);
    ASSERT_EQ(found.nodes.size(), dense.nodes.size());
    for (std::size_t i = 0; i < dense.nodes.size(); ++i) {
      EXPECT_FALSE(found.nodes[i].u_n.guaranteed);
      EXPECT_NEAR(found.nodes[i].u_n.value, dense.nodes[i].u_n.value,
                  found.nodes[i].u_n.radius + dense.nodes[i].u_n.radius);
    }
    EXPECT_LT(found.result.solution_radius.value(), 1e-4);
  }
  // Of level 0 alone nothing is told, and nothing where the inverses grow from level to level.
  const InputFault fault =
      fault_of([&] { static_cast<void>(solve_level(held_as(problem, "h2", by_estimate), 1, no_route)); });
  EXPECT_EQ(fault.pointer, "/solver/name");
  EXPECT_THAT(fault.problem, HasSubstr("fewer than two"));
  problem.method = Collocation{{.degree = 3, .alpha = Rational(3, 10)}};
  const InputFault growing =
      fault_of([&] { static_cast<void>(solve_level(held_as(problem, "h2", by_estimate), 2, no_route)); });
  EXPECT_THAT(growing.problem, HasSubstr("more than a fifth"));
}

TEST(MatrixForm, TakesNoEstimateThatOneContradicts) {
  // The reflectivity is 0 at the nodes of levels 0 and 1, whose inverses are therefore I, and 0.9999 at those
  // of level 2: (I - K) 1 = 1e-4 there.
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.reflectivity = everywhere("9999/10000*(1 - cos(12*pi*x)^2*cos(12*pi*y)^2*cos(12*pi*z)^2)");
  const InputFault fault = fault_of([&] {
    static_cast<void>(solve_level(held_as(problem, "dense", std::string(gmres_by_estimate)), 2, no_route));
  });
  EXPECT_EQ(fault.pointer, "/solver/name");
  EXPECT_THAT(fault.problem, HasSubstr("K 1 shows that it is more"));
}

TEST(MatrixForm, LeavesTheProvedSolutionWithinItsRadius) {
  const Problem box = with_basis(sample_problem("box", {{"a", 1}, {"b", 1}, {"c", 3}}), 1, Rational(1, 6));
  for (const Problem& problem : {with_emission(box, "exp(x) + y"), with_solution(box, "1 + x*y + z^2")}) {
    Problem held = held_as(problem, "h2", "verified");
    held.matrix.tolerance = Rational(1, 10000);
    const OperatorRoute route = [](const Surface& surface, const SurfaceFunction& u) {
      return reference::applied_operator(surface, u);
    };
    const LevelOutcome dense = solve_level(held_as(problem, "dense", "verified"), 1, route);
    const LevelOutcome clusters = solve_level(held, 1, route);
    EXPECT_EQ(clusters.result.matrix_form, "h2");
    ASSERT_TRUE(clusters.result.verified);
    EXPECT_LT(clusters.result.verified->theta, 1);
    ASSERT_EQ(dense.nodes.size(), clusters.nodes.size());
    for (std::size_t i = 0; i < dense.nodes.size(); ++i) {
      const Approximation& u = clusters.nodes[i].u_n;
      EXPECT_TRUE(u.guaranteed);
      EXPECT_LE(std::abs(u.value - dense.nodes[i].u_n.value), u.radius + dense.nodes[i].u_n.radius) << i;
      EXPECT_LE(u.radius, 1e-2);
    }
    if (!problem.solution) continue;
    EXPECT_TRUE(clusters.result.node_error->guaranteed);
    EXPECT_NEAR(clusters.result.discretisation_error->value, dense.result.discretisation_error->value,
                clusters.result.discretisation_error->radius + dense.result.discretisation_error->radius);
    EXPECT_NEAR(clusters.result.node_error->value, dense.result.node_error->value,
                clusters.result.node_error->radius + dense.result.node_error->radius);
  }
}

TEST(MatrixForm, LeavesTheProvedSolutionOnASphereWithinItsRadius) {
  // u_n = 2 on the unit sphere, where K 1 = 1.
  Problem problem =
      held_as(with_basis(with_emission(sample_problem("sphere"), "1"), 0, Rational(0)), "h2", "verified");
  problem.reflectivity = everywhere("1/2");
  problem.matrix.tolerance = Rational(1, 10000);
  problem.quadrature.tolerance = Rational(1, 10000);
  const LevelOutcome found = solve_level(problem, 1, no_route);
  EXPECT_EQ(found.result.matrix_form, "h2");
  ASSERT_TRUE(found.result.verified);
  for (const NodeValue& node : found.nodes) {
    EXPECT_TRUE(node.u_n.guaranteed);
    EXPECT_LE(std::abs(node.u_n.value - 2), node.u_n.radius);
    EXPECT_LE(node.u_n.radius, 1e-3);
  }
}

TEST(MatrixForm, IsRefusedByNameWhereItDoesNotServe) {
  const Problem problem = held_as(on_ellipsoid(), "h2");
  EXPECT_NO_THROW(check(problem, std::numeric_limits<std::uint64_t>::max() - 1));
  const auto expect_obstacle = [](const Problem& faulty, const std::string& what) {
    const InputFault fault = refused(faulty);
    EXPECT_EQ(fault.pointer, "/operator/name") << what;
    EXPECT_THAT(fault.problem, HasSubstr(what));
    EXPECT_THAT(fault.allowed, HasSubstr("dense"));
    Problem left_open = faulty;
    left_open.matrix.name = "auto";
    EXPECT_FALSE(takes_clusters(left_open, 1000000)) << what;
  };
  for (const std::string& solver :
       solver_names([](const LinearSolver& each) { return !each.takes_products() && !each.proves(); }))
    expect_obstacle(held_as(on_ellipsoid(), "h2", solver), "solver " + solver);
  EXPECT_NO_THROW(
      check(held_as(on_ellipsoid(), "h2", "verified"), std::numeric_limits<std::uint64_t>::max() - 1));
  const Problem on_cylinder = with_emission(sample_problem("cylinder", {{"radius", 1}, {"height", 2}}), "1");
  EXPECT_NO_THROW(
      check(held_as(on_cylinder, "h2", "verified"), std::numeric_limits<std::uint64_t>::max() - 1));
  Problem proved = held_as(with_emission(sample_problem("cube", {}), "1"), "h2", "verified");
  proved.triangulation.grading = 2;
  expect_obstacle(proved, "a proof on a graded");
  Problem interpolated = problem;
  interpolated.geometry = InterpolatedGeometry{};
  expect_obstacle(interpolated, "interpolated");
  expect_obstacle(held_as(with_emission(sample_problem("two_piece", {{"p", Rational(5, 2)}}), "1"), "h2"),
                  "not analytic");
  Problem unknown = problem;
  unknown.matrix.name = "h3";
  EXPECT_EQ(refused(unknown).pointer, "/operator/name");
  for (const Rational& tolerance :
       {Rational(1, 100000000000000), Rational(1, 10), Rational(0), Rational(-1)}) {
    Problem faulty = problem;
    faulty.matrix.tolerance = tolerance;
    EXPECT_EQ(refused(faulty).pointer, "/operator/tolerance") << tolerance.to_text();
  }
}

TEST(MatrixForm, IsDenseForFewUnknownsWhereItIsLeftOpen) {
  const Problem problem = held_as(on_ellipsoid(), "auto");
  EXPECT_FALSE(takes_clusters(problem, most_dense_unknowns));
  EXPECT_TRUE(takes_clusters(problem, most_dense_unknowns + 1));
  EXPECT_TRUE(takes_clusters(held_as(on_ellipsoid(), "h2"), 1));
  EXPECT_FALSE(takes_clusters(held_as(on_ellipsoid(), "dense"), 1000000));
  EXPECT_FALSE(takes_clusters(held_as(sample_problem("cube", {}), "auto", "verified"), 1000000));
  EXPECT_TRUE(takes_clusters(held_as(sample_problem("cube", {}), "h2", "verified"), 1));
}

TEST(MatrixForm, NeedsMemoryInProportionToTheUnknowns) {
  const Problem problem = held_as(on_ellipsoid(), "h2");
  const std::uint64_t small = level_plan(problem, 8192).total();
  const std::uint64_t large = level_plan(problem, 4 * 8192).total();
  EXPECT_LE(large, 4 * small);
  EXPECT_GE(large, 3 * small);
}

TEST(MatrixForm, PlansWhatClustersOnPlanesTake) {
  for (const auto& [name, degree, level] : {std::tuple{"cube", 0, 4},
                                            {"cube", 1, 3},
                                            {"cube", 2, 3},
                                            {"octahedron", 1, 4},
                                            {"tetrahedron", 0, 5}}) {
    Problem problem = held_as(with_basis(sample_problem(name, {}), degree, Rational(1, 6)), "h2");
    const Surface surface = surface_of(problem);
    const Triangulation triangulation = triangulate(surface, level);
    const TriangleBasis<double> basis(InsetBasis<double>(degree, 1.0 / 6));
    const std::vector<CollocationPoint<double>> nodes =
        collocation_nodes<double>(surface, triangulation, basis);
    const std::vector<double> rho(nodes.size(), 0.5);
    const LevelClusters clusters = clusters_of_level(problem, level, one_rank()).value();
    const ClusterOperator k({.surface = surface,
                             .tree = clusters.tree,
                             .part = clusters.part,
                             .basis = basis,
                             .nodes = nodes,
                             .reflectivity = rho});
    EXPECT_GE(level_plan(problem, triangulation.triangles.size()).total(), k.memory().total())
        << name << ", degree " << degree << ", level " << level;
  }
  // Its clusters are near each other at the edges alone.
  constexpr std::uint64_t elements = std::uint64_t{12} << 16U;
  EXPECT_LE(level_plan(held_as(sample_problem("cube", {}), "h2"), elements).total(),
            level_plan(held_as(on_ellipsoid(), "h2"), elements).total() / 4);
}

}  // namespace
}  // namespace radcert
