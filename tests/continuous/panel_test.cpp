// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::named_surface;
using test::panels_of;

void expect_convex(const std::vector<Panel>& panels) {
  for (const Panel& panel : panels)
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
      const std::size_t n = panel.corners.size();
      const Vector<Rational> a = panel.corners[(i + 1) % n] - panel.corners[i];
      const Vector<Rational> b = panel.corners[(i + 2) % n] - panel.corners[(i + 1) % n];
      EXPECT_GT(dot(cross(a, b), panel.normal).sign(), 0);
      EXPECT_EQ(dot(a, panel.normal).sign(), 0);
      EXPECT_GT(dot(cross(a, panel.centre - panel.corners[i]), panel.normal).sign(), 0);
    }
}

TEST(ConvexPanels, AreTheFacesOfPolyhedra) {
  for (const auto& [name, faces, corners] :
       {std::tuple("cube", 6, 4), std::tuple("box", 6, 4), std::tuple("tetrahedron", 4, 3),
        std::tuple("octahedron", 8, 3)}) {
    const std::vector<Panel> panels = panels_of(name);
    EXPECT_EQ(panels.size(), static_cast<std::size_t>(faces)) << name;
    for (const Panel& panel : panels)
      EXPECT_EQ(panel.corners.size(), static_cast<std::size_t>(corners)) << name;
    expect_convex(panels);
    // Normals point inwards: to all other centres.
    for (const Panel& panel : panels)
      for (const Panel& other : panels)
        EXPECT_GE(dot(panel.normal, other.centre - panel.centre).sign(), 0) << name;
  }
}

TEST(ConvexPanels, RefuseWhatIsNotPlane) {
  const auto refused = convex_panels(named_surface("sphere"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.reason(), testing::HasSubstr("is not plane"));
}

TEST(ConvexPanels, LeaveThePiecesOfAPlaneApart) {
  const Surface surface = named_surface("two_squares");
  const std::vector<Panel> panels = convex_panels(surface).value();
  EXPECT_EQ(panels.size(), surface.piece_names().size());
  expect_convex(panels);
}

/// The root of the square of a whole number or fraction of axes' normals.
Rational sqrt_of_square(const Rational& square) {
  const Rational root = Rational::exactly(std::sqrt(square.to_double()));
  EXPECT_EQ(root * root, square);
  return root;
}

/// Six times the volume between panels and the origin.
Rational volume(const std::vector<Panel>& panels) {
  Rational sum = 0;
  for (const Panel& panel : panels)
    for (std::size_t k = 1; k + 1 < panel.corners.size(); ++k)
      sum += dot(panel.corners[0], cross(panel.corners[k], panel.corners[k + 1]));
  return abs(sum);
}

TEST(ClosingPanels, AreTheFacesThatAreNotThere) {
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const std::vector<Panel> all = panels_of(name);
    for (std::size_t left_out = 1; left_out <= 2; ++left_out) {
      // The last faces of a cube are opposite ones.
      const std::vector<Panel> open(all.begin(), all.end() - static_cast<std::ptrdiff_t>(left_out));
      const std::vector<Panel> closing = closing_panels(open, 77).value();
      ASSERT_EQ(closing.size(), left_out) << name;
      expect_convex(closing);
      std::vector<Panel> closed = open;
      closed.insert(closed.end(), closing.begin(), closing.end());
      EXPECT_EQ(volume(closed), volume(all)) << name;
      for (const Panel& panel : closing) {
        EXPECT_EQ(panel.piece, 77U);
        EXPECT_GT(dot(panel.normal, open.front().centre - panel.centre).sign(), 0);
      }
    }
    EXPECT_TRUE(closing_panels(all, 0).value().empty());
  }
  // Two squares at a right angle: a slanted rectangle and two triangles.
  const std::vector<Panel> closing = closing_panels(panels_of("two_squares"), 2).value();
  ASSERT_EQ(closing.size(), 3U);
  expect_convex(closing);
}

TEST(ClosingPanels, RefuseFacesThatAreThereInPart) {
  std::vector<Panel> panels = panels_of("cube");
  // Half of one face.
  std::vector<Vector<Rational>>& corners = panels.back().corners;
  corners[1] = Rational(1, 2) * (corners[0] + corners[1]);
  corners[2] = Rational(1, 2) * (corners[2] + corners[3]);
  const auto refused = closing_panels(panels, 0);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.reason(), testing::HasSubstr("in part"));
  const auto flat = closing_panels({panels.front()}, 0);
  ASSERT_FALSE(flat);
  EXPECT_THAT(flat.reason(), testing::HasSubstr("one plane"));
}

TEST(EdgesMatched, LeaveNoCornerInsideASide) {
  // A cube whose floor is three strips.
  std::vector<Panel> panels;
  for (const Panel& panel : panels_of("cube")) {
    if (panel.normal.z.sign() <= 0 || dot(panel.normal, panel.normal) != panel.normal.z * panel.normal.z) {
      panels.push_back(panel);
      continue;
    }
    for (long k = 0; k < 3; ++k) {
      Panel strip = panel;
      const auto into = [&](Vector<Rational>& p) { p.x = Rational(1, 3) * (Rational(k) + p.x); };
      for (Vector<Rational>& corner : strip.corners) into(corner);
      into(strip.centre);
      panels.push_back(strip);
    }
  }
  ASSERT_EQ(panels.size(), 8U);
  const std::vector<Panel> matched = with_edges_matched(panels);
  // Two walls have two points more each, and are cut twice.
  EXPECT_EQ(matched.size(), 8U + 4U);
  expect_convex(matched);
  Rational area = 0;
  for (const Panel& panel : matched) {
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
      const Vector<Rational>& a = panel.corners[i];
      const Vector<Rational>& b = panel.corners[(i + 1) % panel.corners.size()];
      area += dot(panel.normal, cross(a, b)) / sqrt_of_square(dot(panel.normal, panel.normal));
      bool is_matched = false;
      for (const Panel& other : matched)
        for (std::size_t j = 0; j < other.corners.size(); ++j)
          is_matched =
              is_matched || (other.corners[j] == b && other.corners[(j + 1) % other.corners.size()] == a);
      EXPECT_TRUE(is_matched);
    }
  }
  EXPECT_EQ(area, Rational(12));
  EXPECT_EQ(with_edges_matched(panels_of("octahedron")).size(), 8U);
}

}  // namespace
}  // namespace radcert
