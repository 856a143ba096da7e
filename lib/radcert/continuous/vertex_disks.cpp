// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/vertex_disks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a vertex lies on a panel: at which angle, in its plane beside it, or above it.
struct Place {
  bool in_plane = false;
  bool on_panel = false;
  double angle = 0;  ///< of the panel about it
};

/// Maths     on a side that is none of its ends pi, inside 2 pi
Place place_on(const Panel& panel, const Vector<Rational>& vertex, const SectorScene& scene) {
  Place place;
  const std::vector<Vector<Rational>>& corners = panel.corners;
  place.in_plane = dot(panel.normal, vertex - corners[0]).sign() == 0;
  if (!place.in_plane) return place;
  const std::size_t n = corners.size();
  place.on_panel = true;
  bool inside = true;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector<Rational>& from = corners[k];
    const Vector<Rational>& to = corners[(k + 1) % n];
    const int side = dot(cross(to - from, vertex - from), panel.normal).sign();
    place.on_panel = place.on_panel && side >= 0;
    inside = inside && side > 0;
  }
  if (!place.on_panel) return place;
  place.angle = inside ? 2 * std::numbers::pi : std::numbers::pi;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(corners[k] == vertex)) continue;
    const Vector<double> here = scene.place(vertex);
    const Vector<double> one = scene.place(corners[(k + 1) % n]) - here;
    const Vector<double> other = scene.place(corners[(k + n - 1) % n]) - here;
    place.angle = std::atan2(norm(cross(one, other)), dot(one, other));
  }
  return place;
}

/// Above the roundings of places, of an angle between sides that are short beside the extent as well.
double angle_slack(const SectorScene& scene, double shortest) {
  return 64 * displacement * scene.extent() / shortest;
}

}  // namespace

VertexDisks::VertexDisks(const SectorScene& scene) : slack_(4 * displacement * scene.extent()) {
  std::vector<Vector<Rational>> exact;
  for (const Panel& panel : scene.panels())
    for (const Vector<Rational>& corner : panel.corners)
      if (std::find(exact.begin(), exact.end(), corner) == exact.end()) exact.push_back(corner);
  double nearest = infinity;
  for (const Vector<Rational>& vertex : exact) {
    const Vector<double> here = scene.place(vertex);
    for (const Vector<double>& other : vertices_) nearest = std::min(nearest, norm(here - other));
    vertices_.push_back(here);
  }
  nearest -= slack_;
  half_distance_ = 0.5 * nearest / upward;
  double clear = half_distance_;
  const std::size_t panels = scene.panels().size();
  receivers_.resize(panels);
  for (std::size_t v = 0; v < exact.size(); ++v) {
    std::vector<Place> places;
    for (const Panel& panel : scene.panels()) places.push_back(place_on(panel, exact[v], scene));
    std::vector<double> distances(panels);
    for (std::size_t i = 0; i < panels; ++i) {
      if (places[i].on_panel) continue;
      const Sector& first = scene.sectors()[scene.first_sector(i)];
      double radius = 0;
      double to_sides = infinity;
      for (std::size_t s = scene.first_sector(i); s < scene.first_sector(i + 1); ++s) {
        const Sector& sector = scene.sectors()[s];
        radius = std::max(radius, norm(sector.a - first.c));
        to_sides = std::min(to_sides, distance(vertices_[v], sector.a, sector.b));
      }
      const double height = dot(scene.normal(i), vertices_[v] - first.a);
      const double found =
          places[i].in_plane ? to_sides : std::max(height, norm(vertices_[v] - first.c) - radius);
      distances[i] = (found - slack_) / upward;
      clear = std::min(clear, distances[i]);
    }
    for (std::size_t i = 0; i < panels; ++i) {
      double squares = 0;
      double angles = 0;
      for (std::size_t j = 0; j < panels; ++j) {
        if (!places[j].on_panel || scene.coplanar(i, j)) continue;
        const double angle = places[j].angle + angle_slack(scene, nearest);
        const double cosine = dot(scene.normal(i), scene.normal(j));
        squares += angle * std::min(1.0, 1 - cosine * cosine + 64 * unit_roundoff<double>());
        angles += angle;
      }
      Receiver& receiver = receivers_[i];
      if (places[i].in_plane) {
        const double at_vertex = squares / (3 * std::numbers::pi) * upward;
        receiver.largest_at_vertex = std::max(receiver.largest_at_vertex, at_vertex);
        receiver.all_at_vertices += at_vertex * upward;
      } else {
        receiver.beyond.push_back(
            {.angles = angles / (2 * std::numbers::pi) * upward, .distance = distances[i]});
      }
    }
  }
  largest_radius_ = 0.25 * clear;
}

