// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::no_route;
using testing::sample_problem;
using testing::with_emission;
using testing::with_solution;

constexpr std::uint64_t plenty = std::uint64_t{1} << 32U;

Problem galerkin(Problem problem, int degree, int digits = 6) {
  problem.method = Galerkin{.degree = degree};
  problem.quadrature.tolerance = Rational(1) / power(Rational(10), digits);
  return problem;
}

std::map<std::string, Approximation> means(const LevelOutcome& level) {
  return {level.result.piece_means.begin(), level.result.piece_means.end()};
}

Problem emitting_floor(int degree, int digits = 6) {
  Problem problem = galerkin(with_emission(sample_problem("cube"), "1"), degree, digits);
  problem.emission = by_piece({{"floor", "1"}, {"*", "0"}});
  return problem;
}

TEST(GalerkinLevel, KnowsTheSolutionThatIsConstant) {
  // K 1 = rho on a closed surface: u = 1 where E = 1 - rho.
  for (const int degree : {0, 1, 3})
    for (const char* surface : {"cube", "sphere"}) {
      const LevelOutcome level =
          solve_level(galerkin(with_emission(sample_problem(surface), "1/2"), degree), 0, no_route);
      ASSERT_TRUE(level.result.solution_radius.has_value());
      EXPECT_LT(*level.result.solution_radius, 2e-2) << surface << " degree " << degree;
      for (const NodeValue& node : level.nodes) {
        EXPECT_LE(std::abs(node.u_n.value - 1), node.u_n.radius) << surface << " degree " << degree;
        EXPECT_NEAR(node.u_n.value, 1, 1e-4) << surface << " degree " << degree;
      }
    }
}

TEST(GalerkinLevel, KeepsTheEnergyOfAClosedSurface) {
  // The test function 1: (1/rho - 1) Int u_n = 1/rho Int E, at every degree. Here the sum of the means is 2.
  for (int degree = 0; degree <= 2; ++degree) {
    double sum = 0;
    double radius = 0;
    for (const auto& [piece, mean] : means(solve_level(emitting_floor(degree), 0, no_route))) {
      sum += mean.value;
      radius += mean.radius;
    }
    EXPECT_LE(std::abs(sum - 2), radius) << degree;
    EXPECT_NEAR(sum, 2, 1e-5) << degree;
  }
}

TEST(GalerkinLevel, IsLinearInEmissionsWhoseSquaresUnderflow) {
  const auto plain = means(solve_level(emitting_floor(0), 0, no_route));
  for (const char* emission : {"1e-158", "1e-165", "1e-290"}) {
    Problem problem = emitting_floor(0);
    problem.emission = by_piece({{"floor", emission}, {"*", "0"}});
    const double size = std::stod(emission);
    // Radii hold what the solver has left, which is another rounding.
    for (const auto& [piece, mean] : means(solve_level(problem, 0, no_route))) {
      EXPECT_NEAR(mean.value / size, plain.at(piece).value, 1e-12) << piece << " " << emission;
      EXPECT_NEAR(mean.radius / size, plain.at(piece).radius, 0.05 * plain.at(piece).radius)
          << piece << " " << emission;
    }
  }
}

TEST(GalerkinLevel, ClaimsNoErrorBelowWhatSquaresHold) {
  // Degree 0 does not have x: the error is that of a projection, 1/(2 sqrt(3)) of u on every face at least.
  Problem problem = galerkin(with_solution(sample_problem("cube"), "1e-170*x"), 0);
  const LevelOutcome level = solve_level(problem, 0, reference::applied_operator);
  ASSERT_TRUE(level.result.l2_error.has_value());
  EXPECT_GE(level.result.l2_error->value + level.result.l2_error->radius, 2e-171);
}

TEST(GalerkinLevel, GrowsWithNestedSpacesOverTheEmitter) {
  const double coarse = means(solve_level(emitting_floor(0), 0, no_route)).at("floor").value;
  const double refined = means(solve_level(emitting_floor(0), 1, no_route)).at("floor").value;
  const double linear = means(solve_level(emitting_floor(1), 0, no_route)).at("floor").value;
  EXPECT_GT(refined, coarse + 1e-3);
  EXPECT_GT(linear, coarse + 1e-3);
  // Below that of the solution, 1.1043613 within 2.4e-6.
  EXPECT_LT(refined, 1.104364);
  EXPECT_LT(linear, 1.104364);
}

TEST(GalerkinLevel, FindsASolutionInItsSpace) {
  // u is linear on each face, and so u_n = u.
  const Problem problem = galerkin(with_solution(sample_problem("cube"), "1 + x - 2*y + z"), 1);
  const LevelOutcome level = solve_level(problem, 1, reference::applied_operator);
  for (const NodeValue& node : level.nodes) {
    EXPECT_LE(std::abs(node.u_n.value - *node.u), node.u_n.radius);
    EXPECT_NEAR(node.u_n.value, *node.u, 2e-3);
  }
  ASSERT_TRUE(level.result.l2_error && level.result.mean_error);
  EXPECT_LE(level.result.l2_error->value, level.result.l2_error->radius);
  EXPECT_LE(level.result.mean_error->value, level.result.mean_error->radius);
  EXPECT_LT(level.result.l2_error->radius, 0.1);
}

