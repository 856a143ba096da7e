// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/source_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/continuous/elements/analytic_error.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

RuleChoice choose_rule(double distance, double half, double part, double height, double area,
                       double jacobian_part, std::span<const double> sizes, double allowed) {
  RuleChoice best{.nodes = 0, .error = infinity};
  for (const double share : {0.5, 0.7}) {
    const double reach = share * distance;
    const double axis = reach / half;
    if (!(axis > 1.02)) continue;
    const double rho = axis + std::sqrt(axis * axis - 1);
    const double bound = std::numbers::inv_pi * area * kernel_in_ellipse(distance, reach, height) *
                         (1 + jacobian_part * axis) * size_in_ellipse(sizes, ellipse_around(part, axis)) *
                         upward;
    if (!(bound > 0)) return {.nodes = 1, .error = bound == 0 ? 0 : infinity};
    const int most = best.nodes == 0 ? most_source_nodes : best.nodes;
    GaussMeanErrors errors(rho);
    for (int nodes = 1; nodes <= most; ++nodes) {
      const double error = errors.next() * bound * upward;
      if (!(error <= allowed)) continue;
      if (nodes < most || best.nodes == 0 || error < best.error) best = {nodes, error};
      break;
    }
  }
  return best;
}

}  // namespace

ObserverBall ball_about(std::span<const Vector<double>> points, double extent) {
  Vector<double> least = points[0];
  Vector<double> largest = points[0];
  for (const Vector<double>& p : points) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    largest = {std::max(largest.x, p.x), std::max(largest.y, p.y), std::max(largest.z, p.z)};
  }
  ObserverBall ball{.centre = 0.5 * (least + largest), .radius = 0};
  for (const Vector<double>& p : points) ball.radius = std::max(ball.radius, norm(p - ball.centre));
  ball.radius = ball.radius * upward + displacement * extent;
  return ball;
}

double SeenPart::least_distance() const { return std::max(to_s - half_s, to_t - half_t); }

SeenPart seen_part(const SectorScene& scene, const SectorElement& element, const SectorBox& box,
                   const ObserverBall& ball) {
  const Sector& sector = scene.sectors()[element.sector];
  const double s = box.middle_s();
  const double t = box.middle_t();
  const double slack = ball.radius + displacement * scene.extent();
  const Vector<double> to_start = sector.c - sector.point(box.s0, 0);
  const Vector<double> to_end = sector.c - sector.point(box.s1, 0);
  const double rounding = 4 * displacement * scene.extent();
  SeenPart out;
  out.area = sector.jacobian * box.weight() * upward;
  out.half_s = 0.5 * (1 - box.t0) * (box.s1 - box.s0) * (norm(sector.b - sector.a) + rounding) * upward;
  out.half_t = 0.5 * (box.t1 - box.t0) * (std::max(norm(to_start), norm(to_end)) + rounding) * upward;
  out.to_s = distance(ball.centre, sector.point(s, box.t0), sector.point(s, box.t1)) / upward - slack;
  out.to_t = distance(ball.centre, sector.point(box.s0, t), sector.point(box.s1, t)) / upward - slack;
  out.part_s = (box.s1 - box.s0) / (element.box.s1 - element.box.s0);
  out.part_t = (box.t1 - box.t0) / (element.box.t1 - element.box.t0);
  out.jacobian_part = 0.5 * (box.t1 - box.t0) / (1 - t);
  return out;
}

double kernel_in_ellipse(double distance, double reach, double height) {
  const double nearest = distance - reach;
  return std::min(distance, height) / (nearest * nearest * nearest);
}

RuleChoice rule_in_s(const SeenPart& part, double height, std::span<const double> sizes, double allowed) {
  return choose_rule(part.to_s, part.half_s, part.part_s, height, part.area, 0, sizes, allowed);
}

RuleChoice rule_in_t(const SeenPart& part, double height, std::span<const double> sizes, double allowed) {
  return choose_rule(part.to_t, part.half_t, part.part_t, height, part.area, part.jacobian_part, sizes,
                     allowed);
}

}  // namespace radcert
