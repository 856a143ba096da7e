// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/contour_exchange.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/contour_edges.h"
#include "radcert/factors/critical_lines.h"
#include "radcert/factors/shadow_exchange.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

const Rational half(1, 2);
const ExactCorners low{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const ExactCorners high{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};

ExactCorners level(const Rational& x, const Rational& y, const Rational& x_end, const Rational& y_end,
                   const Rational& z) {
  return {{x, y, z}, {x_end, y, z}, {x_end, y_end, z}, {x, y_end, z}};
}

Ball open_area(const ExactCorners& from, const ExactCorners& to) {
  const Vector<Rational> normal = cross(from[1] - from[0], from[2] - from[0]);
  Ball area = sqrt(Ball(dot(normal, normal)));
  if (from.size() == 3) area = area / 2;
  return area * polygon_to_polygon(plane_polygon(from).value(), plane_polygon(to).value());
}

Ball seen(const ExactCorners& from, const ExactCorners& to, const std::vector<ExactCorners>& screens,
          double radius = 1e-11, long work_limit = most_contour_pieces.value()) {
  const auto found = contour_exchange_area(from, to, screens, open_area(from, to),
                                           {.radius = radius, .work_limit = work_limit});
  EXPECT_TRUE(found.has_value());
  return *found;
}

TEST(ContourExchangeArea, OfObstructedSquaresIsThreeQuarters) {
  const Ball exact = Ball(Rational(3, 4)) * opposed_rectangles(1, 1, 1);
  const Ball found = seen(low, high, {level(0, 0, half, half, half)});
  EXPECT_TRUE(overlaps(found, exact)) << found.to_text() << " " << exact.to_text();
  EXPECT_LE(found.radius(), 1.1e-11);
  // From four quarters too, and with one of them twice.
  const Rational quarter(1, 4);
  const std::vector<ExactCorners> quarters{
      level(0, 0, quarter, quarter, half), level(quarter, 0, half, quarter, half),
      level(quarter, quarter, half, half, half), level(0, quarter, quarter, half, half),
      level(0, 0, quarter, quarter, half)};
  EXPECT_TRUE(overlaps(seen(low, high, quarters), exact));
  // A screen turned over, one within another, one across a border of another.
  ExactCorners turned = level(0, 0, half, half, half);
  std::reverse(turned.begin(), turned.end());
  EXPECT_TRUE(overlaps(seen(low, high, {turned}), exact));
  EXPECT_TRUE(overlaps(seen(low, high, {turned, level(quarter, quarter, half, half, half)}), exact));
  EXPECT_TRUE(overlaps(
      seen(low, high, {level(0, 0, Rational(3, 8), half, half), level(quarter, 0, half, half, half)}),
      exact));
}

TEST(ContourExchangeArea, DoesNotSeeEdgesWithinAScreen) {
  // Not half way up, where what lies about such an edge is symmetric and comes to nothing.
  const Rational z(3, 8);
  const ExactCorners large = level(0, 0, half, half, z);
  const ExactCorners within = level(Rational(1, 8), Rational(1, 4), Rational(3, 8), half, z);
  const Ball one = seen(low, high, {large});
  EXPECT_TRUE(overlaps(seen(low, high, {large, within}), one));
  EXPECT_TRUE(overlaps(seen(high, low, {within, large}), one));
}

TEST(ContourExchangeArea, OfTwoScreensInOneShadowIsThatOfOne) {
  // Each segment between the squares that meets `narrow` passes `below` at x and y of less than 1/8 + 1/5.
  const ExactCorners below = level(0, 0, half, half, half);
  const ExactCorners narrow = level(0, 0, Rational(1, 8), Rational(1, 8), Rational(5, 8));
  const Ball one = seen(low, high, {below});
  EXPECT_TRUE(overlaps(seen(low, high, {below, narrow}), one));
  EXPECT_TRUE(overlaps(seen(low, high, {narrow, below}), one));
  EXPECT_TRUE(certainly_less(one, seen(low, high, {narrow})));
  // All of them meet the square between.
  const ExactCorners wide = level(0, 0, 1, 1, Rational(9, 16));
  EXPECT_LE(abs(seen(low, high, {wide, below, narrow})).upper_double(), 1e-10);
}

TEST(ContourExchangeArea, IsTheWholeLessTheShadowOfOneScreen) {
  const ExactCorners first{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const ExactCorners second{{0, 0, 2}, {0, 1, Rational(3, 2)}, {1, 0, 2}};
  const ExactCorners screen{{Rational(1, 4), Rational(1, 8), 1},
                            {Rational(3, 4), Rational(1, 4), Rational(5, 4)},
                            {Rational(1, 4), Rational(3, 4), Rational(7, 8)}};
  const auto shadow = shadow_exchange_area(first, second, screen, OccludingSide::both, {.radius = 1e-8});
  ASSERT_TRUE(shadow.has_value());
  const Ball there = seen(first, second, {screen});
  const Ball back = seen(second, first, {screen});
  EXPECT_TRUE(overlaps(there, open_area(first, second) - *shadow)) << there.to_text();
  EXPECT_TRUE(overlaps(there, back)) << there.to_text() << " " << back.to_text();
}

/// Random triangles between two, some with corners or sides in common, coordinates with few bits.
std::vector<ExactCorners> random_screens(std::mt19937_64& random, std::size_t count) {
  const auto number = [&](long from, long to) {
    return Rational(from + static_cast<long>(random() % static_cast<std::uint64_t>(to - from + 1)), 16);
  };
  std::vector<ExactCorners> out;
  while (out.size() < count) {
    ExactCorners screen;
    for (int k = 0; k < 3; ++k) screen.push_back({number(-4, 20), number(-4, 20), number(1, 15)});
    if (!out.empty() && random() % 2 == 0) screen[0] = out.back()[1];
    if (!out.empty() && random() % 3 == 0) screen[1] = out.back()[2];
    const Vector<Rational> normal = cross(screen[1] - screen[0], screen[2] - screen[0]);
    if (normal != Vector<Rational>{}) out.push_back(screen);
  }
  return out;
}

TEST(ContourExchangeArea, IsReciprocalAndAdditiveOnRandomScreens) {
  // The formula treats receiver and source, and what a cut parts, quite differently.
  std::mt19937_64 random(7);
  const double radius = 1e-6;
  const long work = 3000;
  for (int instance = 0; instance < 6; ++instance) {
    const std::vector<ExactCorners> screens = random_screens(random, 1 + random() % 3);
    const Ball there = seen(low, high, screens, radius, work);
    const Ball back = seen(high, low, screens, radius, work);
    EXPECT_TRUE(overlaps(there, back)) << instance << ": " << there.to_text() << " " << back.to_text();
    EXPECT_LE(there.radius(), 1e-3);
    const Ball left = seen(level(0, 0, Rational(3, 8), 1, 0), high, screens, radius, work);
    const Ball right = seen(level(Rational(3, 8), 0, 1, 1, 0), high, screens, radius, work);
    EXPECT_TRUE(overlaps(left + right, there)) << instance;
    std::vector<ExactCorners> cut;
    for (const ExactCorners& screen : screens) {
      const Vector<Rational> middle = half * (screen[1] + screen[2]);
      cut.push_back({screen[0], screen[1], middle});
      cut.push_back({screen[0], middle, screen[2]});
    }
    EXPECT_TRUE(overlaps(seen(low, high, cut, radius, work), there)) << instance;
  }
}

TEST(ContourExchangeArea, HoldsHoweverCoarseItIs) {
  // Of pieces that are long, what the order of lines and the remainders leave is a large part of the radius.
  std::mt19937_64 random(11);
  for (int instance = 0; instance < 16; ++instance) {
    const std::vector<ExactCorners> screens = random_screens(random, 2 + random() % 2);
    const Ball fine = seen(low, high, screens, 1e-8, 5000);
    for (const double radius : {1.0, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4}) {
      const Ball coarse = seen(low, high, screens, radius, 3000);
      EXPECT_TRUE(overlaps(coarse, fine)) << instance << ": " << coarse.to_text() << " " << fine.to_text();
      const Ball back = seen(high, low, screens, radius, 3000);
      EXPECT_TRUE(overlaps(back, fine)) << instance << ": " << back.to_text() << " " << fine.to_text();
    }
  }
}

TEST(ContourExchangeArea, SumsToTheAreaInAClosedRoom) {
  // Solids of which several shadows meet, faces in one plane, and a leg that stands on the floor.
  for (const bool standing : {false, true}) {
    std::vector<sample::Quadrangle> faces = sample::box({0, 0, 0}, {1, 1, 1}, true);
    for (const auto& face : sample::box({0.125, 0.25, 0.25}, {0.375, 0.5, 0.75}, false))
      faces.push_back(face);
    if (!standing)
      for (const auto& face : sample::box({0.5, 0.25, 0.125}, {0.7, 0.6, 0.5}, false)) faces.push_back(face);
    const FacetScene scene(sample::mesh_of(faces));
    for (const std::size_t row : {0U, 3U, 14U}) {
      Ball sum = 0;
      for (std::size_t k = 0; k < scene.facet_count(); ++k)
        if (k != row) sum += certified_exchange_area(scene, row, k, scene.pair(row, k), {.radius = 1e-7});
      EXPECT_TRUE(overlaps(sum, certified_area(scene, row))) << row << " " << sum.to_text();
      EXPECT_LE(sum.radius(), 1e-5) << row;
    }
  }
}

TEST(ContourExchangeArea, OfACubeWithinACubeIsKnownToTenDigits) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  Ball sum = 0;
  for (std::size_t k = 1; k < scene.facet_count(); ++k)
    sum += certified_exchange_area(scene, 0, k, scene.pair(0, k), {.radius = 4e-12});
  EXPECT_TRUE(overlaps(sum, Ball(half))) << sum.to_text();
  EXPECT_LE(sum.radius(), 0.5e-10);
}

TEST(CriticalLines, ContributeAtMostTheirBoundWhateverIsSeen) {
  const ExactCorners screen = level(0, 0, half, half, half);
  const auto edges = contour_edges(low, high, {screen});
  ASSERT_TRUE(edges.has_value());
  EXPECT_EQ(edges->size(), 8U);
  for (const ContourEdge& edge : *edges)
    for (const ContourEdge::Part& part : edge.parts) {
      const CriticalLines lines(low, high, {screen}, edge, part);
      const EdgeContribution whole = lines.on(0, 1, lines.sides(), 1);
      EXPECT_LE(whole.error + whole.value.error(), lines.most_per_length() * (1 + 1e-12));
      // |u| (A / pi)^(1/2) of a square of side 1, u of side 1 or 1/2.
      const double length = edge.source_is_apart ? 0.5 : 1;
      EXPECT_NEAR(lines.most_per_length(), length * 0.5641895835477563, 1e-12);
    }
}

TEST(ContourEdges, KnowTheirFaces) {
  // A box's upright edge, from where both of its faces are seen, and from where one is.
  const ExactCorners south{{half, half, Rational(1, 4)},
                           {Rational(3, 4), half, Rational(1, 4)},
                           {Rational(3, 4), half, Rational(3, 4)},
                           {half, half, Rational(3, 4)}};
  const ExactCorners west{{half, Rational(3, 4), Rational(1, 4)},
                          {half, half, Rational(1, 4)},
                          {half, half, Rational(3, 4)},
                          {half, Rational(3, 4), Rational(3, 4)}};
  const auto edges = contour_edges(low, high, {south, west});
  ASSERT_TRUE(edges.has_value());
  for (const ContourEdge& edge : *edges) {
    const bool common = edge.from.x == half && edge.to.x == half && edge.from.y == half && edge.to.y == half;
    if (!common) continue;
    // Two of the four quarters of the floor about it, in front of one face and behind the other.
    EXPECT_EQ(edge.parts.size(), 2U);
    EXPECT_TRUE(edge.apart.empty());
    EXPECT_TRUE(edge.source_is_apart);
    return;
  }
  FAIL() << "the edge is missing";
}

}  // namespace
}  // namespace radcert
