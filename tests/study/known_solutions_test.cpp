// SPDX-License-Identifier: GPL-3.0-or-later
// Problems whose solution is known exactly, solved within the error that the result itself states. With the
// solution given, E = u - Ku comes from the reference layer and the result states node_error and its radius;
// with E given it states nothing, and u_n must lie where the same problem said that it would.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "radcert/surface/catalogue.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::everywhere;
using testing::no_route;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

Problem problem_on(const SurfaceDescription& entry) {
  std::vector<SurfaceParameter> parameters;
  for (const ParameterDescription& parameter : entry.parameters)
    parameters.push_back({parameter.name, *Rational::parse(parameter.default_text)});
  return sample_problem(entry.name, parameters);
}

/// The problems of the unoccluded surfaces of the catalogue.
std::vector<Problem> all_problems(const std::function<bool(const Surface&)>& wanted) {
  std::vector<Problem> problems;
  for (const SurfaceDescription& entry : surface_catalogue())
    if (entry.unoccluded)
      if (Problem problem = problem_on(entry); wanted(surface_of(problem))) problems.push_back(problem);
  return problems;
}

bool is_closed(const Surface& surface) { return surface.closed; }
bool is_affine(const Surface& surface) {
  return std::all_of(surface.charts.begin(), surface.charts.end(),
                     [](const Chart& chart) { return chart.facts().plane.has_value(); });
}

std::string title(const Problem& problem, int level) {
  return problem.surface.name + ", degree " + std::to_string(triangle_basis_of(problem.method).degree) +
         ", level " + std::to_string(level);
}

/// max |u_n - u| over the nodes.
double largest_error(const LevelOutcome& outcome, const std::function<double(const Vector<double>&)>& u) {
  double largest = 0;
  for (const NodeValue& node : outcome.nodes)
    largest = std::max(largest, std::abs(node.u_n.value - u(node.point)));
  return largest;
}

/// Narrow enough to be worth something: 1e-11 times the size of u, 10^4 roundings.
constexpr double narrow = 1e-11;

/// Solves with u given.
LevelResult solved_for(const Problem& problem, int level, const std::string& solution) {
  const LevelResult result =
      solve_level(with_solution(problem, solution), level, reference::applied_operator).result;
  EXPECT_LT(result.discretisation_error->radius, narrow) << title(problem, level);
  EXPECT_LT(result.node_error->radius, narrow) << title(problem, level);
  return result;
}

/// A solution in the space of the basis: no error but that of rounding and of the two quadratures.
void expect_within_the_radius(const LevelResult& result, const std::string& where) {
  EXPECT_LE(result.discretisation_error->value, result.discretisation_error->radius) << where;
  EXPECT_LE(result.node_error->value, result.node_error->radius) << where;
  EXPECT_LT(result.uniform_error->value, narrow) << where;
}

/// Solves with E given: |u_n - u| is the node error that the problem states with u given, within its radius.
void expect_the_error_stated(const Problem& problem, int level, const std::string& emission,
                             const std::function<double(const Vector<double>&)>& u,
                             const LevelResult& stated) {
  const double error = largest_error(solve_level(with_emission(problem, emission), level, no_route), u);
  EXPECT_NEAR(error, stated.node_error->value, stated.node_error->radius) << title(problem, level);
}

void expect_furnace(Problem problem, int level, const std::string& rho) {
  problem.reflectivity = everywhere(rho);
  const LevelResult stated = solved_for(problem, level, "1");
  expect_within_the_radius(stated, title(problem, level));
  expect_the_error_stated(
      problem, level, "1 - (" + rho + ")", [](const Vector<double>&) { return 1.0; }, stated);
}

