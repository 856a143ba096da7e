// SPDX-License-Identifier: GPL-3.0-or-later
// The ingredients of certified numbers, each where its bound is nearly reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "radcert/collocation/certified/certified_operator.h"
#include "radcert/collocation/certified/exact_nodes.h"
#include "radcert/quadrature/certified/disk_bound.h"
#include "radcert/quadrature/certified/kernel_disk.h"
#include "radcert/quadrature/certified/kernel_rule.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

/// How far rho/pi times a number lies from an entry, in parts of its radius, at most.
double reach(const Approximation& entry, double reflectivity, const Rational& integral) {
  const BallPrecision precision(2300);
  const Ball exact = Ball(Rational::exactly(reflectivity) * integral) / Ball::pi();
  return (abs(exact - Ball(entry.value)) / Ball(entry.radius)).upper_double();
}

TEST(CertifiedEntry, HoldsItsRoundingsAndTheErrorOfTheIntegral) {
  std::mt19937_64 random(61);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -53); };
  double without_error = 0;
  double with_error = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double reflectivity = (trial % 2 == 0 ? 1 : -1e9) * unit();
    const double integral = 2 * unit() - 1;
    without_error = std::max(without_error, reach(certified_entry(reflectivity, integral, 0), reflectivity,
                                                  Rational::exactly(integral)));
    const double error = std::ldexp(unit(), -static_cast<int>(random() % 40));
    for (const int side : {-1, 1})
      with_error = std::max(with_error, reach(certified_entry(reflectivity, integral, error), reflectivity,
                                              Rational::exactly(integral) + side * Rational::exactly(error)));
  }
  EXPECT_LE(without_error, 1);
  EXPECT_GE(without_error, 0.3);
  EXPECT_LE(with_error, 1);
  EXPECT_GE(with_error, 0.999);
}

TEST(CertifiedEntry, HoldsWhatUnderflows) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const double reflectivity : {least, 7 * least, 101 * least, 1e-310, 1e-160})
    for (const double integral : {0.0, 1e-160, 1e-10, 1.0, 3.0, 1000.0, -77.0})
      EXPECT_LE(reach(certified_entry(reflectivity, integral, 0), reflectivity, Rational::exactly(integral)),
                1)
          << reflectivity << " " << integral;
}

constexpr double hardly_half = 0x1.fffffp-54;  ///< of a unit of 1: lost beside it

TEST(CertifiedSums, CountTheRoundingOfEverySum) {
  constexpr long others = 999;
  CertifiedSums sums(1);
  sums.add(std::array{1.0}, std::array{0.0});
  for (long k = 0; k < others; ++k) sums.add(std::array{hardly_half}, std::array{0.0});
  const CertifiedValues found = std::move(sums).within(1, 1 + others).value();
  const Rational exact = 1 + Rational(others) * Rational::exactly(hardly_half);
  const Rational off = abs(exact - Rational::exactly(found.values[0]));
  EXPECT_LE(off, Rational::exactly(found.radius[0]));
  EXPECT_GE(2 * off, Rational(99, 100) * Rational::exactly(found.radius[0]));
}

TEST(CertifiedSums, CountTheRoundingsOfTheirRadii) {
  constexpr long others = 999;
  CertifiedSums sums(1);
  sums.add(std::array{0.0}, std::array{1.0});
  for (long k = 0; k < others; ++k) sums.add(std::array{0.0}, std::array{hardly_half});
  const CertifiedValues found = std::move(sums).within(2, 1 + others).value();
  EXPECT_GE(Rational::exactly(found.radius[0]), 1 + Rational(others) * Rational::exactly(hardly_half));
}

/// A rule all of whose nodes are straight before P, at the distance 1: the kernel is 1.
struct StraightRule {
  KernelRule rule{1};
  explicit StraightRule(int order) { rule.begin(order); }

  void add(const BoundedDouble& weight, double normal_error = 0) {
    const auto exactly = [](double x) { return BoundedDouble::exactly(x); };
    rule.add({exactly(0), exactly(0), exactly(1)}, {exactly(0), exactly(0), BoundedDouble(-1, normal_error)},
             std::array{weight});
  }
  /// The sum with its radius.
  [[nodiscard]] Approximation sum() const {
    const KernelRule::Points points{.position = {Pack(0), Pack(0), Pack(0)},
                                    .normal = {Pack(0), Pack(0), Pack(1)}};
    KernelRule::Sums sums;
    rule.take_sums(points, sums);
    std::array<double, 1> radius{};
    rule.rounding(sums, 0, {}, radius);
    return Approximation::proved(sums.sum[0].lane(0), radius[0]);
  }
};

TEST(KernelRule, CountsTheRoundingsOfItsSums) {
  // In the first row each term after the first is lost, and beside it each further row.
  constexpr int order = 100;
  constexpr double in_row = hardly_half / 128;
  StraightRule straight(order);
  Rational exact;
  for (int row = 0; row < order; ++row)
    for (int k = 0; k < order; ++k) {
      const double weight = row == 0 ? (k == 0 ? 1.0 : hardly_half) : in_row;
      straight.add(BoundedDouble::exactly(weight));
      exact += Rational::exactly(weight);
    }
  const Approximation sum = straight.sum();
  const Rational off = abs(exact - Rational::exactly(sum.value));
  EXPECT_LE(off, Rational::exactly(sum.radius));
  EXPECT_GE(4 * off, Rational::exactly(sum.radius));
}

