// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

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

}  // namespace
}  // namespace radcert
