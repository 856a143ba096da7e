// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/plane_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace radcert {
namespace {

using ::testing::HasSubstr;

const Vector<Rational> origin{0, 0, 0};
const Vector<Rational> first{1, 0, 0};
const Vector<Rational> second{0, 1, 0};

PolygonLoop square(const Rational& from, const Rational& to) {
  return {{from, from}, {to, from}, {to, to}, {from, to}};
}

PolygonLoop reversed(PolygonLoop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Outcome<PlanePolygon> flat(std::vector<PolygonLoop> loops) {
  return plane_polygon(origin, first, second, std::move(loops));
}

std::string refusal(std::vector<PolygonLoop> loops) {
  const Outcome<PlanePolygon> polygon = flat(std::move(loops));
  return polygon ? "accepted" : polygon.reason();
}

TEST(Contains, CountsTheBorderAndNothingBeyond) {
  // An L; what is off it by any rational number is off it.
  const PolygonLoop corner{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  const Rational little = 1 / power(Rational(10), 40);
  for (const PolygonLoop& loop : {corner, reversed(corner)}) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      EXPECT_TRUE(contains(loop, loop[k]));
      EXPECT_TRUE(contains(loop, Rational(1, 3) * (Rational(2) * loop[k] + loop[(k + 1) % loop.size()])));
    }
    for (const ParameterPoint<Rational>& inside : {ParameterPoint<Rational>{2 - little, 2 + little},
                                                   {1, 1},
                                                   {4 - little, 2 - little},
                                                   {little, 4 - little}})
      EXPECT_TRUE(contains(loop, inside));
    for (const ParameterPoint<Rational>& outside : {ParameterPoint<Rational>{2 + little, 2 + little},
                                                    {3, 3},
                                                    {4 + little, 1},
                                                    {-little, 4},
                                                    {-1, 0},
                                                    {5, 2}})
      EXPECT_FALSE(contains(loop, outside));
  }
}

TEST(PlanePolygon, LiesToTheLeftOfAllItsLoops) {
  for (const PolygonLoop& outer : {square(0, 4), reversed(square(0, 4))})
    for (const PolygonLoop& hole : {square(1, 2), reversed(square(1, 2))}) {
      const PlanePolygon polygon = flat({outer, hole}).value();
      EXPECT_EQ(polygon.parameter_area(), 15);
      EXPECT_EQ(polygon.loops()[0], square(0, 4));
      EXPECT_EQ(polygon.loops()[1], reversed(square(1, 2)));
    }
}

TEST(PlanePolygon, MayHaveCornersOnAStraightEdgeAndBeFarFromConvex) {
  EXPECT_EQ(flat({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}}).value().parameter_area(), 4);
  PolygonLoop comb;
  for (int k = 0; k < 50; ++k) {
    comb.push_back({2 * k, 0});
    comb.push_back({2 * k + 1, 0});
    comb.push_back({2 * k + 1, 9});
    comb.push_back({2 * k + 2, 9});
  }
  comb.push_back({100, 10});
  comb.push_back({0, 10});
  EXPECT_EQ(flat({comb}).value().parameter_area(), 100 + 50 * 9);
}

TEST(PlanePolygon, NamesWhatIsWrongWithALoop) {
  EXPECT_EQ(refusal({}), "no loop");
  EXPECT_EQ(refusal({{{0, 0}, {1, 0}}}), "loop 0: 2 vertices, three are needed");
  EXPECT_EQ(refusal({{{0, 0}, {0, 0}, {1, 0}, {1, 1}}}), "loop 0: vertices 0 and 1 are the same point");
  EXPECT_EQ(refusal({{{1, 1}, {0, 0}, {1, 0}, {1, 1}}}), "loop 0: vertices 3 and 0 are the same point");
  EXPECT_EQ(refusal({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), "loop 0: edges 0 and 2 meet");
  EXPECT_EQ(refusal({{{0, 0}, {1, 0}, {2, 0}}}), "loop 0: edges 0 and 2 overlap");
  EXPECT_EQ(refusal({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}), "loop 0: edges 0 and 1 overlap");
  // One corner lies on another edge, by less than a double could tell.
  const Rational tiny = Rational(1) / power(Rational(10), 40);
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}), "loop 0: edges 0 and 2 meet");
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 4}, {2, tiny}, {0, 4}}}), "accepted");
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 4}, {2, -tiny}, {0, 4}}}), "loop 0: edges 0 and 2 meet");
}

