// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <tuple>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/study/collocation/nodal_function.h"
#include "radcert/study/study.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::no_route;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

/// A route for solutions whose Int G u is the same number at every point.
OperatorRoute constant_route(double value) {
  return [value](const Surface&, const SurfaceFunction&) {
    return [value](const SurfacePoint<double>&) { return Approximation{value, 4e-16 * std::abs(value)}; };
  };
}

Problem box125() { return sample_problem("box", {{"a", 1}, {"b", 2}, {"c", 5}}); }

TEST(SolveLevel, IsOneInAFurnace) {
  // E = 1 - rho on a closed surface: u = 1, for rho that varies too.
  for (const Problem& surface : {sample_problem("cube"), sample_problem("sphere"), box125()})
    for (int degree = 0; degree <= 2; ++degree)
      for (const bool constant : {true, false}) {
        Problem problem = with_basis(surface, degree, Rational(1, 8));
        problem.reflectivity = everywhere(constant ? "1/2" : "1/2 + sin(x + 2*y + 3*z)/4");
        problem.solution = std::nullopt;
        problem.emission = everywhere(constant ? "1/2" : "1 - (1/2 + sin(x + 2*y + 3*z)/4)");
        const LevelOutcome outcome = solve_level(problem, 0, no_route);
        for (const NodeValue& node : outcome.nodes)
          EXPECT_NEAR(node.u_n.value, 1, 1e-12) << problem.surface.name << " degree " << degree;
        for (const auto& [piece, mean] : outcome.result.piece_means)
          EXPECT_NEAR(mean.value, 1, 1e-12) << piece;
      }
}

TEST(SolveLevel, MakesNoErrorForAConstantSolution) {
  for (const char* surface : {"cube", "sphere"}) {
    const LevelResult result =
        solve_level(sample_problem(surface), 0, constant_route(std::numbers::pi)).result;
    EXPECT_LE(result.discretisation_error->value, result.discretisation_error->radius);
    EXPECT_LE(result.node_error->value, result.node_error->radius);
    EXPECT_LT(result.discretisation_error->radius, 1e-11);
    EXPECT_LT(result.node_error->radius, 1e-11);
    EXPECT_LT(result.uniform_error->value, 1e-11);
    EXPECT_FALSE(result.node_error->guaranteed);
  }
}

TEST(SolveLevel, IntegratesAsWellAsTheProblemAsks) {
  Problem problem = sample_problem("cube");
  const LevelResult fine = solve_level(problem, 1, constant_route(std::numbers::pi)).result;
  problem.quadrature.tolerance = Rational(1, 100000);
  const LevelResult coarse = solve_level(problem, 1, constant_route(std::numbers::pi)).result;
  EXPECT_LE(coarse.discretisation_error->value, coarse.discretisation_error->radius);
  EXPECT_GT(coarse.discretisation_error->radius, 1e3 * fine.discretisation_error->radius);
  EXPECT_LT(coarse.discretisation_error->radius, 1e-4);
}

TEST(SolveLevel, PassesTheErrorsOfTheRouteOn) {
  // Ku wrong by e (1/2)/pi at every node: so is K(I-P_n)u, and the node error is (I-K)^-1 of it, twice as
  // much.
  constexpr double e = 1e-3;
  const auto route = [](const Surface&, const SurfaceFunction&) {
    return [](const SurfacePoint<double>&) { return Approximation{std::numbers::pi + e, 2 * e}; };
  };
  const LevelResult result = solve_level(sample_problem("cube"), 0, route).result;
  const double moved = e / 2 / std::numbers::pi;
  EXPECT_NEAR(result.discretisation_error->value, moved, 1e-12);
  EXPECT_NEAR(result.node_error->value, 2 * moved, 1e-12);
  EXPECT_NEAR(result.discretisation_error->radius, 2 * moved, 1e-10);
  EXPECT_GE(result.node_error->radius, 2 * 2 * moved * 0.999);
  EXPECT_LE(result.node_error->radius, 2 * 2 * moved * 1.001);
}

