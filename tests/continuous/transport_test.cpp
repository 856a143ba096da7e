// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/transport.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/closed_form/point_to_polygon.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

/// A point of a sector, exactly, at dyadic parameters.
Vector<Rational> exact_point(const std::vector<Panel>& panels, const SectorScene& scene, std::size_t sector,
                             double s, double t) {
  const std::size_t panel = scene.sectors()[sector].panel;
  const std::size_t i = sector - scene.first_sector(panel);
  const std::vector<Vector<Rational>>& corners = panels[panel].corners;
  const Rational rs = Rational::exactly(s);
  const Rational rt = Rational::exactly(t);
  const Vector<Rational> foot = (Rational(1) - rs) * corners[i] + rs * corners[(i + 1) % corners.size()];
  return (Rational(1) - rt) * foot + rt * panels[panel].centre;
}

/// T f in closed form, f = a + b t on one sector, t its parameter: an affine function of the plane.
Ball affine_on_sector(const std::vector<Panel>& panels, const SectorScene& scene, std::size_t sector,
                      double a, double b, const Vector<Rational>& p, const Vector<Rational>& normal) {
  const std::size_t panel = scene.sectors()[sector].panel;
  const std::size_t i = sector - scene.first_sector(panel);
  const std::vector<Vector<Rational>>& corners = panels[panel].corners;
  const Vector<Rational>& origin = corners[i];
  const Vector<Rational>& end = corners[(i + 1) % corners.size()];
  const PlanePolygon polygon =
      plane_polygon(origin, end - origin, panels[panel].centre - origin, {{{0, 0}, {1, 0}, {0, 1}}}).value();
  PlanePolynomial<Rational> q(1);
  q(0, 0) = Rational::exactly(a);
  q(0, 1) = Rational::exactly(b);
  return point_to_polygon(p, normal, polygon, q) / Ball::pi();
}

TEST(Transport, AgreesWithTheClosedFormWithinItsRadius) {
  Draw draw(7);
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const std::vector<Panel> panels = panels_of(name);
    const SectorScene scene(panels);
    const std::vector<SectorElement> elements = graded_elements(scene, 1);
    for (int k = 0; k < 60; ++k) {
      // One function, a + b t on one sector: elements with t in [0,1] are [0,1/2] and [1/2,1] in s.
      const std::size_t lit = draw.below(scene.sectors().size());
      SectorFunctions f(elements.size(), 1, 1);
      const double a = draw();
      const double b = draw();
      for (std::size_t e = 0; e < elements.size(); ++e)
        if (elements[e].sector == lit) {
          f.of(e, 0)[0] = a + b / 2;
          f.of(e, 0)[1] = b / 2;
        }
      const Transport transport(scene, elements, f);
      const std::size_t own = draw.below(scene.sectors().size());
      const double near = std::ldexp(1.0, -static_cast<int>(draw.below(24)));
      ObserverGroup group{.panel = scene.sectors()[own].panel, .points = {}};
      std::vector<Vector<Rational>> exact;
      for (int p = 0; p < 5; ++p) {
        const double s = 0.125 + 0.75 * draw();
        const double t = near * (0.25 + 0.5 * draw());
        group.points.push_back(scene.sectors()[own].point(s, t));
        exact.push_back(exact_point(panels, scene, own, s, t));
      }
      const double tolerance = std::pow(10.0, -1.0 - static_cast<double>(draw.below(11)));
      const Transport::Values found = transport(group, tolerance);
      // The demand is met up to some parts that share it, and roundings near an edge.
      EXPECT_LE(found.radius, 8 * tolerance + 1e-11 / near) << name << " " << near;
      for (std::size_t p = 0; p < exact.size(); ++p) {
        const Ball truth = affine_on_sector(panels, scene, lit, a, b, exact[p], panels[group.panel].normal);
        EXPECT_LE(abs(truth - Ball(found.values[p])).upper_double(), found.radius)
            << name << " tolerance " << tolerance << " near " << near;
      }
    }
  }
}

TEST(Transport, OfOneIsOne) {
  Draw draw(3);
  const SectorScene scene(panels_of("octahedron"));
  const std::vector<SectorElement> elements = graded_elements(scene, 3);
  SectorFunctions one(elements.size(), 9, 2);  // more functions than a pack has lanes
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t k = 0; k < one.count(); ++k) one.of(e, k)[0] = static_cast<double>(k + 1);
  const Transport transport(scene, elements, one);
  for (int k = 0; k < 20; ++k) {
    const std::size_t own = draw.below(scene.sectors().size());
    ObserverGroup group{.panel = scene.sectors()[own].panel, .points = {}};
    for (int p = 0; p < 20; ++p)
      group.points.push_back(scene.sectors()[own].point(draw(), 0.001 + draw() * draw()));
    const Transport::Values found = transport(group, 1e-9);
    EXPECT_LT(found.radius, 1e-7);
    for (std::size_t p = 0; p < group.points.size(); ++p)
      for (std::size_t f = 0; f < one.count(); ++f)
        EXPECT_NEAR(found.values[p * one.count() + f], static_cast<double>(f + 1), found.radius);
  }
}

TEST(Transport, HasNoRadiusTooNearAnEdge) {
  const SectorScene scene(panels_of("cube"));
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  SectorFunctions one(elements.size(), 1, 0);
  for (std::size_t e = 0; e < elements.size(); ++e) one.of(e, 0)[0] = 1;
  const Transport transport(scene, elements, one);
  const ObserverGroup group{.panel = 0, .points = {scene.sectors()[0].point(0.5, 1e-13)}};
  EXPECT_EQ(transport(group, 1e-3).radius, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace radcert
