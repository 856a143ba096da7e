// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/occlusion/sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/transport/transport.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::cube_in_a_cube;
using test::Draw;
using test::l_room;

/// Of a panel's corners: -1, 0, 1, or nothing where they lie on both sides.
std::optional<int> side_of(const Panel& panel, const Panel& plane) {
  int least = 1;
  int largest = -1;
  for (const Vector<Rational>& corner : panel.corners) {
    const int sign = dot(plane.normal, corner - plane.corners[0]).sign();
    least = std::min(least, sign);
    largest = std::max(largest, sign);
  }
  if (least < 0 && largest > 0) return std::nullopt;
  return least < 0 ? -1 : largest;
}

TEST(CutPanels, LieOnOneSideOfEveryPlane) {
  for (const auto& [whole, count] : {std::pair{l_room(), 14U}, {cube_in_a_cube(), 60U}}) {
    const std::vector<Panel> cut = cut_panels(whole);
    EXPECT_EQ(cut.size(), count);
    for (const Panel& panel : cut)
      for (const Panel& plane : whole) EXPECT_TRUE(side_of(panel, plane).has_value());
    EXPECT_DOUBLE_EQ(SectorScene(cut).area(), SectorScene(whole).area());
  }
}

TEST(CutPanels, HaveTheSameEdgesOnBothSides) {
  const SectorScene scene(cut_panels(l_room()), l_room());
  std::size_t inner = 0;
  std::size_t opposite = 0;
  for (std::size_t k = 0; k < scene.sectors().size(); ++k) {
    bool touches = false;
    for (std::size_t j = 0; j < scene.panels().size(); ++j)
      touches =
          touches || (scene.touching(k, j) && scene.sight().view(scene.sectors()[k].panel, j) != View::none);
    if (scene.opposite(k)) ++opposite;
    if (!touches) ++inner;
  }
  // 26 edges: 8 below, 8 above, cut in 2 where they are of length 2, and 5 upright ones that look outwards.
  EXPECT_EQ(opposite, 2U * (8 + 8 + 5));
  EXPECT_EQ(scene.sectors().size(), 4U * 14U);
  EXPECT_GT(inner, 0U);
}

/// A point inside a rectangle of a panel's sector.
Vector<double> point_in(const Sector& sector, const SectorBox& box, Draw& draw) {
  return sector.point(box.s0 + (box.s1 - box.s0) * draw(), box.t0 + (box.t1 - box.t0) * draw());
}

/// Whether the segment crosses one of the polygons: by the signs of volumes, in long double.
bool is_blocked(const std::vector<Panel>& blockers, const Vector<double>& origin, const Vector<double>& p,
                const Vector<double>& q) {
  using Point = std::array<long double, 3>;
  const auto lifted = [](const Vector<double>& v) { return Point{v.x, v.y, v.z}; };
  const auto volume = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto minus = [](const Point& x, const Point& y) {
      return Point{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
    };
    const Point u = minus(b, a);
    const Point v = minus(c, a);
    const Point w = minus(d, a);
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  const Point from = lifted(p);
  const Point to = lifted(q);
  for (const Panel& blocker : blockers) {
    std::vector<Point> corners;
    for (const Vector<Rational>& corner : blocker.corners)
      corners.push_back(
          lifted(Vector<double>{corner.x.to_double(), corner.y.to_double(), corner.z.to_double()} - origin));
    const long double at_from = volume(corners[0], corners[1], corners[2], from);
    const long double at_to = volume(corners[0], corners[1], corners[2], to);
    constexpr long double tiny = 1e-12L;
    if (!((at_from > tiny && at_to < -tiny) || (at_from < -tiny && at_to > tiny))) continue;
    bool left = true;
    bool right = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const long double turn = volume(from, to, corners[i], corners[(i + 1) % corners.size()]);
      left = left && turn > 0;
      right = right && turn < 0;
    }
    if (left || right) return true;
  }
  return false;
}

/// A rectangle of a sector, of any size.
SectorBox drawn_box(Draw& draw) {
  const double size = std::ldexp(1.0, -static_cast<int>(draw.below(7)));
  const double s = size * static_cast<double>(draw.below(static_cast<std::size_t>(1 / size)));
  const double t = size * static_cast<double>(draw.below(static_cast<std::size_t>(1 / size)));
  return {.s0 = s, .s1 = s + size, .t0 = t, .t1 = t + size};
}

void expect_views_are_true(const std::vector<Panel>& whole, std::uint64_t seed, std::size_t pairs) {
  const SectorScene scene(cut_panels(whole), whole);
  Draw draw(seed);
  std::array<std::size_t, 3> found{};
  for (std::size_t n = 0; n < pairs; ++n) {
    const Sector& from = scene.sectors()[draw.below(scene.sectors().size())];
    const Sector& to = scene.sectors()[draw.below(scene.sectors().size())];
    if (from.panel == to.panel || scene.sight().view(from.panel, to.panel) != View::partly) continue;
    const SectorBox box = drawn_box(draw);
    const SectorBox other = drawn_box(draw);
    const auto hull = corners_of(from, box);
    const View view = Sight::Lookout(scene.sight(), from.panel, hull, to.panel).view(corners_of(to, other));
    ++found[static_cast<std::size_t>(view)];
    for (int k = 0; k < 40; ++k) {
      const Vector<double> p = point_in(from, box, draw);
      const Vector<double> q = point_in(to, other, draw);
      const bool blocked = is_blocked(whole, scene.origin(), p, q);
      EXPECT_TRUE(view == View::partly || blocked == (view == View::none)) << "pair " << n;
    }
  }
  for (const std::size_t count : found) EXPECT_GT(count, pairs / 50);
}

