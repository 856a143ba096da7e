// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/contracting_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(ContractingSystem, ReachesItsBoundWhereTheProductsDo) {
  // K = ((0, 1/2), (1/4, 0)), u = (1, 1): e = (1/2, 3/4). From x = (1 + d, 1 + c) the residual is exact.
  const double d = 0x1p-10;
  const double c = 0x1p-11;
  const std::vector<double> x{1 + d, 1 + c};
  const std::vector<double> residual{std::abs(0.5 - x[0] + x[1] / 2), std::abs(0.75 - x[1] + x[0] / 4)};
  const std::vector<double> weights{1, 0.75};
  const std::vector<double> sizes{0.375, 0.25};
  const auto found = contracting_solution(x, residual, weights, sizes);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->theta, 0.375, 1e-12);
  EXPECT_GE(found->solution.radius[0], d);
  EXPECT_GE(found->solution.radius[1], c);
  EXPECT_LE(found->solution.radius[0], 1.5 * d);
  EXPECT_LE(found->solution.radius[1], 2.5 * c);
}

TEST(ContractingSystem, EnclosesTheSolutionOfOneEquation) {
  // (1 - k) u = e with k < 0: the residual's bound and theta are both reached for k = theta.
  for (const double theta : {0.0, 0.25, 0.5, 0.9375}) {
    const double u = 3;
    const double x = 3.5;
    const std::vector<double> residual{std::abs((1 - theta) * u - x + theta * x)};
    const auto found = contracting_solution(std::vector<double>{x}, residual, std::vector<double>{1},
                                            std::vector<double>{theta});
    ASSERT_TRUE(found);
    EXPECT_GE(found->solution.radius[0], 0.5);
    EXPECT_LE(found->solution.radius[0], 0.5 * (1 + 1e-9));
  }
}

TEST(ContractingSystem, RefusesWhatDoesNotContract) {
  const std::vector<double> one{1};
  EXPECT_FALSE(contracting_solution(one, one, one, one));
  EXPECT_FALSE(contracting_solution(one, one, one, std::vector<double>{2}));
  EXPECT_FALSE(contracting_solution(one, std::vector<double>{INFINITY}, one, std::vector<double>{0.5}));
  EXPECT_FALSE(contracting_solution(one, one, one, std::vector<double>{NAN}));
  EXPECT_THROW(static_cast<void>(contracting_solution(one, one, std::vector<double>{0}, one)),
               ContractViolation);
  EXPECT_THROW(
      static_cast<void>(contracting_solution(one, std::vector<double>{-1}, one, std::vector<double>{0})),
      ContractViolation);
}

}  // namespace
}  // namespace radcert
