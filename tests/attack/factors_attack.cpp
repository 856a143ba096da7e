// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/factor_matrix.h"
#include "radcert/factors/visible_exchange.h"
#include "tests/attack/attack.h"
#include "tests/attack/sight_judge.h"

// Configuration factors of random scenes: open, closed, occluded, with bodies in bodies, with slivers.
namespace radcert::attack {
namespace {

using Point = Vector<double>;

/// A scene under construction: triangles that may share vertices by their coordinates.
class SceneDraw {
public:
  explicit SceneDraw(Draw& draw) : draw_(&draw), on_grid_(draw.below(2) == 0) { mesh_.group_names = {""}; }

  TriangleMesh mesh() const { return mesh_; }

  /// Of a coarse grid in half of the scenes: corners on edges, faces in one plane, parallel sides.
  double between(double low, double high) {
    constexpr double steps = 16;
    const double x = low + (high - low) * draw_->unit();
    return on_grid_ ? std::round(x * steps) / steps : x;
  }
  Point point(const Point& low, const Point& high) {
    return {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
  }

  void triangle(const Point& a, const Point& b, const Point& c) {
    const std::size_t n = mesh_.vertices.size();
    mesh_.vertices.insert(mesh_.vertices.end(), {a, b, c});
    mesh_.triangles.push_back({n, n + 1, n + 2});
    mesh_.group.push_back(0);
    mesh_.face.push_back(mesh_.face.size());
  }
  void quadrangle(const Point& a, const Point& b, const Point& c, const Point& d) {
    if (draw_->below(2) == 0) {
      triangle(a, b, c);
      triangle(a, c, d);
    } else {
      triangle(b, c, d);
      triangle(b, d, a);
    }
  }

  /// A parallelepiped, looking outwards or inwards.
  void body(const Point& corner, const std::array<Point, 3>& edge, bool inwards) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const Point a = upper ? corner + edge[axis] : corner;
        const Point u = edge[(axis + 1) % 3];
        const Point v = edge[(axis + 2) % 3];
        const bool right_handed = dot(cross(edge[0], edge[1]), edge[2]) > 0;
        if ((upper == inwards) == right_handed)
          quadrangle(a, a + v, (a + v) + u, a + u);
        else
          quadrangle(a, a + u, (a + v) + u, a + v);
      }
  }
  void box(const Point& low, const Point& high, bool inwards) {
    // Corners are those given: no sums that round differently.
    const auto at = [&](int k) {
      return Point{(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                   (k & 4) != 0 ? high.z : low.z};
    };
    static constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : faces) {
      if (inwards)
        quadrangle(at(f[3]), at(f[2]), at(f[1]), at(f[0]));
      else
        quadrangle(at(f[0]), at(f[1]), at(f[2]), at(f[3]));
    }
  }
  void tetrahedron(Point a, Point b, const Point& c, const Point& d) {
    if (dot(cross(b - a, c - a), d - a) > 0) std::swap(a, b);
    triangle(a, b, c);
    triangle(a, c, d);
    triangle(a, d, b);
    triangle(b, d, c);
  }