TEST(KernelRule, CountsWeightsOfBothSigns) {
  // Normals that are longer where the weight is positive, and shorter where it is negative.
  StraightRule straight(2);
  for (const double weight : {1.0, -1.0, 1.0, -1.0}) straight.add(BoundedDouble::exactly(weight), 0x1p-20);
  const Approximation sum = straight.sum();
  EXPECT_EQ(sum.value, 0);
  EXPECT_GE(sum.radius, 4 * 0x1p-20);
  EXPECT_LE(sum.radius, 4.01 * 0x1p-20);
}

TEST(KernelRule, CountsWhatItsWeightsAreOffBy) {
  StraightRule straight(2);
  for (const double weight : {1.0, -1.0, 1.0, -1.0}) straight.add(BoundedDouble(weight, 0x1p-20));
  EXPECT_GE(straight.sum().radius, 4 * 0x1p-20);
  EXPECT_LE(straight.sum().radius, 4.01 * 0x1p-20);
}

TEST(KernelRule, CountsWhatADisplacementTurnsAtThePoint) {
  // Q straight before a point whose normal lies across: where Q or P moves along that normal by d, the kernel
  // becomes d at the distance 1. The other way round for the normal of Q.
  constexpr double d = 0x1p-20;
  const auto exactly = [](double x) { return BoundedDouble::exactly(x); };
  for (const bool at_point : {true, false})
    for (const bool node_moves : {true, false}) {
      KernelRule rule{1};
      rule.begin(1);
      rule.add({BoundedDouble(0, node_moves ? d : 0), exactly(0), exactly(1)},
               {exactly(at_point ? 0 : 1), exactly(0), exactly(at_point ? -1 : 0)}, std::array{exactly(3)});
      const KernelRule::Points points{.position = {Pack(0), Pack(0), Pack(0)},
                                      .normal = {Pack(at_point ? 1 : 0), Pack(0), Pack(at_point ? 0 : 1)}};
      KernelRule::Sums sums;
      rule.take_sums(points, sums);
      EXPECT_EQ(sums.sum[0].lane(0), 0);
      std::array<double, 1> radius{};
      rule.rounding(sums, 0, {.position = node_moves ? 0 : d, .normal = 0}, radius);
      EXPECT_GE(radius[0], 3 * d) << at_point << node_moves;
      EXPECT_LE(radius[0], 3.01 * d) << at_point << node_moves;
    }
}

TEST(KernelRule, CountsThatThePointsNormalIsOff) {
  // A normal that lies across is off by d: the kernel becomes d.
  constexpr double d = 0x1p-20;
  const auto exactly = [](double x) { return BoundedDouble::exactly(x); };
  KernelRule rule{1};
  rule.begin(1);
  rule.add({exactly(0), exactly(0), exactly(1)}, {exactly(0), exactly(0), exactly(-1)},
           std::array{exactly(3)});
  KernelRule::Sums sums;
  rule.take_sums({.position = {Pack(0), Pack(0), Pack(0)}, .normal = {Pack(1), Pack(0), Pack(0)}}, sums);
  std::array<double, 1> radius{};
  rule.rounding(sums, 0, {.position = 0, .normal = d}, radius);
  EXPECT_GE(radius[0], 3 * d);
  EXPECT_LE(radius[0], 3.01 * d);
}

TEST(RoundedVector, IsOffByTheLengthOfAllThreeErrors) {
  const auto length = [](double x, double y, double z) {
    return rounded(Vector<BoundedDouble>{BoundedDouble(1, x), BoundedDouble(2, y), BoundedDouble(3, z)})
        .error;
  };
  EXPECT_GE(length(2e-3, 3e-3, 6e-3), 7e-3);
  EXPECT_GE(length(6e-3, 2e-3, 3e-3), 7e-3);
  EXPECT_LE(length(3e-3, 6e-3, 2e-3), 7e-3 * (1 + 1e-9));
}

TEST(DiskBound, BoundsTheKernelFromTheNearestPoint) {
  // On the line of P and c, with both normals along it, the kernel is 1/|w|^2, and the nearest point is
  // d - L - E away; e alone turns w by E.
  for (const double d : {1.0, 1e-3, 300.0})
    for (const double linear : {0.0, 0.1, 0.4, 0.9})
      for (const double rest : {0.0, 0.01, 0.05}) {
        const double bound = DiskBound{.linear = linear * d, .rest = rest * d, .weight = 3}.scaled(d);
        const double nearest = 1 - linear - rest;
        if (nearest > 0) {
          EXPECT_GE(bound, 3 / (nearest * nearest)) << linear << " " << rest;
        }
        // Across the line: |w.w| falls to d^2 - L^2 where |w|^2 grows to d^2 + L^2.
        const double less = 1 - (linear + rest) * (linear + rest);
        const double more = 1 + (linear + rest) * (linear + rest);
        EXPECT_GE(bound, 3 * more / (less * less)) << linear << " " << rest;
        EXPECT_TRUE(linear + rest > 0.1 || bound <= 3.001 * (1 + 9 * (linear + rest)));
      }
  EXPECT_TRUE(std::isinf((DiskBound{.linear = 1, .rest = 0, .weight = 1}.scaled(1))));
  EXPECT_TRUE(std::isinf((DiskBound{.linear = 0, .rest = 0.42, .weight = 1}.scaled(1))));
}

