// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/events/event_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane.h"

namespace radcert {
namespace {

/// To nearest, if products of two are then normal numbers; else nothing that a filter takes.
double rounded(const Rational& x) {
  constexpr double least = 0x1p-400;
  constexpr double most = 0x1p400;
  const double value = x.to_double();
  if (x.sign() == 0 || (std::abs(value) >= least && std::abs(value) <= most)) return value;
  return std::numeric_limits<double>::infinity();
}

Rational cross_product(const PencilPoint& a, const PencilPoint& b) { return a.x * b.y - a.y * b.x; }

/// Whether both lie in one open quadrant that no line of the pencil enters.
bool beside_pencil(const PencilPoint& p, const PencilPoint& q) {
  const auto beside = [](const PencilPoint& point, int sign) {
    return sign * point.x.sign() > 0 && sign * point.y.sign() < 0;
  };
  return (beside(p, 1) && beside(q, 1)) || (beside(p, -1) && beside(q, -1));
}

/// The l of the line through a point, if it is one of the pencil's.
std::optional<Rational> line_through(const PencilPoint& point) {
  const int x = point.x.sign();
  const int y = point.y.sign();
  if (x * y < 0 || (x == 0 && y == 0)) return std::nullopt;
  return point.y / (point.x + point.y);
}

}  // namespace

PencilPoint pencil_point(Rational x, Rational y) {
  const ParameterPoint<double> near{rounded(x), rounded(y)};
  return {.x = std::move(x), .y = std::move(y), .rounded = near};
}

int cross_sign(const PencilPoint& a, const PencilPoint& b) {
  const double first = a.rounded.s * b.rounded.t;
  const double second = a.rounded.t * b.rounded.s;
  const double size = std::abs(first) + std::abs(second);
  const double difference = first - second;
  constexpr double eight_roundings = 0x1p-50;
  if (std::isfinite(size) && std::abs(difference) > eight_roundings * size) return difference > 0 ? 1 : -1;
  return cross_product(a, b).sign();
}

PlaneSigns plane_signs(const Scene& scene, const EventEdges& edges, const Vector<double>& a,
                       const Vector<double>& b, const Vector<double>& c) {
  expects(!collinear(a, b, c), "three points that are not on one line");
  PlaneSigns signs(scene.mesh().vertices.size(), 0);
  for (std::size_t w = 0; w < signs.size(); ++w)
    if (!edges.triangles_at[w].empty()) signs[w] = orientation(a, b, c, scene.vertex(w));
  return signs;
}

EventPlane::EventPlane(const Scene& scene, const EventEdges& edges, const PlaneSigns& signs,
                       PencilFrame frame)
    : scene_(&scene),
      signs_(&signs),
      frame_(std::move(frame)),
      plane_normal_(radcert::cross(frame_.from, frame_.to)) {
  expects(!is_zero(plane_normal_), "two independent directions");
  for (std::size_t t = 0; t < scene.triangle_count(); ++t) cross(t);
  for (const EventEdge& edge : edges.edges)
    if (signs[edge.from] == 0 && signs[edge.to] == 0 && !edge.flat) touch(edge);
}

PencilPoint EventPlane::point(const Vector<Rational>& q) const {
  const auto solved = [&](const Rational& n, const Rational& qi, const Rational& qj, const Rational& ai,
                          const Rational& aj, const Rational& bi, const Rational& bj) {
    return pencil_point((qi * bj - qj * bi) / n, (ai * qj - aj * qi) / n);
  };
  const Vector<Rational>& a = frame_.from;
  const Vector<Rational>& b = frame_.to;
  if (plane_normal_.z.sign() != 0) return solved(plane_normal_.z, q.x, q.y, a.x, a.y, b.x, b.y);
  if (plane_normal_.y.sign() != 0) return solved(plane_normal_.y, q.z, q.x, a.z, a.x, b.z, b.x);
  return solved(plane_normal_.x, q.y, q.z, a.y, a.z, b.y, b.z);
}

void EventPlane::cross(std::size_t triangle) {
  const VertexTriple& v = scene_->vertices(triangle);
  const auto [least, most] = std::minmax({(*signs_)[v[0]], (*signs_)[v[1]], (*signs_)[v[2]]});
  if (least >= 0 || most <= 0) return;
  static const std::array<ParameterPoint<Rational>, 3> corners{
      ParameterPoint<Rational>{0, 0}, ParameterPoint<Rational>{1, 0}, ParameterPoint<Rational>{0, 1}};
  std::vector<std::pair<PencilPoint, ParameterPoint<Rational>>> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vector<Rational> p = exactly(scene_->vertex(v[i])) - frame_.centre;
    if ((*signs_)[v[i]] == 0) ends.emplace_back(point(p), corners[i]);
    if ((*signs_)[v[i]] * (*signs_)[v[j]] >= 0) continue;
    const Vector<Rational> q = exactly(scene_->vertex(v[j])) - frame_.centre;
    const Rational height = dot(plane_normal_, p);
    const Rational part = height / (height - dot(plane_normal_, q));
    ends.emplace_back(point(p + part * (q - p)), corners[i] + part * (corners[j] - corners[i]));
  }
  if (beside_pencil(ends[0].first, ends[1].first)) return;
  crossings_.push_back({.triangle = triangle,
                        .p = std::move(ends[0].first),
                        .q = std::move(ends[1].first),
                        .at_p = std::move(ends[0].second),
                        .at_q = std::move(ends[1].second),
                        .normal = normal(triangle)});
}