  /// Something that may stand between z = 0 and z = 1.
  void occluder() {
    const Point low{0, 0, 0.0625};
    const Point high{1, 1, 0.9375};
    const Point at = point(low, high);
    switch (draw_->below(6)) {
      case 0: triangle(at, point(low, high), point(low, high)); break;
      case 1: {
        const double thin = draw_->below(2) == 0 ? 0.5 : 0.03;
        tetrahedron(at, at + thin * (point(low, high) - at), at + thin * (point(low, high) - at),
                    at + thin * (point(low, high) - at));
        break;
      }
      case 2: {  // a box, of which some sides are thin: a leg, a plate
        Point size{between(0.0625, 0.5), between(0.0625, 0.5), between(0.0625, 0.5)};
        if (draw_->below(2) == 0) size.x = 0.03125;
        if (draw_->below(2) == 0) size.y = 0.03125;
        if (draw_->below(3) == 0) size.z = 0.03125;
        box(at, at + size, false);
        break;
      }
      case 3:
        quadrangle(at, {at.x + 0.25, at.y, at.z}, {at.x + 0.25, at.y + 0.25, at.z},
                   {at.x, at.y + 0.25, at.z});
        break;
      case 4: {  // a small one close to the lower triangle
        const double height = draw_->below(2) == 0 ? 0.01 : 0.0001;
        const double size = draw_->below(2) == 0 ? 0.05 : 0.2;
        triangle({at.x / 2, at.y / 2, height}, {at.x / 2 + size, at.y / 2, height},
                 {at.x / 2, at.y / 2 + size, height});
        break;
      }
      default: {  // a sliver
        const Point along = point(low, high) - at;
        triangle(at, at + along,
                 (at + 0.5 * along) + Point{0, 0, std::ldexp(1, -static_cast<int>(draw_->below(50)))});
      }
    }
  }

private:
  Draw* draw_;
  bool on_grid_;
  TriangleMesh mesh_;
};

struct Instance {
  TriangleMesh mesh;
  double accuracy = 1e-4;
  std::uint64_t seed = 0;  ///< of the judge's lattices
};

std::string text_of(const Instance& instance) {
  std::string out = "accuracy " + shortest(instance.accuracy) + "\nOFF\n" +
                    std::to_string(3 * instance.mesh.triangles.size()) + " " +
                    std::to_string(instance.mesh.triangles.size()) + " 0\n";
  for (std::size_t t = 0; t < instance.mesh.triangles.size(); ++t)
    for (const Point& p : instance.mesh.corners(t))
      out += shortest(p.x) + " " + shortest(p.y) + " " + shortest(p.z) + "\n";
  for (std::size_t t = 0; t < instance.mesh.triangles.size(); ++t)
    out += "3 " + std::to_string(3 * t) + " " + std::to_string(3 * t + 1) + " " + std::to_string(3 * t + 2) +
           "\n";
  return out;
}

/// Without one triangle, from the third on: the first two are the pair that is looked at.
std::vector<Instance> without_one(const Instance& instance) {
  std::vector<Instance> out;
  for (std::size_t t = 2; t < instance.mesh.triangles.size(); ++t) {
    Instance less = instance;
    const auto at = static_cast<std::ptrdiff_t>(t);
    less.mesh.triangles.erase(less.mesh.triangles.begin() + at);
    less.mesh.group.pop_back();
    less.mesh.face.pop_back();
    out.push_back(std::move(less));
  }
  return out;
}

/// Two triangles that look at each other, and others that may stand between.
Instance occluded(Draw& draw) {
  for (;;) {
    SceneDraw scene(draw);
    const auto below = [&] {
      return Point{scene.between(0, 1), scene.between(0, 1),
                   draw.below(3) == 0 ? scene.between(-0.25, 0.5) : 0.0};
    };
    const auto above = [&] {
      return Point{scene.between(0, 1), scene.between(0, 1),
                   draw.below(3) == 0 ? scene.between(0.5, 1.25) : 1.0};
    };
    std::array<Point, 3> low{below(), below(), below()};
    std::array<Point, 3> high{above(), above(), above()};
    if (draw.below(8) == 0) high[0] = low[0];
    if (draw.below(16) == 0) high[1] = low[1];
    if (cross(low[1] - low[0], low[2] - low[0]).z < 0) std::swap(low[1], low[2]);
    if (cross(high[1] - high[0], high[2] - high[0]).z > 0) std::swap(high[1], high[2]);
    scene.triangle(low[0], low[1], low[2]);
    scene.triangle(high[0], high[1], high[2]);
    if (!scene_faults(scene.mesh()).empty()) continue;
    const std::size_t count = draw.below(6) == 0 ? 16 : 1 + draw.below(6);
    SceneDraw whole = scene;
    for (std::size_t k = 0; k < count; ++k) {
      SceneDraw more = whole;
      more.occluder();
      if (scene_faults(more.mesh()).empty()) whole = std::move(more);
    }
    static constexpr std::array<double, 4> accuracies{1e-2, 1e-3, 1e-4, 1e-5};
    return {whole.mesh(), accuracies[draw.below(accuracies.size())], draw.bits()};
  }
}

/// Whether what was found may be the exchange area of the first two triangles: first few points, then many.
Judgement held_by_points(const Instance& instance, const Approximation& found, std::size_t i, std::size_t j) {
  const SightJudge judge(instance.mesh);
  Draw draw(instance.seed);
  // Of 16 shifts: nine times the deviation is left out once in a million at 15 degrees of freedom.
  constexpr double sure = 9;
  constexpr double suspicious = 3;
  SampledArea sample;
  for (const int points : {64, 512, 8192}) {
    sample = judge.exchange_area(i, j, points, draw);
    const double off = std::abs(sample.value - found.value);
    // The radius is wide enough for these points, or many of them see no reason for doubt.
    if (sample.deviation > 0 && off + 4 * sample.deviation <= found.radius) return Judgement::held();
    if (points >= 512 && off <= found.radius + suspicious * sample.deviation + sample.rounding)
      return Judgement::held();
    if (points == 8192 && off <= found.radius + sure * sample.deviation + sample.rounding)
      return Judgement::held();
  }
  return Judgement::violated("exchange area of " + std::to_string(i) + " and " + std::to_string(j) + ": " +
                             shortest(found.value) + " +- " + shortest(found.radius) + ", by points " +
                             shortest(sample.value) + " with deviation " + shortest(sample.deviation));
}

TEST(FactorsAttack, EstimatesOfOccludedPairsHold) {
  static_cast<void>(hold(Attack<Instance>{
      .name = "factors_occluded_estimated",
      .usual_instances = 40,
      .make = occluded,
      .judge =
          [](const Instance& instance) {
            const FacetScene scene(instance.mesh);
            const PairExchange found = pair_exchange(scene, 0, 1, {.accuracy = instance.accuracy});
            return held_by_points(instance, found.area, 0, 1);
          },
      .text = text_of,
      .smaller = without_one,
  }));
}

/// A scene that certifies within moments, or not: the ball holds the truth, however wide.
TEST(FactorsAttack, CertifiedOccludedPairsHold) {
  static_cast<void>(hold(Attack<Instance>{
      .name = "factors_occluded_certified",
      .usual_instances = 4,
      .make = occluded,
      .judge =
          [](const Instance& instance) {
            const FacetScene scene(instance.mesh);
            constexpr CertifiedDemand quick{.radius = 1e-2, .work_limit = 300};
            const Ball ball = certified_exchange_area(scene, 0, 1, scene.pair(0, 1), quick);
            return held_by_points(instance, enclosing(ball), 0, 1);
          },
      .text = text_of,
      .smaller = without_one,
  }));
}

/// Two triangles that may see each other wholly: in the open, with a common corner or side, far from each
/// other, slivers.
Instance open_pair(Draw& draw) {
  for (;;) {
    SceneDraw scene(draw);
    const double scale = std::ldexp(1, static_cast<int>(draw.below(120)) - 60);
    const double distance = draw.below(3) == 0 ? std::ldexp(1, static_cast<int>(draw.below(12))) : 1;
    std::array<Point, 3> low;
    std::array<Point, 3> high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = scene.point({0, 0, 0}, {1, 1, 0.5});
      high[k] = scene.point({0, 0, 0.5 * distance}, {1, 1, distance});
    }
    if (draw.below(4) == 0) high[0] = low[0];
    if (draw.below(4) == 0) high[1] = low[1];
    // Corners nearly, or but for rounding, on a line.
    if (draw.below(4) == 0) {
      const double part = draw.unit();
      low[2] = low[0] + part * (low[1] - low[0]);
      if (draw.below(2) == 0) low[2].x += std::ldexp(1, -static_cast<int>(draw.below(60)));
    }
    for (std::array<Point, 3>* t : {&low, &high})
      for (Point& p : *t) p = scale * p;
    if (cross(low[1] - low[0], low[2] - low[0]).z < 0) std::swap(low[1], low[2]);
    if (cross(high[1] - high[0], high[2] - high[0]).z > 0) std::swap(high[1], high[2]);
    scene.triangle(low[0], low[1], low[2]);
    scene.triangle(high[0], high[1], high[2]);
    if (scene_faults(scene.mesh()).empty()) return {scene.mesh(), 1e-4, draw.bits()};
  }
}