TEST(Sight, SaysNothingFalseOfAnLShapedRoom) { expect_views_are_true(l_room(), 3, 8000); }

TEST(Sight, SaysNothingFalseOfACubeInACube) { expect_views_are_true(cube_in_a_cube(), 4, 4000); }

TEST(Sight, IsAlmostAlwaysDecidedBetweenSmallParts) {
  // Of pairs of squares of the side h, those are partly seen across the edge that looks inwards which a plane
  // through it may cut: a part of the order h.
  const std::vector<Panel> whole = l_room();
  const SectorScene scene(cut_panels(whole), whole);
  Draw draw(5);
  for (const double size : {0x1p-4, 0x1p-7}) {
    std::size_t partly = 0;
    std::size_t pairs = 0;
    while (pairs < 4000) {
      const Sector& from = scene.sectors()[draw.below(scene.sectors().size())];
      const Sector& to = scene.sectors()[draw.below(scene.sectors().size())];
      if (scene.sight().view(from.panel, to.panel) != View::partly) continue;
      ++pairs;
      const auto box = [&] {
        const double s = (1 - size) * draw();
        const double t = (1 - size) * draw();
        return SectorBox{.s0 = s, .s1 = s + size, .t0 = t, .t1 = t + size};
      };
      const auto hull = corners_of(from, box());
      const View view = Sight::Lookout(scene.sight(), from.panel, hull, to.panel).view(corners_of(to, box()));
      if (view == View::partly) ++partly;
    }
    EXPECT_LT(static_cast<double>(partly), 6 * size * static_cast<double>(pairs)) << size;
  }
}

/// w = f(s,t) on elements, and T w at a point by many points of each, with exact visibility.
double sent_to(const SectorScene& scene, const std::vector<Panel>& blockers,
               const std::vector<SectorElement>& elements, const SectorFunctions& w, std::size_t panel,
               const Vector<double>& p) {
  constexpr int steps = 16;
  double sum = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Sector& sector = scene.sectors()[elements[e].sector];
    if (sector.panel == panel || scene.coplanar(sector.panel, panel)) continue;
    const SectorBox& box = elements[e].box;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double x = (i + 0.5) / steps;
        const double y = (j + 0.5) / steps;
        const double t = box.t0 + y * (box.t1 - box.t0);
        const Vector<double> q = sector.point(box.s0 + x * (box.s1 - box.s0), t);
        const Vector<double> way = q - p;
        const double here = dot(scene.normal(panel), way);
        const double there = -dot(scene.normal(sector.panel), way);
        if (here <= 0 || there <= 0 || is_blocked(blockers, scene.origin(), p, q)) continue;
        const double area =
            sector.jacobian * (1 - t) * (box.s1 - box.s0) * (box.t1 - box.t0) / (steps * steps);
        const double squared = dot(way, way);
        sum += w.of(e, 0)[0] * here * there / (squared * squared) * area / 3.14159265358979;
      }
  }
  return sum;
}

TEST(Penumbra, BoundsWhatIsShaded) {
  const std::vector<Panel> whole = l_room();
  const SectorScene scene(cut_panels(whole), whole);
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  Draw draw(6);
  double closest = 0;
  for (int n = 0; n < 6; ++n) {
    SectorFunctions w(elements.size(), 2, 0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      w.of(e, 0)[0] = draw() - 0.3;
      w.of(e, 1)[0] = 1;
    }
    const Penumbra penumbra(scene, elements, w);
    const std::size_t from = draw.below(elements.size());
    const Sector& sector = scene.sectors()[elements[from].sector];
    const double size = 0.25;
    const double s = 0.7 * draw();
    const double t = 0.2 + 0.5 * draw();
    const SectorBox box{.s0 = s, .s1 = s + size, .t0 = t, .t1 = t + size};
    const auto hull = corners_of(sector, box);
    std::vector<ShadedPart> shaded;
    const Vector<double> p = point_in(sector, box, draw);
    const Transport transport(scene, elements, w);
    const Transport::Values found =
        transport({.panel = sector.panel, .points = {p}, .hull = {hull.begin(), hull.end()}}, 1e-6);
    if (found.shaded.empty()) continue;
    const Penumbra::Rest rest = penumbra.rest(found.shaded);
    const double truth = sent_to(scene, whole, elements, w, sector.panel, p);
    const double near = found.values[0] + rest.constants[0] * (1 - found.values[1]);
    // The sum over points is good to a percent or so of what is shaded.
    EXPECT_LE(std::abs(truth - near), rest.bounds[0] * 1.02 + 4e-3) << n;
    closest = std::max(closest, std::abs(truth - near) / rest.bounds[0]);
    // 1 is sent by all: nothing is left of it.
    EXPECT_LE(rest.bounds[1], 1e-13);
    EXPECT_NEAR(found.values[1] + rest.constants[1] * (1 - found.values[1]), 1, 1e-12);
  }
  EXPECT_GT(closest, 0.1);
}

}  // namespace
}  // namespace radcert
