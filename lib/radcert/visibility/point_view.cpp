// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/point_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/visibility/sight_geometry.h"

namespace radcert {
namespace {

using Side = SightGeometry::Side;
using Corner = SightGeometry::Corner;
using Signs = std::vector<std::int8_t>;

bool fits(const Vector<double>& v) {
  return std::abs(v.x) <= Scene::largest_coordinate && std::abs(v.y) <= Scene::largest_coordinate &&
         std::abs(v.z) <= Scene::largest_coordinate;
}

/// A convex cone of directions: corners[k] is where sides[k - 1] and sides[k] meet, counterclockwise as seen
/// from P.
struct Cone {
  std::vector<Side> sides;
  std::vector<Corner> corners;
};

Side opposite(const Side& side) { return {side.plane, -side.sign}; }

/// On which sides of a plane a cone has corners.
struct Spread {
  bool inside = false;
  bool outside = false;
};

Spread spread(const Signs& signs) {
  Spread result;
  for (const std::int8_t s : signs) {
    result.inside = result.inside || s > 0;
    result.outside = result.outside || s < 0;
  }
  return result;
}

/// Refuses boxes that have no point inside the hull of P and a triangle, or lie beyond the horizon.
class HullProbe {
public:
  /// For boxes within `all`.
  HullProbe(const Vector<double>& eye, const std::array<Vector<double>, 3>& corners, const BoundingBox& all)
      : about_(box_about(std::array<Vector<double>, 4>{eye, corners[0], corners[1], corners[2]})),
        all_(all) {}

  /// Nothing matters where m . (X - origin) < 0, the rounded m within 5 u of its size.
  void add(const Vector<double>& origin, const SizedVector<double>& inward) {
    const Vector<double> low = sizes(all_.low - origin);
    const Vector<double> high = sizes(all_.high - origin);
    const Vector<double> far{std::max(low.x, high.x), std::max(low.y, high.y), std::max(low.z, high.z)};
    // Five roundings of m, one of the difference, one of the product, two of the sum. A coordinate of m with
    // the wrong sign is at most its error: then the other end of the box gives at most twice that more.
    constexpr double roundings = 20;
    constexpr double underflow = 0x1p-600;
    planes_[count_] = {origin, inward.value,
                       -roundings * unit_roundoff<double>() * dot(inward.size, far) - underflow};
    ++count_;
  }

  [[nodiscard]] bool operator()(const BoundingBox& box) const {
    // What only touches the hull's box meets no point inside the hull.
    if (box.high.x <= about_.low.x || box.low.x >= about_.high.x || box.high.y <= about_.low.y ||
        box.low.y >= about_.high.y || box.high.z <= about_.low.z || box.low.z >= about_.high.z)
      return false;
    for (std::size_t k = 0; k < count_; ++k)
      if (planes_[k].beyond(box)) return false;
    return true;
  }

private:
  struct Plane {
    Vector<double> origin;
    Vector<double> inward;
    double least = 0;
    [[nodiscard]] bool beyond(const BoundingBox& box) const {
      const Vector<double>& m = inward;
      const Vector<double> low = box.low - origin;
      const Vector<double> high = box.high - origin;
      return std::max(m.x * low.x, m.x * high.x) + std::max(m.y * low.y, m.y * high.y) +
                 std::max(m.z * low.z, m.z * high.z) <
             least;
    }
  };
  BoundingBox about_;
  BoundingBox all_;
  std::array<Plane, 5> planes_;
  std::size_t count_ = 0;
};

}  // namespace

class PointView::Search {
public:
  Search(const Scene& scene, const Viewpoint& from) : geometry_(scene, from) {
    expects(fits(from.point), "coordinates of at most 2^100", named("x", from.point.x),
            named("y", from.point.y), named("z", from.point.z));
    expects(fits(from.normal) && !(from.normal == Vector<double>{0, 0, 0}),
            "a normal that is not zero, with coordinates of at most 2^100", named("x", from.normal.x),
            named("y", from.normal.y), named("z", from.normal.z));
    if (from.triangle)
      expects(*from.triangle < scene.triangle_count(), "a triangle of the scene",
              named("triangle", *from.triangle), named("count", scene.triangle_count()));
  }

  [[nodiscard]] const SightGeometry& geometry() const { return geometry_; }
  VisibleRegion region(std::size_t triangle);

private:
  /// Whether an occluder stands before the source in the directions that they share.
  enum class Order { before, behind, unknown };
  struct Occluder {
    std::size_t triangle = 0;
    Order order = Order::unknown;
    std::array<Side, 3> sides;
  };
  /// The cone over a triangle.
  struct Source {
    std::size_t triangle = 0;
    VertexTriple vertices{};
    std::array<Side, 3> sides;
  };