TEST(FactorsAttack, OpenPairsHold) {
  static_cast<void>(hold(Attack<Instance>{
      .name = "factors_open",
      .usual_instances = 80,
      .make = open_pair,
      .judge =
          [](const Instance& instance) {
            if (beyond_doubles(instance.mesh)) return Judgement::refused();
            const FacetScene scene(instance.mesh);
            const Approximation found = pair_exchange(scene, 0, 1, {}).area;
            const Ball proved = certified_exchange_area(scene, 0, 1, scene.pair(0, 1), {});
            if (!overlaps(ball_of(found), proved))
              return Judgement::violated("estimated " + shortest(found.value) + " +- " +
                                         shortest(found.radius) + ", certified " + proved.to_text());
            // A sliver is no receiver for the judge's doubles.
            if (scene.area(0) < 1e-9 * scene.total_area()) return Judgement::held();
            return held_by_points(instance, enclosing(proved), 0, 1);
          },
      .text = text_of,
  }));
}

/// A closed room with things in it, some of which stand in or on others.
Instance room(Draw& draw) {
  SceneDraw scene(draw);
  const double side = draw.below(3) == 0 ? 1.25 : 4;
  scene.box({-0.25, -0.25, 0}, {1.25, side, 1}, true);
  const std::size_t count = draw.below(4);
  for (std::size_t k = 0; k < count; ++k) {
    SceneDraw more = scene;
    const Point at = more.point({0, 0, 0.0625}, {0.75, 0.75, 0.5});
    const Point size{more.between(0.03125, 0.25), more.between(0.03125, 0.25), more.between(0.03125, 0.4)};
    if (draw.below(4) == 0)
      more.tetrahedron(at, {at.x + size.x, at.y, at.z}, {at.x, at.y + size.y, at.z},
                       {at.x, at.y, at.z + size.z});
    else
      more.box(at, at + size, false);
    if (scene_faults(more.mesh()).empty()) scene = more;
  }
  static constexpr std::array<double, 3> accuracies{1e-2, 1e-3, 1e-4};
  return {scene.mesh(), accuracies[draw.below(accuracies.size())], draw.bits()};
}