TEST(SolveLevel, ManufacturesTheEmissionAsUMinusKu) {
  Problem problem = with_solution(sample_problem("sphere"), "exp(z)");
  problem.reflectivity = everywhere("3/4");
  const LevelOutcome outcome = solve_level(problem, 0, constant_route(std::numbers::pi * std::sinh(1.0)));
  for (const NodeValue& node : outcome.nodes) {
    EXPECT_EQ(node.u, std::exp(node.point.z));
    EXPECT_NEAR(node.emission, std::exp(node.point.z) - 0.75 * std::sinh(1.0), 2e-15);
  }
}

/// u_n - u at the nodes of the unit sphere for E = exp(z), rho = 1/2, where u = exp(z) + sinh(1): the mean of
/// exp(z) is sinh(1), that of u twice as much.
std::vector<double> errors_on_the_sphere(int level, int degree, const Rational& alpha) {
  const Problem problem = with_emission(with_basis(sample_problem("sphere"), degree, alpha), "exp(z)");
  std::vector<double> errors;
  for (const NodeValue& node : solve_level(problem, level, no_route).nodes)
    errors.push_back(node.u_n.value - (std::exp(node.point.z) + std::sinh(1.0)));
  return errors;
}

/// The mean over the sphere of (P_n - I) exp(z).
double mean_of_interpolation_error(int level, int degree, const Rational& alpha) {
  const Surface surface = sphere();
  const InsetBasis<double> basis(degree, degree == 0 ? 0 : alpha.to_double());
  const std::vector<Barycentric<double>> nodes = basis.nodes();
  const TriangleRule<double> rule = conical_rule<double>(28, Grading::none);
  std::vector<double> l(basis.size());
  double sum = 0;
  for (const ParameterTriangle& element : triangulate(surface, level).triangles) {
    const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
    const auto u = [&](const Barycentric<double>& x) {
      return std::exp(chart.frame(element.at(x.x)).point.z);
    };
    const auto& v = element.vertices;
    for (std::size_t k = 0; k < rule.weights.size(); ++k) {
      basis.values(rule.points[k], l);
      double error = -u(rule.points[k]);
      for (std::size_t j = 0; j < l.size(); ++j) error += l[j] * u(nodes[j]);
      sum += rule.weights[k] * cross(v[1] - v[0], v[2] - v[0]) *
             area_element(chart.frame(element.at(rule.points[k].x))) * error;
    }
  }
  return sum / (4 * std::numbers::pi);
}

TEST(SolveLevel, HasTheErrorOnTheSphereThatTheMeanOfTheInterpolationErrorForetells) {
  // G = 1/4: K f is half the mean of f, so u_n - u = (I - K_n)^-1 K (P_n - I) u is that mean, the same at
  // every node.
  for (const auto& [level, degree, alpha] : {std::tuple{0, 0, Rational(0)},
                                             {1, 0, Rational(0)},
                                             {0, 1, Rational(1, 10)},
                                             {1, 1, Rational(1, 6)},
                                             {0, 2, Rational(1, 10)},
                                             {0, 3, Rational(1, 20)}}) {
    const double expected = mean_of_interpolation_error(level, degree, alpha);
    EXPECT_GT(std::abs(expected), 1e-6);
    for (const double error : errors_on_the_sphere(level, degree, alpha))
      EXPECT_NEAR(error, expected, 2e-13) << "level " << level << ", degree " << degree;
  }
}

TEST(SolveLevel, ConvergesOnTheSphereWithOrderTwoForDegreeZero) {
  // The leading term takes over at level 2: from there the mean of the interpolation error has the orders
  // 1.84, 2.02,
  // 2.01.
  const double coarse = errors_on_the_sphere(2, 0, 0)[0];
  const double fine = errors_on_the_sphere(3, 0, 0)[0];
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << coarse << ", " << fine;
}

