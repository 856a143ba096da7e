// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/exact_function.h"

#include <gtest/gtest.h>

#include "radcert/surface/catalogue.h"
#include "radcert/surface/exact_chart.h"
#include "tests/surface/default_surface.h"

namespace radcert {
namespace {

const ExactFunction one = 1;

TEST(ExactFunction, ProvesIdentitiesWithRoots) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  const ExactFunction g = one + s * s + t * t;
  EXPECT_TRUE((sqrt(g) * sqrt(g) - g).is_zero());
  EXPECT_TRUE((one / sqrt(g) - sqrt(g) / g).is_zero());
  EXPECT_TRUE((s / g + t / g - (s + t) / g).is_zero());
  EXPECT_TRUE((sqrt(g) * sqrt(s) * sqrt(g) - g * sqrt(s)).is_zero());
  EXPECT_TRUE((sqrt(ExactFunction(Rational(9, 4))) - ExactFunction(Rational(3, 2))).is_zero());
  EXPECT_FALSE((sqrt(g) - g).is_zero());
  EXPECT_FALSE((sqrt(g) * sqrt(g) - g - ExactFunction(Rational(1, 1000000))).is_zero());
  EXPECT_FALSE((sqrt(ExactFunction(2)) - one).is_zero());
}

TEST(ExactFunction, TakesPowersWithAnyExponent) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction three_halves(Rational(3, 2));
  EXPECT_TRUE((pow(s, three_halves) * pow(s, three_halves) - s * s * s).is_zero());
  EXPECT_FALSE((pow(s, three_halves) - s).is_zero());
  EXPECT_FALSE(pow(s + one, three_halves).is_known());
}

TEST(ExactFunction, DoesNotKnowWhatItCannotRepresent) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction sum = one + sqrt(s);
  EXPECT_FALSE(reciprocal(sum).is_known());
  EXPECT_FALSE(sqrt(sum).is_known());
  EXPECT_FALSE((reciprocal(sum) - reciprocal(sum)).is_zero());
  EXPECT_FALSE((ExactFunction(0) * reciprocal(sum)).is_zero());
}

TEST(ExactFunction, EvaluatesAtZero) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  EXPECT_TRUE(((s + t * s + t) / (one + t)).where_t_is_zero().is_known());
  EXPECT_TRUE((((s + t * s + t) / (one + t)).where_t_is_zero() - s).is_zero());
  EXPECT_FALSE((s / t).where_t_is_zero().is_known());
}

TEST(ExactFunction, ShowsSignsUpToTouching) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  using enum ParameterRegion;
  EXPECT_TRUE(is_nowhere_negative(one - s - t, triangle));
  EXPECT_FALSE(is_nowhere_negative(one - s - t, square));
  EXPECT_TRUE(is_nowhere_negative(s * t, square));
  EXPECT_TRUE(is_nowhere_negative((one - s) / (one + s), square));
  EXPECT_TRUE(is_nowhere_negative((s - one) / (ExactFunction(-1) - s), square));
  EXPECT_FALSE(is_nowhere_negative((s - one) / (one + s), square));
  EXPECT_FALSE(is_nowhere_negative(one - s - s, square));
  EXPECT_FALSE(is_nowhere_negative(one - s - t - ExactFunction(Rational(1, 1000000)), triangle));
  // 2 - s^(5/3) >= 1 on the square, 1 - s^(5/3) touches 0.
  const ExactFunction power = pow(s, ExactFunction(Rational(5, 3)));
  EXPECT_TRUE(is_nowhere_negative(one - power, square));
  EXPECT_FALSE(is_nowhere_negative(ExactFunction(Rational(999, 1000)) - power, square));
  EXPECT_FALSE(is_nowhere_negative(ExactFunction::unknown(), square));
  EXPECT_TRUE(is_nowhere_negative(s * sqrt(one + s), square));
  EXPECT_FALSE(is_nowhere_negative(-(s * sqrt(one + s)), square));
}

TEST(ExactImage, IsKnownOfEveryChartThatStatesItsShape) {
  for (const SurfaceDescription& entry : surface_catalogue()) {
    for (const Chart& chart : default_surface(entry).charts) {
      const ChartFacts& facts = chart.facts();
      if (!facts.flat_in() && !facts.structure.quadric && !facts.structure.ruling) continue;
      const ExactImage* exact = exact_image(chart.in<Ball>());
      ASSERT_NE(exact, nullptr) << entry.name << " " << facts.name;
      const Vector<ExactFunction> image = exact->image();
      EXPECT_TRUE(image.x.is_known() && image.y.is_known() && image.z.is_known())
          << entry.name << " " << facts.name;
    }
  }
}

}  // namespace
}  // namespace radcert
