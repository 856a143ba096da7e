// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/visible_parts.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "radcert/reference/polygon.h"

namespace radcert::reference {
namespace {

using Corners = std::vector<Parameters>;

/// The largest |u| at the corners of a part.
double largest_density(const OperatorPoint& at, std::size_t index, const Corners& part) {
  const ChartIn<double>& chart = at.surface->charts[index].in<double>();
  double largest = 0;
  for (const Parameters& corner : part)
    largest = std::max(largest, std::abs((*at.density)({index, corner}, chart.frame(corner).point)));
  return largest;
}

/// What a convex part and a cell have in common.
Corners intersection(Corners part, const DensityCell& cell) {
  for (std::size_t i = 0; i < cell.polygon.count && !cell.is_whole; ++i) {
    const Parameters from = cell.polygon[i];
    const Parameters along = cell.polygon[i + 1] - from;
    const auto inside = [&](const Parameters& v) { return cross(along, v - from); };
    Corners kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Parameters& v = part[k];
      const Parameters& next = part[(k + 1) % part.size()];
      const double here = inside(v);
      const double there = inside(next);
      if (here >= 0) kept.push_back(v);
      if ((here > 0 && there < 0) || (here < 0 && there > 0))
        kept.push_back(v + here / (here - there) * (next - v));
    }
    part = std::move(kept);
  }
  return part;
}

/// Adds a convex part. A Polygon holds so many vertices: a part of more is cut into some that share its first
/// corner.
void add_convex_part(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index,
                     const Corners& part) {
  const ChartIn<double>& chart = at.surface->charts[index].in<double>();
  cubature.add_unseen(strip_bound(at.frame.point, chart, part) * largest_density(at, index, part));
  constexpr std::size_t most = std::tuple_size_v<decltype(Polygon::vertex)>;
  for (std::size_t first = 1; first + 1 < part.size(); first += most - 2) {
    Polygon polygon;
    polygon.add(part[0]);
    for (std::size_t k = first; k < std::min(first + most - 1, part.size()); ++k) polygon.add(part[k]);
    add_part(cubature, at, index, polygon);
  }
}

}  // namespace

void add_visible_parts(AdaptiveCubature& cubature, const OperatorPoint& at, std::size_t index,
                       const ChartView& view, std::span<const DensityCell> cells) {
  for (const Corners& part : view.parts)
    for (const DensityCell& cell : cells)
      if (const Corners common = intersection(part, cell); common.size() >= 3)
        add_convex_part(cubature, at, index, common);
}

}  // namespace radcert::reference
