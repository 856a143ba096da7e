// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/grading_in_double.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {
namespace {

constexpr long digits_in_bits = 400;

/// (2c)^q / 2, c = k/2^level at most 1/2.
Ball moved(long k, int level, const Rational& grading) {
  if (k == 0) return Ball(0);
  const Rational doubled = Rational(k) / power(Rational(2), level - 1);
  const std::optional<long> whole = grading.to_long();
  return (whole ? power(Ball(doubled), *whole) : pow(Ball(doubled), Ball(grading))) / Ball(2);
}

double as_double(long k, int level, const Rational& grading) {
  return graded_coordinate(std::ldexp(static_cast<double>(k), -level), grading.to_double());
}

/// The largest change of a layer's width, as a part of the width.
double largest_change(int level, const Rational& grading) {
  const long last = 1L << level;
  double largest = 0;
  for (long k = 0; k < last / 2; ++k) {
    const Ball width = moved(k + 1, level, grading) - moved(k, level, grading);
    for (const long at : {k, last - k - 1}) {
      const Ball there = Ball(as_double(at + 1, level, grading)) - Ball(as_double(at, level, grading));
      largest = std::max(largest, abs((there - width) / width).upper_double());
    }
  }
  return largest;
}

const std::vector<Rational> gradings{1,
                                     Rational(65, 64),
                                     Rational(3, 2),
                                     2,
                                     3,
                                     Rational(16, 5),
                                     7,
                                     11,
                                     Rational(51, 4),
                                     17,
                                     26,
                                     32,
                                     Rational(258, 5),
                                     52,
                                     53};

TEST(GradingInDouble, IsExactWhereEachVertexIsTheDouble) {
  const BallPrecision inside(digits_in_bits);
  const Surface surface = cube();
  for (const Rational& grading : gradings)
    for (int level = 0; level <= 6; ++level) {
      bool exact = true;
      for (long k = 0; 2 * k <= 1L << level; ++k) {
        const Ball near = level == 0 ? Ball(0) : moved(k, level, grading);
        for (const bool is_far : {false, true}) {
          const Ball there = is_far ? Ball(1) - near : near;
          const Ball found(as_double(is_far ? (1L << level) - k : k, level, grading));
          exact = exact && overlaps(there, found);
        }
      }
      EXPECT_EQ(grading_in_double(surface, grading, level) == GradingInDouble::exact, exact)
          << grading.to_text() << " level " << level;
    }
}

TEST(GradingInDouble, KnowsLayersToAMillionthUnlessItSaysSo) {
  const BallPrecision inside(digits_in_bits);
  const Surface surface = cube();
  for (const Rational& grading : gradings)
    for (int level = 1; level <= 6; ++level) {
      const GradingInDouble found = grading_in_double(surface, grading, level);
      if (found == GradingInDouble::blurred) continue;
      EXPECT_LE(largest_change(level, grading), found == GradingInDouble::exact ? 0x1p-300 : 0x1p-20)
          << grading.to_text() << " level " << level;
    }
  EXPECT_EQ(grading_in_double(surface, Rational(258, 5), 2), GradingInDouble::blurred);
  EXPECT_GT(largest_change(2, Rational(258, 5)), 0x1p-3);
  EXPECT_EQ(grading_in_double(surface, 32, 2), GradingInDouble::exact);
  EXPECT_EQ(grading_in_double(surface, Rational(127, 4), 2), GradingInDouble::rounded);
  EXPECT_EQ(grading_in_double(surface, Rational(129, 4), 2), GradingInDouble::blurred);
}

TEST(GradingInDouble, IsOfUnitSquares) {
  EXPECT_EQ(grading_in_double(sphere(), Rational(258, 5), 4), GradingInDouble::exact);
  EXPECT_THROW(static_cast<void>(grading_in_double(cube(), Rational(1, 2), 1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(grading_in_double(cube(), 2, -1)), ContractViolation);
}

TEST(NarrowestLayer, IsTheFirstVertex) {
  for (const Rational& grading : gradings)
    for (int level = 0; level <= 6; ++level)
      EXPECT_NEAR(narrowest_layer(grading, level) / as_double(1, level, grading), 1, 1e-12)
          << grading.to_text() << " level " << level;
  EXPECT_EQ(narrowest_layer(power(Rational(10), 400), 2), 0);
}

}  // namespace
}  // namespace radcert
