// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/vertex_disks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// phi of VertexDisks for a disk of radius a, D or more away.
/// Result    rounded up: with x = sin alpha the sine's inverse, the root and the products are off by 4 u x in
///           all, beside which little is left of a small phi
double half_cone(double a, double D) {
  if (a > D) return 1;
  const double x = std::min(1.0, a / D * upward);
  const double computed = (std::asin(x) - x * std::sqrt((1 - x) * (1 + x))) * std::numbers::inv_pi;
  return std::min(0.5 * x * x * x, computed + 4 * unit_roundoff<double>() * x) * upward;
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
  half_distance_ = std::max(0.0, 0.5 * (nearest - slack_) / upward);
  for (std::size_t i = 0; i < scene.panels().size(); ++i) {
    const Panel& panel = scene.panels()[i];
    Receiver receiver;
    for (std::size_t v = 0; v < exact.size(); ++v) {
      if (dot(panel.normal, exact[v] - panel.corners[0]).sign() == 0) {
        ++receiver.in_plane;
        continue;
      }
      const double computed = dot(scene.normal(i), vertices_[v] - scene.sectors()[scene.first_sector(i)].a);
      const double height = std::max(0.0, (std::abs(computed) - slack_) / upward);
      receiver.inverse_squares += 1 / (height * height) * upward;
    }
    receivers_.push_back(receiver);
  }
}

double VertexDisks::mass(double radius, double distance) const {
  expects(radius >= 0 && distance > 0, "0 <= radius, 0 < distance", named("radius", radius),
          named("distance", distance));
  const double nearest = half_cone(radius, distance);
  const double others = half_cone(radius, std::max(distance, half_distance_));
  double most = 0;
  for (const Receiver& receiver : receivers_) {
    const double sum =
        (nearest + (receiver.in_plane - 1) * others + radius * radius * receiver.inverse_squares) * upward;
    if (!(sum < 1)) return 1;
    most = std::max(most, sum);
  }
  return most;
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
