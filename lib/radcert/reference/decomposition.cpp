// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/decomposition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace radcert::reference {

void add_triangles(AdaptiveCubature& cubature, std::uint32_t integrand, const Polygon& polygon) {
  for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
    const Parameters corner = polygon[i] - polygon[0];
    const Parameters side = polygon[i + 1] - polygon[i];
    cubature.add(Collapse{corner, side, cross(corner, side)}, integrand);
  }
}

void add_slabs(AdaptiveCubature& cubature, std::uint32_t integrand, const Polygon& polygon,
               const Parameters& apex, bool graded, const Spread& spread) {
  std::array<double, 8> cut{};
  for (std::size_t i = 0; i < polygon.count; ++i) cut[i] = polygon[i].s;
  std::sort(cut.begin(), cut.begin() + static_cast<std::ptrdiff_t>(polygon.count));
  for (std::size_t k = 0; k + 1 < polygon.count; ++k) {
    if (!(cut[k] < cut[k + 1])) continue;
    const double middle = cut[k] + 0.5 * (cut[k + 1] - cut[k]);
    Slab slab{};
    slab.graded = graded;
    slab.from_s = cut[k];
    slab.to_s = cut[k + 1];
    slab.from_z = graded ? std::pow(slab.from_s, 1.0 / grading_power) : slab.from_s;
    slab.to_z = graded ? std::pow(slab.to_s, 1.0 / grading_power) : slab.to_s;
    slab.centre = spread.centre;
    slab.delta = spread.delta;
    slab.apex = apex;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Parameters& a = polygon[i];
      const Parameters& b = polygon[i + 1];
      const bool lower = a.s < middle && b.s > middle;  // counterclockwise: the lower sides run to the right
      const bool upper = a.s > middle && b.s < middle;
      if (!lower && !upper) continue;
      const double slope = (b.t - a.t) / (b.s - a.s);
      const double from = a.t + (slab.from_s - a.s) * slope;
      const double to = a.t + (slab.to_s - a.s) * slope;
      (lower ? slab.lower_from : slab.upper_from) = from;
      (lower ? slab.lower_to : slab.upper_to) = to;
    }
    cubature.add(slab, integrand);
  }
}

void add_sectors(AdaptiveCubature& cubature, std::uint32_t integrand, const Polygon& polygon,
                 const Parameters& apex, const TangentPlane& plane, const Polar& polar) {
  double diameter = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    diameter = std::max(diameter, length(plane.coordinates(polygon[i] - apex)));
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters a = plane.coordinates(polygon[i] - apex);
    const Parameters b = plane.coordinates(polygon[i + 1] - apex);
    const double side = length(b - a);
    if (side == 0) continue;
    const Parameters tangent = (1 / side) * (b - a);
    const Parameters normal{tangent.t, -tangent.s};
    const double height = inner(length(a) < length(b) ? a : b, normal);
    if (height <= 4 * roundoff * diameter) continue;  // the apex lies on this side
    Sector sector{};
    sector.normal = plane.parameters(normal);
    sector.tangent = plane.parameters(tangent);
    sector.height = height;
    sector.start = std::asinh(inner(a, tangent) / height);
    sector.end = std::asinh(inner(b, tangent) / height);
    sector.extent = sector.end - sector.start;
    sector.delta = polar.delta;
    sector.inner_radius = polar.inner_radius;
    sector.density = 1 / plane.determinant();
    sector.radial = polar.graded      ? Sector::Radial::power
                    : polar.delta > 0 ? Sector::Radial::sinh
                                      : Sector::Radial::linear;
    if (polar.graded && polygon[i].s == 0) sector.graded = Sector::Graded::at_start;
    if (polar.graded && polygon[i + 1].s == 0) sector.graded = Sector::Graded::at_end;
    cubature.add(sector, integrand);
    if (polar.inner_radius > 0) {
      const double angle = std::atan(inner(b, tangent) / height) - std::atan(inner(a, tangent) / height);
      cubature.add_unseen(polar.bound * 0.5 * angle * polar.inner_radius * polar.inner_radius);
    }
  }
}

}  // namespace radcert::reference
