// SPDX-License-Identifier: GPL-3.0-or-later

// (10): the F_j are one-to-one and onto, by their inverses.
//
// Octant of the ellipsoid with half axes a, b, c: F = (a X, b Y, c Z), (X,Y,Z) = e/|e|, e = (u, s, t) with u
// + s + t = 1, all >= 0. With the signs taken off, s = Y/(X + Y + Z) and t = Z/(X + Y + Z); X + Y + Z = 1/|e|
// >= 1. X^2 + Y^2 + Z^2 = 1, so that the image lies in the octant; a point (X,Y,Z) of it is the image of (Y,
// Z)/(X + Y + Z), a point of the triangle, as F puts e = (X,Y,Z)/(X + Y + Z) back to e/|e| = (X,Y,Z): onto.
// The roof and the square of two_piece(p) are graphs over the square: (s,t) are the first two coordinates.
//
// Checked      these identities, as functions of s and t, for the formulas of the library's charts: all eight
//              octants of (1,2,5), two_piece(2) and (3). Stretching the coordinates takes (1,2,5) to any
//              other ellipsoid. That what is divided by does not vanish: 1/|e|^2 - 1 is nowhere negative on
//              the triangle. Rejected: the inverse of another octant; the map (s,t) -> (s, s t), which
//              squeezes a side to a point: y/x is an inverse only where x does not vanish, and x^2 - 1 is
//              negative.
// Not checked  other charts.

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/exact_chart.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

using Image = Vector<ExactFunction>;

Image image_of(const Chart& chart) { return exact_image(chart.in<Ball>())->image(); }

// 0 if f and g are shown to be the parameters.
Rational failing(const ExactFunction& f, const ExactFunction& g) {
  return Rational((f - ExactFunction::s()).is_zero() ? 0 : 1) +
         Rational((g - ExactFunction::t()).is_zero() ? 0 : 1);
}

// Parameters that the inverse of an octant does not give back, for an image of the ellipsoid (a,b,c).
Rational failing_inverse(const Image& image, const Vector<Rational>& axes, const Octant& octant) {
  const ExactFunction x = ExactFunction(octant.x / axes.x) * image.x;
  const ExactFunction y = ExactFunction(octant.y / axes.y) * image.y;
  const ExactFunction z = ExactFunction(octant.z / axes.z) * image.z;
  const ExactFunction sum = x + y + z;
  return failing(y / sum, z / sum);
}

// Whether the image is not on the ellipsoid.
Rational off_the_ellipsoid(const Image& image, const Vector<Rational>& axes) {
  const auto part = [](const ExactFunction& coordinate, const Rational& axis) {
    const ExactFunction scaled = ExactFunction(1 / axis) * coordinate;
    return scaled * scaled;
  };
  const ExactFunction rest =
      part(image.x, axes.x) + part(image.y, axes.y) + part(image.z, axes.z) - ExactFunction(1);
  return rest.is_zero() ? 0 : 1;
}

// Whether f - 1 may be negative.
Rational may_be_below_one(const ExactFunction& f, ParameterRegion region) {
  return is_nowhere_negative(f - ExactFunction(1), region) ? 0 : 1;
}

}  // namespace

Finding equation_10_one_to_one(const Bench&) {
  const IsExactly none{0};
  const Vector<Rational> axes{1, 2, 5};
  const Surface surface = ellipsoid(axes.x, axes.y, axes.z);
  Finding finding;
  std::size_t chart = 0;
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1}) {
        const Image image = image_of(surface.charts[chart]);
        const std::string of = ", " + surface.charts[chart].facts().name + " of the ellipsoid (1,2,5)";
        ++chart;
        finding.require("parameters that the inverse does not give back" + of, none,
                        failing_inverse(image, axes, {x, y, z}));
        finding.require("whether the image leaves the ellipsoid" + of, none, off_the_ellipsoid(image, axes));
        finding.control("parameters that the inverse of the octant beside it does not give back" + of, none,
                        failing_inverse(image, axes, {-x, y, z}));
      }
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  const ExactFunction u = ExactFunction(1) - s - t;
  finding.require("whether 1/|e|^2, the square of what is divided by, may be below 1", none,
                  may_be_below_one(ExactFunction(1) / (u * u + s * s + t * t), ParameterRegion::triangle));
  finding.control("the same of x^2 for the map (s,t) -> (s, s t), whose inverse divides by x", none,
                  may_be_below_one(s * s, ParameterRegion::square));
  for (const int p : {2, 3}) {
    const Image roof = image_of(two_piece(p).charts[1]);
    finding.require(
        "parameters that are not the first two coordinates, roof of two_piece(" + std::to_string(p) + ")",
        none, failing(roof.x, roof.y));
  }
  const Image square = image_of(two_piece(2).charts[0]);
  finding.require("parameters that are not the first two coordinates, square of two_piece", none,
                  failing(square.x, square.y));
  return finding;
}

}  // namespace radcert::verification::m06
