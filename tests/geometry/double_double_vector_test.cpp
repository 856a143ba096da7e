// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/double_double_vector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Exact = Vector<Rational>;

DoubleDoubleVector rounded(const Exact& a) {
  using Wide = Mpfr<50>;
  return double_double(Vector<Wide>{Wide(a.x), Wide(a.y), Wide(a.z)});
}

Exact exactly(const std::array<double, 3>& a) {
  return {Rational::exactly(a[0]), Rational::exactly(a[1]), Rational::exactly(a[2])};
}

/// Unit vectors in thirds, sevenths and elevenths, none of whose parts is a double.
const std::array<std::array<Exact, 3>, 3> frames{{{Exact{Rational(1, 3), Rational(2, 3), Rational(2, 3)},
                                                   {Rational(2, 3), Rational(1, 3), Rational(-2, 3)},
                                                   {Rational(2, 3), Rational(-2, 3), Rational(1, 3)}},
                                                  {Exact{Rational(2, 7), Rational(3, 7), Rational(6, 7)},
                                                   {Rational(3, 7), Rational(-6, 7), Rational(2, 7)},
                                                   {Rational(6, 7), Rational(2, 7), Rational(-3, 7)}},
                                                  {Exact{Rational(2, 11), Rational(6, 11), Rational(9, 11)},
                                                   {Rational(6, 11), Rational(7, 11), Rational(-6, 11)},
                                                   {Rational(9, 11), Rational(-6, 11), Rational(2, 11)}}}};

double largest(const std::array<double, 3>& a) {
  return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

/// A point with its difference from another, which is given to `part` of its size along a direction.
struct Pair {
  Exact direction;
  Exact difference;
  DoubleDoubleVector rounded_difference;
  double size = 0;  ///< three times the sum of the largest coordinates
};

Pair draw_pair(Draw& draw, const Rational& part) {
  const auto& frame = frames[draw.below(frames.size())];
  const auto number = [&draw] { return Rational(static_cast<long>(draw.below(2001)) - 1000, 1237); };
  Pair pair;
  pair.direction = frame[0];
  pair.difference = number() * frame[1] + number() * frame[2] + part * number() * frame[0];
  const std::array<double, 3> p{2 * draw.unit() - 1, 2 * draw.unit() - 1, 2 * draw.unit() - 1};
  const DoubleDoubleVector a = rounded(exactly(p) - pair.difference);
  pair.rounded_difference = difference(p, a);
  pair.size = 3 * (largest(p) + largest(a.head)) * (1 + 0x1p-50);
  return pair;
}

/// The largest error over its bound.
template <typename Product>
double worst(const Rational& part, Product product) {
  Draw draw(7);
  double found = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Pair pair = draw_pair(draw, part);
    const BoundedDouble value = product(rounded(pair.direction), pair.rounded_difference, pair.size);
    const Rational off = Rational::exactly(value.value()) - dot(pair.direction, pair.difference);
    EXPECT_LE(abs(off), Rational::exactly(value.error())) << trial;
    found = std::max(found, std::abs(off.to_double()) / value.error());
  }
  return found;
}

// The parts cancel to what is small against the rounding of their last places.
TEST(DoubleDoubleVector, ProductsThatCancelAreWithinTheirError) {
  const double found = worst(power(Rational(1, 2), 100), product);
  EXPECT_GT(found, 0.01);
  RecordProperty("worst", std::to_string(found));
}

TEST(DoubleDoubleVector, ProductsAreWithinTheirError) {
  EXPECT_GT(worst(1, product), 0.9) << "half of the last place of the value";
}

TEST(DoubleDoubleVector, PlainProductsAreWithinTheirError) {
  EXPECT_GT(worst(1, plain_product), 0.3);
  EXPECT_GT(worst(power(Rational(1, 2), 60), plain_product), 0.3);
}

TEST(DoubleDoubleVector, LengthsAreWithinTheirError) {
  Draw draw(8);
  double found = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    // Squares just above a power of two lose most.
    const std::array<double, 3> a{1 + 0.01 * draw.unit(), 0.1 * draw.unit(), 0.1 * draw.unit()};
    const BoundedDouble value = bounded_length(a);
    const Ball off = abs(Ball(value.value()) - sqrt(Ball(dot(exactly(a), exactly(a)))));
    EXPECT_TRUE(certainly_at_most(off, Ball(value.error()))) << trial;
    found = std::max(found, off.lower_double() / value.error());
  }
  EXPECT_GT(found, 0.5);
}

}  // namespace
}  // namespace radcert
