// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/two_squares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {
namespace {

struct Place {
  double x;
  double z;
};

/// Points of the open square: ordinary ones, next to edges and corners, next to x = 1/2.
class Places {
public:
  explicit Places(std::uint64_t seed) : random_(seed) {}
  Place next() {
    const double x = coordinate();
    return {x, coordinate()};
  }
  double unit() { return static_cast<double>((random_() >> 11U) | 1U) * 0x1p-53; }

private:
  double coordinate() {
    const auto below = [&](std::uint64_t count) { return static_cast<int>(random_() % count); };
    switch (below(5)) {
      case 0: return unit();
      case 1: return 1 - std::ldexp(1 + unit(), -1 - below(52));
      case 2: return std::ldexp(1 + unit(), -2 - below(1020));
      case 3: return 0.5 + (unit() - 0.5) * std::ldexp(1, -below(52));
      default: return std::ldexp(1 + unit(), -2 - below(20));
    }
  }
  std::mt19937_64 random_;
};

std::string text(const Place& p) { return "x = " + description(p.x) + ", z = " + description(p.z); }

// In the order of `names`.
constexpr std::array<const char*, 6> names{"one",     "offset",   "distance", "inverse_square",
                                           "outside", "half disk"};
template <class R>
std::array<R, 6> values(const R& x, const R& z, const R& radius) {
  const TwoSquares<R> closed(x, z);
  return {closed.one(),
          closed.offset(),
          closed.distance(),
          closed.inverse_square(),
          closed.inverse_square_outside(radius),
          inverse_square_over_half_disk(radius, z)};
}

TEST(TwoSquares, GivesTheKnownValues) {
  const BallPrecision precision(128);
  const TwoSquares<Ball> closed(Ball(Rational(1, 3)), Ball(Rational(1, 7)));
  // Found by high-precision quadrature; the last digit shown is rounded.
  const std::array<std::pair<Ball, const char*>, 3> known{
      {{closed.one(), "1.19901694200745466734732784136 +/- 1e-29"},
       {closed.offset(), "0.03587048430574663062415412568602655130141 +/- 1e-37"},
       {closed.distance(), "0.29708137306324786544485847876 +/- 1e-29"}}};
  for (const auto& [value, digits] : known) {
    EXPECT_TRUE(overlaps(value, Ball::parse(digits).value())) << value.to_text(40) << " " << digits;
    EXPECT_LT(value.radius(), 1e-30) << digits;
  }
}

TEST(TwoSquares, LosesNoDigitsInDoubleNearEdgesAndCorners) {
  // Units of 2^-53, relative: what the header says.
  constexpr std::array<double, 6> allowed{16, 16, 64, 16, 32, 8};
  Places places(41);
  for (int i = 0; i < 400; ++i) {
    const Place p = places.next();
    const double radius = std::min(p.x, 1 - p.x) * places.unit();
    const std::array<double, 6> rounded = values(p.x, p.z, radius);
    std::array<Ball, 6> exact;
    {
      const BallPrecision precision(320);
      exact = values(Ball(p.x), Ball(p.z), Ball(radius));
    }
    const BallPrecision precision(2300);  // for 1 + (r/z)^2 with the smallest r and the largest z
    exact.back() = inverse_square_over_half_disk(Ball(radius), Ball(p.z));
    for (std::size_t k = 0; k < names.size(); ++k) {
      ASSERT_TRUE(exact.at(k).is_finite()) << names.at(k) << " at " << text(p) << exact.at(k).failure();
      if (std::abs(exact.at(k).to_double()) < 0x1p-1000) continue;  // products below the normal doubles
      const double units = (abs(Ball(rounded.at(k)) / exact.at(k) - Ball(1)) * Ball(0x1p53)).upper_double();
      EXPECT_LE(units, allowed.at(k))
          << names.at(k) << " at " << text(p) << ", radius " << description(radius);
    }
  }
}

TEST(TwoSquares, HasInFiftyDigitsTheValuesOfTheBalls) {
  const BallPrecision precision(256);
  Places places(42);
  for (int i = 0; i < 100; ++i) {
    const Place p{0.01 + 0.98 * places.unit(), 0.01 + 0.98 * places.unit()};
    const std::array<Mpfr<50>, 6> rounded = values(Mpfr<50>(p.x), Mpfr<50>(p.z), Mpfr<50>(0x1p-7));
    const std::array<Ball, 6> exact = values(Ball(p.x), Ball(p.z), Ball(0x1p-7));
    for (std::size_t k = 0; k < names.size(); ++k) {
      const Ball difference = Ball(rounded.at(k).to_rational()) - exact.at(k);
      EXPECT_LT(abs(difference).upper_double(), 1e-49) << names.at(k) << " at " << text(p);
    }
  }
}

TEST(TwoSquares, EnclosesTheValuesOfABoxAtItsPoints) {
  const BallPrecision precision(128);
  Places places(43);
  for (int i = 0; i < 60; ++i) {
    const Place centre{0.1 + 0.8 * places.unit(), 0.1 + 0.8 * places.unit()};
    const double half = std::ldexp(0.09, -static_cast<int>(i % 8));
    const auto around = [&](double c) { return widened(Ball(c), Ball(half)); };
    const std::array<Ball, 6> box = values(around(centre.x), around(centre.z), Ball(0x1p-7));
    for (int j = 0; j < 5; ++j) {
      const double s = j < 4 ? (j % 2 == 0 ? -half : half) : half * (2 * places.unit() - 1);
      const double t = j < 4 ? (j < 2 ? -half : half) : half * (2 * places.unit() - 1);
      // Half way between centre and corner, clear of the rounding of the double.
      const Place p{centre.x + 0.99 * s, centre.z + 0.99 * t};
      const std::array<Ball, 6> at = values(Ball(p.x), Ball(p.z), Ball(0x1p-7));
      for (std::size_t k = 0; k < names.size(); ++k)
        EXPECT_TRUE(box.at(k).contains(at.at(k))) << names.at(k) << " at " << text(p) << ", half " << half;
    }
  }
}

// The integral over a square by Gauss rules on panels that shrink geometrically towards (x,0) until they are
// as short as z.
double by_panels(const Place& p, const std::function<double(double, double)>& integrand) {
  static const IntervalRule<double> rule = gauss_rule<double>(16, IntervalWeight::one);
  const auto cuts = [&](double length) {
    std::vector<double> ends{length};
    while (ends.back() > p.z) ends.push_back(ends.back() / 2);
    ends.push_back(0);
    std::reverse(ends.begin(), ends.end());
    return ends;
  };
  double sum = 0;
  const std::vector<double> eta = cuts(1);
  for (const double side : {-p.x, 1 - p.x}) {
    const std::vector<double> offset = cuts(std::abs(side));
    for (std::size_t i = 1; i < offset.size(); ++i)
      for (std::size_t j = 1; j < eta.size(); ++j) {
        const double width = offset[i] - offset[i - 1];
        const double height = eta[j] - eta[j - 1];
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
          for (std::size_t l = 0; l < rule.nodes.size(); ++l)
            sum += width * height * rule.weights[k] * rule.weights[l] *
                   integrand(std::copysign(offset[i - 1] + width * rule.nodes[k], side),
                             eta[j - 1] + height * rule.nodes[l]);
      }
  }
  return sum;
}

TEST(TwoSquares, AgreesWithQuadrature) {
  Places places(44);
  std::vector<Place> all{{1.0 / 3, 1.0 / 7}, {0.5, 0.9}, {0.001, 0.01}, {0.999, 0.5}, {0.25, 1e-6}};
  for (int i = 0; i < 10; ++i) all.push_back({places.unit(), std::exp(-8 * places.unit())});
  for (const Place& p : all) {
    const auto integral = [&](const std::function<double(double, double)>& density) {
      return by_panels(p, [&](double s, double eta) {
        const double squared = s * s + eta * eta + p.z * p.z;
        return density(s, eta) * p.z / squared;
      });
    };
    const auto with_kernel = [&](const std::function<double(double, double)>& u) {
      return by_panels(
          p, [&](double s, double eta) { return two_squares_kernel(0.0, p.z, s, eta) * u(s, eta); });
    };
    const TwoSquares<double> closed(p.x, p.z);
    const double scale = std::abs(closed.one());
    EXPECT_NEAR(closed.one(), with_kernel([](double, double) { return 1.0; }), 1e-12 * scale) << text(p);
    EXPECT_NEAR(closed.offset(), with_kernel([](double s, double) { return s; }), 1e-12 * p.z) << text(p);
    EXPECT_NEAR(closed.distance(), with_kernel([](double, double eta) { return eta; }),
                1e-12 * closed.distance())
        << text(p);
    EXPECT_NEAR(closed.inverse_square(), integral([](double, double) { return 1.0; }),
                1e-12 * closed.inverse_square())
        << text(p);
  }
}

TEST(TwoSquares, IsSymmetricAboutTheMiddle) {
  const BallPrecision precision(128);
  Places places(45);
  for (int i = 0; i < 50; ++i) {
    const Ball x(places.unit());
    const Ball z(places.unit());
    const TwoSquares<Ball> here(x, z);
    const TwoSquares<Ball> there(Ball(1) - x, z);
    EXPECT_TRUE(overlaps(here.one(), there.one()));
    EXPECT_TRUE(overlaps(here.distance(), there.distance()));
    EXPECT_TRUE(overlaps(here.offset(), -there.offset()));
  }
  EXPECT_EQ(TwoSquares<double>(0.5, 0.25).offset(), 0);
}

TEST(TwoSquares, FindsTheHalfDiskAndTheRest) {
  const BallPrecision precision(192);
  Places places(46);
  for (int i = 0; i < 50; ++i) {
    const Place p{0.01 + 0.98 * places.unit(), std::exp((i % 4 == 0 ? -600 : -50) * places.unit())};
    const Ball radius = Ball(std::min(p.x, 1 - p.x) * places.unit());
    const TwoSquares<Ball> closed(Ball(p.x), Ball(p.z));
    const Ball whole =
        closed.inverse_square_outside(radius) + inverse_square_over_half_disk(radius, Ball(p.z));
    EXPECT_TRUE(overlaps(whole, closed.inverse_square())) << text(p);
    EXPECT_LT((whole - closed.inverse_square()).radius(), 1e-45) << text(p);
  }
}

// The half-disk by a Gauss rule in rho, on panels of the length of z.
TEST(TwoSquares, FindsTheHalfDiskByQuadrature) {
  const IntervalRule<double> rule = gauss_rule<double>(16, IntervalWeight::one);
  for (const auto& [radius, z] : {std::pair{0.5, 0.125}, {0.25, 0.5}, {1.0, 0.0625}, {0.01, 0.9}}) {
    const int panels = static_cast<int>(radius / z) + 1;
    double sum = 0;
    for (int k = 0; k < panels; ++k)
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double rho = radius * (k + rule.nodes[i]) / panels;
        sum += rule.weights[i] * radius / panels * z * rho / (rho * rho + z * z);
      }
    const double integral = std::acos(-1.0) * sum;
    EXPECT_NEAR(inverse_square_over_half_disk(radius, z), integral, 1e-13 * integral) << radius << " " << z;
  }
}