TEST(KnownSolutions, TheFurnaceIsOneOnEveryClosedSurface) {
  const std::vector<Problem> problems = all_problems(is_closed);
  EXPECT_GE(problems.size(), 9U);
  for (const Problem& problem : problems) {
    expect_furnace(with_basis(problem, 0, std::nullopt), 0, "9/10");
    expect_furnace(with_basis(problem, 1, Rational(1, 6)), 0, "1/2 + sin(x + 2*y + 3*z)/4");
    expect_furnace(with_basis(problem, 2, Rational(1, 8)), 0, "1/2");
  }
}

TEST(KnownSolutions, TheFurnaceIsOneOnRefinedRoundSurfaces) {
  for (const char* name : {"cylinder", "cone", "paraboloid_cap"})
    expect_furnace(problem_on(*find_surface(name)), 1, "1/2");
}

TEST(KnownSolutions, TheUnitSphereAddsSinhOfOneToExp) {
  // u = E + rho/(1-rho) mean(E), and the mean of exp(z) is sinh(1).
  const Problem problem = sample_problem("sphere");
  for (const int level : {0, 1})
    expect_the_error_stated(
        problem, level, "exp(z)", [](const Vector<double>& p) { return std::exp(p.z) + std::sinh(1.0); },
        solved_for(problem, level, "exp(z) + (exp(1) - exp(-1))/2"));
}

TEST(KnownSolutions, TheSphericalCapGathersItsFraction) {
  // G = 1/4: Ku = rho f mean(u), so that constants E have u = E/(1 - rho f).
  for (const char* fraction : {"1/4", "1/2", "9/10", "1/20"})
    for (const char* rho : {"1/2", "9/10"}) {
      const Rational f = *Rational::parse(fraction);
      Problem problem = sample_problem("spherical_cap", {{"fraction", f}});
      problem.reflectivity = everywhere(rho);
      const Rational u = 3 / (1 - *Rational::parse(rho) * f);
      const LevelResult stated = solved_for(problem, 0, "3/(1 - " + std::string(rho) + "*" + fraction + ")");
      expect_within_the_radius(stated, title(problem, 0));
      expect_the_error_stated(
          problem, 0, "3", [&u](const Vector<double>&) { return u.to_double(); }, stated);
    }
}

TEST(KnownSolutions, TheSphericalCapAddsAConstantToTheHeight) {
  // With the rim at z_0 = 1 - 2f, Int z dS = pi (1 - z_0^2); u = z + c, c (1 - rho f) = rho (1 - z_0^2)/4.
  // For rho = 1/2 and f = 1/4 that is c = 3/28.
  const Problem problem = sample_problem("spherical_cap", {{"fraction", Rational(1, 4)}});
  for (const int level : {0, 1})
    expect_the_error_stated(
        problem, level, "z", [](const Vector<double>& p) { return p.z + 3.0 / 28; },
        solved_for(problem, level, "z + 3/28"));
}

TEST(KnownSolutions, LinearFunctionsAreSolvedForOnPolyhedra) {
  // They lie in the space of degree 1 on affine charts: E = u - Ku is the reference layer's, Ku_n that of the
  // quadrature.
  const std::vector<Problem> problems = all_problems(is_affine);
  EXPECT_GE(problems.size(), 5U);
  for (const Problem& problem : problems)
    expect_within_the_radius(solved_for(problem, 1, "2 + x/2 - y/3 + z/5"), title(problem, 1));
}

TEST(KnownSolutions, TheHeightIsSolvedForOnCylinderAndCone) {
  // Constant on the disks, and linear in the parameters of the mantle.
  const Problem narrow_below =
      sample_problem("cone", {{"radius", Rational(1, 3)}, {"top", 2}, {"height", Rational(7, 3)}});
  for (const Problem& problem :
       {problem_on(*find_surface("cylinder")), problem_on(*find_surface("cone")), narrow_below})
    expect_within_the_radius(solved_for(problem, 0, "1 + z/3"), title(problem, 0));
}

