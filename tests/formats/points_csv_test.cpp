// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/points_csv.h"

#include <gtest/gtest.h>

#include <functional>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

TEST(ReadPoints, TakesWhatTheFirstLineSays) {
  const std::vector<AskedPoint> in_space = read_points("y,words,x,z\n2,\"a, b\",1,3\n\n-2,,0.5,1e-3\r\n");
  ASSERT_EQ(in_space.size(), 2U);
  EXPECT_EQ(in_space[0].point.x, 1);
  EXPECT_EQ(in_space[0].point.y, 2);
  EXPECT_EQ(in_space[1].point.z, 1e-3);
  EXPECT_EQ(in_space[1].where, "line 4");
  EXPECT_FALSE(in_space[0].chart || in_space[0].piece);
  const std::vector<AskedPoint> by_piece = read_points("piece,s,t\nfloor,0.25,1\n");
  EXPECT_EQ(*by_piece[0].piece, "floor");
  EXPECT_EQ(by_piece[0].at.t, 1);
  // A chart says more than its piece, and parameters more than a point.
  const std::vector<AskedPoint> by_chart =
      read_points("piece,chart,s,t,x,y,z\nfloor,floor/1,0.25,0.5,7,8,9\n");
  EXPECT_EQ(*by_chart[0].chart, "floor/1");
  EXPECT_FALSE(by_chart[0].piece);
}

TEST(ReadPoints, RefusesWithTheLine) {
  for (const auto& [text, line] : {std::pair("", "line 1"),
                                   {"x,y\n1,2\n", "line 1"},
                                   {"s,t\n0,0\n", "line 1"},
                                   {"x,y,z\n", "line 1"},
                                   {"x,y,z\n1,2,3\n1,2\n", "line 3"},
                                   {"x,y,z\n1,2,a\n", "line 2"},
                                   {"x,y,z\n1,2,1e999\n", "line 2"}}) {
    try {
      static_cast<void>(read_points(text));
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.fault().pointer, line) << text;
    }
  }
}

TEST(ReadPoints, AreExactWhereThatIsAskedFor) {
  const std::vector<Vector<Rational>> points = read_exact_points("z,x,note,y\n1/3,0.1,a,-2e-400\n");
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].x, Rational(1, 10));
  EXPECT_EQ(points[0].y, Rational::parse("-2e-400").value());
  EXPECT_EQ(points[0].z, Rational(1, 3));
  for (const auto& [text, line] : {std::pair("piece,s,t\nfloor,0,0\n", "line 1"),
                                   {"x,y,z\n", "line 1"},
                                   {"x,y,z\n1,2,3\n1,2,sqrt(2)\n", "line 3"}}) {
    try {
      static_cast<void>(read_exact_points(text));
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.fault().pointer, line) << text;
    }
  }
}

ValueAt value_at(double x) {
  ValueAt at;
  at.piece = "floor";
  at.chart = "floor";
  at.at = {x, 0.5};
  at.point = {x, 0.5, 0};
  at.u_n = Approximation::estimated(1 / 3.0, 1e-12);
  return at;
}

TEST(PointsCsv, IsReadAgainAndLeavesUnknownCellsEmpty) {
  std::vector<ValueAt> values = {value_at(0.1), value_at(0.7)};
  values[1].iterated.emplace();
  values[1].iterated->value = Approximation::estimated(0.25, 1e-3);
  values[1].u = Approximation::estimated(0.5, 0);
  const std::string text = points_csv(values);
  EXPECT_NE(text.find("floor,floor,0.1,0.5,0.1,0.5,0,0,0.3333333333333333,1e-12,,,,,\r\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find(",0.25,0.001,0.5,,\r\n"), std::string::npos) << text;
  const std::vector<AskedPoint> again = read_points(text);
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[1].at.s, 0.7);
  const JsonValue json = points_json(values);
  EXPECT_TRUE((*json.elements())[0].find("iterated")->is_null());
  EXPECT_TRUE((*json.elements())[0].find("iterated_terms")->is_null());
  EXPECT_EQ(*(*json.elements())[1].find("iterated")->find("radius")->number(), 1e-3);
}

}  // namespace
}  // namespace radcert
