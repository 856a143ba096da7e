// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <variant>

#include "radcert/reference/cubature/sinh_cosh.h"
#include "radcert/reference/polygon.h"
#include "radcert/scalar/pack.h"

namespace radcert::reference {

/// The power p of the map s = z^p that makes an integrand smooth towards a side.
inline constexpr int grading_power =
    4;  // in s = z^4 the power s^(1/2) is analytic, and others have four derivatives more

/// How the points of [0,1] are spaced on [0,1].
/// Maths     g(x) = x;  x^4;  or  shift + scale sinh(from + extent x), which gathers points about g = shift
///           in a neighbourhood of width `scale` and is analytic in a strip about the real line of width pi /
///           extent
/// Source    Johnston and Elliott 2005 (the substitution by sinh)
/// Requires  g(0) = 0 and g(1) = 1, which the makers see to: centred() puts the neighbourhood at a centre
/// Result    g and g' at eight points
struct Spacing {
  enum class Kind : std::uint8_t { linear, power, sinh };
  Kind kind = Kind::linear;
  double shift = 0;
  double scale = 1;
  double from = 0;
  double extent = 1;

  static Spacing centred(double centre, double width) {
    const double from = std::asinh(-centre / width);
    return {.kind = Kind::sinh,
            .shift = centre,
            .scale = width,
            .from = from,
            .extent = std::asinh((1 - centre) / width) - from};
  }

  struct Values {
    Pack position;
    Pack slope;
  };
  Values operator()(const Pack& x) const {
    switch (kind) {
      case Kind::linear: break;
      case Kind::power: {
        const Pack lower = power(x, grading_power - 1);
        return {lower * x, Pack(grading_power) * lower};
      }
      case Kind::sinh: {
        const SinhCosh value = sinh_cosh(fma(x, extent, from));
        return {fma(value.sinh, scale, shift), Pack(scale * extent) * value.cosh};
      }
    }
    return {x, 1.0};
  }
};

/// A line of the parameter plane along which points are spaced, or eight such lines.
/// Maths     w = base + r direction, r = start + extent g(x), 0 <= x <= 1;  the area element of (y, x) -> w,
///           y the number of the line, is factor extent g'(x), and times r where the lines come from one
///           point
/// Result    holds what it is given
template <class R>
struct Line {
  ParameterPoint<R> base;
  ParameterPoint<R> direction;
  R start;
  R extent;
  R factor;
};

/// A triangle with a corner at the apex, collapsed.
/// Maths     w = r (corner + y side), area element r * area
/// Source    Duffy
/// Requires  area = |corner x side|
/// Result    line(y), y in [0,1], covers the triangle once
/// Limits    no grading: for integrands that are smooth on the triangle
struct Collapse {
  static constexpr bool from_one_point = true;
  Parameters corner;
  Parameters side;
  double area;

  Line<Pack> line(const Pack& y) const {
    return {{0.0, 0.0}, {corner.s + y * side.s, corner.t + y * side.t}, 0.0, 1.0, area};
  }
};

/// A triangle with a corner at the apex in polar coordinates of the tangent plane, r up to the side at
/// distance h.
/// Maths     tan(angle) = sinh(v), so that a near side is no more trouble than a far one; analytic in a strip
///           about the real line of width pi/2. v = start + extent g(y), or counted from the other end: v =
///           start + extent (1 - g(1-y)), which gathers lines at an end of the side that lies on a singular
///           line or near one
/// Source    ours
/// Requires  height > 0
/// Result    line(y), y in [0,1], covers the triangle once, off the disk of radius inner_radius
struct Sector {
  static constexpr bool from_one_point = true;

  Parameters normal;   // of the side, in parameters for unit length in space
  Parameters tangent;  // along the side
  double height;       // distance h of the side
  double start;        // in v
  double extent;
  double inner_radius;
  double density;   // parameter area for unit area in space
  Spacing spacing;  // g
  bool from_end;

  Line<Pack> line(const Pack& y) const {
    const Spacing::Values g = spacing(from_end ? 1.0 - y : y);
    const SinhCosh v =
        sinh_cosh(from_end ? fma(g.position, -extent, start + extent) : fma(g.position, extent, start));
    const Pack slope = extent * g.slope;
    const Pack cosine = 1.0 / v.cosh;
    return {.base = {0.0, 0.0},
            .direction = {cosine * (normal.s + v.sinh * tangent.s), cosine * (normal.t + v.sinh * tangent.t)},
            .start = inner_radius,
            .extent = height * v.cosh - inner_radius,
            .factor = slope * cosine * density};
  }
};

/// A trapezium of the parameter plane between two straight lines.
/// Maths     from_s <= s <= to_s, lower(s) <= t <= upper(s); s = z^4, graded towards s = 0, or linear
/// Source    ours
/// Requires  from_s < to_s; from_s = from_z^4 and to_s = to_z^4 if graded
/// Result    line(y), y in [0,1], covers the trapezium once
struct Slab {
  static constexpr bool from_one_point = false;
  double from_z;
  double to_z;
  bool graded;
  double from_s;
  double to_s;
  double lower_from;
  double lower_to;
  double upper_from;
  double upper_to;
  Parameters apex;

  Line<Pack> line(const Pack& y) const {
    const Pack z = fma(y, to_z - from_z, from_z);
    const Pack lower_power = graded ? power(z, grading_power - 1) : Pack(1.0);
    const Pack s = lower_power * z;
    const Pack l = (s - from_s) / (to_s - from_s);
    const Pack lower = lower_from + l * (lower_to - lower_from);
    const Pack upper = upper_from + l * (upper_to - upper_from);
    return {.base = {s - apex.s, 0.0},
            .direction = {0.0, 1.0},
            .start = lower - apex.t,
            .extent = upper - lower,
            .factor = Pack(to_z - from_z) * (graded ? grading_power * lower_power : Pack(1.0))};
  }
};

/// Any of them.
using Map = std::variant<Collapse, Sector, Slab>;

}  // namespace radcert::reference
