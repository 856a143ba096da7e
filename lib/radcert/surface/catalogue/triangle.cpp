// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/triangle.h"

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Chart make_triangle(ChartFacts facts, const Vector<Rational>& a, const Vector<Rational>& b,
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
