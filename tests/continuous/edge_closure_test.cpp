// SPDX-License-Identifier: GPL-3.0-or-later
// The closure's bounds, put together here once more from what is sampled: slopes by differences, largest
// values, heights and distances at points. Samples are no larger than the truth, distances no smaller.
#include "radcert/continuous/transport/edge_closure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "radcert/continuous/elements/local_values.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::drawn_functions;
using test::panels_of;

using Points = std::vector<Vector<double>>;

constexpr int steps = 40;

double between(double from, double to, int k) { return from + (to - from) * k / steps; }

/// Points of a side of a box.
Points along(const Sector& sector, double s0, double t0, double s1, double t1) {
  Points out;
  for (int k = 0; k <= steps; ++k) out.push_back(sector.point(between(s0, s1, k), between(t0, t1, k)));
  return out;
}

double least_distance(const Points& some, const Points& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector<double>& p : some)
    for (const Vector<double>& q : others) least = std::min(least, norm(p - q));
  return least;
}

/// A scene, its elements, and what samples of functions on them say.
class Sampled {
public:
  Sampled(const std::string& name, int layers)
      : scene(panels_of(name)), elements(graded_elements(scene, layers)) {}

  SectorScene scene;
  std::vector<SectorElement> elements;

  [[nodiscard]] std::size_t panel(std::size_t e) const { return scene.sectors()[elements[e].sector].panel; }
  [[nodiscard]] std::vector<double> values(const SectorFunctions& w, std::size_t e, double x,
                                           double y) const {
    std::vector<double> out(w.count());
    LocalValues(elements[e], w, e).at(elements[e].box, x, y, out);
    return out;
  }
  /// The largest |w| on an element, at 1 in x or y too.
  [[nodiscard]] double size(const SectorFunctions& w, std::size_t e) const {
    double largest = 0;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j)
        for (const double value : values(w, e, between(-1, 1, i), between(-1, 1, j)))
          largest = std::max(largest, std::abs(value));
    return largest;
  }
  /// The largest |grad w| on an element.
  /// Maths     of w as a function of x and y, with the tangents X, Y: |grad w|^2 = d^T G^-1 d, d = (w_x,
  ///           w_y), G the scalar products of X and Y
  [[nodiscard]] double slope(const SectorFunctions& w, std::size_t e) const {
    constexpr double h = 1e-5;
    const Sector& sector = scene.sectors()[elements[e].sector];
    const SectorBox& box = elements[e].box;
    const auto point = [&](double x, double y) {
      return sector.point(box.middle_s() + 0.5 * (box.s1 - box.s0) * x,
                          box.middle_t() + 0.5 * (box.t1 - box.t0) * y);
    };
    double largest = 0;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const double x = between(-1 + h, 1 - h, i);
        const double y = between(-1 + h, 1 - h, j);
        const Vector<double> to_x = point(x + h, y) - point(x - h, y);
        const Vector<double> to_y = point(x, y + h) - point(x, y - h);
        const double xx = dot(to_x, to_x);
        const double xy = dot(to_x, to_y);
        const double yy = dot(to_y, to_y);
        const std::vector<double> left = values(w, e, x - h, y);
        const std::vector<double> right = values(w, e, x + h, y);
        const std::vector<double> below = values(w, e, x, y - h);
        const std::vector<double> above = values(w, e, x, y + h);
        for (std::size_t k = 0; k < w.count(); ++k) {
          const double w_x = right[k] - left[k];
          const double w_y = above[k] - below[k];
          largest =
              std::max(largest, (w_x * w_x * yy - 2 * w_x * w_y * xy + w_y * w_y * xx) / (xx * yy - xy * xy));
        }
      }
    return std::sqrt(largest);
  }
  /// The sides of the elements of a panel that are asked for, without what lies on an edge.
  [[nodiscard]] Points sides(std::size_t of_panel, std::size_t edge,
                             const std::function<bool(std::size_t)>& asked) const {
    Points out;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (panel(e) != of_panel || !asked(e)) continue;
      const Sector& sector = scene.sectors()[elements[e].sector];
      const SectorBox& b = elements[e].box;
      const auto add = [&](const Points& side) { out.insert(out.end(), side.begin(), side.end()); };
      add(along(sector, b.s0, b.t0, b.s0, b.t1));
      add(along(sector, b.s1, b.t0, b.s1, b.t1));
      add(along(sector, b.s0, b.t1, b.s1, b.t1));
      if (elements[e].sector != edge || b.t0 > 0) add(along(sector, b.s0, b.t0, b.s1, b.t0));
    }
    return out;
  }
  /// Whether two elements of a panel have a point in common.
  [[nodiscard]] bool touch(std::size_t e, std::size_t other) const {
    const auto border = [&](std::size_t of) {
      const Sector& sector = scene.sectors()[elements[of].sector];
      const SectorBox& b = elements[of].box;
      Points out;
      for (const auto& [s0, t0, s1, t1] : {std::array{b.s0, b.t0, b.s1, b.t0},
                                           {b.s1, b.t0, b.s1, b.t1},
                                           {b.s0, b.t1, b.s1, b.t1},
                                           {b.s0, b.t0, b.s0, b.t1}})
        out.insert(out.end(), {sector.point(s0, t0), sector.point(s1, t1)});
      return out;
    };
    const Points own = border(e);
    const Points others = border(other);
    const auto meets = [](const Points& corners, const Points& sides) {
      for (const Vector<double>& p : corners)
        for (std::size_t i = 0; i < sides.size(); i += 2)
          if (distance(p, sides[i], sides[i + 1]) < 1e-9) return true;
      return false;
    };
    return meets(own, others) || meets(others, own);
  }
};