TEST(TwoSquares, HasExpansionsWithinTheirBounds) {
  const BallPrecision precision(320);
  Places places(47);
  for (int i = 0; i < 40; ++i) {
    const Ball x(0.02 + 0.96 * places.unit());
    const std::array<EdgeExpansion<Ball>, 3> expansions{TwoSquares<Ball>::expansion_of_one(x),
                                                        TwoSquares<Ball>::expansion_of_offset(x),
                                                        TwoSquares<Ball>::expansion_of_distance(x)};
    double largest = 0;
    for (const double z : {0.9, 0.3, 0.01, 0x1p-30, 0x1p-60}) {
      const TwoSquares<Ball> closed(x, Ball(z));
      const std::array<Ball, 3> exact{closed.one(), closed.offset(), closed.distance()};
      for (std::size_t k = 0; k < 3; ++k) {
        const EdgeExpansion<Ball>& e = expansions.at(k);
        const Ball rest =
            exact.at(k) - (e.constant + e.linear * Ball(z) + e.linear_logarithm * Ball(z) * log(Ball(z)));
        const Ball scaled = abs(rest) / power(Ball(z), 3) / e.cubic_bound;
        EXPECT_FALSE(certainly_less(Ball(1), scaled))
            << names.at(k) << ", z = " << z << ", x = " << x.to_text();
        EXPECT_LT(scaled.radius(), 1e-9) << names.at(k) << ", z = " << z;
        if (z < 0.1) largest = std::max(largest, scaled.upper_double());
      }
    }
    // Wrong coefficients would be seen: the bound is within a factor of what is there.
    EXPECT_GT(largest, 0.1);
  }
}

