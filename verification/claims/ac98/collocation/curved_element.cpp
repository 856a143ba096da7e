// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/curved_element.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/lazy_table.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/gauss.h"

namespace radcert::verification::ac98 {
namespace {

constexpr PartCorners whole{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

const TriangleRule<double>& plain_rule(int order) {
  static LazyTable<TriangleRule<double>, 96> rules;
  return rules.at(static_cast<std::size_t>(order),
                  [&] { return conical_rule<double>(order, Grading::none); });
}

// G alone is not analytic in l, so that l belongs to the integrand and not to the weight.
const TriangleRule<double>& collapsed_at_first(int order) {
  static LazyTable<TriangleRule<double>, 96> rules;
  return rules.at(static_cast<std::size_t>(order), [&] {
    const IntervalRule<double> gauss = gauss_rule<double>(order, IntervalWeight::one);
    TriangleRule<double> product;
    for (std::size_t i = 0; i < gauss.nodes.size(); ++i)
      for (std::size_t j = 0; j < gauss.nodes.size(); ++j) {
        const double l = gauss.nodes[i];
        const double t = gauss.nodes[j];
        product.points.push_back({{1 - l, l * (1 - t), l * t}});
        product.weights.push_back(gauss.weights[i] * gauss.weights[j] * l);
      }
    return product;
  });
}

double part_of(const PartCorners& corners) {
  const auto& [a, b, c] = corners;
  return std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]));
}

void add(ElementSums& sums, const ElementSums& more) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums.at(i) += more.at(i);
}

}  // namespace

CurvedElement::CurvedElement(const ChartIn<double>& chart,
                             const std::array<ParameterPoint<double>, 3>& triangle, SpaceFunction function,
                             int order)
    : chart_(&chart), triangle_(triangle), function_(function), order_(order) {
  samples_ = by(whole, plain_rule(order));
  for (std::size_t i = 0; i < 3; ++i)
    diameter_ = std::max(diameter_, norm(at(whole.at(i)).point - at(whole.at((i + 1) % 3)).point));
}

std::vector<ElementSample> CurvedElement::by(const PartCorners& corners,
                                             const TriangleRule<double>& rule) const {
  const double jacobian =
      part_of(corners) * std::abs(cross(triangle_[1] - triangle_[0], triangle_[2] - triangle_[0]));
  std::vector<ElementSample> all;
  all.reserve(rule.points.size());
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    ElementSample sample;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) sample.x.at(k) += rule.points[i].x.at(j) * corners.at(j).at(k);
    const Frame<double> frame = at(sample.x);
    sample.point = frame.point;
    sample.normal = jacobian * rule.weights[i] * frame.area_normal;
    sample.value = function_(frame.point);
    all.push_back(sample);
  }
  return all;
}

ElementSums FromPoint::over(const CurvedElement& element) const {
  const double distance = norm(element.at({1.0 / 3, 1.0 / 3, 1.0 / 3}).point - point_);
  return distance >= element.diameter() ? sum(element.samples())
                                        : divided(element, whole, element.diameter());
}

ElementSums FromPoint::around(const CurvedElement& element, const std::array<double, 3>& x, int order) const {
  ElementSums sums{};
  for (std::size_t i = 0; i < 3; ++i) {
    const PartCorners part{x, whole.at((i + 1) % 3), whole.at((i + 2) % 3)};
    if (part_of(part) > 0) add(sums, sum(element.by(part, collapsed_at_first(order))));
  }
  return sums;
}

ElementSums FromPoint::divided(const CurvedElement& element, const PartCorners& corners,
                               double diameter) const {
  const auto middle = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::array<double, 3>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  std::array<double, 3> centre{};
  for (const auto& corner : corners)
    for (std::size_t i = 0; i < 3; ++i) centre.at(i) += corner.at(i) / 3;
  if (norm(element.at(centre).point - point_) >= diameter)
    return sum(element.by(corners, plain_rule(element.order())));
  const std::array<double, 3> a = middle(corners[1], corners[2]);
  const std::array<double, 3> b = middle(corners[2], corners[0]);
  const std::array<double, 3> c = middle(corners[0], corners[1]);
  ElementSums sums{};
  for (const PartCorners& part : {PartCorners{corners[0], c, b}, PartCorners{c, corners[1], a},
                                  PartCorners{b, a, corners[2]}, PartCorners{a, b, c}})
    add(sums, divided(element, part, diameter / 2));
  return sums;
}

ElementSums FromPoint::sum(const std::vector<ElementSample>& samples) const {
  ElementSums sums{};
  for (const ElementSample& each : samples) {
    const double kernel = geometric_kernel(point_, normal_, each.point, each.normal);
    for (std::size_t k = 0; k < 3; ++k) sums[k] += kernel * each.x[k];
    sums[3] += kernel * each.value;
  }
  return sums;
}

}  // namespace radcert::verification::ac98