/// A border between two elements, as points, and the largest jump of a function on it.
struct Border {
  Points points;
  double jump = 0;
};

/// The borders between elements that touch one.
std::vector<Border> borders_about(const Sampled& sampled, std::size_t mirror, const SectorFunctions& w) {
  std::vector<Border> out;
  const std::size_t first = sampled.scene.first_sector(sampled.panel(mirror));
  const std::size_t count = sampled.scene.first_sector(sampled.panel(mirror) + 1) - first;
  const auto touches = [&](std::size_t e) {
    return sampled.panel(e) == sampled.panel(mirror) && sampled.touch(mirror, e);
  };
  for (std::size_t one = 0; one < sampled.elements.size(); ++one)
    for (std::size_t other = 0; other < sampled.elements.size(); ++other) {
      if (!touches(one) || !touches(other)) continue;
      const SectorElement& f = sampled.elements[one];
      const SectorElement& g = sampled.elements[other];
      const bool is_above = f.sector == g.sector && f.box.t1 == g.box.t0;
      const bool is_next = first + (f.sector - first + 1) % count == g.sector;
      const bool is_beside =
          (f.sector == g.sector && f.box.s1 == g.box.s0) || (is_next && f.box.s1 == 1 && g.box.s0 == 0);
      if (!is_above && !is_beside) continue;
      const double from = is_above ? std::max(f.box.s0, g.box.s0) : std::max(f.box.t0, g.box.t0);
      const double to = is_above ? std::min(f.box.s1, g.box.s1) : std::min(f.box.t1, g.box.t1);
      if (!(from < to)) continue;
      Border border;
      for (int k = 0; k <= steps; ++k) {
        const double at = between(from, to, k);
        const auto x = [&](const SectorBox& b) { return (2 * at - b.s0 - b.s1) / (b.s1 - b.s0); };
        const auto y = [&](const SectorBox& b) { return (2 * at - b.t0 - b.t1) / (b.t1 - b.t0); };
        const double here =
            is_above ? sampled.values(w, one, x(f.box), 1)[0] : sampled.values(w, one, 1, y(f.box))[0];
        const double there =
            is_above ? sampled.values(w, other, x(g.box), -1)[0] : sampled.values(w, other, -1, y(g.box))[0];
        border.jump = std::max(border.jump, std::abs(here - there));
        border.points.push_back(is_above ? sampled.scene.sectors()[f.sector].point(at, f.box.t1)
                                         : sampled.scene.sectors()[f.sector].point(f.box.s1, at));
      }
      out.push_back(std::move(border));
    }
  return out;
}

