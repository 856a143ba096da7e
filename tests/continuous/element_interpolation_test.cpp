// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/core/contract.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

/// By products of differences, at points that no table of the bound has.
TEST(LebesgueConstant, IsTheLargestSumOfLagrangesPolynomials) {
  EXPECT_NEAR(lebesgue_constant(1), 1, 1e-9);
  for (int n = 1; n <= most_gauss_nodes; ++n) {
    const std::vector<double>& x = gauss_on_interval(n).nodes;
    double largest = 0;
    for (int a = 0; a <= 3001; ++a) {
      const double at = -1 + 2.0 * a / 3001;
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        double product = 1;
        for (std::size_t k = 0; k < x.size(); ++k)
          if (k != i) product *= (at - x[k]) / (x[i] - x[k]);
        sum += std::abs(product);
      }
      largest = std::max(largest, sum);
    }
    EXPECT_GE(lebesgue_constant(n), largest) << n;
    EXPECT_LE(lebesgue_constant(n), 1.02 * largest) << n;
  }
  EXPECT_THROW(static_cast<void>(lebesgue_constant(0)), ContractViolation);
}

double value(const std::vector<double>& c, std::size_t of_x, std::size_t of_y, double x, double y) {
  std::vector<double> p_x(of_x);
  std::vector<double> p_y(of_y);
  legendre_values<double>(x, p_x);
  legendre_values<double>(y, p_y);
  double sum = 0;
  for (std::size_t i = 0; i < of_x; ++i)
    for (std::size_t j = 0; j < of_y; ++j) sum += c[i * of_y + j] * p_x[i] * p_y[j];
  return sum;
}

TEST(Supremum, IsAboveTheLargestValueAndNearIt) {
  Draw draw(51);
  double farthest = 1;
  for (std::size_t of_x = 1; of_x <= 16; of_x += 3)
    for (std::size_t of_y = 1; of_y <= 16; of_y += 5) {
      std::vector<double> c;
      double size = 0;
      for (std::size_t k = 0; k < of_x * of_y; ++k) {
        // Coefficients that fall, as those of residuals do.
        c.push_back((draw.unit() - 0.5) * std::exp2(-0.5 * static_cast<double>(k / of_y + k % of_y)));
        size += std::abs(c.back());
      }
      double most = 0;
      for (int a = 0; a <= 100; ++a)
        for (int b = 0; b <= 100; ++b)
          most = std::max(most, std::abs(value(c, of_x, of_y, -1 + 0.02 * a, -1 + 0.02 * b)));
      const double bound = supremum(c, of_x, of_y);
      EXPECT_GE(bound, most) << of_x << " " << of_y;
      EXPECT_LE(bound, size * (1 + 1e-9)) << of_x << " " << of_y;
      farthest = std::max(farthest, bound / most);
    }
  EXPECT_LE(farthest, 1.9);
}

/// Each power alone, with its largest value at a corner or inside of one part alone.
TEST(Supremum, LooksAtAllParts) {
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t j = 0; j < 16; ++j) {
      std::vector<double> c(16 * 16);
      c[i * 16 + j] = 1;
      EXPECT_GE(supremum(c, 16, 16), 1) << i << " " << j;
      EXPECT_LE(supremum(c, 16, 16), 1 + 1e-9) << i << " " << j;
    }
  // (1 +- x)(1 +- y)/4 is largest in one corner.
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const double bound = supremum(std::vector<double>{0.25, 0.25 * y, 0.25 * x, 0.25 * x * y}, 2, 2);
      EXPECT_GE(bound, 1);
      EXPECT_LE(bound, 1 + 1e-9);
    }
  // A peak within each part: 1 - (x - m)^2/2 - (y - m')^2/2 has its largest value there.
  for (const double m : {-0.75, -0.25, 0.25, 0.75})
    for (const double l : {-0.75, -0.25, 0.25, 0.75}) {
      const double at = 1 - 0.5 * (m * m + l * l) - 1.0 / 3;
      const std::vector<double> c{at, l, -1.0 / 3, m, 0, 0, -1.0 / 3, 0, 0};
      const double least =
          1 - 0.5 * ((1 + std::abs(m)) * (1 + std::abs(m)) + (1 + std::abs(l)) * (1 + std::abs(l)));
      EXPECT_GE(supremum(c, 3, 3), std::max(1.0, -least));
      EXPECT_LE(supremum(c, 3, 3), std::max(1.0, -least) + 0.3);
    }
}

TEST(Supremum, RefusesMorePowersThanItHasTablesOf) {
  EXPECT_THROW(static_cast<void>(supremum(std::vector<double>(17), 17, 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(supremum(std::vector<double>(3), 2, 2)), ContractViolation);
}

}  // namespace
}  // namespace radcert
