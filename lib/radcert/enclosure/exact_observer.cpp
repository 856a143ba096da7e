// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/exact_observer.h"

#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

Vector<Ball> in_balls(const Vector<Rational>& v) { return {Ball(v.x), Ball(v.y), Ball(v.z)}; }

Frame<Ball> frame_at(const Surface& surface, const SurfacePoint<Rational>& name) {
  expects(name.chart < surface.chart_count(), "a chart of the surface", named("chart", name.chart));
  return surface.charts[name.chart].in<Ball>().frame({Ball(name.at.s), Ball(name.at.t)});
}

}  // namespace

ExactObserver ExactObserver::on_surface(std::vector<SurfacePoint<Rational>> names) {
  expects(!names.empty(), "a point of a surface with a name");
  ExactObserver result;
  result.names_ = std::move(names);
  return result;
}

ExactObserver ExactObserver::off_surface(const Vector<Rational>& position, const Vector<Rational>& normal) {
  expects(dot(normal, normal).sign() != 0, "a normal that is not zero");
  ExactObserver result;
  result.position_ = position;
  result.normal_ = normal;
  return result;
}

std::optional<ParameterPoint<Rational>> ExactObserver::on_chart(std::size_t chart) const {
  for (const SurfacePoint<Rational>& name : names_)
    if (name.chart == chart) return name.at;
  return std::nullopt;
}

bool ExactObserver::in_plane_of(const Surface& surface, std::size_t chart) const {
  const Chart& other = surface.charts[chart];
  const std::optional<Plane>& plane = other.facts().flat_in();
  if (!plane) return false;
  if (names_.empty()) return dot(plane->normal(), position_) == plane->offset();
  for (const SurfacePoint<Rational>& name : names_)
    if (name.chart == chart || in_one_plane(surface.charts[name.chart], other)) return true;
  return false;
}

Vector<Ball> ExactObserver::position(const Surface& surface) const {
  return names_.empty() ? in_balls(position_) : frame_at(surface, names_.front()).point;
}

Vector<Ball> ExactObserver::normal(const Surface& surface) const {
  if (!names_.empty()) return unit_normal(frame_at(surface, names_.front()));
  const Vector<Ball> direction = in_balls(normal_);
  return (1 / sqrt(Ball(dot(normal_, normal_)))) * direction;
}

}  // namespace radcert