/// J + l (R + m H (1 + log((d-R)/(m H)))) + 2 sup|w| m H/(d-R), which holds for any d up to the distance. The
/// least for those that are shorter than it by the length of the part of the edge at most.
struct Sent {
  double jumps = 0;
  double slope = 0;
  double distance = 0;
  double size = 0;

  [[nodiscard]] double at(double reach, double rings, double length) const {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= steps; ++k) {
      const double d = distance - between(0, length, k) - reach;
      least =
          std::min(least, jumps + slope * (reach + rings * (1 + std::log(d / rings))) + 2 * size * rings / d);
    }
    return least;
  }
};

/// A part of an element at its edge, short beside its depth, and what is sampled of it.
struct Part {
  SectorBox box;
  Points edge;
  double reach = 0;
  double height = 0;
  double length = 0;

  enum class Place { middle, start };
  Part(const Sampled& sampled, std::size_t e, double depth, Place place = Place::middle)
      : box(sampled.elements[e].box) {
    const Sector& sector = sampled.scene.sectors()[sampled.elements[e].sector];
    const double width = box.s1 - box.s0;
    const double start = place == Place::start ? box.s0 : box.middle_s() - width / 256;
    box = {.s0 = start, .s1 = start + width / 128, .t0 = 0, .t1 = depth};
    edge = along(sector, box.s0, 0, box.s1, 0);
    length = norm(edge.back() - edge.front());
    const std::size_t opposite = *sampled.scene.opposite(sampled.elements[e].sector);
    const Sector& beyond = sampled.scene.sectors()[opposite];
    const Vector<double> n = cross(beyond.b - beyond.a, beyond.c - beyond.a);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const double s = between(box.s0, box.s1, i);
        const Vector<double> p = sector.point(s, between(0, box.t1, j));
        reach = std::max(reach, norm(p - sector.point(s, 0)));
        height = std::max(height, dot(n, p - beyond.a) / norm(n));
      }
  }
};

/// The elements on one edge that contain its ends, with a mirror.
std::vector<std::size_t> at_ends(const Sampled& sampled, const EdgeClosure& closure) {
  std::vector<std::size_t> out;
  for (std::size_t e = 0; e < sampled.elements.size(); ++e) {
    const SectorBox& box = sampled.elements[e].box;
    if (sampled.elements[e].sector == 0 && closure.mirror(e) && (box.s0 == 0 || box.s1 == 1))
      out.push_back(e);
  }
  return out;
}

class EdgeClosureOf : public ::testing::TestWithParam<const char*> {
protected:
  /// 2 where observers have their foot before them.
  [[nodiscard]] double rings() const { return std::string(GetParam()) == "cube" ? 1 : 2; }
};

