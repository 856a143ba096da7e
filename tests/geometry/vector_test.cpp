// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/vector.h"

#include <gtest/gtest.h>

#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

using Exact = Vector<Rational>;

const Exact a{Rational(1, 3), -2, Rational(7, 5)};
const Exact b{4, Rational(1, 7), -1};
const Exact c{Rational(-3, 2), 5, Rational(2, 9)};

TEST(Vector, CrossIsOrthogonalToBothAndAntisymmetric) {
  EXPECT_EQ(dot(cross(a, b), a), Rational(0));
  EXPECT_EQ(dot(cross(a, b), b), Rational(0));
  EXPECT_EQ(cross(a, b), -cross(b, a));
  EXPECT_EQ(cross(Exact{1, 0, 0}, Exact{0, 1, 0}), (Exact{0, 0, 1})) << "right-handed";
}

TEST(Vector, ObeysTheIdentitiesOfLagrangeAndGrassmann) {
  EXPECT_EQ(dot(cross(a, b), cross(a, b)), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
  EXPECT_EQ(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c);
}

TEST(Vector, AddsAndScalesCoordinatewise) {
  EXPECT_EQ(a + b - b, a);
  EXPECT_EQ(Rational(3) * a, a + a + a);
  EXPECT_EQ(norm(Vector<double>{2, -3, 6}), 7);
}

TEST(ParameterPoint, CrossIsTheSignedAreaOfTheParallelogram) {
  const ParameterPoint<Rational> s{1, 0};
  const ParameterPoint<Rational> t{0, 1};
  EXPECT_EQ(cross(s, t), Rational(1));
  EXPECT_EQ(cross(t, s), Rational(-1));
  EXPECT_EQ(cross(Rational(2) * s + t, s + t), Rational(1));
  EXPECT_EQ(cross(s - t, s - t), Rational(0));
}

}  // namespace
}  // namespace radcert
