// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/edge_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/contract.h"
#include "verification/claims/ac98/collocation/known_problems.h"

namespace radcert::verification::ac98 {
namespace {

// Elements with the vertices (x,0,0), (x,0,1/4), (x + 1/4,0,1/4) and the value u at the first.
ElementValue element_at(double x, double u) {
  return {.piece = "xz",
          .corners = {Vector<double>{x, 0, 0}, Vector<double>{x, 0, 0.25}, Vector<double>{x + 0.25, 0, 0.25}},
          .corner_values = {u, 100, 100}};
}

TEST(EdgeValue, IsTheFixedPointOfTheFirstTermOfEquation22) {
  for (const Rational& rho : {Rational(0), Rational(1, 2), Rational(9, 10), Rational(1)}) {
    const Rational u = solution_on_the_edge(rho);
    EXPECT_EQ(u, 1 + rho / 2 * u) << rho.to_text();
  }
}

TEST(EdgeError, TakesVerticesOnTheEdgeButItsEnds) {
  const double exact = 4.0 / 3;
  LevelOutcome level;
  level.elements = {element_at(0, exact + 7), element_at(0.25, exact - 3), element_at(0.5, exact + 1),
                    element_at(0.5, exact - 2), element_at(1, exact + 9)};
  const EdgeError error = edge_error(level, Rational(1, 2));
  EXPECT_NEAR(error.at_midpoint.value, 2, 1e-14);
  EXPECT_NEAR(error.anywhere.value, 3, 1e-14);
}

TEST(EdgeError, AsksForAVertexInTheMiddle) {
  LevelOutcome level;
  level.elements = {element_at(0.25, 1)};
  EXPECT_THROW(static_cast<void>(edge_error(level, Rational(1, 2))), ContractViolation);
}

// (rho/4) B((b+2)/2, (1-b)/2) = 1 by the gamma function of the standard library.
TEST(EdgeExponent, SolvesItsEquation) {
  for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(9, 10), Rational(3, 2)}) {
    const double b = edge_exponent(rho);
    const double x = (b + 2) / 2;
    const double y = (1 - b) / 2;
    const double beta = std::exp(std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y));
    EXPECT_NEAR(rho.to_double() / 4 * beta, 1, 1e-6) << rho.to_text();
  }
}

TEST(LinearProblem, HasOneOfTheTwoKindsOfData) {
  const Problem bare = linear_problem("cube", {}, "1/2");
  EXPECT_FALSE(bare.solution || bare.emission);
  EXPECT_EQ(triangle_basis_of(bare.method).alpha, Rational(1, 6));
  EXPECT_TRUE(linear_problem_with_solution("cube", {}, "1/2", "x").solution.has_value());
  const Problem squares = constant_emission_on_two_squares(Rational(1, 2), 3);
  EXPECT_TRUE(squares.emission && !squares.solution);
  EXPECT_EQ(squares.triangulation.grading, Rational(3));
}

}  // namespace
}  // namespace radcert::verification::ac98