TEST(SolveLevel, HasTheSameErrorsWhenTheSolutionIsStated) {
  // The same equation stated by its solution: u = exp(z) + sinh(1), Int G u = 2 pi sinh(1).
  const Problem problem = with_solution(with_basis(sample_problem("sphere"), 1, Rational(1, 10)),
                                        "exp(z) + (exp(1) - exp(-1))/2");
  std::vector<LevelResult> levels;
  for (const int level : {0, 1})
    levels.push_back(
        solve_level(problem, level, constant_route(2 * std::numbers::pi * std::sinh(1.0))).result);
  for (const LevelResult& level : levels) {
    EXPECT_NEAR(level.node_error->value,
                std::abs(mean_of_interpolation_error(level.level, 1, Rational(1, 10))), 2e-13);
    // Constant functions are multiplied by (I - K)^-1 = 2.
    EXPECT_NEAR(level.node_error->value, 2 * level.discretisation_error->value, 1e-12);
    EXPECT_GE(level.uniform_error->value, level.node_error->value * 0.5);
  }
  const Result result = collect(problem, levels, {});
  EXPECT_EQ(result.levels[1].node_ratio, levels[0].node_error->value / levels[1].node_error->value);
  EXPECT_EQ(result.orders[1].levels, (std::vector<int>{0, 1}));
}

TEST(SolveLevel, RefusesAClosedSurfaceWithANormalThatPointsOutwards) {
  TriangleMesh mesh = sample::mesh_of(sample::cube());
  const std::vector<std::size_t> pieces(mesh.triangles.size(), 0);
  const auto problem = [&] {
    Problem cube = with_emission(with_basis(sample_problem("cube"), 1, Rational(1, 6)), "1 + x");
    cube.surface = {.name = "cube", .parameters = {}, .mesh = MeshChoice{}};
    cube.surface.mesh->surface = std::make_shared<const Surface>(mesh_surface(
        "cube", mesh, pieces, std::vector<std::string>{"wall"},
        {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = true}));
    return cube;
  };
  EXPECT_NO_THROW(solve_level(problem(), 0, no_route));
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);
  try {
    solve_level(problem(), 0, no_route);
    ADD_FAILURE() << "no exception";
  } catch (const AccuracyNotReached& error) {
    EXPECT_THAT(error.what(), HasSubstr("not pi"));
  }
}

/// The solvers that stop at a tolerance.
const std::vector<std::string> iterations =
    solver_names([](const LinearSolver& each) { return each.iterates() && !each.on_ranks; });

TEST(SolveLevel, HasTheSameSolutionByEverySolver) {
  for (const Problem& surface : {sample_problem("cube"), sample_problem("two_piece", {{"p", 2}})}) {
    Problem problem = with_solution(surface, "exp(x)*cos(y) + z");
    problem.solver.name = "direct";
    const LevelOutcome direct = solve_level(problem, 0, reference::applied_operator);
    EXPECT_FALSE(direct.result.iteration);
    for (const std::string& name : iterations) {
      problem.solver.name = name;
      const LevelOutcome outcome = solve_level(problem, 0, reference::applied_operator);
      const LevelResult& result = outcome.result;
      EXPECT_NEAR(result.node_error->value, direct.result.node_error->value, 1e-13);
      EXPECT_EQ(result.discretisation_error->value, direct.result.discretisation_error->value);
      for (std::size_t i = 0; i < outcome.nodes.size(); ++i)
        EXPECT_NEAR(outcome.nodes[i].u_n.value, direct.nodes[i].u_n.value, 1e-13);
      ASSERT_TRUE(result.iteration);
      EXPECT_GT(result.iteration->iterations, 0U);
      EXPECT_LT(result.iteration->contraction, 0.6);
      EXPECT_LT(result.iteration->error_bound, 4e-15);
      // The radius bounds with 1/(1 - theta) what the other solver's estimates with ||(I - K_n)^-1||.
      EXPECT_GE(result.node_error->radius, result.iteration->error_bound);
      EXPECT_GE(result.node_error->radius, direct.result.node_error->radius * 0.3);
      EXPECT_LE(result.node_error->radius, direct.result.node_error->radius * 3);
    }
  }
}