TEST(PlanePolygon, NamesHolesThatAreNone) {
  EXPECT_EQ(refusal({square(0, 4), square(5, 6)}), "loop 1 lies outside of loop 0");
  EXPECT_EQ(refusal({square(1, 2), square(0, 4)}), "loop 1 lies outside of loop 0");
  EXPECT_EQ(refusal({square(0, 4), square(0, 2)}), "loop 1 touches loop 0");
  EXPECT_EQ(refusal({square(0, 4), square(3, 5)}), "loop 1 touches loop 0");
  EXPECT_EQ(refusal({square(0, 9), square(1, 2), square(2, 3)}), "loop 2 touches loop 1");
  EXPECT_EQ(refusal({square(0, 9), square(1, 4), square(2, 3)}),
            "loop 2 and loop 1 lie one inside the other");
  EXPECT_EQ(refusal({square(0, 9), square(2, 3), square(1, 4)}),
            "loop 2 and loop 1 lie one inside the other");
}

TEST(PlanePolygon, NeedsTwoDirections) {
  const Outcome<PlanePolygon> line = plane_polygon(origin, first, Rational(3) * first, {square(0, 1)});
  ASSERT_FALSE(line);
  EXPECT_THAT(line.reason(), HasSubstr("span no plane"));
}

TEST(PlanePolygon, OfCornersInSpaceKeepsThemInTheirOrder) {
  const std::vector<Vector<Rational>> corners{
      {1, 0, 0}, {0, Rational(1, 3), 0}, {0, 0, 1}, {Rational(1, 2), Rational(-1, 6), 1}};
  const PlanePolygon polygon = plane_polygon(corners).value();
  ASSERT_EQ(polygon.loops()[0].size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    EXPECT_EQ(polygon.point(polygon.loops()[0][i]), corners[i]);
  // Counterclockwise from the side of the inner normal: the vector area has its direction.
  Vector<Rational> area{};
  for (std::size_t i = 0; i < corners.size(); ++i)
    area = area + cross(corners[i], corners[(i + 1) % corners.size()]);
  EXPECT_EQ(cross(area, polygon.normal()), Vector<Rational>{});
  EXPECT_GT(dot(area, polygon.normal()), Rational(0));
}

TEST(PlanePolygon, OfCornersInSpaceTurnsItsNormalWithTheirOrder) {
  std::mt19937_64 bits(11);
  const auto number = [&bits] { return Rational(static_cast<long>(bits() % 19) - 9, 7); };
  for (int draw = 0; draw < 200; ++draw) {
    // An arrow, with its dent at any of the places: the first two edges may turn either way.
    const Vector<Rational> o{number(), number(), number()};
    const Vector<Rational> a{number(), number(), number()};
    const Vector<Rational> b{number(), number(), number()};
    if (cross(a, b) == Vector<Rational>{}) continue;
    std::vector<Vector<Rational>> corners{o, o + a + b, o + Rational(3) * b, o + Rational(1, 4) * a + b};
    std::rotate(corners.begin(), corners.begin() + draw % 4, corners.end());
    const Vector<Rational> normal = plane_polygon(corners).value().normal();
    EXPECT_GT(dot(normal, cross(a, b)), Rational(0));
    std::reverse(corners.begin(), corners.end());
    const Vector<Rational> other = plane_polygon(corners).value().normal();
    EXPECT_LT(dot(normal, other), Rational(0));
  }
}

TEST(PlanePolygon, OfCornersInSpaceNamesWhatIsWrong) {
  const auto reason = [](const std::vector<Vector<Rational>>& corners) {
    const Outcome<PlanePolygon> polygon = plane_polygon(corners);
    return polygon ? "accepted" : polygon.reason();
  };
  EXPECT_EQ(reason({{0, 0, 0}, {1, 0, 0}}), "2 corners, three are needed");
  EXPECT_EQ(reason({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), "all corners lie on one line");
  EXPECT_EQ(reason({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}}), "corners 0 and 1 are the same point");
  EXPECT_EQ(reason({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, Rational(1) / power(Rational(10), 30)}}),
            "corner 3 does not lie in the plane of the corners 0, 1 and 2");
}

}  // namespace
}  // namespace radcert