double VertexDisks::mass(double radius, double distance) const {
  expects(radius <= largest_radius_, "radius <= largest_radius()", named("radius", radius));
  const double reach = (distance - radius) / upward;
  if (!(reach > 0)) return 1;
  const auto cube = [](double x) { return x * x * x; };
  double most = 0;
  for (const Receiver& receiver : receivers_) {
    double sum = receiver.largest_at_vertex * cube(radius / reach) +
                 receiver.all_at_vertices * cube(radius / (half_distance_ - radius));
    for (const Receiver::Beyond& beyond : receiver.beyond) {
      const double quotient = radius / (beyond.distance - radius);
      sum += beyond.angles * quotient * quotient;
    }
    most = std::max(most, sum * upward);
  }
  return std::min(1.0, most);
}

double VertexDisks::distance_at_most(const Sector& sector, const SectorBox& box) const {
  double least = infinity;
  for (const Vector<double>& vertex : vertices_) {
    double most = 0;
    for (const double s : {box.s0, box.s1})
      for (const double t : {box.t0, box.t1}) most = std::max(most, norm(sector.point(s, t) - vertex));
    least = std::min(least, most);
  }
  return least * upward + slack_;
}

double VertexDisks::distance_at_least(const Sector& sector, const SectorBox& box) const {
  const Vector<double> middle = sector.point(box.middle_s(), box.middle_t());
  double radius = 0;
  for (const double s : {box.s0, box.s1})
    for (const double t : {box.t0, box.t1}) radius = std::max(radius, norm(sector.point(s, t) - middle));
  double least = infinity;
  for (const Vector<double>& vertex : vertices_) least = std::min(least, norm(middle - vertex));
  return std::max(0.0, least / upward - radius * upward - slack_);
}

std::vector<double> supersolution(const VertexDisks& disks, std::span<const double> radii,
                                  std::span<const double> residuals, double gap) {
  const std::size_t shells = residuals.size();
  expects(radii.size() + 1 == shells, "one radius fewer than shells", named("radii", radii.size()));
  const double s = (1 - gap) * upward;
  std::vector<double> masses(shells * shells, 1.0);
  for (std::size_t m = 0; m < radii.size(); ++m)
    for (std::size_t k = m + 1; k < shells; ++k) masses[m * shells + k] = disks.mass(radii[k - 1], radii[m]);
  std::vector<double> z(shells, s / gap * residuals.back() * upward);
  constexpr int most_steps = 10000;
  constexpr double worth_a_step = 1e-3;
  for (int step = 0; step < most_steps; ++step) {
    std::vector<double> next(shells);
    double change = 0;
    for (std::size_t m = 0; m < shells; ++m) {
      double sum = residuals[0] + z[0];
      for (std::size_t k = 1; k < shells; ++k) {
        const double more = (residuals[k] + z[k]) - (residuals[k - 1] + z[k - 1]);
        sum += std::max(0.0, more) * masses[m * shells + k] +
               4 * unit_roundoff<double>() * (residuals[k] + z[k]);
      }
      next[m] = std::min(z[m], s * sum * upward);
      if (z[m] > 0) change = std::max(change, 1 - next[m] / z[m]);
    }
    z = std::move(next);
    if (change < worth_a_step) break;
  }
  return z;
}

}  // namespace radcert