TEST(SolveLevel, IteratesWhereAContractionIsFoundIfTheSolverIsLeftOpen) {
  Problem problem = with_solution(sample_problem("cube"), "exp(x)*cos(y) + z");
  const LevelOutcome open = solve_level(problem, 0, reference::applied_operator);
  EXPECT_EQ(open.result.solver, "gmres");
  EXPECT_EQ(open.result.matrix_form, "dense");
  ASSERT_TRUE(open.result.iteration);
  problem.solver.name = "gmres";
  const LevelOutcome named = solve_level(problem, 0, reference::applied_operator);
  for (std::size_t i = 0; i < open.nodes.size(); ++i)
    EXPECT_EQ(open.nodes[i].u_n.value, named.nodes[i].u_n.value);
  // Quadratics change sign so much that no weights are found below the norm 0.95.
  Problem hard = with_solution(with_basis(sample_problem("cube"), 2, Rational(1, 6)), "1 + x");
  hard.reflectivity = everywhere("0.95");
  const LevelOutcome eliminated = solve_level(hard, 0, reference::applied_operator);
  EXPECT_EQ(eliminated.result.solver, "direct");
  EXPECT_FALSE(eliminated.result.iteration);
  hard.solver.name = "direct";
  EXPECT_EQ(solve_level(hard, 0, reference::applied_operator).result.node_error->value,
            eliminated.result.node_error->value);
  // Of products alone nothing can be eliminated: the entries are computed.
  hard.solver.name = "auto";
  hard.matrix.name = "h2";
  const LevelOutcome fallen_back = solve_level(hard, 0, reference::applied_operator);
  EXPECT_EQ(fallen_back.result.solver, "direct");
  EXPECT_EQ(fallen_back.result.matrix_form, "dense");
  EXPECT_EQ(fallen_back.result.node_error->value, eliminated.result.node_error->value);
  hard.solver.name = "gmres";
  EXPECT_EQ(fault_of([&] { static_cast<void>(solve_level(hard, 0, reference::applied_operator)); }).pointer,
            "/solver/name");
}

TEST(SolveLevel, PutsTheToleranceOfAnIterationIntoTheRadius) {
  Problem problem = with_solution(sample_problem("cube"), "1");
  for (const std::string& name : iterations) {
    problem.solver = {.name = name, .tolerance = Rational(1, 1000)};
    const LevelResult result = solve_level(problem, 0, constant_route(std::numbers::pi)).result;
    EXPECT_LE(result.iteration->error_bound, 1e-3);
    // u_n = 1 but for what the iteration left, and that is all of the error.
    EXPECT_LE(result.node_error->value, result.node_error->radius);
    EXPECT_GE(result.node_error->radius, result.iteration->error_bound);
    EXPECT_LE(result.node_error->radius, result.iteration->error_bound * 1.001 + 1e-11);
  }
  // The Neumann series approaches from below by factors of 1/2: it stops between one step and the next.
  problem.solver.name = "neumann";
  const double left = solve_level(problem, 0, constant_route(std::numbers::pi)).result.node_error->value;
  EXPECT_GT(left, 0.4e-3);
  EXPECT_LT(left, 1e-3);
}

TEST(SolveLevel, CoversTheErrorsOfTheRouteByEverySolver) {
  // As PassesTheErrorsOfTheRouteOn: the emission is uncertain by 2 e (1/2)/pi, and (I - K)^-1 doubles that.
  constexpr double e = 1e-3;
  const auto route = [](const Surface&, const SurfaceFunction&) {
    return [](const SurfacePoint<double>&) { return Approximation{std::numbers::pi + e, 2 * e}; };
  };
  Problem problem = sample_problem("cube");
  for (const std::string& name : iterations) {
    problem.solver.name = name;
    const double radius = solve_level(problem, 0, route).result.node_error->radius;
    EXPECT_GE(radius, 2 * e / std::numbers::pi * 0.999);
    EXPECT_LE(radius, 2 * e / std::numbers::pi * 1.001);
  }
}