TEST(TwoSquares, TendsToALimitAtACornerThatDependsOnTheDirection) {
  for (const double slope : {0.01, 0.5, 1.0, 3.0, 100.0}) {
    const double x = 0x1p-60;
    const double limit = (std::acos(-1.0) - std::atan(slope)) / 2;
    EXPECT_NEAR(TwoSquares<double>(x, slope * x).one(), limit, 1e-14) << slope;
  }
}

TEST(TwoSquares, HasTheKernelOfTwoInnerNormals) {
  const Vector<Rational> normal_p{0, 1, 0};
  const Vector<Rational> normal_q{0, 0, 1};
  std::mt19937_64 random(48);
  const auto fraction = [&] { return Rational(static_cast<long>(random() % 1000) + 1, 1001); };
  for (int i = 0; i < 50; ++i) {
    const Rational x = fraction();
    const Rational z = fraction();
    const Rational xi = fraction();
    const Rational eta = fraction();
    const Rational value = two_squares_kernel(x, z, xi, eta);
    EXPECT_EQ(value, geometric_kernel<Rational>({x, 0, z}, normal_p, {xi, eta, 0}, normal_q));
    EXPECT_EQ(value, geometric_kernel<Rational>({x, z, 0}, normal_q, {xi, 0, eta}, normal_p));
  }
}

