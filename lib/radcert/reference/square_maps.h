// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "radcert/reference/polygon.h"

namespace radcert::reference {

inline constexpr int grading_power = 6;  // in s = z^6 the powers s^(1/2) and s^(1/3) are analytic

/// Both hyperbolic functions of one argument.
struct SinhCosh {
  double sinh;
  double cosh;
};

inline SinhCosh sinh_cosh(double x) {
  const double e = std::expm1(x);  // one call for both, and no digits lost at small x
  const double f = e / (1 + e);
  return {0.5 * (e + f), 1 + 0.5 * (e - f)};
}

/// x^n for n >= 0.
inline double integer_power(double x, int n) {
  double result = 1;
  for (int k = 0; k < n; ++k) result *= x;
  return result;
}

/// The image of a point of the unit square in the parameter plane.
/// Maths     w, parameters counted from an apex, and the area element |det Dw| of the map
/// Source    -
/// Requires  -
/// Result    rounded
/// Limits    -
struct MapPoint {
  Parameters w;
  double area;
};

/// A triangle with a corner at the apex, collapsed.
/// Maths     w = r (corner + x side), area element r * area
/// Source    Duffy
/// Requires  area = |corner x side|
/// Result    line(x).at(r), x and r in [0,1], covers the triangle once
/// Limits    no grading: for integrands that are smooth on the triangle
struct Collapse {
  Parameters corner;
  Parameters side;
  double area;

  struct Line {
    Parameters end;
    double area;
    MapPoint at(double r) const { return {r * end, r * area}; }
  };
  Line line(double x) const { return {corner + x * side, area}; }
};

/// A triangle with a corner at the apex in polar coordinates of the tangent plane, r up to the side at distance h.
/// Maths     tan(angle) = sinh(y), so that a near side is no more trouble than a far one; r linear, or r = delta sinh(x), which
///           spreads a peak of width delta at the apex, or r = x^6. The first two are analytic in a strip about the real line of
///           width pi/2; `graded` gathers y by a sixth power at an end of the side that lies on a singular line
/// Source    Johnston and Elliott 2005 (the substitution by sinh); the angle and the powers are ours
/// Requires  height > 0, start < end; delta > 0 if radial = sinh
/// Result    line(y).at(x), both in [0,1], covers the triangle once, off the disk of radius inner_radius if radial = sinh
/// Limits    -
struct Sector {
  enum class Radial : std::uint8_t { linear, sinh, power };
  enum class Graded : std::uint8_t { no, at_start, at_end };

  Parameters normal;   // of the side, in parameters for unit length in space
  Parameters tangent;  // along the side
  double height;       // distance h of the side
  double start;        // in y
  double end;
  double extent;
  double delta;
  double inner_radius;
  double density;  // parameter area for unit area in space
  Radial radial;
  Graded graded;

  struct Line {
    Parameters direction;
    double radius;
    double delta;
    double from;
    double extent;
    double factor;
    Radial radial;

    MapPoint at(double x) const {
      double r = 0;
      double slope = 0;
      switch (radial) {
        case Radial::linear:
          r = x * radius;
          slope = radius;
          break;
        case Radial::sinh: {
          const SinhCosh value = sinh_cosh(from + x * extent);
          r = delta * value.sinh;
          slope = delta * value.cosh * extent;
          break;
        }
        case Radial::power: {
          const double lower = integer_power(x, grading_power - 1);
          r = radius * lower * x;
          slope = radius * grading_power * lower;
          break;
        }
      }
      return {r * direction, r * slope * factor};
    }
  };

  Line line(double x) const {
    double position = start + x * extent;
    double slope = extent;
    if (graded != Graded::no) {
      const double z = graded == Graded::at_start ? x : 1 - x;
      const double lower = integer_power(z, grading_power - 1);
      position = graded == Graded::at_start ? start + lower * z * extent : end - lower * z * extent;
      slope *= grading_power * lower;
    }
    const SinhCosh y = sinh_cosh(position);
    Line line{};
    line.direction = (1 / y.cosh) * (normal + y.sinh * tangent);
    line.radius = height * y.cosh;
    line.radial = radial;
    line.factor = slope / y.cosh * density;
    if (radial == Radial::sinh) {
      const double to = std::asinh(line.radius / delta);
      line.delta = delta;
      line.from = std::min(to, std::asinh(inner_radius / delta));
      line.extent = to - line.from;
    }
    return line;
  }
};

/// A trapezium of the parameter plane between two straight lines.
/// Maths     from_s <= s <= to_s, lower(s) <= t <= upper(s); s = z^6, graded towards s = 0, or linear; t linear or spread about
///           `centre` by t = centre + delta sinh(y)
/// Source    Johnston and Elliott 2005 (the substitution by sinh); the power is ours
/// Requires  from_s < to_s; from_s = from_z^6 and to_s = to_z^6 if graded; delta >= 0, where 0 means t linear
/// Result    line(x).at(y), both in [0,1], covers the trapezium once
/// Limits    -
struct Slab {
  double from_z;
  double to_z;
  bool graded;
  double from_s;
  double to_s;
  double lower_from;
  double lower_to;
  double upper_from;
  double upper_to;
  double centre;
  double delta;  // 0: linear
  Parameters apex;

  struct Line {
    double w_s;
    double from;
    double extent;
    double delta;
    double shift;
    double factor;

    MapPoint at(double x) const {
      const double y = from + x * extent;
      if (delta == 0) return {{w_s, y + shift}, factor * extent};
      const SinhCosh value = sinh_cosh(y);
      return {{w_s, delta * value.sinh + shift}, factor * extent * delta * value.cosh};
    }
  };

  Line line(double x) const {
    const double z = from_z + x * (to_z - from_z);
    const double power = graded ? integer_power(z, grading_power - 1) : 1;
    const double s = graded ? power * z : z;
    const double l = (s - from_s) / (to_s - from_s);
    const double lower = lower_from + l * (lower_to - lower_from) - centre;
    const double upper = upper_from + l * (upper_to - upper_from) - centre;
    Line line{};
    line.w_s = s - apex.s;
    line.shift = centre - apex.t;
    line.delta = delta;
    line.from = delta == 0 ? lower : std::asinh(lower / delta);
    line.extent = (delta == 0 ? upper : std::asinh(upper / delta)) - line.from;
    line.factor = (to_z - from_z) * (graded ? grading_power * power : 1);
    return line;
  }
};

}  // namespace radcert::reference