// The kernel's integrals are off by some roundings of what they are times max |u|, and by no more.
TEST(SolveLevel, ScalesTheRadiusOfTheErrorWithTheSolution) {
  const auto radius = [](const std::string& u, double integral) {
    return solve_level(with_solution(sample_problem("cube"), u), 0, constant_route(integral))
        .result.discretisation_error->radius;
  };
  const double of_one = radius("1", std::numbers::pi);
  EXPECT_GT(of_one, 0);
  EXPECT_EQ(radius("1048576", 0x1p20 * std::numbers::pi), 0x1p20 * of_one);
  EXPECT_EQ(radius("1/1048576", 0x1p-20 * std::numbers::pi), 0x1p-20 * of_one);
}

// With u = 1 and a route that gives V exactly, Ku - K P_n u is rho (V/pi - 1). Of the rho and V that were
// tried these lose most, 2.3 units of Ku, of which one counts as the rounding of rho.
TEST(SolveLevel, CoversTheRoundingOfKu) {
  const BallPrecision scope(200);
  for (const auto& [rho, factor] :
       {std::pair{Rational(405, 1024), 0x1.fd0cf31a758d5p0}, {Rational(849, 1024), 0x1.e6605e0dde78cp0}}) {
    const double integral = factor * 0x1p40;
    const auto route = [&](const Surface&, const SurfaceFunction&) {
      return [&](const SurfacePoint<double>&) { return Approximation{integral, 0}; };
    };
    Problem problem = sample_problem("cube");
    problem.reflectivity = everywhere(rho.to_text());
    const Approximation error = *solve_level(problem, 0, route).result.discretisation_error;
    const Ball exact = Ball(rho) * (Ball(integral) / Ball::pi() - Ball(1));
    EXPECT_TRUE(certainly_at_most(abs(Ball(error.value) - exact), Ball(error.radius))) << rho.to_text();
  }
}

// Nothing is reflected, so that u_n is u at the nodes: 1 + x + 10^9 - 10^9, which loses 6e-8.
TEST(SolveLevel, CoversTheRoundingOfTheSolutionThatIsGiven) {
  Problem problem = with_solution(sample_problem("cube"), "(1 + x + 1000000000) - 1000000000");
  problem.reflectivity = everywhere("0");
  double largest = 0;
  for (const NodeValue& node : solve_level(problem, 0, constant_route(0)).nodes) {
    const double off = std::abs(node.u_n.value - (1 + node.point.x));
    EXPECT_LE(off, node.u_n.radius);
    EXPECT_LT(node.u_n.radius, 1e-5);
    largest = std::max(largest, off);
  }
  EXPECT_GT(largest, 1e-8);
}

// A furnace: u = 1, for rho = 1/2 and E = 1/2. What is computed of rho is off by 1e-8 and more.
TEST(SolveLevel, CoversTheRoundingOfTheReflectivity) {
  Problem problem = with_emission(sample_problem("cube"), "1/2");
  problem.reflectivity = everywhere("(1/2 + x + 1000000000) - 1000000000 - x");
  double largest = 0;
  for (const NodeValue& node : solve_level(problem, 0, no_route).nodes) {
    EXPECT_LE(std::abs(node.u_n.value - 1), node.u_n.radius);
    EXPECT_LT(node.u_n.radius, 1e-4);
    largest = std::max(largest, std::abs(node.u_n.value - 1));
  }
  EXPECT_GT(largest, 1e-8);
}

TEST(SolveLevel, RefusesAnIterationWithoutAContraction) {
  // The quadratic functions with the inset 1/6 change sign so much that |K_n| has a spectral radius of 1.12
  // rho.
  Problem problem = with_emission(with_basis(sample_problem("cube"), 2, Rational(1, 6)), "1");
  problem.reflectivity = everywhere("19/20");
  EXPECT_NO_THROW(solve_level(problem, 0, no_route));
  for (const std::string& name : iterations) {
    problem.solver.name = name;
    const InputFault fault = fault_of([&] { solve_level(problem, 0, no_route); });
    EXPECT_EQ(fault.pointer, "/solver/name");
    EXPECT_EQ(fault.value, name);
    EXPECT_THAT(fault.problem, HasSubstr("1.0"));
    EXPECT_EQ(fault.allowed, name == gmres_by_estimate
                                 ? "direct, or two coarser levels of at most 3072 unknowns"
                                 : "direct");
  }
}

