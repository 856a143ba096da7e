// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/occlusion/panel_sight.h"

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
    const std::vector<Panel> cut = test::cut(whole);
    EXPECT_EQ(cut.size(), count);
    for (const Panel& panel : cut)
      for (const Panel& plane : whole) EXPECT_TRUE(side_of(panel, plane).has_value());
    EXPECT_DOUBLE_EQ(SectorScene(cut).area(), SectorScene(whole).area());
  }
}

TEST(CutPanels, AreRefusedWhereTheyAreTooMany) {
  EXPECT_TRUE(cut_panels(cube_in_a_cube(), 60));
  const auto refused = cut_panels(cube_in_a_cube(), 59);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.reason(), "the planes of its faces cut them into more than 59 parts");
  EXPECT_FALSE(cut_panels(cube_in_a_cube(), 1));
}

TEST(CutPanels, HaveTheSameEdgesOnBothSides) {
  const SectorScene scene(test::cut(l_room()), l_room());
  std::size_t inner = 0;
  std::size_t opposite = 0;
  for (std::size_t k = 0; k < scene.sectors().size(); ++k) {
    bool touches = false;
    for (std::size_t j = 0; j < scene.panels().size(); ++j)
      touches = touches ||
                (scene.touching(k, j) && scene.sight().view(scene.sectors()[k].panel, j) != PanelView::none);
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
  const SectorScene scene(test::cut(whole), whole);
  Draw draw(seed);
  std::array<std::size_t, 3> found{};
  for (std::size_t n = 0; n < pairs; ++n) {
    const Sector& from = scene.sectors()[draw.below(scene.sectors().size())];
    const Sector& to = scene.sectors()[draw.below(scene.sectors().size())];
    if (from.panel == to.panel || scene.sight().view(from.panel, to.panel) != PanelView::partly) continue;
    const SectorBox box = drawn_box(draw);
    const SectorBox other = drawn_box(draw);
    const auto hull = corners_of(from, box);
    const PanelView view =
        PanelSight::Lookout(scene.sight(), from.panel, hull, to.panel).view(corners_of(to, other));
    ++found[static_cast<std::size_t>(view)];
    for (int k = 0; k < 40; ++k) {
      const Vector<double> p = point_in(from, box, draw);
      const Vector<double> q = point_in(to, other, draw);
      const bool blocked = is_blocked(whole, scene.origin(), p, q);
      EXPECT_TRUE(view == PanelView::partly || blocked == (view == PanelView::none)) << "pair " << n;
    }
  }
  for (const std::size_t count : found) EXPECT_GT(count, pairs / 50);
}

TEST(Sight, SaysNothingFalseOfAnLShapedRoom) { expect_views_are_true(l_room(), 3, 8000); }

TEST(Sight, SaysNothingFalseOfACubeInACube) { expect_views_are_true(cube_in_a_cube(), 4, 4000); }

TEST(Sight, IsOfPanelsThatLookAtEachOther) {
  for (const std::vector<Panel>& whole : {l_room(), cube_in_a_cube()}) {
    const std::vector<Panel> cut = test::cut(whole);
    const SectorScene scene(cut, whole);
    std::size_t facing = 0;
    for (std::size_t i = 0; i < cut.size(); ++i)
      for (std::size_t j = 0; j < cut.size(); ++j) {
        const bool both = side_of(cut[i], cut[j]) == 1 && side_of(cut[j], cut[i]) == 1;
        EXPECT_TRUE(both || scene.sight().view(i, j) == PanelView::none) << i << " " << j;
        if (both && scene.sight().view(i, j) != PanelView::none) ++facing;
      }
    EXPECT_GT(facing, cut.size());
  }
}

TEST(Sight, IsAlmostAlwaysDecidedBetweenSmallParts) {
  // Of pairs of squares of the side h, those are partly seen across the edge that looks inwards which a plane
  // through it may cut: a part of the order h.
  const std::vector<Panel> whole = l_room();
  const SectorScene scene(test::cut(whole), whole);
  Draw draw(5);
  for (const double size : {0x1p-4, 0x1p-7}) {
    std::size_t partly = 0;
    std::size_t pairs = 0;
    while (pairs < 4000) {
      const Sector& from = scene.sectors()[draw.below(scene.sectors().size())];
      const Sector& to = scene.sectors()[draw.below(scene.sectors().size())];
      if (scene.sight().view(from.panel, to.panel) != PanelView::partly) continue;
      ++pairs;
      const auto box = [&] {
        const double s = (1 - size) * draw();
        const double t = (1 - size) * draw();
        return SectorBox{.s0 = s, .s1 = s + size, .t0 = t, .t1 = t + size};
      };
      const auto hull = corners_of(from, box());
      const PanelView view =
          PanelSight::Lookout(scene.sight(), from.panel, hull, to.panel).view(corners_of(to, box()));
      if (view == PanelView::partly) ++partly;
    }
    EXPECT_LT(static_cast<double>(partly), 6 * size * static_cast<double>(pairs)) << size;
  }
}

/// (1/pi) Int G w_k over a part of an element, from a point, by its middle points; those alone that are seen.
struct PartSum {
  const SectorScene& scene;
  const std::vector<SectorElement>& elements;
  const SectorFunctions& w;
  const std::vector<Panel>* blockers = nullptr;

  double operator()(std::size_t panel, const Vector<double>& p, const PartOfElement& part, std::size_t k,
                    int steps) const {
    const SectorElement& element = elements[part.element];
    const Sector& sector = scene.sectors()[element.sector];
    if (sector.panel == panel || scene.coplanar(sector.panel, panel)) return 0;
    const SectorBox& box = part.box;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const double s = box.s0 + (i + 0.5) / steps * (box.s1 - box.s0);
        const double t = box.t0 + (j + 0.5) / steps * (box.t1 - box.t0);
        const Vector<double> q = sector.point(s, t);
        const Vector<double> way = q - p;
        const double here = dot(scene.normal(panel), way);
        const double there = -dot(scene.normal(sector.panel), way);
        if (here <= 0 || there <= 0) continue;
        if (blockers != nullptr && is_blocked(*blockers, scene.origin(), p, q)) continue;
        const double area =
            sector.jacobian * (1 - t) * (box.s1 - box.s0) * (box.t1 - box.t0) / (steps * steps);
        const double squared = dot(way, way);
        sum += w.of(part.element, k)[0] * here * there / (squared * squared) * area / 3.14159265358979;
      }
    return sum;
  }
};

