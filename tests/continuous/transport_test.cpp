// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/transport.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

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

/// T 1 of an element in closed form.
Ball one_on_element(const std::vector<Panel>& panels, const SectorScene& scene, const SectorElement& element,
                    const Vector<Rational>& p, const Vector<Rational>& normal) {
  const SectorBox& box = element.box;
  const auto corner = [&](double s, double t) { return exact_point(panels, scene, element.sector, s, t); };
  const PlanePolygon polygon = plane_polygon({corner(box.s0, box.t0), corner(box.s1, box.t0),
                                              corner(box.s1, box.t1), corner(box.s0, box.t1)})
                                   .value();
  PlanePolynomial<Rational> one(0);
  one(0, 0) = Rational(1);
  return point_to_polygon(p, normal, polygon, one) / Ball::pi();
}

/// The elements of a scene, the sector `cut` in nine of which the middle one is `box`; and where that is.
std::pair<std::vector<SectorElement>, std::size_t> elements_around(const SectorScene& scene, std::size_t cut,
                                                                   const SectorBox& box) {
  std::vector<SectorElement> elements;
  std::size_t middle = 0;
  for (std::size_t sector = 0; sector < scene.sectors().size(); ++sector) {
    if (sector != cut) {
      elements.push_back({sector, {}});
      continue;
    }
    const std::array<double, 4> in_s{0, box.s0, box.s1, 1};
    const std::array<double, 4> in_t{0, box.t0, box.t1, 1};
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        if (i == 1 && j == 1) middle = elements.size();
        elements.push_back({sector, {.s0 = in_s[i], .s1 = in_s[i + 1], .t0 = in_t[j], .t1 = in_t[j + 1]}});
      }
  }
  return {elements, middle};
}

/// 1 on some elements.
SectorFunctions one_on(std::size_t elements, std::initializer_list<std::size_t> lit) {
  SectorFunctions f(elements, 1, 0);
  for (const std::size_t e : lit) f.of(e, 0)[0] = 1;
  return f;
}

TEST(Transport, CountsWhatARuleMissesInEitherParameter) {
  // Elements that are long in one parameter: nothing but the rule in it errs.
  const std::vector<Panel> panels = panels_of("cube");
  const SectorScene scene(panels);
  for (const bool long_in_t : {false, true}) {
    const double thin = 0x1p-12;
    const SectorBox box = long_in_t ? SectorBox{.s0 = 0.5, .s1 = 0.5 + thin, .t0 = 0, .t1 = 0.5}
                                    : SectorBox{.s0 = 0.25, .s1 = 0.75, .t0 = 0.25, .t1 = 0.25 + thin};
    double closest = 0;
    for (std::size_t own = 4; own < scene.sectors().size(); ++own) {
      const auto [elements, lit] = elements_around(scene, 0, box);
      const SectorFunctions f = one_on(elements.size(), {lit});
      const Transport transport(scene, elements, f);
      for (const double t : {0.25, 0.75}) {
        const std::size_t panel = scene.sectors()[own].panel;
        const ObserverGroup group{.panel = panel, .points = {scene.sectors()[own].point(0.5, t)}};
        const Transport::Values found = transport(group, 1);
        const Ball truth = one_on_element(panels, scene, elements[lit],
                                          exact_point(panels, scene, own, 0.5, t), panels[panel].normal);
        const double off = abs(truth - Ball(found.values[0])).upper_double();
        EXPECT_LE(off, found.radius) << own << " " << t;
        closest = std::max(closest, off / found.radius);
      }
    }
    EXPECT_GT(closest, 5e-3) << long_in_t;
  }
}

TEST(Transport, CountsWhatPointsAreOffByNearAnEdge) {
  // The centres of the panels have thirds for coordinates: no point is exact.
  const std::vector<Panel> panels = panels_of("octahedron");
  const SectorScene scene(panels);
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  Draw draw(17);
  double largest = 0;
  for (std::size_t own = 0; own < scene.sectors().size(); ++own) {
    const std::size_t across = scene.opposite(own).value();
    SectorFunctions f(elements.size(), 1, 1);
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements[e].sector == across) f.of(e, 0)[0] = 1;
    const Transport transport(scene, elements, f);
    const double s = 0.25 + 0.5 * draw();
    const double t = 0x1p-24 * (1 + draw());
    const std::size_t panel = scene.sectors()[own].panel;
    const Transport::Values found =
        transport({.panel = panel, .points = {scene.sectors()[own].point(s, t)}}, 1e-13);
    const Ball truth = affine_on_sector(panels, scene, across, 1, 0, exact_point(panels, scene, own, s, t),
                                        panels[panel].normal);
    const double off = abs(truth - Ball(found.values[0])).upper_double();
    EXPECT_LE(off, found.radius);
    largest = std::max(largest, off);
  }
  // More than rules and sums are off by.
  EXPECT_GT(largest, 1e-10);
}

TEST(Transport, AddsWhatIsMissedForAllPointsAndForSome) {
  // One element is far from both points and summed for them together, one near the second point alone.
  const SectorScene scene(panels_of("cube"));
  const std::size_t panel = scene.sectors()[0].panel;
  const std::size_t across = scene.opposite(0).value();
  std::size_t far = 0;
  while (scene.sectors()[far].panel == panel || scene.opposite(far) == std::nullopt ||
         dot(scene.normal(scene.sectors()[far].panel), scene.normal(panel)) > -0.5)
    ++far;
  std::vector<SectorElement> elements;
  for (std::size_t sector = 0; sector < scene.sectors().size(); ++sector)
    for (const double s : {0.0, 0.5}) elements.push_back({sector, {.s0 = s, .s1 = s + 0.5}});
  const auto element_of = [&](std::size_t sector) { return 2 * sector; };
  const ObserverGroup group{
      .panel = panel, .points = {scene.sectors()[0].point(0.25, 0.9), scene.sectors()[0].point(0.25, 0.02)}};
  for (const bool turned : {false, true}) {
    ObserverGroup seen = group;
    if (turned) std::swap(seen.points[0], seen.points[1]);
    const auto radius = [&](std::initializer_list<std::size_t> lit) {
      const SectorFunctions f = one_on(elements.size(), lit);
      return Transport(scene, elements, f)(seen, 1e-3).radius;
    };
    const double of_far = radius({element_of(far)});
    // What the near one, on the other side of the edge, is missed by is the second point's.
    const double of_near = radius({element_of(across) + 1});
    const double roundings = 1e-11;
    EXPECT_GT(of_far, 1e-6);
    EXPECT_GT(of_near, 1e-6);
    EXPECT_GE(radius({element_of(far), element_of(across) + 1}), of_far + of_near - roundings) << turned;
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