TEST(SolveLevel, ThrowsWhereTheToleranceIsOutOfReach) {
  Problem problem = with_emission(sample_problem("cube"), "1 + x");
  problem.reflectivity = everywhere("99/100");
  for (const std::string& name : iterations) {
    problem.solver = {.name = name, .tolerance = Rational::exactly(0x1p-51)};
    try {
      solve_level(problem, 0, no_route);
      ADD_FAILURE() << "no exception";
    } catch (const AccuracyNotReached& error) {
      // Where there is a contraction, no estimate is taken.
      const std::string taken = name == gmres_by_estimate ? "gmres" : name;
      EXPECT_THAT(error.what(), HasSubstr("level 0, solver " + taken + ":"));
      EXPECT_THAT(error.what(), HasSubstr("4.440892098500626e-16"));
    }
    problem.solver.tolerance = std::nullopt;
    EXPECT_NO_THROW(solve_level(problem, 0, no_route));
  }
}

TEST(SolveLevel, LeavesTheErrorsEmptyForAGivenEmission) {
  const LevelOutcome outcome = solve_level(with_emission(sample_problem("cube"), "1 + x"), 0, no_route);
  EXPECT_EQ(outcome.result.discretisation_error.has_value(), false);
  EXPECT_EQ(outcome.result.node_error.has_value(), false);
  EXPECT_EQ(outcome.result.uniform_error.has_value(), false);
  for (const NodeValue& node : outcome.nodes) {
    EXPECT_EQ(node.u, std::nullopt);
    EXPECT_EQ(node.emission, 1 + node.point.x);
  }
}

TEST(SolveLevel, HasItsIteratedSolutionAtTheNodes) {
  // [ac98, (44)]: u^ = E + K u_n equals u_n at the nodes; here K is applied by the adaptive cubature of
  // `reference`.
  for (const char* name : {"cube", "sphere"}) {
    const Problem problem = with_emission(sample_problem(name), "exp(x + y) - z");
    const Surface surface = surface_of(problem);
    const Triangulation triangulation = triangulate(surface, 0);
    const InsetBasis<double> basis(1, Rational(1, 6).to_double());
    const LevelOutcome outcome = solve_level(problem, 0, no_route);
    std::vector<double> values;
    for (const NodeValue& node : outcome.nodes) values.push_back(node.u_n.value);
    const NodalFunction u_n(surface, triangulation, basis, values);
    for (std::size_t i = 0; i < values.size(); i += 11) {
      const ParameterTriangle& own = triangulation.triangles[i / 3];
      const SurfacePoint<double> p{own.chart, own.at(basis.nodes()[i % 3].x)};
      double integral = 0;
      for (std::size_t k = 0; k < triangulation.triangles.size(); ++k) {
        const ParameterTriangle& element = triangulation.triangles[k];
        const auto& v = element.vertices;
        const double twice = cross(v[1] - v[0], v[2] - v[0]);
        const auto density = [&](const SurfacePoint<double>& q, const Vector<double>&) {
          const double x2 = cross(q.at - v[0], v[2] - v[0]) / twice;
          const double x3 = cross(v[1] - v[0], q.at - v[0]) / twice;
          return u_n.at(k, {{1 - x2 - x3, x2, x3}});
        };
        integral += reference::operator_integral(surface, p, element.chart, v, density).value;
      }
      const double iterated = outcome.nodes[i].emission + 0.5 / std::numbers::pi * integral;
      EXPECT_NEAR(iterated, values[i], 1e-12 * std::abs(values[i])) << name << " node " << i;
    }
  }
}