/// Cells of a size below 3/4 of sectors, at random.
struct DrawnCell {
  std::size_t sector = 0;
  SectorBox box;
  std::array<Vector<double>, 4> hull;

  DrawnCell(const SectorScene& scene, double size, Draw& draw) : sector(draw.below(scene.sectors().size())) {
    const double s = (1 - size) * draw();
    const double t = 0.1 + (0.8 - size) * draw();
    box = {.s0 = s, .s1 = s + size, .t0 = t, .t1 = t + size};
    hull = corners_of(scene.sectors()[sector], box);
  }
};

TEST(Penumbra, BoundsWhatIsShaded) {
  const std::vector<Panel> whole = l_room();
  const SectorScene scene(test::cut(whole), whole);
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  Draw draw(6);
  double closest = 0;
  double most = 0;
  std::size_t tried = 0;
  while (tried < 4) {
    SectorFunctions w(elements.size(), 2, 0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      w.of(e, 0)[0] = draw() - 0.3;
      w.of(e, 1)[0] = 1;
    }
    const Penumbra penumbra(scene, elements, w);
    const DrawnCell cell(scene, 0.7, draw);
    const std::size_t panel = scene.sectors()[cell.sector].panel;
    const Vector<double> p = point_in(scene.sectors()[cell.sector], cell.box, draw);
    const Transport transport(scene, elements, w);
    const Transport::Values found =
        transport({.panel = panel, .points = {p}, .hull = {cell.hull.begin(), cell.hull.end()}}, 1e-6);
    if (found.shaded.empty()) continue;
    ++tried;
    const Penumbra::Rest rest = penumbra.rest(found.shaded);
    double truth = 0;
    const PartSum seen{scene, elements, w, &whole};
    for (std::size_t e = 0; e < elements.size(); ++e) truth += seen(panel, p, {e, elements[e].box}, 0, 16);
    const double near = found.values[0] + rest.constants[0] * (1 - found.values[1]);
    // The sum over points is good to a percent or so of what is shaded.
    EXPECT_LE(std::abs(truth - near), rest.bounds[0] * 1.02 + 4e-3);
    closest = std::max(closest, std::abs(truth - near) / rest.bounds[0]);
    // 1 is sent by all: nothing is left of it.
    EXPECT_LE(rest.bounds[1], 1e-13);
    EXPECT_NEAR(found.values[1] + rest.constants[1] * (1 - found.values[1]), 1, 1e-12);
    // Half of what is shaded is counted, and all that is seen.
    double counted = 0;
    double half = 0;
    const PartSum all{scene, elements, w};
    for (std::size_t j = 0; j < scene.panels().size(); ++j) {
      if (j == panel || scene.coplanar(j, panel)) continue;
      const SeenPanel own = penumbra.seen(panel, cell.hull, j, 0);
      for (const PartOfElement& part : own.whole) counted += all(panel, p, part, 1, 24);
      for (const ShadedPart& part : own.shaded) half += all(panel, p, part.part, 1, 4) / 2;
    }
    EXPECT_NEAR(found.values[1], counted + half, 5e-3);
    most = std::max(most, half);
  }
  EXPECT_GT(closest, 0.1);
  EXPECT_GT(most, 0.02);
}

