// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/near_polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {
namespace {

using Digits = Mpfr<50>;

/// The largest |f - p| on a lattice of the rectangle.
template <class Formula>
double seen(const Formula& f, const NearPolynomial& near, const ParameterRectangle& on) {
  constexpr int steps = 40;
  double largest = 0;
  PlanePolynomial<Digits> p(near.polynomial.degree());
  for (int i = 0; i <= p.degree(); ++i)
    for (int j = 0; i + j <= p.degree(); ++j) p(i, j) = from_rational<Digits>(near.polynomial(i, j));
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const Digits s = from_rational<Digits>(on.s_low + (on.s_high - on.s_low) * Rational(i, steps));
      const Digits t = from_rational<Digits>(on.t_low + (on.t_high - on.t_low) * Rational(j, steps));
      largest = std::max(largest, abs(f(s, t) - p.value(s, t)).to_double());
    }
  return largest;
}

/// That the distance is one, and no more than so many times what is seen and a rounding.
template <class Formula>
void expect_near(const Formula& f, const ParameterRectangle& on, int degree, double slack) {
  const Outcome<NearPolynomial> near = near_polynomial(plane_function(f), on, degree);
  ASSERT_TRUE(near.has_value()) << near.reason();
  const double largest = seen(f, *near, on);
  EXPECT_LE(largest, near->distance);
  EXPECT_LE(near->distance, slack * largest + 1e-13);
}

const ParameterRectangle unit{};
const ParameterRectangle skew{
    .s_low = Rational(-1, 3), .s_high = Rational(5, 2), .t_low = 2, .t_high = Rational(9, 4)};

TEST(NearPolynomial, IsAsNearAsItSaysForAnalyticFunctions) {
  const auto grows = []<class R>(const R& s, const R& t) { return exp(s / R(2) - t); };
  const auto waves = []<class R>(const R& s, const R& t) { return sin(s + R(2) * t) * cos(t); };
  const auto has_a_pole = []<class R>(const R& s, const R& t) { return R(1) / (R(4) + s + t); };
  const auto has_a_branch = []<class R>(const R& s, const R& t) { return sqrt(R(3) + s * t); };
  for (const ParameterRectangle& on : {unit, skew})
    for (const int degree : {0, 1, 4, 8, 12}) {
      expect_near(grows, on, degree, 3);
      expect_near(waves, on, degree, 3);
      expect_near(has_a_pole, on, degree, 3);
      expect_near(has_a_branch, on, degree, 3);
    }
}

TEST(NearPolynomial, IsThePolynomialWhereItIsOne) {
  const auto f = []<class R>(const R& s, const R& t) { return s * s * s * t - R(2) * t * t + R(1); };
  const Outcome<NearPolynomial> near = near_polynomial(plane_function(f), skew, 4);
  ASSERT_TRUE(near.has_value());
  EXPECT_LE(near->distance, 1e-12);
  EXPECT_NEAR(near->polynomial(3, 1).to_double(), 1, 1e-10);
  EXPECT_NEAR(near->polynomial(0, 2).to_double(), -2, 1e-10);
  EXPECT_NEAR(near->polynomial(2, 2).to_double(), 0, 1e-10);
}

/// T_k(x) by its recurrence.
template <class R>
R chebyshev(int k, const R& x) {
  R before(1);
  R now = x;
  for (int i = 1; i < k; ++i) {
    const R next = R(2) * x * now - before;
    before = now;
    now = next;
  }
  return k == 0 ? before : now;
}

TEST(NearPolynomial, CountsTheFirstDegreeThatItLeavesOut) {
  const ParameterRectangle on{.s_low = -1, .s_high = 1, .t_low = -1, .t_high = 1};
  for (const int k : {0, 3, 9})
    expect_near([k]<class R>(const R& s, const R& t) { return chebyshev(k, s) * chebyshev(9 - k, t); }, on, 8,
                1.001);
}

TEST(NearPolynomial, CountsWhatLiesBeyondTheCoefficientsItLooksAt) {
  const ParameterRectangle on{.s_low = -1, .s_high = 1, .t_low = -1, .t_high = 1};
  for (const int k : {25, 40}) {
    const auto f = [k]<class R>(const R& s, const R&) { return chebyshev(k, s); };
    const Outcome<NearPolynomial> near = near_polynomial(plane_function(f), on, 8);
    ASSERT_TRUE(near.has_value());
    EXPECT_LE(1, near->distance) << k;
  }
}

TEST(NearPolynomial, CountsWhatItsPointsTakeForAnother) {
  // At 32 points T_63 is -T_1: the polynomial is -s, and off by almost 2.
  const ParameterRectangle on{.s_low = -1, .s_high = 1, .t_low = -1, .t_high = 1};
  const auto f = []<class R>(const R& s, const R&) { return chebyshev(63, s); };
  const Outcome<NearPolynomial> near = near_polynomial(plane_function(f), on, 8);
  ASSERT_TRUE(near.has_value());
  EXPECT_NEAR(near->polynomial(1, 0).to_double(), -1, 1e-6);
  EXPECT_LE(1.9, seen(f, *near, on));
  EXPECT_LE(seen(f, *near, on), near->distance);
}

TEST(NearPolynomial, RefusesWhatIsNotAnalytic) {
  const auto kink = []<class R>(const R& s, const R& t) { return abs(s - R(1) / R(3)) + t; };
  const auto pole = []<class R>(const R& s, const R& t) { return R(1) / (s - t); };
  const auto branch = []<class R>(const R& s, const R& t) { return sqrt(s + t); };
  EXPECT_FALSE(near_polynomial(plane_function(kink), unit, 8));
  EXPECT_FALSE(near_polynomial(plane_function(pole), unit, 8));
  EXPECT_FALSE(near_polynomial(plane_function(branch), unit, 8));
  EXPECT_TRUE(near_polynomial(plane_function(kink), {.s_low = 1, .s_high = 2}, 8));
}

TEST(NearPolynomial, RefusesRectanglesAndDegreesThatAreNone) {
  const PlaneFunction f = plane_function([]<class R>(const R& s, const R& t) { return s + t; });
  EXPECT_THROW(static_cast<void>(near_polynomial(f, {.s_low = 1, .s_high = 1}, 2)), ContractViolation);
  EXPECT_THROW(static_cast<void>(near_polynomial(f, unit, -1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(near_polynomial(f, unit, 17)), ContractViolation);
}

}  // namespace
}  // namespace radcert