TEST(SolveLevel, DescribesTheLevel) {
  const Problem problem = with_emission(with_basis(box125(), 2, Rational(1, 8)), "1/2");
  const LevelOutcome outcome = solve_level(problem, 1, no_route);
  EXPECT_EQ(outcome.result.level, 1);
  EXPECT_EQ(outcome.result.elements, 48U);
  EXPECT_EQ(outcome.result.unknowns, 288U);
  EXPECT_EQ(outcome.result.mesh_size, std::numbers::sqrt2 / 2);
  EXPECT_EQ(outcome.result.planned_bytes, level_plan(problem, 48).total());
  ASSERT_EQ(outcome.nodes.size(), 288U);
  ASSERT_EQ(outcome.elements.size(), 48U);
  const Surface surface = surface_of(problem);
  const Triangulation triangulation = triangulate(surface, 1);
  for (std::size_t i = 0; i < outcome.nodes.size(); ++i) {
    EXPECT_EQ(outcome.nodes[i].element, i / 6);
    EXPECT_EQ(outcome.nodes[i].index_in_element, i % 6);
    EXPECT_EQ(outcome.nodes[i].piece, outcome.elements[i / 6].piece);
  }
  for (std::size_t k = 0; k < 48; ++k) {
    const Chart& chart = surface.charts[triangulation.triangles[k].chart];
    EXPECT_EQ(outcome.elements[k].piece, chart.facts().piece);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(outcome.elements[k].corners[c],
                chart.in<double>().frame(triangulation.triangles[k].vertices[c]).point);
      EXPECT_NEAR(outcome.elements[k].corner_values[c], 1, 1e-11);
    }
  }
}

TEST(SolveLevel, KnowsTheNormOfKOnClosedSurfacesOfConstantReflectivity) {
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.reflectivity = by_piece({{"floor", "3/4"}, {"*", "1/4"}});
  const Approximation piecewise = solve_level(problem, 0, no_route).result.norm_K;
  EXPECT_EQ(piecewise.value, 0.75);
  EXPECT_TRUE(piecewise.guaranteed);
  problem.reflectivity = by_piece({{"floor", "1/4"},
                                   {"west", "3/4"},
                                   {"east", "0"},
                                   {"south", "0"},
                                   {"north", "0"},
                                   {"ceiling", "0"},
                                   {"*", "1"}});
  const Approximation covered = solve_level(problem, 0, no_route).result.norm_K;
  EXPECT_EQ(covered.value, 0.75) << "the case * is no piece's";
  problem.reflectivity = everywhere("x/2");
  const Approximation varying = solve_level(problem, 0, no_route).result.norm_K;
  EXPECT_FALSE(varying.guaranteed);
  EXPECT_EQ(varying.value, 0.5);  // the east face
  EXPECT_FALSE(varying.has_radius());
}

// The double 0.8 is not 4/5.
TEST(SolveLevel, GivesTheNormOfKARadiusThatReachesTheReflectivity) {
  Problem problem = with_emission(sample_problem("cube"), "1");
  for (const auto& [text, largest] : {std::pair("4/5", 0x1p-54),
                                      {"1/10", 0x1p-57},
                                      {"1/3", 0x1p-55},
                                      {"999999999999/1000000000000", 0x1p-54},
                                      {"1/3000000000000000000000", 0x1p-120},
                                      {"1/2", 0.0},
                                      {"0", 0.0}}) {
    problem.reflectivity = everywhere(text);
    const Approximation norm = solve_level(problem, 0, no_route).result.norm_K;
    ASSERT_TRUE(norm.guaranteed && norm.has_radius()) << text;
    const Rational off = abs(Rational::exactly(norm.value) - Rational::parse(text).value());
    EXPECT_LE(off, Rational::exactly(norm.radius)) << text;
    EXPECT_LE(norm.radius, largest) << text;
  }
}

TEST(SolveLevel, EstimatesTheNormOfKOnOpenSurfacesAtTheNodes) {
  Problem problem = with_emission(sample_problem("two_squares"), "1");
  const LevelOutcome outcome = solve_level(problem, 0, no_route);
  EXPECT_FALSE(outcome.result.norm_K.guaranteed);
  // Near the common edge Int G tends to pi/2, and rho = 1/2.
  EXPECT_GT(outcome.result.norm_K.value, 0.15);
  EXPECT_LT(outcome.result.norm_K.value, 0.25);
}

