// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/visible_element.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/collocation/convex_polygon.h"

namespace radcert {
namespace {

using Point = ParameterPoint<double>;
using Corners = ConvexPolygon<double>;

double extent(const Point& along) { return std::abs(along.s) + std::abs(along.t); }

/// What the corners of a part are off by at most, once cut.
constexpr double corner_error = 0x1p-50;

/// Whether a part of an element is all of it, but for what the rounding of its corners may have taken.
bool is_all_of(const Corners& polygon, const Corners& element) {
  double perimeter = 0;
  for (std::size_t k = 0; k < element.size(); ++k)
    perimeter += extent(element[(k + 1) % element.size()] - element[k]);
  return std::abs(doubled_area(element) - doubled_area(polygon)) <= 2 * corner_error * perimeter;
}

/// Whether an element lies in a part, off its sides.
bool lies_inside(const Corners& element, const Corners& part) {
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Point along = part[(k + 1) % part.size()] - part[k];
    for (const Point& corner : element)
      if (cross(along, corner - part[k]) <= 4 * corner_error * extent(along)) return false;
  }
  return true;
}

/// The triangle with these corners as a cell of the element.
ElementPart<double> cell_of(const ParameterTriangle& element, const std::array<Point, 3>& corners) {
  const auto& v = element.vertices;
  const double area = cross(v[1] - v[0], v[2] - v[0]);
  ElementPart<double> cell{corners, {}, cross(corners[1] - corners[0], corners[2] - corners[0])};
  for (std::size_t k = 0; k < 3; ++k) {
    const double second = cross(corners[k] - v[0], v[2] - v[0]) / area;
    const double third = cross(v[1] - v[0], corners[k] - v[0]) / area;
    cell.corners[k] = {{1 - second - third, second, third}};
  }
  return cell;
}

/// Whether a triangle is no wider than what its corners are rounded by, so that strip_bound counts all of it.
bool is_within_the_strips(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({extent(b - a), extent(c - b), extent(a - c)});
  return cross(b - a, c - a) <= corner_error * longest;
}

/// Sums the integrals over the triangles of parts.
class PartSums {
public:
  PartSums(const ParameterTriangle& triangle, const Chart& chart, ElementIntegrator<double>& element)
      : triangle_(triangle), chart_(chart), element_(element) {}

  /// Adds what of a part lies in the element.
  void add(const CollocationPoint<double>& p, const Corners& part) {
    const auto& v = triangle_.vertices;
    const Corners corners(v.begin(), v.end());
    if (lies_inside(corners, part)) {
      add(element_.integrate(p), 0);
      return;
    }
    // The part is what is cut: its sides may be too short to cut along.
    const Corners polygon = clipped(part, std::span<const Point>(corners));
    if (polygon.size() < 3) return;
    double beside = strip_bound(p.point, chart_.in<double>(), polygon);
    if (is_all_of(polygon, corners)) {
      add(element_.integrate(p), beside);
      return;
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      if (is_within_the_strips(polygon[0], polygon[k - 1], polygon[k])) continue;
      add(element_.integrate_part(p, cell_of(triangle_, {polygon[0], polygon[k - 1], polygon[k]})), beside);
      beside = 0;
    }
  }
  [[nodiscard]] const ElementIntegral<double>& sum() const { return sum_; }

private:
  void add(const ElementIntegral<double>& term, double beside) {
    for (std::size_t j = 0; j < element_.scheme().basis().size(); ++j) {
      sum_.value[j] += term.value[j];
      sum_.radius[j] += term.radius[j] + element_.scheme().largest_value(j) * beside;
    }
    sum_.absolute += term.absolute;
  }

  const ParameterTriangle& triangle_;
  const Chart& chart_;
  ElementIntegrator<double>& element_;
  ElementIntegral<double> sum_;
};

void set_lane(BlockIntegral<double>& integral, std::size_t lane, const ElementIntegral<double>& alone) {
  integral.absolute.set_lane(lane, alone.absolute);
  for (std::size_t j = 0; j < alone.value.size(); ++j) {
    integral.value[j].set_lane(lane, alone.value[j]);
    integral.radius[j].set_lane(lane, alone.radius[j]);
  }
}

}  // namespace

NodeSights::NodeSights(const SurfaceScene& scene, std::span<const CollocationPoint<double>> nodes)
    : scene_(scene), seen_(nodes.size()) {
  views_.reserve(nodes.size());
  for (const CollocationPoint<double>& node : nodes)
    views_.push_back(scene.view(node.at.chart, node.point, node.normal));
}

void NodeSights::look_at(std::size_t chart) {
  if (chart_ == chart) return;
  chart_ = chart;
  for (std::size_t i = 0; i < views_.size(); ++i) seen_[i] = scene_.seen(views_[i], chart);
}

void integrate_visible(const ParameterTriangle& triangle, const CollocationPointBlock<double>& block,
                       std::span<const CollocationPoint<double>> nodes, const NodeSights& sights,
                       const Chart& chart, ElementIntegrator<double>& element,
                       BlockIntegral<double>& integral) {
  bool any_whole = false;
  for (std::size_t lane = 0; lane < block.count; ++lane)
    any_whole = any_whole || sights.of(block.first + lane).sight == Sight::whole;
  if (any_whole) element.integrate(block, nodes, integral);
  for (std::size_t lane = 0; lane < block.count; ++lane) {
    const CollocationPoint<double>& p = nodes[block.first + lane];
    const ChartView& seen = sights.of(block.first + lane);
    if (seen.sight == Sight::whole) continue;
    PartSums sums(triangle, chart, element);
    for (const Corners& part : seen.parts) sums.add(p, part);
    set_lane(integral, lane, sums.sum());
  }
}

}  // namespace radcert
