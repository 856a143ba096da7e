// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/facet_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/factors/convex_parts.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"

namespace radcert {

namespace {

using Point = Vector<double>;
/// On which side of the plane through three points others lie, exactly; nearly always decided in doubles.
class Plane {
public:
  explicit Plane(const std::array<Point, 3>& through) : through_(through) {
    const Point b = through[1] - through[0];
    const Point c = through[2] - through[0];
    normal_ = cross(b, c);
    sizes_ = {std::abs(b.y * c.z) + std::abs(b.z * c.y), std::abs(b.z * c.x) + std::abs(b.x * c.z),
              std::abs(b.x * c.y) + std::abs(b.y * c.x)};
  }

  [[nodiscard]] int side(const Point& p) const {
    if (p == through_[0] || p == through_[1] || p == through_[2]) return 0;
    const Point d = p - through_[0];
    const double height = dot(normal_, d);
    // Shewchuk's bound for this order of operations is (7 + 56/2^53) / 2^53 of the sum of sizes; the least
    // keeps underflow away.
    constexpr double roundings = 0x1p-49;
    constexpr double least = 0x1p-900;
    const double bound =
        roundings * (sizes_.x * std::abs(d.x) + sizes_.y * std::abs(d.y) + sizes_.z * std::abs(d.z)) + least;
    if (height > bound) return 1;
    if (height < -bound) return -1;
    return orientation(through_[0], through_[1], through_[2], p);
  }

private:
  std::array<Point, 3> through_;
  Point normal_;
  Point sizes_;
};

int side_of(const std::array<Point, 3>& plane, const Point& p) { return Plane(plane).side(p); }

std::array<Point, 3> plane_of(const FacetCorners& polygon) { return {polygon[0], polygon[1], polygon[2]}; }

/// The signs that points have: 1 for some in front, 2 for some behind.
template <class Points>
unsigned sides(const Plane& plane, const Points& points) {
  unsigned found = 0;
  for (const Point& p : points) {
    const int side = plane.side(p);
    found |= side > 0 ? 1U : side < 0 ? 2U : 0U;
    if (found == 3U) break;
  }
  return found;
}
template <class Points>
unsigned sides(const std::array<Point, 3>& plane, const Points& points) {
  return sides(Plane(plane), points);
}

/// The exact cross product of two sides of a triangle.
Vector<Rational> exact_normal(const std::array<Point, 3>& corners) {
  const Vector<Rational> origin = exactly(corners[0]);
  return cross(exactly(corners[1]) - origin, exactly(corners[2]) - origin);
}

/// A direction rounded: its largest coordinate divides the others before they leave the range of doubles.
Point unit_vector(const Vector<Rational>& direction) {
  const Rational largest = std::max({abs(direction.x), abs(direction.y), abs(direction.z)});
  const Point v{(direction.x / largest).to_double(), (direction.y / largest).to_double(),
                (direction.z / largest).to_double()};
  return (1 / norm(v)) * v;
}

/// What of a polygon lies in front of a plane; which corners do is exact, and those cut off are exact points
/// rounded.
FacetCorners in_front(const FacetCorners& polygon, const std::array<Point, 3>& plane) {
  std::vector<int> side;
  for (const Point& p : polygon) side.push_back(side_of(plane, p));
  const Vector<Rational> normal = exact_normal(plane);
  const Vector<Rational> origin = exactly(plane[0]);
  FacetCorners out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = (k + 1) % polygon.size();
    if (side[k] >= 0) out.push_back(polygon[k]);
    if (side[k] * side[next] >= 0) continue;
    const Vector<Rational> from = exactly(polygon[k]);
    const Vector<Rational> to = exactly(polygon[next]);
    const Rational above = dot(normal, from - origin);
    const Vector<Rational> at = from + (above / (above - dot(normal, to - origin))) * (to - from);
    out.push_back({at.x.to_double(), at.y.to_double(), at.z.to_double()});
  }
  return out;
}

BoundingBox hull_box(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
  return box_about(std::array<Point, 6>{a[0], a[1], a[2], b[0], b[1], b[2]});
}

}  // namespace

