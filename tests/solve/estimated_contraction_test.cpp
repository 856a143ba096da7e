// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/estimated_contraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/linear_solver.h"

namespace radcert {
namespace {

Outcome<double> estimate(const std::vector<double>& norms) { return estimated_inverse_norm(norms); }

TEST(EstimatedInverseNorm, IsTwiceTheLargestOfNormsThatHaveSettled) {
  EXPECT_EQ(estimate({3, 3.5}).value(), 7);
  EXPECT_EQ(estimate({4, 3.5}).value(), 8);
  EXPECT_EQ(estimate({9, 4, 4}).value(), 18);
  EXPECT_EQ(estimate({0.3, 0.3}).value(), 1);
}

TEST(EstimatedInverseNorm, IsRefusedWhereTheNormsTellNothing) {
  EXPECT_FALSE(estimate({}));
  EXPECT_FALSE(estimate({3}));
  EXPECT_FALSE(estimate({3, 4}));
  EXPECT_FALSE(estimate({4, 3}));
  EXPECT_TRUE(estimate({4, 3.3}));
  EXPECT_FALSE(estimate({std::numeric_limits<double>::infinity(), 3}));
  EXPECT_FALSE(estimate({3, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(ContractionByEstimate, BoundsWhatTheInverseDoesToMatricesWithinTheRadii) {
  for (const double norm : {1.0, 2.0, 57.0})
    for (const double radius : {0.0, 1e-9, 0.25 / norm}) {
      const Contraction c = contraction_by_estimate(VectorParts(5), norm, radius);
      EXPECT_GE(c.inverse_bound(1), norm / (1 - norm * radius));
      EXPECT_LE(c.inverse_bound(1), norm / (1 - norm * radius) * (1 + 1e-12));
      EXPECT_EQ(c.least_weight(), 1);
      EXPECT_LT(c.theta(), 1);
    }
  EXPECT_THROW(static_cast<void>(contraction_by_estimate(VectorParts(5), 0.5, 0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(contraction_by_estimate(VectorParts(5), 4, 0.25)), ContractViolation);
  EXPECT_THROW(
      static_cast<void>(contraction_by_estimate(VectorParts(5), std::numeric_limits<double>::infinity(), 0)),
      ContractViolation);
}

TEST(GmresByEstimate, KeepsToItsBoundWhereNothingContracts) {
  // Rotations by a quarter turn and by others: of spectral radius above 1, and far from 1 itself.
  constexpr std::size_t n = 40;
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    Matrix<double> k(n, n);
    for (std::size_t i = 0; i < n; i += 2) {
      const double turn = std::uniform_real_distribution<double>(1, 2)(random);
      k(i, i) = k(i + 1, i + 1) = 1.5 * std::cos(turn);
      k(i, i + 1) = 1.5 * std::sin(turn);
      k(i + 1, i) = -k(i, i + 1);
    }
    ASSERT_FALSE(find_contraction(k));
    std::vector<double> e(n);
    for (double& each : e) each = std::uniform_real_distribution<double>(-1, 1)(random);
    const DirectSolver direct(k);
    const Contraction c =
        contraction_by_estimate(VectorParts(n), std::max(1.0, direct.inverse_norm() * (1 + 1e-9)), 0);
    const std::vector<double> exact = direct.solve(e);
    for (const double tolerance : {1e-3, 1e-9}) {
      const Outcome<IterativeSolution, NotReached> found = solve_by_gmres(SystemMatrix(k), c, e, tolerance);
      ASSERT_TRUE(found);
      double off = 0;
      double size = 0;
      for (std::size_t i = 0; i < n; ++i) {
        off = std::max(off, std::abs(found->values[i] - exact[i]));
        size = std::max(size, std::abs(exact[i]));
      }
      EXPECT_LE(off, found->error_bound + 1e-14);
      EXPECT_LE(found->error_bound, 1.01 * tolerance * size);
    }
  }
}

TEST(GmresByEstimate, IsGmresWhereAContractionIsFound) {
  const LinearSolver* solver = find_linear_solver(gmres_by_estimate);
  ASSERT_NE(solver, nullptr);
  EXPECT_EQ(chosen(*solver, true).name, "gmres");
  EXPECT_EQ(chosen(*solver, false).name, gmres_by_estimate);
  EXPECT_TRUE(solver->iterates());
  EXPECT_FALSE(solver->proves());
}

}  // namespace
}  // namespace radcert
