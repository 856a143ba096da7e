// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/events/event_plane.h"

#include <gtest/gtest.h>

#include "radcert/scalar/real.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::Numbers;

TEST(CrossSign, IsThatOfTheExactProductWithinRoundingOfZero) {
  // b is a times a factor, one coordinate of it moved by nothing or by so little that rounding hides it.
  Numbers random(91);
  const auto drawn = [&](std::size_t most) {
    return Rational(static_cast<long>(random.below(2 * most + 1)) - static_cast<long>(most));
  };
  int zero = 0;
  int misled = 0;
  for (int k = 0; k < 4000; ++k) {
    const Rational x = drawn(50) / Rational(7);
    const Rational y = drawn(50) / Rational(9);
    const Rational factor = Rational(1 + static_cast<long>(random.below(40)), 11);
    const Rational little = k % 4 == 0 ? Rational(0) : drawn(9) / power(Rational(2), 52 + k % 12);
    const PencilPoint a = pencil_point(x, y);
    const PencilPoint b = pencil_point(factor * x, factor * y + little);
    const int exact = (x * (factor * y + little) - y * (factor * x)).sign();
    EXPECT_EQ(cross_sign(a, b), exact);
    EXPECT_EQ(cross_sign(b, a), -exact);
    const double rounded = a.rounded.s * b.rounded.t - a.rounded.t * b.rounded.s;
    const bool is_misled = rounded > 0 ? exact <= 0 : rounded < 0 && exact >= 0;
    misled += is_misled ? 1 : 0;
    zero += exact == 0 ? 1 : 0;
  }
  EXPECT_GT(misled, 100);
  EXPECT_GT(zero, 500);
}

TEST(CrossSign, HoldsForNumbersBeyondDoubles) {
  for (const long exponent : {-2000L, -800L, -500L, 500L, 800L, 2000L}) {
    const Rational scale =
        exponent > 0 ? power(Rational(2), exponent) : Rational(1) / power(Rational(2), -exponent);
    const PencilPoint a = pencil_point(scale, Rational(3) * scale);
    const PencilPoint b = pencil_point(Rational(1, 3), Rational(1));
    const PencilPoint c = pencil_point(Rational(1, 3), Rational(1) + scale);
    EXPECT_EQ(cross_sign(a, b), 0);
    EXPECT_EQ(cross_sign(a, c), 1);
    EXPECT_EQ(cross_sign(c, a), -1);
  }
}

}  // namespace
}  // namespace radcert