std::optional<std::string> beyond_doubles(const TriangleMesh& mesh) {
  const auto first = mesh.corners(0);
  BoundingBox box = box_about(first);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Point& p : mesh.corners(t)) box = box_about(std::array<Point, 3>{box.low, box.high, p});
  const Point size = box.high - box.low;
  const double length = std::max({size.x, size.y, size.z});
  constexpr double longest = 0x1p100;
  constexpr double shortest_length = 0x1p-100;
  if (!(length <= longest && length >= shortest_length))
    return "is " + shortest(length) +
           " long, and doubles carry exchange areas of scenes from 2^-100 to 2^100";
  const Rational least = Rational::exactly(0x1p-200 * length * length);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corners = mesh.corners(t);
    // Nearly always decided in doubles: a rounded area errs by some roundings of its sides' product.
    const Point a = corners[1] - corners[0];
    const Point b = corners[2] - corners[0];
    if (norm(cross(a, b)) > 0x1p-40 * norm(a) * norm(b) && norm(cross(a, b)) > 0x1p-190 * length * length)
      continue;
    const Vector<Rational> normal = exact_normal(corners);
    if (dot(normal, normal) >= least * least) continue;
    return "has the triangle " + std::to_string(t) + " at (" + shortest(corners[0].x) + ", " +
           shortest(corners[0].y) + ", " + shortest(corners[0].z) +
           ") with an area below 2^-200 of the square of the scene's length " + shortest(length);
  }
  return std::nullopt;
}

FacetScene::FacetScene(TriangleMesh mesh, Rational unit) : scene_(std::move(mesh)), unit_(std::move(unit)) {
  expects(unit_.sign() > 0, "a positive unit of lengths", named("unit", unit_));
  expects(facet_count() > 0, "a scene of at least one triangle");
  if (const auto words = beyond_doubles(scene_.mesh()))
    expects(false, "a scene that doubles carry: it " + *words);
  for (std::size_t t = 0; t < facet_count(); ++t) {
    const Vector<Rational> normal = exact_normal(scene_.corners(t));
    areas_.push_back(sqrt(Ball(dot(normal, normal) / 4)).to_double());
    total_area_ += areas_.back();
    unit_normals_.push_back(unit_vector(normal));
  }
  find_occluders();
  find_solids();
  find_neighbours();
  find_contained();
  std::vector<BoundingBox> boxes;
  for (const ConvexOccluder& occluder : occluders_) {
    BoundingBox box{occluder.corners[0], occluder.corners[0]};
    for (const Point& p : occluder.corners) box = box_about(std::array<Point, 3>{box.low, box.high, p});
    boxes.push_back(box);
  }
  tree_ = BoxTree(std::move(boxes));
}

FacetCorners FacetScene::facet(std::size_t triangle) const {
  const std::array<Point, 3> corners = scene_.corners(triangle);
  return {corners.begin(), corners.end()};
}

void FacetScene::find_occluders() {
  const PlaneClasses classes = plane_classes(scene_.mesh());
  std::vector<std::vector<std::size_t>> members(classes.count());
  // Of the two sides of a plate one: occluders of one plane must not overlap, and the other side may have
  // other neighbours to be joined with.
  std::set<VertexTriple> known;
  for (std::size_t t = 0; t < facet_count(); ++t) {
    VertexTriple corners = scene_.vertices(t);
    std::sort(corners.begin(), corners.end());
    if (known.insert(corners).second) members[classes.of_triangle[t]].push_back(t);
  }
  for (const std::vector<std::size_t>& triangles : members) {
    if (triangles.empty() || sides(scene_.corners(triangles.front()), scene_.mesh().vertices) != 3U) continue;
    for (ConvexPart& part : convex_parts(scene_, triangles)) {
      occluders_.push_back({.corners = std::move(part.corners), .plane = scene_.plane(triangles.front())});
      // One of the occluder's own: several bodies may have faces in one plane.
      occluder_triangle_.push_back(part.triangle);
    }
  }
}

