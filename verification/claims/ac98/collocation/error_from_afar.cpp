// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/error_from_afar.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/reference/operator_integral.h"

namespace radcert::verification::ac98 {
namespace {

double size(const Surface& surface, const ParameterTriangle& element) {
  std::array<Vector<double>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners.at(i) = surface.charts.at(element.chart).in<double>().frame(element.vertices.at(i)).point;
  return std::max(
      {norm(corners[1] - corners[0]), norm(corners[2] - corners[1]), norm(corners[0] - corners[2])});
}

// Int G (u - P_n u) over an element away from P, by one rule.
double by_rule(const Frame<double>& p, const InterpolationError& error, const TriangleRule<double>& rule) {
  const ParameterTriangle& element = error.element();
  const auto& v = element.vertices;
  const double twice_the_area = std::abs(cross(v[1] - v[0], v[2] - v[0]));
  const ChartIn<double>& chart = error.surface().charts.at(element.chart).in<double>();
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const ParameterPoint<double> at = element.at(rule.points[i].x);
    const Frame<double> q = chart.frame(at);
    // G is linear in the normals: the area normal carries the area element.
    sum += rule.weights[i] * geometric_kernel(p.point, p.area_normal, q.point, q.area_normal) *
           error({element.chart, at}, q.point);
  }
  return twice_the_area * sum / norm(p.area_normal);
}

// Two rules by the distance from an element's centroid in sizes of the element: up to 3, up to 12, beyond.
struct RulePair {
  TriangleRule<double> coarse;
  TriangleRule<double> fine;
};
const RulePair& rules_at(double distance) {
  static const std::array<RulePair, 3> pairs{
      RulePair{conical_rule<double>(12, Grading::none), conical_rule<double>(16, Grading::none)},
      RulePair{conical_rule<double>(4, Grading::none), conical_rule<double>(6, Grading::none)},
      RulePair{conical_rule<double>(3, Grading::none), conical_rule<double>(4, Grading::none)}};
  return pairs[distance < 3 ? 0 : distance < 12 ? 1 : 2];
}

Approximation seen_from(const Frame<double>& frame, const SurfacePoint<double>& p,
                        const InterpolationError& error) {
  const ParameterTriangle& element = error.element();
  const ParameterPoint<double> middle = element.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
  const Surface& surface = error.surface();
  const double distance =
      norm(surface.charts.at(element.chart).in<double>().frame(middle).point - frame.point) /
      size(surface, element);
  if (distance < 1) return reference::operator_integral(surface, p, element.chart, element.vertices, error);
  const RulePair& rules = rules_at(distance);
  const double value = by_rule(frame, error, rules.fine);
  return {.value = value, .radius = std::abs(value - by_rule(frame, error, rules.coarse))};
}

}  // namespace

double wave(const Vector<double>& q) { return std::exp(q.x + q.y / 2 - q.z / 3); }

InterpolationError::InterpolationError(const Surface& surface, const ParameterTriangle& element, double alpha)
    : surface_(&surface), element_(element), alpha_(alpha) {
  const ChartIn<double>& chart = surface.charts.at(element.chart).in<double>();
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<double, 3> x{alpha, alpha, alpha};
    x.at(j) = 1 - 2 * alpha;
    at_nodes_.at(j) = wave(chart.frame(element.at(x)).point);
  }
}

double InterpolationError::operator()(const SurfacePoint<double>& q, const Vector<double>& point) const {
  const auto& v = element_.vertices;
  const double area = cross(v[1] - v[0], v[2] - v[0]);
  const double x_2 = cross(q.at - v[0], v[2] - v[0]) / area;
  const double x_3 = cross(v[1] - v[0], q.at - v[0]) / area;
  const std::array<double, 3> x{1 - x_2 - x_3, x_2, x_3};
  const double u = wave(point);
  double value = 0;
  for (std::size_t j = 0; j < 3; ++j) value += (u - at_nodes_.at(j)) * (x.at(j) - alpha_) / (1 - 3 * alpha_);
  return value;
}

Approximation error_seen_from(const Surface& surface, const SurfacePoint<double>& p,
                              const std::vector<ParameterTriangle>& elements, double alpha) {
  const Frame<double> frame = surface.charts.at(p.chart).in<double>().frame(p.at);
  const Approximation none{.value = 0, .radius = 0};
  constexpr std::size_t at_a_time = 1024;
  return parallel_reduce_ordered(
      elements.size(), at_a_time, none,
      [&](std::size_t begin, std::size_t end) {
        Approximation sum = none;
        for (std::size_t k = begin; k < end; ++k) {
          const Approximation part = seen_from(frame, p, InterpolationError(surface, elements[k], alpha));
          sum.value += part.value;
          sum.radius += part.radius;
        }
        return sum;
      },
      [](const Approximation& a, const Approximation& b) {
        return Approximation{.value = a.value + b.value, .radius = a.radius + b.radius};
      });
}

}  // namespace radcert::verification::ac98