TEST(GalerkinLevel, ProjectsTheEmissionOfPiecesThatReflectNothing) {
  Problem problem = emitting_floor(1);
  problem.reflectivity = by_piece({{"floor", "0"}, {"*", "1/2"}});
  problem.emission = by_piece({{"floor", "1 + x"}, {"*", "0"}});
  const LevelOutcome level = solve_level(problem, 0, no_route);
  for (const NodeValue& node : level.nodes) {
    if (node.piece == "floor") {
      EXPECT_NEAR(node.u_n.value, 1 + node.point.x, 1e-12);
    } else {
      EXPECT_GT(node.u_n.value, 0.05);
    }
  }
  // Where all is black, u = E.
  problem.reflectivity = everywhere("0");
  for (const NodeValue& node : solve_level(problem, 0, no_route).nodes)
    EXPECT_NEAR(node.u_n.value, node.emission, 1e-12);
}

TEST(GalerkinLevel, AgreesWithCollocation) {
  // Other integrals, other equations, another solver: the differences are those of the discretisations.
  Problem problem = emitting_floor(2);
  problem.reflectivity = by_piece({{"floor", "3/10"}, {"ceiling", "0"}, {"*", "1/2 + z/8"}});
  const auto ours = means(solve_level(problem, 1, no_route));
  problem.method = Collocation{{.degree = 2, .alpha = Rational(1, 10)}};
  const auto theirs = means(solve_level(problem, 1, no_route));
  for (const auto& [piece, mean] : ours) EXPECT_NEAR(mean.value, theirs.at(piece).value, 2e-3) << piece;
}

TEST(GalerkinLevel, HasARadiusThatHoldsWhatTheIntegralsChange) {
  const LevelOutcome rough = solve_level(emitting_floor(1, 3), 1, no_route);
  const LevelOutcome fine = solve_level(emitting_floor(1, 8), 1, no_route);
  double largest = 0;
  for (std::size_t i = 0; i < rough.nodes.size(); ++i) {
    const double difference = std::abs(rough.nodes[i].u_n.value - fine.nodes[i].u_n.value);
    EXPECT_LE(difference, rough.nodes[i].u_n.radius + fine.nodes[i].u_n.radius);
    largest = std::max(largest, difference);
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(fine.nodes.front().u_n.radius, rough.nodes.front().u_n.radius);
}

TEST(GalerkinLevel, RefusesWhereTheIntegralsLeaveNothingOfTheDefiniteness) {
  // The exact system has 1 - rho below its least eigenvalue; that of rough integrals may be singular.
  const auto nearly_white = [](int digits) {
    Problem problem = galerkin(with_emission(sample_problem("cube"), "1"), 1, digits);
    problem.reflectivity = everywhere("0.9999999");
    return problem;
  };
  try {
    (void)solve_level(nearly_white(2), 0, no_route);
    FAIL() << "not refused";
  } catch (const AccuracyNotReached& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("tolerance of /quadrature"));
  }
  EXPECT_NO_THROW((void)solve_level(nearly_white(11), 0, no_route));
}

TEST(GalerkinLevel, BoundsTheReflectivityFromAbove) {
  Problem problem = emitting_floor(0);
  EXPECT_EQ(reflectivity_bound(problem, surface_of(problem)), 0.5);
  problem.reflectivity = everywhere("1/2 + x*y/4");
  const double bound = reflectivity_bound(problem, surface_of(problem));
  EXPECT_GE(bound, 0.75);
  EXPECT_LT(bound, 0.76);
}

TEST(GalerkinLevel, RefusesByName) {
  const auto fault = [](const Problem& problem) { return fault_of([&] { check(problem, plenty); }); };
  EXPECT_NO_THROW(check(emitting_floor(0), plenty));
  Problem problem = emitting_floor(5);
  EXPECT_EQ(fault(problem).pointer, "/basis/degree");
  problem = emitting_floor(1);
  problem.solver.name = "gmres";
  EXPECT_EQ(fault(problem).pointer, "/solver/name");
  problem = emitting_floor(1);
  problem.geometry = InterpolatedGeometry{.degree = 2};
  EXPECT_EQ(fault(problem).pointer, "/geometry/interpolated");
  problem = emitting_floor(1);
  problem.iterated = true;
  EXPECT_EQ(fault(problem).pointer, "/iterated");
  problem = emitting_floor(1);
  problem.reflectivity = everywhere("x/2");
  EXPECT_THAT(fault(problem).problem, HasSubstr("positive"));
  problem.reflectivity = by_piece({{"floor", "0"}, {"*", "1 - z/2"}});
  EXPECT_EQ(fault(problem).pointer, "/reflectivity");
  problem = galerkin(with_emission(sample_problem("two_squares"), "1"), 0);
  problem.reflectivity = everywhere("1");
  EXPECT_EQ(fault(problem).pointer, "/reflectivity");
}

}  // namespace
}  // namespace radcert