TEST_P(EdgeClosureOf, BoundsWhatOneElementSendsAtLeastAsItsMathsSays) {
  const Sampled sampled(GetParam(), 2);
  struct Function {
    const char* name;
    std::size_t i, j;  ///< of P_i(x) P_j(y); 9: drawn
  };
  Draw draw(21);
  for (const Function& f :
       {Function{"x", 1, 0}, {"y", 0, 1}, {"P_3(x)", 3, 0}, {"P_3(y)", 0, 3}, {"drawn", 9, 9}}) {
    SectorFunctions w(sampled.elements.size(), 2, 3);
    const bool is_drawn = f.i == 9;
    if (is_drawn) w = drawn_functions(sampled.elements.size(), 2, 3, draw);
    const std::vector<std::size_t> observers =
        at_ends(sampled, EdgeClosure(sampled.scene, sampled.elements, w));
    ASSERT_EQ(observers.size(), 2U);
    for (const std::size_t e : observers) {
      const EdgeClosure without(sampled.scene, sampled.elements, w);
      const std::size_t mirror = *without.mirror(e);
      SectorFunctions on_mirror = w;
      if (!is_drawn) {
        on_mirror.of(mirror, 0)[f.i * 4 + f.j] = 1;
        on_mirror.of(mirror, 1)[f.i * 4 + f.j] = 0.5;
      }
      const EdgeClosure closure(sampled.scene, sampled.elements, on_mirror);
      Sent sent{.slope = sampled.slope(on_mirror, mirror)};
      for (std::size_t other = 0; other < sampled.elements.size(); ++other)
        if (sampled.panel(other) == sampled.panel(mirror))
          sent.size = std::max(sent.size, sampled.size(on_mirror, other));
      const Points sides = sampled.sides(sampled.panel(mirror), sampled.elements[mirror].sector,
                                         [](std::size_t) { return true; });
      for (const double depth : {0x1p-7, 0x1p-10, 0x1p-16}) {
        const Part part(sampled, e, depth);
        sent.distance = least_distance(part.edge, sides);
        const EdgeClosure::Nearby nearby = closure.nearby(e, part.box);
        const double least = sent.at(part.reach, rings() * part.height, part.length);
        EXPECT_GE(nearby.bound, least * 0.9995) << f.name << ", depth " << depth;
        EXPECT_EQ(nearby.jumps, 0) << f.name;
        if (!is_drawn) {
          EXPECT_LE(nearby.bound, least * 1.03) << f.name << ", depth " << depth;
        }
      }
    }
  }
}

TEST_P(EdgeClosureOf, CountsEveryBorderByWhatLiesBeyondIt) {
  const Sampled sampled(GetParam(), 3);
  const EdgeClosure mirrors(sampled.scene, sampled.elements, SectorFunctions(sampled.elements.size(), 1, 0));
  enum class Function { stairs, slopes, saddle };
  for (const Function function : {Function::stairs, Function::slopes, Function::saddle}) {
    int with_jumps = 0;
    int at_a_border = 0;
    for (std::size_t e = 0; e < sampled.elements.size(); ++e) {
      if (sampled.elements[e].sector != 0 || !mirrors.mirror(e)) continue;
      const std::size_t mirror = *mirrors.mirror(e);
      // Constants that grow with s and t, P_1(y) times such, or P_1(x) P_1(y) on the mirror, 0 in the mean on
      // all of its sides, and 0 elsewhere.
      SectorFunctions w(sampled.elements.size(), 2, 2);
      for (std::size_t other = 0; other < sampled.elements.size(); ++other) {
        const SectorBox& box = sampled.elements[other].box;
        const double size = function == Function::saddle ? static_cast<double>(other == mirror)
                                                         : box.middle_s() + 2 * box.middle_t();
        const std::size_t place = function == Function::stairs ? 0 : function == Function::slopes ? 1 : 4;
        w.of(other, 0)[place] = size;
        w.of(other, 1)[place] = size / 2;
      }
      const EdgeClosure closure(sampled.scene, sampled.elements, w);
      Sent sent;
      for (std::size_t other = 0; other < sampled.elements.size(); ++other) {
        if (sampled.panel(other) != sampled.panel(mirror)) continue;
        sent.size = std::max(sent.size, sampled.size(w, other));
        if (sampled.touch(mirror, other)) sent.slope = std::max(sent.slope, sampled.slope(w, other));
      }
      const std::vector<Border> borders = borders_about(sampled, mirror, w);
      const Points sides = sampled.sides(sampled.panel(mirror), sampled.elements[mirror].sector,
                                         [&](std::size_t other) { return !sampled.touch(mirror, other); });
      // In the middle of its edge, and at an end of it.
      for (const Part::Place place : {Part::Place::middle, Part::Place::start})
        for (const double depth : {0x1p-12, 0x1p-8}) {
          const Part part(sampled, e, depth, place);
          const EdgeClosure::Nearby nearby = closure.nearby_across_borders(e, part.box);
          if (!std::isfinite(nearby.bound)) continue;
          sent.jumps = 0;
          double touched = 0;
          for (const Border& border : borders) {
            const double to_border = least_distance(part.edge, border.points);
            const double beyond = std::max(0.0, to_border - part.reach);
            const double mass = std::min(1.0, rings() * part.height / beyond);
            sent.jumps += border.jump * mass;
            if (to_border < 1e-12) touched += border.jump;
            with_jumps += static_cast<int>(border.jump > 0 && mass < 1);
          }
          at_a_border += static_cast<int>(touched > 0);
          sent.distance = least_distance(part.edge, sides);
          const double least = sent.at(part.reach, rings() * part.height, part.length);
          EXPECT_GE(nearby.bound, least * 0.9995) << "depth " << depth;
          EXPECT_LE(nearby.bound, least * 1.15) << "depth " << depth;
          EXPECT_NEAR(nearby.jumps, touched, 1e-10);
        }
    }
    EXPECT_GT(with_jumps, 20);
    EXPECT_GT(at_a_border, function == Function::saddle ? 0 : 2);
  }
}

