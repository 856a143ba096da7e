// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/round_blockers.h"

#include <gtest/gtest.h>

#include <limits>

#include "radcert/core/contract.h"
#include "tests/visibility/exact_sight.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::Exact;
using sample::Numbers;

template <class Blocker>
bool hides_both_ways(const Blocker& blocker, const Vector<double>& p, const Vector<double>& q) {
  const bool hidden = hides(blocker, p, q);
  EXPECT_EQ(hides(blocker, q, p), hidden);
  return hidden;
}

TEST(BallBlocker, HidesInsideAlone) {
  const BallBlocker ball{{0, 0, 0}, 5};
  EXPECT_TRUE(hides_both_ways(ball, {-9, 0, 0}, {9, 0, 0}));
  EXPECT_TRUE(hides_both_ways(ball, {0, 0, 0}, {9, 0, 0}));    // from inside
  EXPECT_TRUE(hides_both_ways(ball, {0, 0, 0}, {1, 0, 0}));    // within
  EXPECT_FALSE(hides_both_ways(ball, {5, 0, 0}, {9, 0, 0}));   // an end on it
  EXPECT_FALSE(hides_both_ways(ball, {5, -1, 0}, {5, 1, 0}));  // touching
  EXPECT_TRUE(hides_both_ways(ball, {3, 4, 0}, {-3, 4, 0}));   // a chord
  EXPECT_FALSE(hides_both_ways(ball, {7, 1, 0}, {-1, 7, 0}));  // touching at (3, 4, 0)
  EXPECT_TRUE(hides_both_ways(ball, {7 - 0x1p-50, 1, 0}, {-1, 7, 0}));
  EXPECT_FALSE(hides_both_ways(ball, {7 + 0x1p-50, 1, 0}, {-1, 7, 0}));
  EXPECT_FALSE(hides_both_ways(ball, {5, 0, 0}, {5, 0, 0}));
  EXPECT_TRUE(hides_both_ways(ball, {4, 0, 0}, {4, 0, 0}));
  EXPECT_FALSE(hides_both_ways(ball, {6, 0, 0}, {60, 1, 0}));
}

TEST(DiskBlocker, HidesOnItsRimToo) {
  const DiskBlocker disk{{0, 0, 0}, {0, 0, -2}, 5};
  EXPECT_TRUE(hides_both_ways(disk, {0, 0, 1}, {0, 0, -1}));
  EXPECT_TRUE(hides_both_ways(disk, {3, 4, 1}, {3, 4, -1}));  // the rim
  EXPECT_TRUE(hides_both_ways(disk, {2, 4, 1}, {4, 4, -1}));  // the rim, slantwise
  EXPECT_FALSE(hides_both_ways(disk, {3 + 0x1p-51, 4, 1}, {3 + 0x1p-51, 4, -1}));
  EXPECT_FALSE(hides_both_ways(disk, {1, 1, 0}, {1, 1, 1}));  // an end on it
  EXPECT_TRUE(hides_both_ways(disk, {-9, 0, 0}, {9, 0, 0}));  // in its plane
  EXPECT_TRUE(hides_both_ways(disk, {7, 1, 0}, {-1, 7, 0}));  // touching it there
  EXPECT_FALSE(hides_both_ways(disk, {5, 0, 0}, {9, 0, 0}));  // to its rim
  EXPECT_FALSE(hides_both_ways(disk, {0, 0, 1}, {0, 0, 2}));
  EXPECT_FALSE(hides_both_ways(disk, {1, 1, 0}, {1, 1, 0}));
}

/// The least of |P + t (Q - P) - c|^2 over [0, 1].
Rational least_distance_square(const Exact& p, const Exact& q, const Exact& c) {
  const Exact d = q - p;
  const Rational length = dot(d, d);
  Rational t = length.sign() == 0 ? Rational(0) : dot(c - p, d) / length;
  t = std::clamp(t, Rational(0), Rational(1));
  const Exact x = p + t * d - c;
  return dot(x, x);
}