TEST(Penumbra, KnowsWhatAPartMaySend) {
  const std::vector<Panel> whole = cube_in_a_cube();
  const SectorScene scene(test::cut(whole), whole);
  const std::vector<SectorElement> elements = graded_elements(scene, 1);
  SectorFunctions one(elements.size(), 1, 0);
  for (std::size_t e = 0; e < elements.size(); ++e) one.of(e, 0)[0] = 1;
  const Penumbra penumbra(scene, elements, one);
  const PartSum sum{scene, elements, one};
  Draw draw(8);
  double closest = 0;
  std::size_t tried = 0;
  for (int n = 0; n < 200; ++n) {
    const DrawnCell cell(scene, 0.25, draw);
    const std::size_t panel = scene.sectors()[cell.sector].panel;
    const std::size_t other = draw.below(scene.panels().size());
    if (scene.sight().view(panel, other) != PanelView::partly) continue;
    for (const ShadedPart& own : penumbra.seen(panel, cell.hull, other, 0).shaded) {
      if (!(own.mass < 1)) continue;
      const Vector<double> p = point_in(scene.sectors()[cell.sector], cell.box, draw);
      const double sent = sum(panel, p, own.part, 0, 6);
      EXPECT_LE(sent, own.mass * 1.001);
      closest = std::max(closest, sent / own.mass);
      ++tried;
    }
  }
  EXPECT_GT(tried, 100U);
  EXPECT_GT(closest, 0.5);
}

TEST(Penumbra, LeavesHalfOfEveryDifference) {
  // Any w may stand at the parts: the rest is a bound for those at random points of them.
  const std::vector<Panel> whole = l_room();
  const SectorScene scene(test::cut(whole), whole);
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  Draw draw(9);
  double closest = 0;
  for (int n = 0; n < 200; ++n) {
    const SectorFunctions w = test::drawn_functions(elements.size(), 1, 2, draw);
    const Penumbra penumbra(scene, elements, w);
    std::vector<ShadedPart> shaded;
    std::vector<double> least;
    std::vector<double> largest;
    const std::size_t parts = 1 + draw.below(3);
    for (std::size_t m = 0; m < parts; ++m) {
      const std::size_t e = draw.below(elements.size());
      const SectorBox& box = elements[e].box;
      const double size = draw();
      const double s = (1 - size) * draw();
      const double t = (1 - size) * draw();
      const auto at = [](double from, double to, double x) { return from + x * (to - from); };
      shaded.push_back({{e,
                         {.s0 = at(box.s0, box.s1, s),
                          .s1 = at(box.s0, box.s1, s + size),
                          .t0 = at(box.t0, box.t1, t),
                          .t1 = at(box.t0, box.t1, t + size)}},
                        draw()});
      least.push_back(HUGE_VAL);
      largest.push_back(-HUGE_VAL);
      for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j) {
          const double x = 2 * (s + size * i / 8) - 1;
          const double y = 2 * (t + size * j / 8) - 1;
          const std::array<double, 3> in_s{1, x, 1.5 * x * x - 0.5};
          const std::array<double, 3> in_t{1, y, 1.5 * y * y - 0.5};
          double value = 0;
          for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) value += w.of(e, 0)[a * 3 + b] * in_s[a] * in_t[b];
          least.back() = std::min(least.back(), value);
          largest.back() = std::max(largest.back(), value);
        }
    }
    const Penumbra::Rest rest = penumbra.rest(shaded);
    double sum = 0;
    for (std::size_t m = 0; m < parts; ++m)
      sum += 0.5 * shaded[m].mass *
             std::max(std::abs(least[m] - rest.constants[0]), std::abs(largest[m] - rest.constants[0]));
    EXPECT_LE(sum, rest.bounds[0] * (1 + 1e-12));
    closest = std::max(closest, sum / rest.bounds[0]);
  }
  EXPECT_GT(closest, 0.9);
}

}  // namespace
}  // namespace radcert
