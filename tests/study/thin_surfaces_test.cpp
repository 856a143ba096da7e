// SPDX-License-Identifier: GPL-3.0-or-later
// Problems at the ends of what double holds: a value within its radius, or a refusal with a name.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::everywhere;
using testing::fault_of;
using testing::sample_problem;
using testing::with_basis;
using testing::with_emission;
using testing::with_solution;

/// The level, or nothing where it is refused.
std::optional<LevelOutcome> solved(const Problem& problem, int level = 0) {
  try {
    check(problem, std::uint64_t{1} << 32U);
    return solve_level(problem, level, reference::applied_operator);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const AccuracyNotReached&) {
    return std::nullopt;
  }
}

/// Whether u = 1 lies within what a level says of itself.
void expect_one(const LevelOutcome& level, const std::string& what) {
  const LevelResult& result = level.result;
  ASSERT_TRUE(result.solution_radius.has_value()) << what;
  for (const NodeValue& node : level.nodes)
    EXPECT_LE(std::abs(node.u_n.value - 1), *result.solution_radius) << what;
  for (const auto& [piece, mean] : result.piece_means)
    EXPECT_LE(std::abs(mean.value - 1), mean.radius) << what << ", " << piece;
  if (result.node_error) {
    EXPECT_LE(result.node_error->value, result.node_error->radius) << what;
  }
  if (result.discretisation_error) {
    EXPECT_LE(result.discretisation_error->value, result.discretisation_error->radius) << what;
  }
}

Rational power_of_ten(int exponent) {
  Rational value = 1;
  for (int k = 0; k < std::abs(exponent); ++k)
    value = exponent < 0 ? value / Rational(10) : value * Rational(10);
  return value;
}

TEST(ThinSurfaces, HaveTheSolutionWithinTheRadiusOrAreRefused) {
  for (const int exponent : {-1, -6, -8, -9, -10, -12, -14, -16, -30})
    for (const char* solver : {"direct", "gmres"}) {
      const std::string what = "10^" + std::to_string(exponent) + ", " + std::string(solver);
      Problem problem = sample_problem("box", {{"a", power_of_ten(exponent)}, {"b", 1}, {"c", 1}});
      problem.solver = {.name = solver, .tolerance = std::nullopt};
      for (const Problem& p : {with_emission(problem, "1/2"), with_solution(problem, "1")}) {
        const std::optional<LevelOutcome> level = solved(p);
        if (level) expect_one(*level, what);
        if (exponent >= -9) {
          EXPECT_TRUE(level) << what;
        }
        if (exponent >= -6) {
          EXPECT_LT(*level->result.solution_radius, 1e-7) << what;
        }
        if (exponent <= -16) {
          EXPECT_FALSE(level) << what;
        }
      }
    }
}

TEST(ThinSurfaces, KnowTheirMeansOnCurvedPieces) {
  for (const char* surface : {"sphere", "cylinder", "ellipsoid"})
    for (int degree = 0; degree <= 2; ++degree) {
      const std::string what = std::string(surface) + ", degree " + std::to_string(degree);
      std::vector<SurfaceParameter> parameters;
      if (std::string(surface) == "ellipsoid") parameters = {{"a", 1}, {"b", 2}, {"c", Rational(1, 10)}};
      if (std::string(surface) == "cylinder") parameters = {{"radius", 1}, {"height", 2}};
      const Problem problem =
          with_basis(sample_problem(surface, parameters), degree, degree == 0 ? Rational(0) : Rational(1, 8));
      const std::optional<LevelOutcome> level = solved(with_emission(problem, "1/2"));
      ASSERT_TRUE(level) << what;
      expect_one(*level, what);
    }
}

/// A tetrahedron of that size, as a mesh of so many of its faces that says to be closed.
Problem tetrahedron(double size, std::size_t faces = 4) {
  TriangleMesh mesh{.vertices = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}},
                    .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                    .group = {0, 0, 0, 0},
                    .group_names = {""},
                    .face = {0, 1, 2, 3}};
  mesh.triangles.resize(faces);
  mesh.group.resize(faces);
  mesh.face.resize(faces);
  const std::vector<std::size_t> pieces(mesh.face.begin(), mesh.face.end());
  std::vector<std::string> names{"a", "b", "c", "d"};
  names.resize(faces);
  Problem problem = sample_problem("t.off");
  problem.surface.mesh = MeshChoice{.file = "t.off",
                                    .digest = "",
                                    .angle = 30,
                                    .repair = {},
                                    .mended = {},
                                    .surface = std::make_shared<const Surface>(mesh_surface(
                                        "t.off", mesh, pieces, names, {.closed = true, .unoccluded = true}))};
  return problem;
}

TEST(ThinSurfaces, AreRefusedAtScalesBeyondDouble) {
  for (const double size : {1e-200, 1e-100, 1e-75, 1e75, 1e100})
    for (const char* solver : {"direct", "verified"}) {
      Problem problem = tetrahedron(size);
      problem.solver = {.name = solver, .tolerance = std::nullopt};
      EXPECT_EQ(
          fault_of([&] { static_cast<void>(solve_level(problem, 0, reference::applied_operator)); }).pointer,
          "/surface")
          << size;
    }
  for (const double size : {1e-55, 1e-20, 1.0, 1e20, 1e55}) {
    const std::optional<LevelOutcome> level = solved(with_emission(tetrahedron(size), "1/2"));
    ASSERT_TRUE(level) << size;
    expect_one(*level, std::to_string(size));
    EXPECT_LT(*level->result.solution_radius, 1e-11) << size;
  }
}

