// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/sight_geometry.h"

#include <algorithm>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// The sign of a . b; 0 where it is not certain.
int certain_sign(const SizedVector<double>& a, const SizedVector<double>& b) {
  const double value = dot(a.value, b.value);
  const double bound = dot_rounding(a, b);
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

}  // namespace

SightGeometry::SightGeometry(const Scene& scene, const Viewpoint& from)
    : scene_(&scene),
      from_(from),
      exponent_(std::min(scene.lowest_exponent(), lowest_exponent(from.point))),
      normal_exponent_(lowest_exponent(from.normal)) {}

std::size_t SightGeometry::add(std::size_t from, std::size_t to) {
  Plane plane;
  plane.from = from;
  plane.to = to;
  planes_.push_back(std::move(plane));
  const std::size_t number = planes_.size() - 1;
  planes_[number].normal = normal<double>({number, 1});
  return number;
}

SightGeometry::Side SightGeometry::side(std::size_t from, std::size_t to) {
  if (from < to) return {add(from, to), 1};
  return {add(to, from), -1};
}

SightGeometry::Side SightGeometry::horizon() { return {add(none, none), 1}; }

SightGeometry::Side SightGeometry::side_of(const SightPlane& plane) {
  return {add(plane.from, plane.to), plane.sign};
}

SightPlane SightGeometry::description(const Side& side) const {
  return {planes_[side.plane].from, planes_[side.plane].to, side.sign};
}

SightGeometry::Corner SightGeometry::corner(const Side& first, const Side& second) {
  Corner result{first, second, none, 1, {}};
  const Plane& p = planes_[first.plane];
  const Plane& q = planes_[second.plane];
  if (p.from != none && q.from != none) {
    if (p.from == q.from || p.from == q.to) {
      result.vertex = p.from;
    } else if (p.to == q.from || p.to == q.to) {
      result.vertex = p.to;
    }
  }
  if (result.vertex != none) {
    // n_q x (v' x w') = (n_q . w') v', for n_q . v' = 0; the other way round where v is the end of the side.
    const bool begins = result.vertex == p.from;
    const int along = sign_at(second, begins ? p.to : p.from);
    result.sign = first.sign * (begins ? along : -along);
  }
  result.direction = direction<double>(result);
  return result;
}

SightGeometry::Corner SightGeometry::corner_at(std::size_t vertex, const Side& first,
                                               const Side& second) const {
  Corner result{first, second, vertex, 1, {}};
  result.direction = direction<double>(result);
  return result;
}

int SightGeometry::sign_at(const Side& side, std::size_t vertex) {
  const Plane& plane = planes_[side.plane];
  if (plane.from == vertex || plane.to == vertex) return 0;
  const int sign = certain_sign(ray<double>(vertex), plane.normal);
  if (sign != 0) return side.sign * sign;
  return side.sign * dot(exact_normal(side.plane), whole_ray(vertex)).sign();
}

int SightGeometry::sign_at(const Side& side, const Corner& corner) {
  if (same_plane(side.plane, corner.first.plane) || same_plane(side.plane, corner.second.plane)) return 0;
  if (corner.vertex != none) return corner.sign * sign_at(side, corner.vertex);
  const int sign = certain_sign(corner.direction, planes_[side.plane].normal);
  if (sign != 0) return side.sign * sign;
  return side.sign * dot(whole_direction(corner), exact_normal(side.plane)).sign();
}

WholeVector SightGeometry::whole_ray(std::size_t vertex) const {
  return scaled(scene_->vertex(vertex), exponent_) - scaled(from_.point, exponent_);
}

const WholeVector& SightGeometry::exact_normal(std::size_t plane) {
  Plane& p = planes_[plane];
  if (!p.exact)
    p.exact =
        p.from == none ? scaled(from_.normal, normal_exponent_) : cross(whole_ray(p.from), whole_ray(p.to));
  return *p.exact;
}

WholeVector SightGeometry::whole_normal(const Side& side) {
  const WholeVector& n = exact_normal(side.plane);
  return side.sign > 0 ? n : -n;
}

WholeVector SightGeometry::whole_direction(const Corner& corner) {
  if (corner.vertex == none) return cross(whole_normal(corner.second), whole_normal(corner.first));
  const WholeVector ray = whole_ray(corner.vertex);
  return corner.sign > 0 ? ray : -ray;
}

std::array<WholeNumber, 3> SightGeometry::weights(const Corner& corner, const std::array<Side, 3>& sides) {
  const WholeVector d = whole_direction(corner);
  return {dot(d, whole_normal(sides[1])), dot(d, whole_normal(sides[2])), dot(d, whole_normal(sides[0]))};
}

ParameterPoint<Rational> SightGeometry::exact_parameters(const Corner& corner,
                                                         const std::array<Side, 3>& sides) {
  const auto [first, second, third] = weights(corner, sides);
  const Rational sum = (first + second + third).to_rational();
  return {second.to_rational() / sum, third.to_rational() / sum};
}

ParameterPoint<double> SightGeometry::parameters(const Corner& corner, const std::array<Side, 3>& sides,
                                                 const VertexTriple& vertices) {
  if (corner.vertex == vertices[0]) return {0, 0};
  if (corner.vertex == vertices[1]) return {1, 0};
  if (corner.vertex == vertices[2]) return {0, 1};
  using F = long double;
  const SizedVector<F> d = direction<F>(corner);
  // A vertex' ray has k = 1 in place of 13.
  constexpr int with_ray = roundings_of_dot - SightGeometry::rounding_of_direction + 1;
  const int k_of_dot = corner.vertex == none ? roundings_of_dot : with_ray;
  std::array<F, 3> weight{};
  F bound = 0;
  F largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (same_plane(sides[k].plane, corner.first.plane) || same_plane(sides[k].plane, corner.second.plane))
      continue;
    const SizedVector<F> m = normal<F>(sides[k]);
    weight[k] = dot(d.value, m.value);
    const F own = dot_rounding(d, m, k_of_dot);
    bound += own;
    largest = std::max(largest, own);
  }
  const F sum = weight[0] + weight[1] + weight[2];
  // |x/y - x'/y'| <= (|x - x'| + |y - y'|) / y' for x <= y; the rounding to a double, at most 2^-54, leaves
  // 2^-51 in all.
  constexpr F accuracy = 0x1.8p-52L;
  if (!(bound + largest <= accuracy * sum)) {
    const auto [first, second, third] = weights(corner, sides);
    const WholeNumber total = first + second + third;
    return {static_cast<double>(quotient(second, total)), static_cast<double>(quotient(third, total))};
  }
  const auto part = [&](F w) { return std::clamp(static_cast<double>(w / sum), 0.0, 1.0); };
  return {part(weight[2]), part(weight[0])};
}

}  // namespace radcert