void FacetScene::find_solids() {
  // The topology by coordinates, not by the numbers that a file gave.
  TriangleMesh joined = scene_.mesh();
  for (std::size_t t = 0; t < facet_count(); ++t) joined.triangles[t] = scene_.vertices(t);
  topology_ = mesh_topology(joined);
  const MeshTopology& topology = topology_;
  std::vector<bool> is_convex(topology.component_count, true);
  const auto spoil = [&](const std::vector<std::size_t>& edges) {
    for (const std::size_t e : edges)
      for (std::size_t s = topology.edges[e].begin; s < topology.edges[e].end; ++s)
        is_convex[topology.component[topology.sides[s].triangle]] = false;
  };
  spoil(topology.open_edges);
  spoil(topology.crowded_edges);
  spoil(topology.disagreeing_edges);
  const PlaneClasses oriented = plane_classes(scene_.mesh());
  std::vector<std::vector<std::size_t>> members(topology.component_count);
  for (std::size_t t = 0; t < facet_count(); ++t) members[topology.component[t]].push_back(t);
  for (std::size_t c = 0; c < topology.component_count; ++c) {
    if (!is_convex[c]) continue;
    // Looking outwards with nothing of itself in front: a convex body seen from outside, unless it is a plate
    // with both of its sides. Exact, and quadratic only in planes.
    std::set<std::size_t> seen;
    const std::size_t plane = scene_.plane(members[c].front());
    is_convex[c] = std::any_of(members[c].begin(), members[c].end(),
                               [&](std::size_t t) { return scene_.plane(t) != plane; });
    for (const std::size_t t : members[c]) {
      if (!is_convex[c] || !seen.insert(oriented.of_triangle[t]).second) continue;
      for (const std::size_t other : members[c])
        if ((sides(scene_.corners(t), scene_.corners(other)) & 1U) != 0) {
          is_convex[c] = false;
          break;
        }
    }
  }
  std::map<std::pair<bool, std::size_t>, std::size_t> numbers;
  for (std::size_t k = 0; k < occluders_.size(); ++k) {
    const std::size_t component = topology.component[occluder_triangle_[k]];
    const bool body = is_convex[component];
    const auto [at, fresh] =
        numbers.emplace(std::pair(body, body ? component : occluders_[k].plane), numbers.size());
    if (fresh) is_body_.push_back(body);
    occluders_[k].solid = at->second;
  }
}

void FacetScene::find_neighbours() {
  using Place = std::array<double, 3>;
  const auto place = [](const Point& p) { return Place{p.x, p.y, p.z}; };
  struct Border {
    std::size_t occluder;
    std::size_t corner;
  };
  std::map<std::pair<Place, Place>, Border> sides;
  const auto corner_place = [&](std::size_t k, std::size_t c) {
    const FacetCorners& corners = occluders_[k].corners;
    return place(corners[c % corners.size()]);
  };
  for (std::size_t k = 0; k < occluders_.size(); ++k)
    for (std::size_t c = 0; solid_is_body(occluders_[k].solid) && c < occluders_[k].corners.size(); ++c)
      sides[{corner_place(k, c), corner_place(k, c + 1)}] = {k, c};
  for (std::size_t k = 0; k < occluders_.size(); ++k) {
    ConvexOccluder& occluder = occluders_[k];
    const std::size_t count = occluder.corners.size();
    occluder.beyond_side.resize(count);
    occluder.around_corner.resize(count);
    if (!solid_is_body(occluder.solid)) continue;
    for (std::size_t c = 0; c < count; ++c) {
      // Round the corner from face to face; back at the first one, these are all.
      std::vector<std::size_t> faces;
      Border at{k, c};
      for (std::size_t step = 0; step <= occluders_.size(); ++step) {
        faces.push_back(at.occluder);
        const auto found =
            sides.find({corner_place(at.occluder, at.corner + 1), corner_place(at.occluder, at.corner)});
        if (found == sides.end()) break;
        const Border over = found->second;
        if (step == 0) occluder.beyond_side[c] = over.occluder;
        at = {over.occluder, (over.corner + 1) % occluders_[over.occluder].corners.size()};
        if (at.occluder != k) continue;
        occluder.around_corner[c] = faces;
        break;
      }
    }
  }
}