TEST(FactorsAttack, RowsOfClosedRoomsSumToOne) {
  static_cast<void>(hold(Attack<Instance>{
      .name = "factors_closed",
      .usual_instances = 4,
      .make = room,
      .judge =
          [](const Instance& instance) {
            const FacetScene scene(instance.mesh);
            FactorUnits units;
            for (std::size_t t = 0; t < scene.facet_count(); ++t) {
              units.of_triangle.push_back(t);
              units.names.push_back(std::to_string(t));
            }
            const FactorMatrix matrix = factor_matrix(scene, units, {.accuracy = instance.accuracy}, {});
            for (std::size_t i = 0; i < matrix.rows.size(); ++i)
              if (matrix.closure_defect(i) > matrix.rows[i].sum.radius)
                return Judgement::violated("row " + std::to_string(i) + ": " +
                                           shortest(matrix.rows[i].sum.value) + " +- " +
                                           shortest(matrix.rows[i].sum.radius));
            return Judgement::held();
          },
      .text = text_of,
  }));
}

/// A convex body with triangles in it and outside, the first two of the mesh; the body's faces stand between
/// some.
Instance contained(Draw& draw) {
  for (;;) {
    SceneDraw scene(draw);
    const auto place = [&](bool inside, double low, double high) {
      const Point a{0.1, 0.1, low};
      const Point b{0.9, 0.9, high};
      const double shift = inside || draw.below(2) == 0 ? 0 : 1.5;
      std::array<Point, 3> c{scene.point(a, b), scene.point(a, b), scene.point(a, b)};
      for (Point& p : c) p.x += shift;
      return c;
    };
    const std::size_t where = draw.below(3);
    std::array<Point, 3> low = where == 2 ? place(false, -0.9, -0.2) : place(true, 0.1, 0.4);
    std::array<Point, 3> high = where == 0 ? place(true, 0.6, 0.9) : place(false, 1.2, 1.9);
    // Corners of the body that are the triangle's too.
    if (where < 2 && draw.below(4) == 0) low[0] = {draw.below(2) == 0 ? 0.0 : 1.0, 0, 0};
    if (cross(low[1] - low[0], low[2] - low[0]).z < 0) std::swap(low[1], low[2]);
    if (cross(high[1] - high[0], high[2] - high[0]).z > 0) std::swap(high[1], high[2]);
    scene.triangle(low[0], low[1], low[2]);
    scene.triangle(high[0], high[1], high[2]);
    scene.box({0, 0, 0}, {1, 1, 1}, draw.below(4) == 0);
    if (draw.below(2) == 0) scene.box({-1, -1, -1}, {3, 3, 3}, draw.below(2) == 0);
    if (draw.below(3) == 0) {
      SceneDraw more = scene;
      const Point at = more.point({0.1, 0.1, 0.4}, {0.5, 0.5, 0.5});
      more.box(at, at + Point{0.25, 0.25, 0.0625}, false);
      if (scene_faults(more.mesh()).empty()) scene = more;
    }
    if (scene_faults(scene.mesh()).empty()) return {scene.mesh(), 1e-3, draw.bits()};
  }
}

TEST(FactorsAttack, PairsInAndOutsideBodiesHold) {
  static_cast<void>(hold(Attack<Instance>{
      .name = "factors_contained",
      .usual_instances = 30,
      .make = contained,
      .judge =
          [](const Instance& instance) {
            const FacetScene scene(instance.mesh);
            const Judgement estimated = held_by_points(
                instance, pair_exchange(scene, 0, 1, {.accuracy = instance.accuracy}).area, 0, 1);
            if (estimated.kind != Judgement::Kind::held) return estimated;
            constexpr CertifiedDemand quick{.radius = 1e-2, .work_limit = 100};
            const Ball ball = certified_exchange_area(scene, 0, 1, scene.pair(0, 1), quick);
            return held_by_points(instance, enclosing(ball), 0, 1);
          },
      .text = text_of,
      .smaller = without_one,
  }));
}

}  // namespace
}  // namespace radcert::attack
