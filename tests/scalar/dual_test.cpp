// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/dual.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radcert {
namespace {

static_assert(Field<Dual<double>>);
static_assert(Field<Dual<Rational>>);

/// x^i y^j at (a, b) with its exact partial derivatives.
Dual<Rational> monomial(long i, long j, const Rational& a, const Rational& b) {
  const Rational by_s = i == 0 ? Rational(0) : Rational(i) * power(a, i - 1) * power(b, j);
  const Rational by_t = j == 0 ? Rational(0) : Rational(j) * power(a, i) * power(b, j - 1);
  return {power(a, i) * power(b, j), by_s, by_t};
}

void expect_equal(const Dual<Rational>& f, const Dual<Rational>& g) {
  EXPECT_EQ(f.value, g.value);
  EXPECT_EQ(f.by_s, g.by_s);
  EXPECT_EQ(f.by_t, g.by_t);
}

const Rational a(3, 7);
const Rational b(-5, 2);
const Dual<Rational> s{a, 1, 0};
const Dual<Rational> t{b, 0, 1};

TEST(Dual, DifferentiatesPolynomialsExactly) {
  expect_equal(power(s, 4) * power(t, 3), monomial(4, 3, a, b));
  expect_equal(Rational(2) * s * t - (Rational(5) - t) + s,
               {Rational(2) * a * b - Rational(5) + b + a, Rational(2) * b + Rational(1),
                Rational(2) * a + Rational(1)});
  expect_equal(-(s - t), {b - a, -1, 1});
  expect_equal(Rational(1) - s * t, {Rational(1) - a * b, -b, -a});
  expect_equal(Rational(3) + s * Dual<Rational>(2), {Rational(3) + a + a, 2, 0});
}

TEST(Dual, DifferentiatesQuotientsExactly) {
  // (s t) / (1 + s^2) by s: t (1 - s^2) / (1 + s^2)^2
  const Dual<Rational> f = s * t / (Rational(1) + s * s);
  const Rational w = Rational(1) + a * a;
  expect_equal(f, {a * b / w, b * (Rational(1) - a * a) / (w * w), a / w});
  expect_equal(f * (Rational(1) + s * s) / t, s);
}

TEST(Dual, DifferentiatesRootsAndPowersAsLongDoubleDoes) {
  for (const Rational& e :
       {Rational(1), Rational(3, 2), Rational(11, 10), Rational(2), Rational(5), Rational(17, 3)})
    for (const double x : {1e-3, 0.3, 1.0, 1.7}) {
      const Dual<double> f = power(Dual<double>{x, 2, -1}, Exponent<double>(e));
      const auto p = from_rational<long double>(e);
      const auto slope = static_cast<double>(p * std::pow(static_cast<long double>(x), p - 1));
      EXPECT_NEAR(f.value, std::pow(x, e.to_double()), 1e-15 * f.value) << e.to_text() << " at " << x;
      // e - 1 is rounded: that costs (e - 1) |log x| roundings.
      EXPECT_NEAR(f.by_s, 2 * slope, 2e-14 * slope) << e.to_text() << " at " << x;
      EXPECT_NEAR(f.by_t, -slope, 1e-14 * slope) << e.to_text() << " at " << x;
      const Dual<double> root = sqrt(Dual<double>{x, 2, -1});
      EXPECT_DOUBLE_EQ(root.value, std::sqrt(x));
      EXPECT_DOUBLE_EQ(root.by_s, 1 / std::sqrt(x));
      EXPECT_DOUBLE_EQ(root.by_t, -0.5 / std::sqrt(x));
    }
}

TEST(Dual, HasTheOneSidedSlopeOfAPowerAtZero) {
  const Dual<double> zero{0, 1, 0};
  EXPECT_EQ(power(zero, Exponent<double>(Rational(3, 2))).by_s, 0);
  EXPECT_EQ(power(zero, Exponent<double>(Rational(1))).by_s, 1);
  EXPECT_EQ(power(zero, Exponent<double>(Rational(2))).by_s, 0);
}

}  // namespace
}  // namespace radcert