TEST(RoundBlockers, AreWhatRationalNumbersSay) {
  Numbers random(41);
  int hidden = 0;
  constexpr int count = 3000;
  for (int k = 0; k < count; ++k) {
    // Small whole numbers, so that touching happens; else anything.
    const auto number = [&] {
      return k % 2 == 0 ? static_cast<double>(random.below(7)) - 3 : random.between(-3, 3);
    };
    const auto vector = [&] { return Vector<double>{number(), number(), number()}; };
    const Vector<double> p = vector();
    const Vector<double> q = vector();
    const Vector<double> c = vector();
    Vector<double> n = vector();
    if (n == Vector<double>{0, 0, 0}) n.z = 1;
    const double radius = k % 2 == 0 ? static_cast<double>(random.below(4)) : random.between(0, 3);
    const Rational square = Rational::exactly(radius) * Rational::exactly(radius);
    const Rational least = least_distance_square(sample::exact(p), sample::exact(q), sample::exact(c));
    const std::string words = shortest(p.x) + " " + shortest(p.y) + " " + shortest(p.z) + " to " +
                              shortest(q.x) + " " + shortest(q.y) + " " + shortest(q.z) + ", radius " +
                              shortest(radius);
    EXPECT_EQ(hides_both_ways(BallBlocker{c, radius}, p, q), least < square) << words;
    const Exact normal = sample::exact(n);
    const Rational at_p = dot(normal, sample::exact(p) - sample::exact(c));
    const Rational at_q = dot(normal, sample::exact(q) - sample::exact(c));
    if (at_p.sign() == 0 && at_q.sign() == 0) continue;
    bool passes = false;
    if (at_p.sign() * at_q.sign() < 0) {
      const Exact x =
          sample::exact(p) + at_p / (at_p - at_q) * (sample::exact(q) - sample::exact(p)) - sample::exact(c);
      passes = dot(x, x) <= square;
    }
    EXPECT_EQ(hides_both_ways(DiskBlocker{c, n, radius}, p, q), passes) << words;
    hidden += passes ? 1 : 0;
  }
  EXPECT_GT(hidden, count / 20);
}

TEST(BallBlocker, IsTouchedWithinTheRoundingOfItsEnds) {
  // Segments that touch the ball but for the rounding of their ends, so that doubles have either sign.
  Numbers random(42);
  int hidden = 0;
  int wrong = 0;
  constexpr int count = 300;
  for (int k = 0; k < count; ++k) {
    const auto vector = [&] {
      return Vector<double>{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    };
    const Vector<double> c = vector();
    const Vector<double> out = vector();
    const Vector<double> along = cross(out, vector());
    const double radius = norm(out);
    const Vector<double> p = (c + out) - along;
    const Vector<double> q = (c + out) + along;
    const Rational square = Rational::exactly(radius) * Rational::exactly(radius);
    const Rational least = least_distance_square(sample::exact(p), sample::exact(q), sample::exact(c));
    EXPECT_EQ(hides_both_ways(BallBlocker{c, radius}, p, q), least < square) << k;
    hidden += least < square ? 1 : 0;
    const Vector<double> e = p - c;
    const Vector<double> d = q - p;
    const double rounded = (dot(e, e) - radius * radius) * dot(d, d) - dot(e, d) * dot(e, d);
    wrong += (rounded < 0) != (least < square) ? 1 : 0;
  }
  EXPECT_GT(hidden, count / 4);
  EXPECT_GT(wrong, count / 20);
}

TEST(RoundBlockers, RefuseWhatTheyCannotUse) {
  const Vector<double> p{0, 0, 1};
  const Vector<double> q{0, 0, -1};
  EXPECT_THROW(static_cast<void>(hides(BallBlocker{{0, 0, 0}, -1}, p, q)), ContractViolation);
  EXPECT_THROW(static_cast<void>(hides(DiskBlocker{{0, 0, 0}, {0, 0, 0}, 1}, p, q)), ContractViolation);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(hides(BallBlocker{{0, 0, nan}, 1}, p, q)), ContractViolation);
  EXPECT_THROW(static_cast<void>(hides(DiskBlocker{{0, 0, 0}, {0, 0, 1}, nan}, p, q)), ContractViolation);
}

}  // namespace
}  // namespace radcert
