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
  problem.emission = everywhere("exp(x)");
  EXPECT_EQ(refused(problem).pointer, "/emission");
}

TEST(Guarantee, SaysTheSmallestWidth) {
  const InputFault fault = refused(lit_cube(), Rational::parse("1e-12").value());
  EXPECT_EQ(fault.pointer, "/guarantee/width");
  EXPECT_THAT(fault.allowed, HasSubstr("e-10 or more"));
  EXPECT_EQ(refused(lit_cube(), 0).pointer, "/guarantee/width");
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
