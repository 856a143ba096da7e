// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/visible_parts.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "radcert/reference/polygon.h"

namespace radcert::reference {
namespace {

using Corners = std::vector<Parameters>;

/// The largest |u| at the corners of a part.
double largest_density(const Collocation& at, std::size_t index, const Corners& part) {
  const ChartIn<double>& chart = at.surface->charts[index].in<double>();
  double largest = 0;
  for (const Parameters& corner : part)
    largest = std::max(largest, std::abs((*at.density)({index, corner}, chart.frame(corner).point)));
  return largest;
}

}  // namespace

void add_visible_parts(AdaptiveCubature& cubature, const Collocation& at, std::size_t index,
                       const ChartView& view) {
  for (const Corners& part : view.parts) {
    const ChartIn<double>& chart = at.surface->charts[index].in<double>();
    cubature.add_unseen(strip_bound(at.frame.point, chart, part) * largest_density(at, index, part));
    // A Polygon holds so many vertices: a part of more is cut into some that share its first corner.
    constexpr std::size_t most = std::tuple_size_v<decltype(Polygon::vertex)>;
    for (std::size_t first = 1; first + 1 < part.size(); first += most - 2) {
      Polygon polygon;
      polygon.add(part[0]);
      for (std::size_t k = first; k < std::min(first + most - 1, part.size()); ++k) polygon.add(part[k]);
      add_part(cubature, at, index, polygon);
    }
  }
}

}  // namespace radcert::reference