  [[nodiscard]] const Scene& scene() const { return geometry_.scene(); }
  [[nodiscard]] const Viewpoint& from() const { return geometry_.viewpoint(); }
  /// The sides (a,b), (b,c), (c,a), the cone over the triangle to their positive sides; nothing if P is in
  /// the plane.
  [[nodiscard]] int turn_of(const VertexTriple& vertices, std::array<Side, 3>& sides);
  [[nodiscard]] Spread above_horizon(const Source& source);
  [[nodiscard]] bool collect(const Source& source, bool is_cut);
  [[nodiscard]] Order order_of(const Source& source, std::size_t triangle) const;
  [[nodiscard]] bool parted(const std::array<Side, 3>& sides, const VertexTriple& vertices);
  [[nodiscard]] bool hides_all(const Source& source, const Occluder& occluder);
  void find_signs(const Cone& cone, const Side& side, Signs& signs);
  [[nodiscard]] Cone cut(const Cone& cone, const Signs& signs, const Side& side);
  [[nodiscard]] bool stands_before(const Source& source, Occluder& occluder, const Cone& shared);
  bool subtract(const Source& source, Occluder& occluder, Cone& cone, std::vector<Cone>& left);
  [[nodiscard]] VisibleRegion described(const Source& source, const std::vector<Cone>& cones, Sight sight);

  SightGeometry geometry_;
  std::optional<Side> horizon_;
  std::vector<Occluder> occluders_;
  std::array<Signs, 3> signs_;  ///< of the cone at hand, on the sides of an occluder
};

int PointView::Search::turn_of(const VertexTriple& v, std::array<Side, 3>& sides) {
  sides[0] = geometry_.side(v[0], v[1]);
  const int turn = geometry_.sign_at(sides[0], v[2]);
  if (turn == 0) return 0;
  sides[1] = geometry_.side(v[1], v[2]);
  sides[2] = geometry_.side(v[2], v[0]);
  for (Side& side : sides) side.sign *= turn;
  return turn;
}

Spread PointView::Search::above_horizon(const Source& source) {
  Spread result;
  const auto note = [&](int sign) {
    result.inside = result.inside || sign > 0;
    result.outside = result.outside || sign < 0;
  };
  if (from().triangle) {
    const auto own = scene().corners(*from().triangle);
    for (const std::size_t v : source.vertices) note(orientation(own[0], own[1], own[2], scene().vertex(v)));
    if (!(result.inside && result.outside)) return result;
    result = {};
  }
  for (const std::size_t v : source.vertices) note(geometry_.sign_at(*horizon_, v));
  return result;
}

PointView::Search::Order PointView::Search::order_of(const Source& source, std::size_t triangle) const {
  const auto t = scene().corners(source.triangle);
  const VertexTriple& vertices = scene().vertices(triangle);
  // P lies in front of the source: what is in front of its plane is nearer.
  Spread front;
  for (const std::size_t v : vertices) {
    if (std::find(source.vertices.begin(), source.vertices.end(), v) != source.vertices.end()) continue;
    const int side = orientation(t[0], t[1], t[2], scene().vertex(v));
    front.inside = front.inside || side > 0;
    front.outside = front.outside || side < 0;
  }
  if (!front.inside) return Order::behind;
  if (!front.outside) return Order::before;
  const auto o = scene().corners(triangle);
  const int eye = orientation(o[0], o[1], o[2], from().point);
  Spread near;
  for (const std::size_t v : source.vertices) {
    if (std::find(vertices.begin(), vertices.end(), v) != vertices.end()) continue;
    const int side = eye * orientation(o[0], o[1], o[2], scene().vertex(v));
    near.inside = near.inside || side > 0;
    near.outside = near.outside || side < 0;
  }
  if (!near.outside) return Order::behind;
  return near.inside ? Order::unknown : Order::before;
}

/// Whether one of the sides has the triangle on its outer side or on itself.
bool PointView::Search::parted(const std::array<Side, 3>& sides, const VertexTriple& vertices) {
  return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](std::size_t v) { return geometry_.sign_at(side, v) <= 0; });
  });
}

bool PointView::Search::hides_all(const Source& source, const Occluder& occluder) {
  return std::all_of(occluder.sides.begin(), occluder.sides.end(), [&](const Side& side) {
    return std::all_of(source.vertices.begin(), source.vertices.end(),
                       [&](std::size_t v) { return geometry_.sign_at(side, v) >= 0; });
  });
}

