// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/sobol_net.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

TEST(SobolNet, GoesThroughItsPointsInOrder) {
  std::mt19937_64 random(1);
  const SobolNet net(random);
  SobolNet::Digits point = net.at(1000);
  for (std::uint64_t k = 1000; k < 5000; ++k) {
    EXPECT_EQ(point, net.at(k));
    net.advance(point, k);
  }
  EXPECT_THROW((void)net.at(std::uint64_t{1} << 32U), ContractViolation);
}

/// What the initial numbers promise: each coordinate alone is a net of quality 0, and all four are one of
/// quality 3, the sum of the degrees of their polynomials less one each.
TEST(SobolNet, HasAsManyPointsInEachDyadicBoxAsItsVolumeSays) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937_64 random(seed);
    const SobolNet net(random);
    const SobolNet::Digits shift = SobolNet::draw_shift(random);
    constexpr unsigned m = 10;
    constexpr unsigned quality = 3;
    for (const std::uint64_t begin : {std::uint64_t{0}, std::uint64_t{7} << m}) {
      std::vector<std::array<double, 4>> points;
      for (std::uint64_t k = begin; k < begin + (1U << m); ++k)
        points.push_back(SobolNet::shifted(net.at(k), shift));
      for (std::size_t j = 0; j < 4; ++j) {
        std::set<int> cells;
        for (const auto& x : points) cells.insert(static_cast<int>(std::ldexp(x[j], m)));
        EXPECT_EQ(cells.size(), points.size()) << j;
      }
      for (unsigned a = 0; a <= m - quality; ++a)
        for (unsigned b = 0; a + b <= m - quality; ++b)
          for (unsigned c = 0; a + b + c <= m - quality; ++c) {
            const unsigned d = m - quality - a - b - c;
            std::vector<int> count(1U << (m - quality), 0);
            for (const auto& x : points) {
              auto cell = static_cast<unsigned>(std::ldexp(x[0], static_cast<int>(a)));
              cell = (cell << b) + static_cast<unsigned>(std::ldexp(x[1], static_cast<int>(b)));
              cell = (cell << c) + static_cast<unsigned>(std::ldexp(x[2], static_cast<int>(c)));
              cell = (cell << d) + static_cast<unsigned>(std::ldexp(x[3], static_cast<int>(d)));
              ++count[cell];
            }
            for (const int n : count) EXPECT_EQ(n, 1 << quality) << a << b << c << d;
          }
    }
  }
}

TEST(SobolNet, HasMeansThatScatterAboutTheIntegral) {
  std::mt19937_64 random(5);
  double sum = 0;
  double squares = 0;
  constexpr int nets = 100;
  constexpr std::uint64_t points = 4096;
  for (int n = 0; n < nets; ++n) {
    const SobolNet net(random);
    const SobolNet::Digits shift = SobolNet::draw_shift(random);
    double mean = 0;
    for (std::uint64_t k = 0; k < points; ++k) {
      const auto x = SobolNet::shifted(net.at(k), shift);
      double square = 0;
      for (const double t : x) square += (t - 0.5) * (t - 0.5);
      mean += square < 0.25 ? 1.0 / points : 0;
    }
    sum += mean / nets;
    squares += mean * mean / nets;
  }
  // The ball of radius 1/2 has the volume pi^2 / 32; random points would scatter by 0.0072.
  const double volume = 0.30842513753404243;
  const double scatter = std::sqrt(squares - sum * sum);
  EXPECT_LT(scatter, 0.0036);
  EXPECT_NEAR(sum, volume, 4 * scatter / std::sqrt(nets));
}

}  // namespace
}  // namespace radcert
