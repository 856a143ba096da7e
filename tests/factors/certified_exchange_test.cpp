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

TEST(CertifiedExchangeArea, OfAnApertureAndItsComplementIsThatOfNoWall) {
  Ball sum = 0;
  for (const bool plug : {false, true}) {
    const FacetScene scene(sample::squares_past_a_wall(plug));
    Ball through = 0;
    Approximation adaptive = Approximation::exact(0);
    for (const std::size_t i : {0U, 1U})
      for (const std::size_t j : {2U, 3U}) {
        const FacetPair pair = scene.pair(i, j);
        ASSERT_EQ(pair.sight, PairSight::mixed);
        through += certified_exchange_area(scene, i, j, pair, {.radius = 1e-6});
        adaptive += visible_exchange_area(scene, pair, {.tolerance = 1e-7});
      }
    EXPECT_TRUE(overlaps(through, ball_of(adaptive))) << through.to_text() << " " << adaptive.value;
    EXPECT_LE(through.radius(), 1e-5);
    sum += through;
  }
  EXPECT_TRUE(overlaps(sum, opposed_rectangles(1, 1, 1))) << sum.to_text();
}

TEST(CertifiedExchangeArea, BetweenACubeAndTheCubeAroundItIsItsArea) {
  // The inner cube sees the outer one alone: A_1 F_12 = 3/2, so that F is 1 and, from outside, 1/4 of the
  // area 6.
  for (const double gap : {1e-1, 1e-6, 1e-12}) {
    const FacetScene scene(sample::cube_in_cube(gap));
    Ball sum = 0;
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = 12; j < 24; ++j) sum += certified_exchange_area(scene, i, j, scene.pair(i, j), {});
    // The side of the inner cube is that of its doubles.
    EXPECT_LE(abs(sum - Ball(Rational(3, 2))).to_double(), 1e-13) << gap;
    EXPECT_LE(sum.radius(), 1e-12) << gap;
  }
}

/// Triangles that are given one by one.
FacetScene scene_of(const std::vector<std::array<Vector<double>, 3>>& triangles) {
  TriangleMesh mesh;
  mesh.group_names = {""};
  for (const std::array<Vector<double>, 3>& corners : triangles) {
    const std::size_t n = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({n, n + 1, n + 2});
    mesh.group.push_back(0);
    mesh.face.push_back(mesh.face.size());
  }
  return FacetScene(std::move(mesh));
}

TEST(CertifiedExchangeArea, IsThatOfWhatLiesInFrontOfTheOtherPlane) {
  // A floor and a wall that cross each other's plane, and the parts of both that see each other; past a
  // triangle between them.
  const std::array<Vector<double>, 3> between{{{0.25, 0.25, 0.25}, {0.75, 0.5, 0.25}, {0.5, 0.75, 0.5}}};
  const FacetScene whole =
      scene_of({{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, {{{1, 0, -1}, {1, 0, 1}, {1, 2, 1}}}, between});
  const FacetPair pair = whole.pair(0, 1);
  ASSERT_EQ(pair.sight, PairSight::mixed);
  const Ball all = certified_exchange_area(whole, 0, 1, pair, {.radius = 1e-7});
  const Approximation adaptive = visible_exchange_area(whole, pair, {.tolerance = 1e-6});
  EXPECT_TRUE(overlaps(all, ball_of(adaptive))) << all.to_text() << " " << adaptive.value;
  EXPECT_LE(all.radius(), 1e-6);
}

TEST(CertifiedExchangeArea, LeavesOpenWhatAShadowKeepsBackThatIsNotKnown) {
  // A floor and a wall with a side in common. A triangle hides a part, one side of it 2^-46 above the floor:
  // little work bounds nothing of its shadow. A quadrangle has sides on both planes and hides nothing; it is
  // named as one that may stand between, for with it shadows are taken in place of contours.
  constexpr double low = 0x1p-46;
  const FacetScene scene = scene_of({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                     {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                     {{{0.125, 0.0625, low}, {0.75, 0.4375, low}, {0.0625, 0.875, 0.625}}},
                                     {{{0.5, 0.75, 0}, {0.75, 0.75, 0}, {0, 0.75, 0.75}}},
                                     {{{0.5, 0.75, 0}, {0, 0.75, 0.75}, {0, 0.75, 0.5}}}});
  FacetPair pair = scene.pair(0, 1);
  ASSERT_EQ(pair.sight, PairSight::mixed);
  ASSERT_EQ(scene.occluders().size(), 2U);
  const Approximation adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-4});
  pair.occluders = {0, 1};
  const Ball ball = certified_exchange_area(scene, 0, 1, pair, {.radius = 1e-4, .work_limit = 1000});
  EXPECT_TRUE(overlaps(ball, ball_of(adaptive))) << ball.to_text() << " " << adaptive.value;
}

TEST(CertifiedExchangeArea, AddsShadowsThatDoNotMeet) {
  // Two small squares between unit squares, in planes of their own and so far apart that no segment meets
  // both.
  const auto room = [](bool left, bool right) {
    std::vector<sample::Quadrangle> faces{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                          {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}}};
    if (left) faces.push_back({{{0.125, 0.25, 0.5}, {0.25, 0.25, 0.5}, {0.25, 0.5, 0.5}, {0.125, 0.5, 0.5}}});
    if (right)
      faces.push_back({{{0.75, 0.25, 0.625}, {0.875, 0.25, 0.625}, {0.875, 0.5, 0.625}, {0.75, 0.5, 0.625}}});
    return FacetScene(sample::mesh_of(faces));
  };
  const auto area = [](const FacetScene& scene) {
    return certified_exchange_area(scene, 0, 2, scene.pair(0, 2), {.radius = 1e-7});
  };
  const FacetScene both = room(true, true);
  ASSERT_EQ(both.pair(0, 2).occluders.size(), 2U);
  EXPECT_FALSE(both.may_hide_together(0, 1, 0, 2));
  EXPECT_FALSE(both.may_hide_together(1, 0, 2, 0));
  const Ball together = area(both);
  EXPECT_LE(together.radius(), 1e-6);
  const Ball sum = area(room(true, false)) + area(room(false, true)) - area(room(false, false));
  EXPECT_TRUE(overlaps(together, sum)) << together.to_text() << " " << sum.to_text();
  EXPECT_LE(sum.radius(), 1e-6);
}

TEST(CertifiedExchangeArea, HoldsWhereShadowsMeet) {
  // Two squares, the one above the other: what both hide is hidden once.
  const FacetScene scene(
      sample::mesh_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                       {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}},
                       {{{0.25, 0.25, 0.5}, {0.5, 0.25, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}}},
                       {{{0.25, 0.25, 0.625}, {0.5, 0.25, 0.625}, {0.5, 0.5, 0.625}, {0.25, 0.5, 0.625}}}}));
  const FacetPair pair = scene.pair(0, 2);
  ASSERT_EQ(pair.occluders.size(), 2U);
  EXPECT_TRUE(scene.may_hide_together(0, 1, 0, 2));
  const Ball ball = certified_exchange_area(scene, 0, 2, pair, {.radius = 1e-7});
  const Approximation adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-7});
  EXPECT_TRUE(overlaps(ball, ball_of(adaptive))) << ball.to_text() << " " << adaptive.value;
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
  const Approximation adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-6});
  EXPECT_LE(ball.radius(), 1e-2);
  EXPECT_TRUE(overlaps(ball, ball_of(adaptive))) << ball.to_text() << " " << adaptive.value;
}

}  // namespace
}  // namespace radcert
