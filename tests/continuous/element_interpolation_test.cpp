// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/element_interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/ball.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

/// (2i+1)/2 w_m P_i(x_m) of the exact Gauss rule, by i, m.
std::vector<Ball> exact_table(int nodes) {
  const IntervalRule<Ball> rule = legendre_rule(nodes);
  const std::size_t n = rule.nodes.size();
  std::vector<Ball> out(n * n);
  std::vector<Ball> values(n);
  for (std::size_t m = 0; m < n; ++m) {
    legendre_values<Ball>(rule.nodes[m], values);
    for (std::size_t i = 0; i < n; ++i)
      out[i * n + m] = Ball(Rational(static_cast<long>(2 * i + 1), 2)) * rule.weights[m] * values[i];
  }
  return out;
}

/// The exact coefficients of the interpolant at n_s n_t nodes, by i, j.
std::vector<Ball> exact_coefficients(int n_s, int n_t, const std::vector<double>& values) {
  const std::vector<Ball> in_s = exact_table(n_s);
  const std::vector<Ball> in_t = exact_table(n_t);
  const auto of_s = static_cast<std::size_t>(n_s);
  const auto of_t = static_cast<std::size_t>(n_t);
  std::vector<Ball> out(of_s * of_t);
  for (std::size_t i = 0; i < of_s; ++i)
    for (std::size_t m = 0; m < of_s; ++m)
      for (std::size_t l = 0; l < of_t; ++l) {
        const Ball in_x = in_s[i * of_s + m] * Ball(values[m * of_t + l]);
        for (std::size_t j = 0; j < of_t; ++j) out[i * of_t + j] += in_x * in_t[j * of_t + l];
      }
  return out;
}

std::vector<double> coefficients_of(int n_s, int n_t, const std::vector<double>& values) {
  std::vector<double> out(values.size());
  ElementInterpolation(n_s, n_t).coefficients(values, 1, out);
  return out;
}

constexpr std::array<std::array<int, 2>, 7> orders{
    {{1, 1}, {2, 2}, {1, most_gauss_nodes}, {most_gauss_nodes, 1}, {3, 8}, {8, 5}, {12, 12}}};

TEST(ElementInterpolation, CountsItsRoundings) {
  // Against exact coefficients of the same values, each +-1 or near it; the polynomials differ in a corner,
  // where each P_i P_j is +-1.
  Draw draw(52);
  int rounded = 0;
  for (const auto& [n_s, n_t] : orders) {
    std::vector<double> values;
    for (int k = 0; k < n_s * n_t; ++k)
      values.push_back((draw.unit() < 0.5 ? -1 : 1) * (1 - 0.1 * draw.unit()));
    const std::vector<double> found = coefficients_of(n_s, n_t, values);
    const std::vector<Ball> exact = exact_coefficients(n_s, n_t, values);
    double most = 0;
    for (const int x : {-1, 1})
      for (const int y : {-1, 1}) {
        Ball off(0);
        for (int i = 0; i < n_s; ++i)
          for (int j = 0; j < n_t; ++j) {
            const auto at = static_cast<std::size_t>(i * n_t + j);
            const int sign = (x < 0 && i % 2 != 0) != (y < 0 && j % 2 != 0) ? -1 : 1;
            off += Ball(sign) * (Ball(found[at]) - exact[at]);
          }
        most = std::max(most, abs(off).lower_double());
      }
    EXPECT_LE(most, ElementInterpolation(n_s, n_t).rounding(1, 0)) << n_s << " " << n_t;
    rounded += most > 0 ? 1 : 0;
  }
  EXPECT_GE(rounded, 5);
}

TEST(ElementInterpolation, CountsWhatValuesAreOffBy) {
  // Values off by as much each, with the signs of Lagrange's polynomials in the corner where their sum is
  // largest: the interpolant moves there by the product of both sums, with one node by as much as the value.
  constexpr double off = 1e-3;
  for (const auto& [n_s, n_t] : orders) {
    const auto signs_in_corner = [](int nodes) {
      const std::vector<Ball> table = exact_table(nodes);
      const auto n = static_cast<std::size_t>(nodes);
      std::vector<double> out;
      for (std::size_t m = 0; m < n; ++m) {
        Ball l(0);
        for (std::size_t i = 0; i < n; ++i) l += table[i * n + m];
        out.push_back(certainly_negative(l) ? -1 : 1);
      }
      return out;
    };
    std::vector<double> values;
    for (const double s : signs_in_corner(n_s))
      for (const double t : signs_in_corner(n_t)) values.push_back(off * s * t);
    double moved = 0;
    for (const double c : coefficients_of(n_s, n_t, values)) moved += c;
    EXPECT_GE(moved, off * (1 - 1e-12));
    EXPECT_GE(ElementInterpolation(n_s, n_t).rounding(1, off), moved * (1 - 1e-12)) << n_s << " " << n_t;
  }
}

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
