// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/certified_exchange.h"

#include <gtest/gtest.h>

#include <array>

#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/factors/shadow_exchange.h"
#include "radcert/factors/visible_exchange.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

TEST(CertifiedExchangeArea, EnclosesTheObstructedSquaresNarrowly) {
  const FacetScene scene(sample::obstructed_squares());
  Ball sum = 0;
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {2U, 3U}) sum += certified_exchange_area(scene, i, j, scene.pair(i, j), {});
  const Ball exact = Ball(Rational(3, 4)) * opposed_rectangles(1, 1, 1);
  EXPECT_TRUE(overlaps(sum, exact)) << sum.to_text();
  EXPECT_LE(sum.radius(), 2e-10);
}

TEST(ShadowExchangeArea, OfAnApertureAndItsComplementIsTheWhole) {
  // The plane z = 1/2 over [0,1]^2, cut at x = 3/8 and y = 5/8 into four rectangles: all segments between the
  // squares cross one.
  const ExactCorners low{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const ExactCorners high{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
  const Rational half(1, 2);
  const std::array<Rational, 3> x{0, Rational(3, 8), 1};
  const std::array<Rational, 3> y{0, Rational(5, 8), 1};
  Ball sum = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const ExactCorners part{
          {x[i], y[j], half}, {x[i + 1], y[j], half}, {x[i + 1], y[j + 1], half}, {x[i], y[j + 1], half}};
      const auto shadow = shadow_exchange_area(low, high, part, OccludingSide::both, {.radius = 1e-10});
      ASSERT_TRUE(shadow.has_value());
      EXPECT_LE(shadow->radius(), 2e-10);
      const auto turned = shadow_exchange_area(low, high, {part.rbegin(), part.rend()}, OccludingSide::both,
                                               {.radius = 1e-10});
      ASSERT_TRUE(turned.has_value());
      EXPECT_TRUE(overlaps(*shadow, *turned));
      // From below, the first looks away.
      EXPECT_TRUE(
          certainly_zero(*shadow_exchange_area(low, high, part, OccludingSide::front, {.radius = 1e-10})));
      sum += *shadow;
    }
  EXPECT_TRUE(overlaps(sum, opposed_rectangles(1, 1, 1))) << sum.to_text();
}

TEST(ShadowExchangeArea, IsReciprocal) {
  const ExactCorners first{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const ExactCorners second{{0, 0, 2}, {0, 1, Rational(3, 2)}, {1, 0, 2}};
  const ExactCorners occluder{{Rational(1, 4), Rational(1, 8), 1},
                              {Rational(3, 4), Rational(1, 4), Rational(5, 4)},
                              {Rational(1, 4), Rational(3, 4), Rational(7, 8)}};
  const auto there = shadow_exchange_area(first, second, occluder, OccludingSide::both, {.radius = 1e-9});
  const auto back = shadow_exchange_area(second, first, occluder, OccludingSide::both, {.radius = 1e-9});
  ASSERT_TRUE(there && back);
  EXPECT_TRUE(overlaps(*there, *back)) << there->to_text() << " " << back->to_text();
  EXPECT_LE(there->radius(), 2e-9);
  EXPECT_TRUE(certainly_positive(*there));
}

TEST(CertifiedExchangeArea, EnclosesWhatAdaptiveIntegrationFinds) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  // Of the opposite walls x = 0 and x = 1, past a convex body of which three faces look at most points.
  const FacetPair pair = scene.pair(0, 2);
  ASSERT_EQ(pair.sight, PairSight::mixed);
  const Ball ball = certified_exchange_area(scene, 0, 2, pair, {.radius = 1e-4, .work_limit = 20'000});
  const Estimate adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-6});
  EXPECT_LE(ball.radius(), 1e-2);
  EXPECT_TRUE(overlaps(ball, enclosing_ball(adaptive))) << ball.to_text() << " " << adaptive.value;
}

}  // namespace
}  // namespace radcert
