// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/decomposition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace radcert::reference {
namespace {

constexpr double strip = std::numbers::pi / 2;  // where the maps by sinh are analytic about the real line

/// How r is spaced in a sector that reaches out to `radius`, and how rough the integrand is in it.
struct Radial {
  Spacing spacing;
  double roughness;
};

Radial radial(const Polar& polar, double radius, double bend) {
  if (polar.graded) return {{.kind = Spacing::Kind::power}, 2.4};
  if (polar.delta == 0) return {{}, bend};
  const Spacing spacing = Spacing::centred(0, polar.delta / radius);
  return {spacing, std::hypot(spacing.extent / strip, bend)};
}

}  // namespace

void add_triangles(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
                   const Roughness& roughness) {
  for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
    const Parameters corner = polygon[i] - polygon[0];
    const Parameters side = polygon[i + 1] - polygon[i];
    cubature.add(Collapse{corner, side, cross(corner, side)}, {}, roughness, integrand);
  }
}

void add_slabs(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
               const Parameters& apex, bool graded, const Spread& spread, const Roughness& roughness) {
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
    Spacing spacing;
    Roughness rough = roughness;
    if (spread.delta > 0) {
      // Where the slab is no rectangle the centre moves with it: that costs points, no digits.
      const double lower = 0.5 * (slab.lower_from + slab.lower_to);
      const double width = 0.5 * (slab.upper_from + slab.upper_to) - lower;
      spacing = Spacing::centred((spread.centre - lower) / width, spread.delta / width);
      rough.along = spacing.extent / strip;
    }
    cubature.add(slab, spacing, rough, integrand);
  }
}

double add_sectors(AdaptiveCubature& cubature, std::size_t integrand, const Polygon& polygon,
                   const Parameters& apex, const TangentPlane& plane, const Polar& polar) {
  double left_out = 0;
  double diameter = 0;
  double least_s = polygon[0].s;
  for (std::size_t i = 0; i < polygon.count; ++i)
    diameter = std::max(diameter, length(plane.coordinates(polygon[i] - apex))),
    least_s = std::min(least_s, polygon[i].s);
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Parameters a = plane.coordinates(polygon[i] - apex);
    const Parameters b = plane.coordinates(polygon[i + 1] - apex);
    const double side = length(b - a);
    if (side == 0) continue;
    const Parameters tangent = (1 / side) * (b - a);
    const Parameters normal{tangent.t, -tangent.s};
    const double height = inner(length(a) < length(b) ? a : b, normal);
    if (height <= 4 * roundoff * diameter) {  // the apex lies on this side
      left_out = std::max(left_out, std::abs(height));
      continue;
    }
    Sector sector{};
    sector.normal = plane.parameters(normal);
    sector.tangent = plane.parameters(tangent);
    sector.height = height;
    sector.inner_radius = polar.inner_radius;
    sector.density = 1 / plane.determinant();
    const double start = std::asinh(inner(a, tangent) / height);
    const double extent = std::asinh(inner(b, tangent) / height) - start;
    const bool at_start = polygon[i].s == least_s;
    const bool at_end = polygon[i + 1].s == least_s;
    const bool one_end = at_start != at_end;
    // One spacing of r serves lines of about one length.
    constexpr double widest = 2.5;
    const double parts = std::max(1.0, std::ceil(extent / widest));
    for (double k = 0; k < parts; ++k) {
      sector.start = start + k / parts * extent;
      sector.extent = extent / parts;
      sector.spacing = {};
      sector.from_end = at_end;
      double across = sector.extent / strip;
      if (one_end && k == (at_start ? 0 : parts - 1)) {
        if (polar.graded) {
          sector.spacing = {.kind = Spacing::Kind::power};
          across = 2.4;
        } else if (polar.margin > 0) {
          const double slant =
              std::abs(inner(tangent, plane.coordinates({1, 0}))) / length(plane.coordinates({1, 0}));
          const double end = std::abs(inner(at_start ? a : b, tangent));
          const double gap = std::asinh((end + polar.margin / slant) / height) - std::asinh(end / height);
          if (gap < sector.extent) {
            sector.spacing = Spacing::centred(0, gap / sector.extent);
            across = sector.spacing.extent / strip;
          }
        }
      }
      const double radius =
          height * std::cosh(std::max(std::abs(sector.start), std::abs(sector.start + sector.extent)));
      const Radial r = radial(polar, radius, polar.bend * radius / diameter);
      const double area =
          height * height * (std::sinh(sector.start + sector.extent) - std::sinh(sector.start));
      const double peak = polar.delta > 0 ? polar.delta : diameter;
      cubature.add(sector, r.spacing,
                   {.across = std::hypot(across, polar.bend * radius / diameter),
                    .along = r.roughness,
                    .share = std::min(1.0, area / (peak * peak)),
                    .analytic = polar.analytic},
                   integrand);
    }
    if (polar.inner_radius > 0) {
      const double angle = std::atan(inner(b, tangent) / height) - std::atan(inner(a, tangent) / height);
      cubature.add_unseen(polar.bound * 0.5 * angle * polar.inner_radius * polar.inner_radius);
    }
  }
  return left_out;
}

}  // namespace radcert::reference