/// What r and e of KernelDisk reach, at most, where the parts are these functions of z and v.
struct Reached {
  double linear = 0;
  double rest = 0;
};
template <class F>
Reached reached(const F& f, const Vector<TaylorModel>& models, const Vector<double>& centre, double s) {
  using Complex = std::complex<double>;
  const std::array<const TaylorModel*, 3> model{&models.x, &models.y, &models.z};
  const std::array<double, 3> c{centre.x, centre.y, centre.z};
  Reached most;
  for (int k = 0; k < 48; ++k)
    for (const double v : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const Complex z = std::polar(s, std::numbers::pi / 24 * k);
      const std::array<Complex, 3> q = f(z, v);
      double linear = 0;
      double rest = 0;
      for (std::size_t place = 0; place < 3; ++place) {
        Complex r = 0;
        for (int i = 0; i <= 1; ++i)
          for (int j = 0; i + j <= TaylorModel::highest_degree; ++j)
            if (i + j > 0) r += model[place]->coefficient(i, j).real * (i == 0 ? 1.0 : z) * std::pow(v, j);
        linear += std::norm(r);
        rest += std::norm(q[place] - c[place] - r);
      }
      most.linear = std::max(most.linear, std::sqrt(linear));
      most.rest = std::max(most.rest, std::sqrt(rest));
    }
  return most;
}

TEST(KernelDisk, BoundsWhatIsLinearAndTheRest) {
  using Complex = std::complex<double>;
  const TaylorModel u = TaylorModel::variable_u({0, 0}, 1);
  const TaylorModel v = TaylorModel::variable_v({0, 0}, 1);
  const TaylorModel shifted = TaylorModel::variable_u({0, 0.25}, 1);
  const Vector<TaylorModel> models{TaylorModel(1) / (TaylorModel(3) - u) + v,
                                   TaylorModel(2) * u * (TaylorModel(1) + v) + TaylorModel(2) * v * v,
                                   TaylorModel(3) * shifted};
  const auto f = [](const Complex& z, double y) {
    return std::array<Complex, 3>{1.0 / (3.0 - z) + y, 2.0 * z * (1 + y) + 2 * y * y,
                                  3.0 * (z + Complex(0, 0.25))};
  };
  const Vector<double> centre{0.25, 0, 0.125};
  const KernelDisk disk(models, centre);
  for (const double s : {1.0, 0.75, 0.125}) {
    const Reached found = reached(f, models, centre, s);
    EXPECT_GE(disk.linear(s), found.linear * (1 - 1e-14)) << s;
    EXPECT_GE(disk.rest(s), found.rest * (1 - 1e-14)) << s;
    EXPECT_LE(disk.linear(s), 1.5 * found.linear) << s;
    EXPECT_LE(disk.rest(s), 1.2 * found.rest) << s;
  }
}

TEST(KernelDisk, CountsWhatIsLinearInEitherVariable) {
  const TaylorModel u = TaylorModel::variable_u({0, 0}, 1);
  const TaylorModel v = TaylorModel::variable_v({0, 0}, 1);
  const KernelDisk disk({TaylorModel(3) * v + TaylorModel(6) * u, TaylorModel(4) * v + TaylorModel(8) * u, 7},
                        {0, 0, 7});
  for (const double s : {1.0, 0.5, 0.0}) {
    EXPECT_GE(disk.linear(s), 5 + 10 * s);
    EXPECT_LE(disk.linear(s), (5 + 10 * s) * (1 + 1e-9));
    EXPECT_LE(disk.rest(s), 1e-11);
  }
}

TEST(KernelDisk, CountsWhatItsModelsLeave) {
  // The terms of 1/(3 - z) from the fifth power on are 3^-6 (1 + 1/3 + ...) = 1/486 at z = 1.
  const TaylorModel u = TaylorModel::variable_u({0, 0}, 1);
  const TaylorModel f = TaylorModel(1) / (TaylorModel(3) - u);
  for (const int place : {0, 1, 2}) {
    const auto at = [&](int k) { return k == place ? f : TaylorModel(0); };
    const double c = f.coefficient(0, 0).real;
    const KernelDisk disk({at(0), at(1), at(2)},
                          {place == 0 ? c : 0, place == 1 ? c : 0, place == 2 ? c : 0});
    const double powers = 1.0 / 27 + 1.0 / 81 + 1.0 / 243;
    EXPECT_GE(disk.rest(1), powers + 1.0 / 486);
    EXPECT_LE(disk.rest(1), powers + 1.2 / 486);
  }
}

}  // namespace
}  // namespace radcert