void FacetScene::find_contained() {
  bodies_of_.resize(facet_count());
  std::map<std::size_t, std::vector<std::size_t>> faces;
  for (std::size_t k = 0; k < occluders_.size(); ++k)
    if (is_body_[occluders_[k].solid]) faces[occluders_[k].solid].push_back(k);
  for (const auto& [solid, of_body] : faces) {
    // The faces that are no occluders have the whole scene behind them.
    const std::size_t component = topology_.component[occluder_triangle_[of_body.front()]];
    std::optional<BoundingBox> box;
    for (std::size_t t = 0; t < facet_count(); ++t)
      if (topology_.component[t] == component)
        for (const Point& p : scene_.corners(t))
          box = box ? box_about(std::array<Point, 3>{box->low, box->high, p}) : BoundingBox{p, p};
    for (std::size_t t = 0; t < facet_count(); ++t) {
      const std::array<Point, 3> corners = scene_.corners(t);
      const BoundingBox mine = box_about(corners);
      const bool in_box = mine.low.x >= box->low.x && mine.high.x <= box->high.x &&
                          mine.low.y >= box->low.y && mine.high.y <= box->high.y &&
                          mine.low.z >= box->low.z && mine.high.z <= box->high.z;
      if (topology_.component[t] == component || !in_box) continue;
      // Behind each face, a corner at least.
      if (std::all_of(of_body.begin(), of_body.end(), [&](std::size_t k) {
            return sides(scene_.corners(occluder_triangle_[k]), corners) == 2U;
          }))
        bodies_of_[t].push_back(solid);
    }
  }
}

bool FacetScene::lies_within(std::size_t triangle, std::size_t solid) const {
  const std::vector<std::size_t>& bodies = bodies_of_[triangle];
  return std::find(bodies.begin(), bodies.end(), solid) != bodies.end();
}

bool FacetScene::may_stand_between(const ConvexOccluder& occluder, std::size_t first,
                                   std::size_t second) const {
  if (occluder.plane == scene_.plane(first) || occluder.plane == scene_.plane(second)) return false;
  const std::array<Point, 3> a = scene_.corners(first);
  const std::array<Point, 3> b = scene_.corners(second);
  if ((sides(a, occluder.corners) & 1U) == 0 || (sides(b, occluder.corners) & 1U) == 0) return false;
  if ((sides(plane_of(occluder.corners), a) | sides(plane_of(occluder.corners), b)) != 3U) return false;
  // Planes through three corners, of which two belong to a side: of the triangles' hull, or of the occluder.
  const auto parts_them = [&](const std::array<Point, 3>& through) {
    const Plane plane(through);
    const unsigned first_sides = sides(plane, a);
    if (first_sides == 3U) return false;
    const unsigned hull = first_sides | sides(plane, b);
    if (hull == 3U || hull == 0U) return false;
    const unsigned other = sides(plane, occluder.corners);
    return (hull & other) == 0 && other != 3U;
  };
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t v = 0; v < 3; ++v)
      if (parts_them({a[k], a[(k + 1) % 3], b[v]}) || parts_them({b[k], b[(k + 1) % 3], a[v]})) return false;
  const std::size_t count = occluder.corners.size();
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t v = 0; v < 3; ++v) {
      const Point& from = occluder.corners[k];
      const Point& to = occluder.corners[(k + 1) % count];
      if (parts_them({from, to, a[v]}) || parts_them({from, to, b[v]})) return false;
    }
  return true;
}

