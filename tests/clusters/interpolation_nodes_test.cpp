// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/interpolation_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/clusters/mode_tables.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/triangle_modes.h"

namespace radcert {
namespace {

/// The largest sum of |Lagrange functions| over a lattice.
double lebesgue_constant_of(int degree) {
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
  const std::size_t k = interpolation.nodes.size();
  std::vector<double> modes(k);
  double largest = 0;
  constexpr int lattice = 60;
  for (int a = 0; a <= lattice; ++a)
    for (int b = 0; b <= std::min(a, lattice - a); ++b) {
      const Barycentric<double> x{
          {double(a) / lattice, double(b) / lattice, double(lattice - a - b) / lattice}};
      triangle_modes<double>(degree, x, modes);
      double sum = 0;
      for (std::size_t node = 0; node < k; ++node) {
        double value = 0;
        for (std::size_t n = 0; n < k; ++n) value += modes[n] * interpolation.modes_of_values(n, node);
        sum += std::abs(value);
      }
      largest = std::max(largest, sum);
    }
  return largest;
}

TEST(InterpolationNodes, AreDistinctPointsOfTheTriangleSymmetricInItsVertices) {
  for (int degree = 0; degree <= largest_mode_degree; ++degree) {
    const std::vector<Barycentric<double>> nodes = interpolation_nodes(degree);
    ASSERT_EQ(nodes.size(), mode_count(degree));
    const auto has = [&nodes](double a, double b, double c) {
      return std::count_if(nodes.begin(), nodes.end(), [&](const Barycentric<double>& x) {
        return std::abs(x.x[0] - a) + std::abs(x.x[1] - b) + std::abs(x.x[2] - c) < 1e-14;
      });
    };
    for (const Barycentric<double>& x : nodes) {
      EXPECT_NEAR(x.x[0] + x.x[1] + x.x[2], 1, 4e-16);
      for (const double coordinate : x.x) EXPECT_GE(coordinate, 0);
      EXPECT_EQ(has(x.x[0], x.x[1], x.x[2]), 1) << degree;
      EXPECT_EQ(has(x.x[1], x.x[2], x.x[0]), 1) << degree;
      EXPECT_EQ(has(x.x[1], x.x[0], x.x[2]), 1) << degree;
    }
  }
}

TEST(InterpolationNodes, HaveSmallLebesgueConstants) {
  // As measured at the points of a lattice, and known for these nodes.
  for (const auto& [degree, bound] :
       {std::pair{1, 1.0}, {4, 2.7}, {8, 5.1}, {10, 6.7}, {12, 9.3}, {15, 18.0}, {18, 38.0}, {20, 66.0}}) {
    const double constant = lebesgue_constant_of(degree);
    EXPECT_LE(constant, bound * (1 + 1e-12)) << degree;
    EXPECT_GE(constant, 0.97 * bound) << degree;
  }
}

TEST(InterpolationNodes, RefuseADegreeOutOfRange) {
  EXPECT_THROW(interpolation_nodes(-1), ContractViolation);
  EXPECT_THROW(interpolation_nodes(largest_mode_degree + 1), ContractViolation);
}

}  // namespace
}  // namespace radcert