TEST(TwoSquares, RefusesPointsOffTheOpenSquare) {
  const auto make = [](double x, double z) { return TwoSquares<double>(x, z); };
  for (const auto& [x, z] :
       {std::pair{0.0, 0.5}, {1.0, 0.5}, {0.5, 0.0}, {0.5, 1.0}, {-0.1, 0.5}, {0.5, 2.0}})
    EXPECT_THROW(static_cast<void>(make(x, z)), ContractViolation) << x << " " << z;
  const double none = std::nan("");
  EXPECT_THROW(static_cast<void>(make(none, 0.5)), ContractViolation);
  EXPECT_THROW(static_cast<void>(make(0.5, none)), ContractViolation);
  const Ball around_zero = widened(Ball(0), Ball(0.25));
  EXPECT_THROW(static_cast<void>(TwoSquares<Ball>(around_zero, Ball(0.5))), ContractViolation);
  EXPECT_THROW(static_cast<void>(TwoSquares<double>::expansion_of_distance(0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(make(0.25, 0.5).inverse_square_outside(0.26)), ContractViolation);
  EXPECT_THROW(static_cast<void>(make(0.75, 0.5).inverse_square_outside(0.26)), ContractViolation);
  EXPECT_THROW(static_cast<void>(make(0.75, 0.5).inverse_square_outside(0)), ContractViolation);
  EXPECT_THROW(static_cast<void>(inverse_square_over_half_disk(0.0, 0.5)), ContractViolation);
}

}  // namespace
}  // namespace radcert
