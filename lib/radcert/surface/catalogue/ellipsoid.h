// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "radcert/geometry/vector.h"
#include "radcert/surface/exact_chart.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The signs of the three coordinates in an octant.
struct Octant {
  int x;
  int y;
  int z;
};

/// One eighth of an ellipsoid, the radial image of a face of the octahedron.
/// Maths     F(s,t) = diag(a,b,c) e/|e|,  e = (+-(1-s-t), +-s, +-t)
/// Source    ours; analytic on the closed triangle, as charts by sqrt(1-x^2-y^2) or polar angles are not
/// Requires  a, b, c > 0
/// Result    see ChartOf
/// Limits    -
template <Field R>
class EllipsoidOctant {
public:
  EllipsoidOctant(const Rational& a, const Rational& b, const Rational& c, const Octant& octant)
      : a_(from_rational<R>(octant.x * a)),
        b_(from_rational<R>(octant.y * b)),
        c_(from_rational<R>(octant.z * c)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const T u = R(1) - (s + t);
    using std::sqrt;
    const T inverse_length = reciprocal(sqrt(u * u + s * s + t * t));
    return {a_ * (u * inverse_length), b_ * (s * inverse_length), c_ * (t * inverse_length)};
  }

private:
  R a_;
  R b_;
  R c_;
};

namespace detail {

/// The eight charts; `piece` names the one smooth piece they form.
inline std::vector<Chart> ellipsoid_charts(const Rational& a, const Rational& b, const Rational& c,
                                           const std::string& piece) {
  const ChartStructure structure{
      .quadric = Quadric{.squares = {1 / (a * a), 1 / (b * b), 1 / (c * c)}, .linear = {{0, 0, 0}, -1}},
      .revolution = a == b ? std::optional(z_axis()) : std::nullopt};
  std::vector<Chart> charts;
  for (const int z : {1, -1})
    for (const int y : {1, -1})
      for (const int x : {1, -1}) {
        const bool right_handed = x * y * z > 0;  // then D_s F x D_t F points outwards
        std::string name = "octant_";
        for (const int sign : {x, y, z}) name += sign > 0 ? 'p' : 'm';
        charts.push_back(make_exact_chart<EllipsoidOctant>(
            {.name = std::move(name),
             .piece = piece,
             .domain = ChartDomain::unit_triangle,
             .orientation =
                 right_handed ? Orientation::against_the_cross_product : Orientation::along_the_cross_product,
             .structure = structure},
            a, b, c, Octant{x, y, z}));
      }
  return charts;
}

}  // namespace detail

/// An ellipsoid with centre 0 and half axes a, b, c, by eight charts over the faces of the octahedron.
/// Maths     (x/a)^2 + (y/b)^2 + (z/c)^2 = 1
/// Source    n = 8, 32, 128, ... as in [ac98, section 3]
/// Requires  a, b, c > 0, else ContractViolation
/// Result    one smooth piece `ellipsoid`, inner normals
/// Limits    -
inline Surface ellipsoid(const Rational& a, const Rational& b, const Rational& c) {
  expects(a > Rational(0) && b > Rational(0) && c > Rational(0), "a, b, c > 0", named("a", a), named("b", b),
          named("c", c));
  Surface surface;
  surface.name = "ellipsoid";
  surface.parameters = {{"a", a}, {"b", b}, {"c", c}};
  surface.charts = detail::ellipsoid_charts(a, b, c, "ellipsoid");
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  return surface;
}

/// The unit sphere, by the same eight charts.
/// Maths     x^2 + y^2 + z^2 = 1
/// Source    G = 1/4 on it: [m06, Lemma 1 (d)]
/// Requires  -
/// Result    one smooth piece `sphere`, inner normals
/// Limits    -
inline Surface sphere() {
  Surface surface;
  surface.name = "sphere";
  surface.charts = detail::ellipsoid_charts(1, 1, 1, "sphere");
  surface.diagonals.assign(surface.charts.size(), Diagonal::main);
  surface.closed = true;
  return surface;
}

}  // namespace radcert