/// All triangles that may hide a part of the source; whether none of them hides all of it.
bool PointView::Search::collect(const Source& source, bool is_cut) {
  occluders_.clear();
  const auto corners = scene().corners(source.triangle);
  HullProbe probe(from().point, corners, scene().tree().box());
  const Vector<double>& eye = from().point;
  for (const Side& side : source.sides) probe.add(eye, geometry_.normal<double>(side));
  const Vector<double> first = corners[1] - corners[0];
  const Vector<double> second = corners[2] - corners[0];
  probe.add(corners[0], sized_cross(SizedVector<double>{first, sizes(first)}, {second, sizes(second)}));
  if (is_cut) probe.add(eye, geometry_.normal<double>(*horizon_));
  const std::size_t own = from().triangle ? scene().plane(*from().triangle) : SightGeometry::none;
  const std::size_t plane = scene().plane(source.triangle);
  return scene().tree().visit(probe, [&](std::size_t triangle) {
    if (scene().plane(triangle) == own || scene().plane(triangle) == plane) return true;
    const VertexTriple& vertices = scene().vertices(triangle);
    if (parted(source.sides, vertices)) return true;
    Occluder occluder{triangle, Order::unknown, {}};
    if (turn_of(vertices, occluder.sides) == 0 || parted(occluder.sides, source.vertices)) return true;
    occluder.order = order_of(source, triangle);
    if (occluder.order == Order::behind) return true;
    if (is_cut && std::all_of(vertices.begin(), vertices.end(),
                              [&](std::size_t v) { return geometry_.sign_at(*horizon_, v) <= 0; }))
      return true;
    if (occluder.order == Order::before && hides_all(source, occluder)) return false;
    occluders_.push_back(occluder);
    return true;
  });
}

void PointView::Search::find_signs(const Cone& cone, const Side& side, Signs& signs) {
  signs.resize(cone.corners.size());
  for (std::size_t k = 0; k < signs.size(); ++k)
    signs[k] = static_cast<std::int8_t>(geometry_.sign_at(side, cone.corners[k]));
}

/// The part of the cone to the inner side of a plane that has corners on both sides.
Cone PointView::Search::cut(const Cone& cone, const Signs& signs, const Side& side) {
  // Side k runs from corner k to corner k + 1: one leaves the inner side, one comes back, the plane runs
  // between them.
  const std::size_t count = cone.sides.size();
  const auto after = [count](std::size_t k) { return k + 1 == count ? 0 : k + 1; };
  std::size_t leaving = 0;
  while (!(signs[leaving] > 0 && signs[after(leaving)] <= 0)) ++leaving;
  std::size_t coming = 0;
  while (!(signs[coming] <= 0 && signs[after(coming)] > 0)) ++coming;
  const auto meeting = [&](const Side& first, const Side& second, std::size_t old) {
    // A vertex on the plane stays one.
    return signs[old] == 0 && cone.corners[old].vertex != SightGeometry::none
               ? SightGeometry::moved(cone.corners[old], first, second)
               : geometry_.corner(first, second);
  };
  Cone result;
  result.sides.reserve(count + 1);
  result.corners.reserve(count + 1);
  result.sides.push_back(side);
  result.corners.push_back(meeting(cone.sides[leaving], side, after(leaving)));
  result.corners.push_back(meeting(side, cone.sides[coming], coming));
  for (std::size_t k = coming;; k = after(k)) {
    result.sides.push_back(cone.sides[k]);
    if (k == leaving) break;
    result.corners.push_back(cone.corners[after(k)]);
  }
  return result;
}

/// Where the order is not known: by one direction inside both cones.
bool PointView::Search::stands_before(const Source& source, Occluder& occluder, const Cone& shared) {
  if (occluder.order != Order::unknown) return occluder.order == Order::before;
  WholeVector inside;
  for (const Corner& corner : shared.corners) inside = inside + geometry_.whole_direction(corner);
  // P + t d meets the plane of a triangle at t = det(a', b', c') / (N . d) > 0.
  struct Distance {
    WholeNumber above;
    WholeNumber below;
  };
  const auto distance = [&](const VertexTriple& v) {
    const WholeVector a = geometry_.whole_ray(v[0]);
    const WholeVector normal = cross(geometry_.whole_ray(v[1]) - a, geometry_.whole_ray(v[2]) - a);
    const WholeNumber above = dot(normal, a);
    const WholeNumber below = dot(normal, inside);
    return above.sign() < 0 ? Distance{-above, -below} : Distance{above, below};
  };
  const Distance near = distance(scene().vertices(occluder.triangle));
  const Distance far = distance(source.vertices);
  occluder.order =
      (near.above * far.below - far.above * near.below).sign() < 0 ? Order::before : Order::behind;
  return occluder.order == Order::before;
}