bool FacetScene::hides(const ConvexOccluder& occluder, std::size_t first, std::size_t second) const {
  // A segment meets the convex polygon where its ends lie on different sides and the second in the pyramid
  // from the first. If so for all corners it holds for all points: from a fixed point the map onto the plane
  // takes hulls to hulls.
  const std::array<Point, 3> plane = plane_of(occluder.corners);
  const std::array<Point, 3> from = scene_.corners(first);
  const std::array<Point, 3> to = scene_.corners(second);
  const unsigned from_side = sides(plane, from);
  const unsigned to_side = sides(plane, to);
  if (from_side == 0 || to_side == 0 || (from_side & to_side) != 0 || from_side == 3U || to_side == 3U)
    return false;
  const int sign = from_side == 1U ? 1 : -1;
  for (const Point& p : from) {
    if (side_of(plane, p) == 0) return false;
    for (const Point& q : to)
      for (std::size_t k = 0; k < occluder.corners.size(); ++k) {
        const Point& a = occluder.corners[k];
        const Point& b = occluder.corners[(k + 1) % occluder.corners.size()];
        if (sign * orientation(a, b, p, q) > 0) return false;
      }
  }
  return true;
}

bool FacetScene::may_hide_together(std::size_t occluder, std::size_t other, std::size_t first,
                                   std::size_t second) const {
  // A segment through X of the one lies in the hulls of it and either triangle. What a plane has on its other
  // side these do not meet inside.
  const auto apart_from = [&](const FacetCorners& one, const FacetCorners& two, std::size_t triangle) {
    FacetCorners hull = facet(triangle);
    hull.insert(hull.end(), one.begin(), one.end());
    FacetCorners all = hull;
    all.insert(all.end(), two.begin(), two.end());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j)
        for (std::size_t k = j + 1; k < all.size(); ++k) {
          const Plane plane({all[i], all[j], all[k]});
          const unsigned of_hull = sides(plane, hull);
          const unsigned of_two = sides(plane, two);
          if (of_hull != 0 && of_hull != 3U && of_two != 3U && (of_hull & of_two) == 0) return true;
        }
    return false;
  };
  const auto pass_by = [&](const FacetCorners& one, const FacetCorners& two) {
    return apart_from(one, two, first) && apart_from(one, two, second);
  };
  const FacetCorners& a = occluders_[occluder].corners;
  const FacetCorners& b = occluders_[other].corners;
  return !pass_by(a, b) && !pass_by(b, a);
}

FacetPair FacetScene::pair(std::size_t first, std::size_t second) const {
  expects(first < facet_count() && second < facet_count(), "triangles that are there", named("first", first),
          named("second", second));
  FacetPair out;
  if (scene_.plane(first) == scene_.plane(second)) return out;
  const std::array<Point, 3> a = scene_.corners(first);
  const std::array<Point, 3> b = scene_.corners(second);
  const unsigned a_sides = sides(b, a);
  const unsigned b_sides = sides(a, b);
  if ((a_sides & 1U) == 0 || (b_sides & 1U) == 0) return out;
  out.first = a_sides == 3U ? in_front(facet(first), b) : facet(first);
  out.second = b_sides == 3U ? in_front(facet(second), a) : facet(second);
  out.first_normal = unit_normals_[first];
  out.second_normal = unit_normals_[second];
  if (bodies_of_[first] != bodies_of_[second]) {
    out.sight = PairSight::hidden;
    return out;
  }
  const BoundingBox box = hull_box(a, b);
  tree_.visit(
      [&](const BoundingBox& other) { return !apart(box, other); },
      [&](std::size_t k) {
        if (!lies_within(first, occluders_[k].solid) && may_stand_between(occluders_[k], first, second))
          out.occluders.push_back(k);
        return true;
      });
  std::sort(out.occluders.begin(), out.occluders.end());
  out.sight = out.occluders.empty() ? PairSight::whole : PairSight::mixed;
  for (const std::size_t k : out.occluders)
    if (hides(occluders_[k], first, second)) {
      out.sight = PairSight::hidden;
      break;
    }
  return out;
}

}  // namespace radcert
