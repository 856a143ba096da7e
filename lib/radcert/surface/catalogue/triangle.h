// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A triangle as a chart whose inner normal points to the side of a given point.
/// Maths     F(s,t) = a + s (b-a) + t (c-a) on the unit triangle
/// Source    the faces of a polyhedron
/// Requires  a, b, c not in one line; `inside` off their plane, else ContractViolation
/// Result    domain, plane and orientation of the facts are set, all exactly
/// Limits    -
inline Chart make_triangle(ChartFacts facts, const Vector<Rational>& a, const Vector<Rational>& b,
                           const Vector<Rational>& c, const Vector<Rational>& inside) {
  const int side = dot(cross(b - a, c - a), inside - a).sign();
  expects(side != 0, "a point off the plane of the triangle", named("chart", facts.name));
  facts.domain = ChartDomain::unit_triangle;
  facts.orientation =
      side > 0 ? Orientation::along_the_cross_product : Orientation::against_the_cross_product;
  facts.plane = Plane(a, b - a, c - a);
  return make_exact_chart<Rectangle>(std::move(facts), a, b - a, c - a);
}

}  // namespace radcert