/// The cone minus that of the occluder, as convex cones; whether that took anything away.
bool PointView::Search::subtract(const Source& source, Occluder& occluder, Cone& cone,
                                 std::vector<Cone>& left) {
  std::array<Spread, 3> spreads;
  for (std::size_t k = 0; k < 3; ++k) {
    find_signs(cone, occluder.sides[k], signs_[k]);
    spreads[k] = spread(signs_[k]);
    if (!spreads[k].inside) {
      left.push_back(std::move(cone));
      return false;
    }
  }
  Cone rest;
  const Cone* now = &cone;
  std::vector<Cone> outside;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!spreads[k].outside) continue;  // then it is to no side of what is left of the cone either
    const Side& side = occluder.sides[k];
    if (now == &rest) {
      find_signs(rest, side, signs_[k]);
      spreads[k] = spread(signs_[k]);
    }
    if (!spreads[k].inside) {
      left.push_back(std::move(cone));
      return false;
    }
    if (!spreads[k].outside) continue;
    Cone inner = cut(*now, signs_[k], side);
    for (std::int8_t& s : signs_[k]) s = static_cast<std::int8_t>(-s);
    outside.push_back(cut(*now, signs_[k], opposite(side)));
    rest = std::move(inner);
    now = &rest;
  }
  if (!stands_before(source, occluder, *now)) {
    left.push_back(std::move(cone));
    return false;
  }
  std::move(outside.begin(), outside.end(), std::back_inserter(left));
  return true;
}

VisibleRegion PointView::Search::described(const Source& source, const std::vector<Cone>& cones,
                                           Sight sight) {
  VisibleRegion result;
  result.sight = sight;
  for (const Cone& cone : cones) {
    VisiblePart part;
    for (const Corner& corner : cone.corners)
      part.corners.push_back(geometry_.parameters(corner, source.sides, source.vertices));
    for (const Side& side : cone.sides) part.planes.push_back(geometry_.description(side));
    result.parts.push_back(std::move(part));
  }
  return result;
}

VisibleRegion PointView::Search::region(std::size_t triangle) {
  expects(triangle < scene().triangle_count(), "a triangle of the scene", named("triangle", triangle),
          named("count", scene().triangle_count()));
  if (from().triangle && scene().plane(triangle) == scene().plane(*from().triangle)) return {};
  geometry_.clear();
  horizon_ = geometry_.horizon();
  Source source{triangle, scene().vertices(triangle), {}};
  // P in front of a, b, c: det(a', b', c') < 0.
  if (turn_of(source.vertices, source.sides) >= 0) return {};
  const Spread above = above_horizon(source);
  if (!above.inside) return {};
  const bool is_cut = above.outside;
  if (!collect(source, is_cut)) return {};
  Cone cone;
  for (std::size_t k = 0; k < 3; ++k) {
    cone.sides.push_back(source.sides[k]);
    cone.corners.push_back(
        geometry_.corner_at(source.vertices[k], source.sides[(k + 2) % 3], source.sides[k]));
  }
  if (is_cut) {
    find_signs(cone, *horizon_, signs_[0]);
    cone = cut(cone, signs_[0], *horizon_);
  }
  std::vector<Cone> cones{std::move(cone)};
  bool is_whole = !is_cut;
  for (Occluder& occluder : occluders_) {
    std::vector<Cone> left;
    for (Cone& one : cones)
      if (subtract(source, occluder, one, left)) is_whole = false;
    cones = std::move(left);
    if (cones.empty()) return {};
  }
  return described(source, cones, is_whole ? Sight::whole : Sight::part);
}

PointView::PointView(const Scene& scene, const Viewpoint& from)
    : search_(std::make_unique<Search>(scene, from)) {}
PointView::PointView(PointView&&) noexcept = default;
PointView& PointView::operator=(PointView&&) noexcept = default;
PointView::~PointView() = default;

const Scene& PointView::scene() const { return search_->geometry().scene(); }
const Viewpoint& PointView::viewpoint() const { return search_->geometry().viewpoint(); }
VisibleRegion PointView::region(std::size_t triangle) { return search_->region(triangle); }

VisibleRegion visible_region(const Scene& scene, const Viewpoint& from, std::size_t triangle) {
  return PointView(scene, from).region(triangle);
}

std::vector<ParameterPoint<Rational>> exact_corners(const Scene& scene, const Viewpoint& from,
                                                    std::size_t triangle, const VisiblePart& part) {
  expects(triangle < scene.triangle_count(), "a triangle of the scene", named("triangle", triangle));
  expects(part.planes.size() >= 3, "a part with three sides at least");
  SightGeometry geometry(scene, from);
  const VertexTriple& v = scene.vertices(triangle);
  std::array<Side, 3> own;
  for (std::size_t k = 0; k < 3; ++k) {
    own[k] = geometry.side(v[k], v[(k + 1) % 3]);
    own[k].sign = -own[k].sign;  // P is in front
  }
  std::vector<Side> sides;
  for (const SightPlane& plane : part.planes) sides.push_back(geometry.side_of(plane));
  std::vector<ParameterPoint<Rational>> corners;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Corner corner = geometry.corner(sides[k == 0 ? sides.size() - 1 : k - 1], sides[k]);
    corners.push_back(geometry.exact_parameters(corner, own));
  }
  return corners;
}

}  // namespace radcert