TEST(ClosedSurfaces, AreRefusedWhereARowIsProvedWrong) {
  // A surface that is not what it says to be stands for integrals that are not what they say to be.
  for (const char* solver : {"direct", "gmres", "verified"}) {
    Problem problem = with_emission(tetrahedron(1, 3), "1/2");
    problem.solver = {.name = solver, .tolerance = std::nullopt};
    EXPECT_THROW(static_cast<void>(solve_level(problem, 0, reference::applied_operator)), AccuracyNotReached)
        << std::string(solver);
  }
}

TEST(ThinSurfaces, AreRefusedWhereAGradingLeavesNoTriangles) {
  Problem problem = sample_problem("cube");
  problem.triangulation.grading = 50;
  EXPECT_EQ(
      fault_of([&] { static_cast<void>(solve_level(problem, 3, reference::applied_operator)); }).pointer,
      "/triangulation");
}

TEST(FlatEllipsoids, HaveTwoSidesForTheSecondRouteToo) {
  // The far side is nearer than the disk about a point beyond a seam that is bounded instead of integrated.
  for (const Rational& axis : {Rational(1, 1000000), Rational(3, 100000000), Rational(1, 1000000000)})
    for (const int degree : {0, 1})
      for (const int level : {0, 1}) {
        const std::vector<SurfaceParameter> axes{
            {"a", 1}, {"b", level == 0 ? Rational(1) : Rational(2)}, {"c", axis}};
        const Problem problem =
            with_basis(sample_problem("ellipsoid", axes), degree, degree == 0 ? Rational(0) : Rational(1, 6));
        const std::optional<LevelOutcome> outcome = solved(with_solution(problem, "1"), level);
        if (outcome) expect_one(*outcome, "c = " + axis.to_text() + ", level " + std::to_string(level));
        EXPECT_TRUE(outcome || degree == 1 || level == 1) << axis.to_text();
      }
}

TEST(SteepRoofs, AreIntegratedWithinTheirRadii) {
  // z = 2 - s^p has a layer of width 1/p at s = 1, which two rules for the whole roof miss alike.
  for (const int p : {7, 200, 1000})
    for (const Rational& tolerance : {Rational(1, 1000), Rational(1, 1000000), Rational(1, 1000000000000)})
      for (const int degree : {0, 2}) {
        if (degree == 2 && tolerance != Rational(1, 1000000)) continue;
        Problem problem = with_basis(sample_problem("two_piece", {{"p", p}}), degree,
                                     degree == 0 ? Rational(0) : Rational(1, 10));
        problem.quadrature.tolerance = tolerance;
        const std::optional<LevelOutcome> level = solved(with_solution(problem, "1"));
        ASSERT_TRUE(level);
        expect_one(*level, "p = " + std::to_string(p) + ", degree " + std::to_string(degree) +
                               ", tolerance " + tolerance.to_text());
        EXPECT_LT(*level->result.solution_radius, 10 * tolerance.to_double() + 1e-12);
      }
}

TEST(Solutions, AreRefusedAtAPole) {
  for (const char* u : {"1/(x-0.3)", "1/(y-1/2)^2"}) {
    const Problem problem = with_solution(sample_problem("cube"), u);
    EXPECT_FALSE(solved(problem)) << u;
  }
}

TEST(Solutions, BeyondTheRangeOfDoubleAreRefusedOrHaveNoRadius) {
  for (const char* u : {"x*1e300", "1e308", "x*1e307 + y"}) {
    const std::optional<LevelOutcome> level = solved(with_solution(sample_problem("cube"), u));
    if (!level) continue;
    EXPECT_FALSE(std::isnan(level->result.node_error->radius)) << u;
    EXPECT_TRUE(std::isfinite(level->result.discretisation_error->value)) << u;
  }
}

TEST(Solutions, AreKnownAsFarAsTheirExpressionIs) {
  // The nodes' coordinates are rounded, and next to a pole u says so.
  for (const char* u : {"1/(x + 1e-9)", "1/(1.000000001 - y)", "exp(1e3*x)", "sin(1e8*z)"}) {
    const Problem rough = with_solution(sample_problem("cube"), u);
    Problem proved = rough;
    proved.solver.name = "verified";
    const std::optional<LevelOutcome> level = solved(rough);
    const std::optional<LevelOutcome> truth = solved(proved);
    if (!level || !truth || !level->result.solution_radius) continue;
    for (std::size_t i = 0; i < level->nodes.size(); ++i)
      EXPECT_LE(std::abs(level->nodes[i].u_n.value - truth->nodes[i].u_n.value),
                *level->result.solution_radius + truth->nodes[i].u_n.radius)
          << u << " " << i;
  }
}

TEST(Solutions, ThatNeedTooManyReflectionsAreRefusedAtOnce) {
  Problem problem = with_solution(sample_problem("cube"), "x");
  problem.reflectivity = everywhere("0.999999999999");
  problem.solver = {.name = "neumann", .tolerance = std::nullopt};
  EXPECT_THROW(static_cast<void>(solve_level(problem, 0, reference::applied_operator)), AccuracyNotReached);
}

}  // namespace
}  // namespace radcert
