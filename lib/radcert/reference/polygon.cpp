// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/polygon.h"

namespace radcert::reference {

Polygon whole_domain(ChartDomain domain) {
  Polygon polygon;
  polygon.add({0, 0});
  polygon.add({1, 0});
  if (domain == ChartDomain::unit_square) polygon.add({1, 1});
  polygon.add({0, 1});
  return polygon;
}

Polygon counterclockwise(const std::array<Parameters, 3>& triangle) {
  const bool clockwise = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0;
  Polygon polygon;
  polygon.add(triangle[0]);
  polygon.add(triangle[clockwise ? 2 : 1]);
  polygon.add(triangle[clockwise ? 1 : 2]);
  return polygon;
}

Polygon clipped(const Polygon& polygon, const Parameters& normal, double cut, double sign) {
  const auto beyond = [&](const Parameters& v) { return normal.s * v.s + normal.t * v.t - cut; };
  Polygon part;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters& v = polygon[i];
    const Parameters& next = polygon[i + 1];
    const double here = beyond(v);
    const double there = beyond(next);
    if (sign * here >= 0) part.add(v);
    if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      Parameters on_cut = v + here / (here - there) * (next - v);
      if (normal.t == 0) on_cut.s = cut / normal.s;
      part.add(on_cut);
    }
  }
  if (part.count < 3) part.count = 0;
  return part;
}

}  // namespace radcert::reference
