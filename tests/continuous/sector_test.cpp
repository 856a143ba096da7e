// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/sector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/scalar/ball.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

TEST(SectorScene, HasTheAreaOfTheSurface) {
  const SectorScene scene(panels_of("cube"));
  EXPECT_EQ(scene.sectors().size(), 24U);
  EXPECT_NEAR(scene.area(), 6, 1e-14);
  double sum = 0;
  for (const SectorElement& element : graded_elements(scene, 4))
    sum += scene.sectors()[element.sector].jacobian * element.box.weight();
  EXPECT_NEAR(sum, 6, 1e-13);
}

TEST(SectorScene, KnowsWhatMeetsAtEdges) {
  for (const std::string name : {"cube", "tetrahedron", "octahedron", "box"}) {
    const SectorScene scene(panels_of(name));
    for (std::size_t i = 0; i < scene.sectors().size(); ++i) {
      ASSERT_TRUE(scene.opposite(i)) << name;
      const std::size_t j = *scene.opposite(i);
      EXPECT_EQ(scene.opposite(j), i);
      EXPECT_TRUE(scene.touching(i, scene.sectors()[j].panel));
      EXPECT_FALSE(scene.touching(i, scene.sectors()[i].panel));
      EXPECT_EQ(norm(scene.sectors()[i].a - scene.sectors()[j].b), 0);
    }
  }
  const SectorScene tetrahedron(panels_of("tetrahedron"));
  EXPECT_TRUE(tetrahedron.before(0, 1));  // acute
  const SectorScene octahedron(panels_of("octahedron"));
  const std::size_t across = octahedron.sectors()[*octahedron.opposite(0)].panel;
  EXPECT_FALSE(octahedron.before(0, across));  // obtuse
}

TEST(SectorScene, ComputesPointsWithinTheDisplacement) {
  Draw draw(1);
  for (const std::string name : {"tetrahedron", "box"}) {
    const std::vector<Panel> panels = panels_of(name);
    const SectorScene scene(panels);
    // Coordinates are from the middle of the box about the surface, which a corner and its place tell.
    const Vector<Rational> corner = panels[0].corners[0];
    const Vector<double> placed = scene.sectors()[0].a;
    for (int k = 0; k < 1000; ++k) {
      const std::size_t i = draw.below(panels[0].corners.size());
      const double s = draw();
      const double t = draw() * draw();
      const Rational rs = Rational::exactly(s);
      const Rational rt = Rational::exactly(t);
      const Rational rest = Rational(1) - rt;
      const Vector<Rational>& a = panels[0].corners[i];
      const Vector<Rational>& b = panels[0].corners[(i + 1) % panels[0].corners.size()];
      const Vector<Rational> exact = rest * ((Rational(1) - rs) * a + rs * b) + rt * panels[0].centre;
      const Vector<double> p = scene.sectors()[i].point(s, t);
      const double most = 2 * displacement * scene.extent();
      EXPECT_NEAR(p.x - placed.x, (exact.x - corner.x).to_double(), most);
      EXPECT_NEAR(p.y - placed.y, (exact.y - corner.y).to_double(), most);
      EXPECT_NEAR(p.z - placed.z, (exact.z - corner.z).to_double(), most);
    }
  }
}

TEST(GradedElements, CoverSectorsAndMatchAcrossEdges) {
  const SectorScene scene(panels_of("tetrahedron"));
  for (int layers = 1; layers <= 6; ++layers) {
    const std::vector<SectorElement> elements = graded_elements(scene, layers);
    EXPECT_EQ(elements.size(), 12U * static_cast<std::size_t>(layers * (layers + 1)));
    for (const SectorElement& element : elements) {
      if (element.box.t0 != 0) continue;
      bool found = false;
      for (const SectorElement& other : elements)
        found = found || (other.sector == *scene.opposite(element.sector) && other.box.t0 == 0 &&
                          other.box.s0 == 1 - element.box.s1 && other.box.s1 == 1 - element.box.s0);
      EXPECT_TRUE(found);
    }
  }
}

TEST(SectorScene, SaysNoMoreThanHowFarAPointIsBeyondASide) {
  // A box whose floor has a corner cut off by a short side of a direction that no double has.
  Draw draw(17);
  double closest = 0;
  for (const int exponent : {-2, -20, -36}) {
    std::vector<Panel> panels = panels_of("box");
    for (Panel& panel : panels) {
      const Vector<Rational> a = panel.corners[0];
      const auto towards = [&](std::size_t corner, const Rational& part) {
        return a + part * Rational::exactly(std::ldexp(1.0, exponent)) * (panel.corners[corner] - a);
      };
      std::vector<Vector<Rational>> corners{towards(1, Rational(1, 3)), panel.corners[1], panel.corners[2],
                                            panel.corners[3], towards(3, Rational(5, 7))};
      panel.corners = std::move(corners);
    }
    const SectorScene scene(panels);
    for (std::size_t i = 0; i < scene.sectors().size(); ++i) {
      const Panel& panel = panels[scene.sectors()[i].panel];
      const std::size_t side = i - scene.first_sector(scene.sectors()[i].panel);
      const Vector<Rational>& from = panel.corners[side];
      const Vector<Rational>& to = panel.corners[(side + 1) % panel.corners.size()];
      const Vector<Rational> outward = cross(to - from, panel.normal);
      for (int k = 0; k < 20; ++k) {
        const auto far = [&] { return Rational::exactly(8 * draw() - 4); };
        const Vector<Rational> point = from + Vector<Rational>{far(), far(), far()};
        const double beyond =
            (Ball(dot(outward, point - from)) / sqrt(Ball(dot(outward, outward)))).to_double();
        const double found = scene.beyond_side(i, scene.place(point));
        EXPECT_LE(found, beyond + 4 * displacement * scene.extent() + 1e-15) << exponent;
        EXPECT_GE(found, beyond - std::ldexp(1e-12, -exponent)) << exponent;
        if (side == 4) closest = std::max(closest, (found - beyond) / (4 * displacement * scene.extent()));
      }
    }
  }
  EXPECT_LE(closest, 1);
}

}  // namespace
}  // namespace radcert
