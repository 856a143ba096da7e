// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/plane.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

const Vector<Rational> origin{Rational(1, 3), Rational(-1, 7), Rational(2, 11)};
const Vector<Rational> first{Rational(1, 10), 1, Rational(3, 10)};
const Vector<Rational> second{-2, Rational(1, 3), Rational(5, 9)};

TEST(Plane, ContainsThePointsThatSpanIt) {
  const Plane plane(origin, first, second);
  for (const Vector<Rational>& point :
       {origin, origin + first, origin + second, origin - Rational(7, 3) * first + second})
    EXPECT_EQ(dot(plane.normal(), point), plane.offset());
}

TEST(Plane, IsTheSameFromOtherPointsAndDirections) {
  const Plane plane(origin, first, second);
  const Plane again(origin + Rational(5, 2) * first - second, Rational(1, 3) * second - first,
                    Rational(-8) * second);
  EXPECT_TRUE(same_plane(plane, plane));
  EXPECT_TRUE(same_plane(plane, again));
  EXPECT_TRUE(same_plane(again, plane));
}

TEST(Plane, IsTheSameWithTheOppositeNormal) {
  EXPECT_TRUE(same_plane(Plane(origin, first, second), Plane(origin, second, first)));
}

TEST(Plane, IsTheSameThroughZero) {
  EXPECT_TRUE(same_plane(Plane({0, 0, 0}, first, second), Plane(first, second, first)));
  EXPECT_FALSE(same_plane(Plane({0, 0, 0}, first, second), Plane({0, 0, 1}, first, second)));
}

TEST(Plane, DiffersFromAParallelOneHoweverNear) {
  const Rational tiny = Rational(1) / power(Rational(10), 300);
  const Vector<Rational> moved = origin + Vector<Rational>{0, 0, tiny};
  EXPECT_FALSE(same_plane(Plane(origin, first, second), Plane(moved, first, second)));
}

TEST(Plane, DiffersFromItsMirrorImageAndFromATiltedOne) {
  EXPECT_FALSE(same_plane(Plane({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), Plane({0, 0, -1}, {0, 1, 0}, {1, 0, 0})));
  const Rational tiny = Rational(1) / power(Rational(10), 300);
  EXPECT_FALSE(
      same_plane(Plane(origin, first, second), Plane(origin, first + Vector<Rational>{0, 0, tiny}, second)));
}

TEST(Plane, DiffersFromAnotherOneThroughTheSamePoint) {
  EXPECT_FALSE(same_plane(Plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), Plane({0, 0, 0}, {0, 1, 0}, {0, 0, 1})));
  EXPECT_FALSE(same_plane(Plane(origin, first, second), Plane(origin, first, cross(first, second))));
}

TEST(Plane, RefusesDependentDirections) {
  EXPECT_THROW(Plane(origin, first, Rational(-3, 7) * first), ContractViolation);
  EXPECT_THROW(Plane(origin, {0, 0, 0}, second), ContractViolation);
}

}  // namespace
}  // namespace radcert
