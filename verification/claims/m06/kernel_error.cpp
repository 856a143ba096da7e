// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/kernel_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"

namespace radcert::verification::m06 {
namespace {

// Int G(P,Q) (u - P_n u) dS over elements, P a node of one of them or of another piece.
class KernelIntegral {
public:
  KernelIntegral(const Surface& surface, const SurfacePoint<double>& p, int order)
      : surface_(&surface),
        p_(p),
        frame_(surface.charts[p.chart].in<double>().frame(p.at)),
        normal_(unit_normal(frame_)),
        rule_(conical_rule<double>(order, Grading::none)) {}

  // Triangles about P are cut at P, where G has a value for each direction: the rule is collapsed there.
  [[nodiscard]] double over(const ParameterTriangle& t, const InterpolationRemainder& rest) const {
    if (t.chart != p_.chart) return from_another_chart(t, rest);
    const auto& [v1, v2, v3] = t.vertices;
    if (contains(t)) {
      return by_rule({t.chart, {p_.at, v1, v2}}, rest) + by_rule({t.chart, {p_.at, v2, v3}}, rest) +
             by_rule({t.chart, {p_.at, v3, v1}}, rest);
    }
    const ParameterPoint<double> middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
    const double width = std::max({squared(v1 - v2), squared(v2 - v3), squared(v3 - v1)});
    if (squared(middle - p_.at) > 4 * width) return by_rule(t, rest);
    double sum = 0;
    for (const ParameterTriangle& quarter : quarters(t)) sum += over(quarter, rest);
    return sum;
  }

private:
  // As over, by lengths in space.
  [[nodiscard]] double from_another_chart(const ParameterTriangle& t,
                                          const InterpolationRemainder& rest) const {
    const ChartIn<double>& chart = surface_->charts[t.chart].in<double>();
    const auto point = [&](const ParameterPoint<double>& at) { return chart.frame(at).point; };
    const auto& [v1, v2, v3] = t.vertices;
    const double width =
        std::max({norm(point(v1) - point(v2)), norm(point(v2) - point(v3)), norm(point(v3) - point(v1))});
    if (norm(point(t.at({1.0 / 3, 1.0 / 3, 1.0 / 3})) - frame_.point) > 1.5 * width) return by_rule(t, rest);
    double sum = 0;
    for (const ParameterTriangle& quarter : quarters(t)) sum += from_another_chart(quarter, rest);
    return sum;
  }

  static std::array<ParameterTriangle, 4> quarters(const ParameterTriangle& t) {
    const auto& [v1, v2, v3] = t.vertices;
    const ParameterPoint<double> m12 = 0.5 * (v1 + v2);
    const ParameterPoint<double> m23 = 0.5 * (v2 + v3);
    const ParameterPoint<double> m31 = 0.5 * (v3 + v1);
    return {{{t.chart, {v1, m12, m31}},
             {t.chart, {m12, v2, m23}},
             {t.chart, {m31, m23, v3}},
             {t.chart, {m23, m31, m12}}}};
  }

  static double squared(const ParameterPoint<double>& w) { return w.s * w.s + w.t * w.t; }

  [[nodiscard]] bool contains(const ParameterTriangle& t) const {
    const auto& [v1, v2, v3] = t.vertices;
    return cross(v2 - v1, p_.at - v1) > 0 && cross(v3 - v2, p_.at - v2) > 0 && cross(v1 - v3, p_.at - v3) > 0;
  }

  [[nodiscard]] double by_rule(const ParameterTriangle& t, const InterpolationRemainder& rest) const {
    const ChartIn<double>& chart = surface_->charts[t.chart].in<double>();
    double sum = 0;
    for (std::size_t k = 0; k < rule_.points.size(); ++k) {
      const ParameterPoint<double> at = t.at(rule_.points[k].x);
      const Frame<double> q = chart.frame(at);
      // With the area normal for the unit normal at Q the kernel has the area element in it.
      const double g = t.chart == p_.chart
                           ? chord_kernel(chart.chord(p_.at, at - p_.at), normal_, q.area_normal)
                           : geometric_kernel(frame_.point, normal_, q.point, q.area_normal);
      sum += rule_.weights[k] * g * rest(at, q.point);
    }
    return sum * cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]);
  }

  const Surface* surface_;
  SurfacePoint<double> p_;
  Frame<double> frame_;
  Vector<double> normal_;
  TriangleRule<double> rule_;
};

}  // namespace

Approximation kernel_error(const Surface& surface, const std::vector<ParameterTriangle>& elements,
                           const TriangleBasis<double>& basis, Solution u, const SurfacePoint<double>& p,
                           std::optional<std::size_t> only_chart) {
  const KernelIntegral coarse(surface, p, 10);
  const KernelIntegral fine(surface, p, 14);
  struct Sums {
    double coarse = 0;
    double fine = 0;
  };
  const Sums sums = parallel_reduce_ordered(
      elements.size(), 64, Sums{},
      [&](std::size_t begin, std::size_t end) {
        Sums part;
        for (std::size_t k = begin; k < end; ++k) {
          if (only_chart && elements[k].chart != *only_chart) continue;
          const InterpolationRemainder rest(surface, elements[k], basis, u);
          part.coarse += coarse.over(elements[k], rest);
          part.fine += fine.over(elements[k], rest);
        }
        return part;
      },
      [](const Sums& a, const Sums& b) {
        return Sums{a.coarse + b.coarse, a.fine + b.fine};
      });
  return {.value = sums.fine, .radius = std::abs(sums.fine - sums.coarse)};
}

Approximation kernel_error_at_nodes(const Surface& surface, const std::vector<ParameterTriangle>& elements,
                                    const ParameterTriangle& of, const TriangleBasis<double>& basis,
                                    Solution u, std::optional<std::size_t> only_chart) {
  Approximation largest{.value = 0, .radius = 0};
  for (const Barycentric<double>& q : basis.nodes()) {
    const Approximation here = kernel_error(surface, elements, basis, u, {of.chart, of.at(q.x)}, only_chart);
    largest.value = std::max(largest.value, std::abs(here.value));
    largest.radius = std::max(largest.radius, here.radius);
  }
  return largest;
}

}  // namespace radcert::verification::m06
