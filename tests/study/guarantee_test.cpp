// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;
using testing::fault_of;
using ::testing::HasSubstr;
using testing::sample_problem;
using testing::with_emission;
using testing::with_solution;

Problem lit_cube() {
  Problem problem = with_emission(sample_problem("cube"), "1");
  problem.emission = by_piece({{"floor", "1"}, {"*", "0"}});
  return problem;
}

InputFault refused(const Problem& problem, const Rational& width = Rational(1, 100)) {
  return fault_of([&] { check_guarantee(problem, {width}); });
}

TEST(Guarantee, IsGivenForConstantDataOnConvexPolyhedra) {
  for (const char* name : {"cube", "tetrahedron", "octahedron"})
    EXPECT_NO_THROW(check_guarantee(with_emission(sample_problem(name), "1/3"), {Rational(1, 100)})) << name;
  // Constant on each face, though not as a formula.
  Problem problem = lit_cube();
  problem.reflectivity = by_piece({{"floor", "1/2 + z"}, {"*", "1/2"}});
  EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 100)}));
}

TEST(Guarantee, IsRefusedByNameElsewhere) {
  for (const char* name : {"sphere", "two_squares"}) {
    const InputFault fault = refused(with_emission(sample_problem(name), "1"));
    EXPECT_EQ(fault.pointer, "/surface/name") << name;
    EXPECT_EQ(fault.value, name);
    EXPECT_THAT(fault.allowed, HasSubstr("closed convex polyhedron"));
  }
  EXPECT_EQ(refused(with_solution(sample_problem("cube"), "1")).pointer, "/solution");
  Problem interpolated = lit_cube();
  interpolated.geometry = InterpolatedGeometry{};
  EXPECT_EQ(refused(interpolated).pointer, "/geometry");
}

TEST(Guarantee, RefusesDataThatItDoesNotKnow) {
  Problem problem = lit_cube();
  problem.reflectivity = everywhere("1/2 + x/10");
  EXPECT_EQ(refused(problem).pointer, "/reflectivity");
  for (const char* rho : {"1", "3/2", "-1/10"}) {
    problem.reflectivity = everywhere(rho);
    EXPECT_EQ(refused(problem).pointer, "/reflectivity") << rho;
  }
  problem = lit_cube();
  for (const char* emission : {"exp(x)", "x^9", "1/(2 + x)"}) {
    problem.emission = everywhere(emission);
    EXPECT_EQ(refused(problem).pointer, "/emission") << emission;
  }
  problem.emission = everywhere("x^3*y^2 - z/3");
  EXPECT_NO_THROW(check_guarantee(problem, {Rational(1, 100)}));
  problem.emission = everywhere("1e-70*x");
  EXPECT_EQ(refused(problem).pointer, "/emission");
}

TEST(Guarantee, SaysTheSmallestWidth) {
  const InputFault fault = refused(lit_cube(), Rational::parse("1e-12").value());
  EXPECT_EQ(fault.pointer, "/guarantee/width");
  EXPECT_THAT(fault.allowed, HasSubstr("e-10 or more"));
  EXPECT_EQ(refused(lit_cube(), 0).pointer, "/guarantee/width");
}

TEST(Guarantee, TakesPointsInsideFacesAlone) {
  const auto fault = [](const Vector<Rational>& point, EnclosedQuantity of) {
    return fault_of([&] { check_guarantee(lit_cube(), {Rational(1, 100), of, {point}}); });
  };
  const Rational half(1, 2);
  EXPECT_NO_THROW(
      check_guarantee(lit_cube(), {Rational(1, 100), EnclosedQuantity::values, {{half, half, 0}}}));
  for (const Vector<Rational>& point :
       {Vector<Rational>{half, half, half}, {half, 0, 0}, {0, 0, 0}, {half, half, 2}}) {
    EXPECT_EQ(fault(point, EnclosedQuantity::values).pointer, "/guarantee/points/0");
    EXPECT_THAT(fault(point, EnclosedQuantity::values).allowed, HasSubstr("none of its edges"));
  }
  EXPECT_EQ(fault({half, half, 0}, EnclosedQuantity::means).pointer, "/guarantee/points");
}

TEST(Guarantee, GivesTheValuesAtCentres) {
  Problem problem = with_emission(sample_problem("tetrahedron"), "3/5");
  problem.reflectivity = everywhere("2/5");
  const auto [level, enclosure] = solve_within(problem, {Rational(1, 5), EnclosedQuantity::values, {}});
  EXPECT_TRUE(enclosure.pieces.empty());
  EXPECT_TRUE(level.piece_means.empty());
  ASSERT_EQ(enclosure.points.size(), 4U);
  for (const EnclosedValue& point : enclosure.points) {
    EXPECT_TRUE(point.value.guaranteed);
    EXPECT_LE(std::abs(point.value.value - 1), point.value.radius) << point.piece;
  }
}

TEST(Guarantee, IsForSolveAlone) {
  Problem problem = lit_cube();
  problem.guarantee = Guarantee{Rational(1, 100)};
  EXPECT_EQ(fault_of([&] { check(problem, 1U << 30U); }).pointer, "/guarantee");
}

TEST(Guarantee, GivesTheMeshAndTheMeans) {
  Problem problem = lit_cube();
  const auto [level, enclosure] = solve_within(problem, {Rational(1, 10)});
  EXPECT_EQ(level.level, 2);
  EXPECT_EQ(level.elements, 144U);
  EXPECT_EQ(level.unknowns, 576U);
  EXPECT_TRUE(level.norm_K.guaranteed);
  EXPECT_LE(enclosure.width, 0.1);
  ASSERT_EQ(enclosure.pieces.size(), 6U);
  double sum = 0;
  for (const auto& [piece, mean] : enclosure.pieces) {
    EXPECT_TRUE(mean.guaranteed);
    sum += mean.value;
  }
  EXPECT_NEAR(sum, 2, 0.3);  // Int u = Int E / (1 - rho)
}

}  // namespace
}  // namespace radcert