TEST_P(EdgeClosureOf, KeepsClearOfTheSidesOfElementsBeyond) {
  const Sampled sampled(GetParam(), 2);
  const EdgeClosure closure(sampled.scene, sampled.elements, SectorFunctions(sampled.elements.size(), 1, 0));
  double closest = 0;
  for (const std::size_t sector : {0U, 1U, 5U}) {
    const std::size_t opposite = *sampled.scene.opposite(sector);
    const Points sides =
        sampled.sides(sampled.scene.sectors()[opposite].panel, opposite, [](std::size_t) { return true; });
    for (const auto& [s0, s1] :
         {std::array{0.0625, 0.07}, {0.01, 0.05}, {0.2, 0.49}, {0.3, 0.4}, {0.51, 0.6}}) {
      const Points part = along(sampled.scene.sectors()[sector], s0, 0, s1, 0);
      const double least = least_distance(part, sides);
      const double clearance = closure.clearance(sector, part.front(), part.back());
      EXPECT_LE(clearance, least) << s0 << " to " << s1;
      closest = std::max(closest, clearance / least);
    }
  }
  EXPECT_GT(closest, 0.97);
}

TEST_P(EdgeClosureOf, BoundsEveryFunctionOnTheEdge) {
  const Sampled sampled(GetParam(), 2);
  Draw draw(22);
  SectorFunctions w = drawn_functions(sampled.elements.size(), 3, 3, draw);
  for (std::size_t e = 0; e < sampled.elements.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k)
      for (double& c : w.of(e, k)) c *= k == (e % 3) ? 10 : 1;
  const EdgeClosure closure(sampled.scene, sampled.elements, w);
  double closest = 0;
  for (std::size_t e = 0; e < sampled.elements.size(); ++e) {
    if (!closure.mirror(e)) continue;
    const std::span<const double> sizes = closure.edge_sizes(e);
    const double sum = sizes[0] + sizes[1] + sizes[2] + sizes[3];
    for (int i = 0; i <= steps; ++i)
      for (const double value : sampled.values(w, e, between(-1, 1, i), -1)) {
        EXPECT_LE(std::abs(value), sum) << "element " << e;
        closest = std::max(closest, std::abs(value) / sum);
      }
  }
  EXPECT_GT(closest, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Polyhedra, EdgeClosureOf, ::testing::Values("cube", "tetrahedron"));

}  // namespace
}  // namespace radcert