TEST(KnownSolutions, SmoothFunctionsAreApproachedOnEverySurface) {
  // Two coarse levels: that the error falls, and not yet at what order.
  const std::string u = "exp(x/2)*cos(y) + z";
  for (const Problem& problem : all_problems([](const Surface&) { return true; })) {
    const LevelResult coarse = solved_for(problem, 0, u);
    const LevelResult fine = solved_for(problem, 1, u);
    // (I - K_n)(u - u_n) = K(I - P_n)u at the nodes, and |K_n| is not far above rho = 1/2.
    EXPECT_LT(coarse.node_error->value, 4 * coarse.discretisation_error->value) << problem.surface.name;
    EXPECT_LT(fine.node_error->value, 4 * fine.discretisation_error->value) << problem.surface.name;
    EXPECT_LT(fine.node_error->value, 0.75 * coarse.node_error->value) << problem.surface.name;
  }
}

TEST(KnownSolutions, TheSphericalCapIsSuperconvergent) {
  // The inset 1/6 on a smooth surface: O(h^4 |log h|) at the nodes, against h^2 of the functions. The charts
  // are analytic up to the rim and the centre, or this would not be seen.
  const Problem problem = sample_problem("spherical_cap", {{"fraction", Rational(1, 4)}});
  const double coarse = solved_for(problem, 1, "exp(x/2)*cos(y) + z").node_error->value;
  const double fine = solved_for(problem, 2, "exp(x/2)*cos(y) + z").node_error->value;
  EXPECT_GT(coarse / fine, 8);
  EXPECT_LT(coarse / fine, 32);
}

TEST(KnownSolutions, PeaksBetweenThePointsOfTheSecondRouteAreSeen) {
  // Ku for u = 1 + c exp(-a |Q - Q_0|^2) on the cube is rho (1 + c/a G(P, Q_0) (1 + O(1/a))).
  const Vector<double> peak{0.3, 0.4, 0};
  for (const auto& [a, c] : {std::pair{1e4, 1.0}, {1e6, 1.0}, {1e8, 1e6}, {1e12, -1e3}}) {
    Problem problem =
        with_solution(sample_problem("cube"), "1 + (" + std::to_string(c) + ")*exp(-" + std::to_string(a) +
                                                  "*((x-0.3)^2 + (y-0.4)^2 + z^2))");
    const LevelOutcome level = solve_level(problem, 0, reference::applied_operator);
    ASSERT_TRUE(level.result.discretisation_error->radius);
    double largest = 0;
    for (const NodeValue& node : level.nodes) {
      const Vector<double> d = peak - node.point;
      const double g = node.piece == "floor" ? 0 : dot(d, node.normal) * -d.z / (dot(d, d) * dot(d, d));
      const double peak_of_ku = c / a * g / 2;
      largest = std::max(largest, std::abs(peak_of_ku));
      EXPECT_NEAR(*node.u - node.emission, 0.5 + peak_of_ku,
                  level.result.discretisation_error->radius + 1000 * std::abs(c) / (a * a));
    }
    // u = 1 at all nodes, so that K P_n u = 1/2.
    EXPECT_NEAR(level.result.discretisation_error->value, largest,
                level.result.discretisation_error->radius + 1000 * std::abs(c) / (a * a))
        << a;
    EXPECT_LT(level.result.discretisation_error->radius, 1e-2 * largest + 1e-12) << a;
  }
}

TEST(KnownSolutions, WithoutABoundHaveNoRadius) {
  for (const char* u : {"log((x - 0.3)^2)", "sin(y - 0.4)/(y - 0.4)"}) {
    const LevelResult level =
        solve_level(with_solution(sample_problem("cube"), u), 0, reference::applied_operator).result;
    EXPECT_FALSE(level.discretisation_error->has_radius()) << u;
    EXPECT_FALSE(level.node_error->has_radius()) << u;
    EXPECT_FALSE(level.solution_radius) << u;
  }
}

}  // namespace
}  // namespace radcert