ParameterPoint<Rational> EventPlane::normal(std::size_t triangle) const {
  const auto [c0, c1, c2] = scene_->corners(triangle);
  const Vector<Rational> origin = exactly(c0);
  const Vector<Rational> front = radcert::cross(exactly(c1) - origin, exactly(c2) - origin);
  return {dot(front, frame_.from), dot(front, frame_.to)};
}

void EventPlane::touch(const EventEdge& edge) {
  bool above = false;
  bool below = false;
  bool within = false;
  for (const std::size_t w : edge.opposite) {
    above = above || (*signs_)[w] > 0;
    below = below || (*signs_)[w] < 0;
    within = within || (*signs_)[w] == 0;
  }
  // A line along a face goes on over a convex edge and ends at the wall behind a concave one.
  PlaneContact contact{.p = point(exactly(scene_->vertex(edge.from)) - frame_.centre),
                       .q = point(exactly(scene_->vertex(edge.to)) - frame_.centre),
                       .blocks = (above && below) || (within && !edge.convex)};
  if (!beside_pencil(contact.p, contact.q)) contacts_.push_back(std::move(contact));
}

std::vector<Rational> EventPlane::turns() const {
  std::vector<Rational> all{0, 1};
  const auto add = [&](const PencilPoint& point) {
    if (std::optional<Rational> l = line_through(point)) all.push_back(std::move(*l));
  };
  for (const PlaneCrossing& crossing : crossings_) {
    add(crossing.p);
    add(crossing.q);
  }
  for (const PlaneContact& contact : contacts_) {
    add(contact.p);
    add(contact.q);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

PencilPoint EventPlane::direction(const Rational& l) { return pencil_point(Rational(1) - l, l); }

std::vector<std::size_t> EventPlane::met(const PencilPoint& direction) const {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < crossings_.size(); ++k)
    if (cross_sign(direction, crossings_[k].p) * cross_sign(direction, crossings_[k].q) < 0)
      places.push_back(k);
  return places;
}

std::optional<SightEnd> EventPlane::end(const PencilPoint& direction, int way) const {
  std::optional<SightEnd> first;
  const auto consider = [&](const PencilPoint& p, const PencilPoint& q, std::optional<std::size_t> crossing) {
    const Rational at_p = cross_product(direction, p);
    const Rational at_q = cross_product(direction, q);
    // p + m (q - p) = distance * direction
    const Rational distance = cross_product(p, q) / (at_q - at_p);
    if (distance.sign() != way) return;
    if (!first || abs(distance) < abs(first->distance))
      first = SightEnd{.distance = distance, .crossing = crossing};
  };
  for (const std::size_t k : met(direction)) consider(crossings_[k].p, crossings_[k].q, k);
  for (const PlaneContact& contact : contacts_)
    if (contact.blocks && cross_sign(direction, contact.p) * cross_sign(direction, contact.q) < 0)
      consider(contact.p, contact.q, std::nullopt);
  return first;
}

ParameterPoint<Rational> EventPlane::place(const PencilPoint& direction,
                                           const PlaneCrossing& crossing) const {
  const Rational at_p = cross_product(direction, crossing.p);
  const Rational at_q = cross_product(direction, crossing.q);
  const Rational part = at_p / (at_p - at_q);
  return crossing.at_p + part * (crossing.at_q - crossing.at_p);
}

}  // namespace radcert