TEST(SolveLevel, RefusesANormOfOneThatOnlyTheNodesShow) {
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.reflectivity = everywhere("max(x, 1/2)");  // 1 on the east face
  const InputFault fault = fault_of([&] { solve_level(problem, 0, no_route); });
  EXPECT_EQ(fault.pointer, "/reflectivity");
  EXPECT_EQ(fault.value, "1");
  EXPECT_THAT(fault.problem, HasSubstr("norm of K"));
}

TEST(SolveLevel, RefusesExpressionsThatFailAtANode) {
  const auto fault = [](const Problem& problem) {
    return fault_of([&] { solve_level(problem, 0, no_route); });
  };
  EXPECT_EQ(fault(with_solution(sample_problem("cube"), "1/x")).pointer, "/solution");
  EXPECT_EQ(fault(with_emission(sample_problem("cube"), "log(x)")).pointer, "/emission");
  Problem dark = sample_problem("two_piece", {{"p", 2}});
  dark.reflectivity = everywhere("x - 1/2");
  EXPECT_EQ(fault(dark).pointer, "/reflectivity");
  EXPECT_THAT(fault(dark).problem, HasSubstr(" at node "));
}

TEST(SolveLevel, CutsAndGradesAsTheProblemSays) {
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.triangulation.pattern = {{"*", Diagonal::main}, {"east", Diagonal::anti}};
  problem.triangulation.grading = 2;
  const LevelOutcome outcome = solve_level(problem, 1, no_route);
  const Surface surface = surface_of(problem);
  std::vector<Diagonal> diagonals(6, Diagonal::main);
  diagonals[1] = Diagonal::anti;  // east
  const Triangulation expected = triangulate(surface, 1, {.diagonals = diagonals, .grading = 2});
  for (std::size_t k = 0; k < expected.triangles.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const ParameterTriangle& triangle = expected.triangles[k];
      EXPECT_EQ(outcome.elements[k].corners[c],
                surface.charts[triangle.chart].in<double>().frame(triangle.vertices[c]).point);
    }
}

void expect_equal(const std::optional<Approximation>& a, const std::optional<Approximation>& b) {
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->value, b->value);
  EXPECT_EQ(a->radius, b->radius);
  EXPECT_EQ(a->guaranteed, b->guaranteed);
}

TEST(SolveLevel, HasTheSameBitsForEveryNumberOfThreads) {
  // GMRES, so that its products are among what is compared.
  Problem problem = with_solution(sample_problem("two_piece", {{"p", 2}}), "exp(x)*cos(y) + z");
  problem.solver.name = "gmres";
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return solve_level(problem, 2, reference::applied_operator);
  };
  const LevelOutcome one = with_threads(1);
  const LevelOutcome two = with_threads(2);
  expect_equal(one.result.discretisation_error, two.result.discretisation_error);
  expect_equal(one.result.node_error, two.result.node_error);
  EXPECT_EQ(one.result.uniform_error->value, two.result.uniform_error->value);
  EXPECT_EQ(one.result.norm_K.value, two.result.norm_K.value);
  ASSERT_EQ(one.result.piece_means.size(), two.result.piece_means.size());
  for (std::size_t i = 0; i < one.result.piece_means.size(); ++i)
    EXPECT_EQ(one.result.piece_means[i].second.value, two.result.piece_means[i].second.value);
  ASSERT_EQ(one.nodes.size(), two.nodes.size());
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    EXPECT_EQ(one.nodes[i].u_n.value, two.nodes[i].u_n.value);
    EXPECT_EQ(one.nodes[i].emission, two.nodes[i].emission);
    EXPECT_EQ(one.nodes[i].u, two.nodes[i].u);
    EXPECT_EQ(one.nodes[i].point, two.nodes[i].point);
  }
  for (std::size_t k = 0; k < one.elements.size(); ++k)
    EXPECT_EQ(one.elements[k].corner_values, two.elements[k].corner_values);
}

}  // namespace
}  // namespace radcert
