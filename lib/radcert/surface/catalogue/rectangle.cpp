// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/rectangle.h"

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Chart make_rectangle(ChartFacts facts, const Vector<Rational>& origin, const Vector<Rational>& first,
                     const Vector<Rational>& second) {
  facts.domain = ChartDomain::unit_square;
  facts.plane = Plane(origin, first, second);
  return make_exact_chart<Rectangle>(std::move(facts), origin, first, second);
}

Chart make_rectangle(ChartFacts facts, const Vector<Rational>& origin, const Vector<Rational>& first,
                     const Vector<Rational>& second, const Vector<Rational>& inside) {
  facts.orientation = orientation_towards(inside, origin, first, second);
  return make_rectangle(std::move(facts), origin, first, second);
}

Orientation orientation_towards(const Vector<Rational>& inside, const Vector<Rational>& origin,
                                const Vector<Rational>& first, const Vector<Rational>& second) {
  const int side = dot(cross(first, second), inside - origin).sign();
  expects(side != 0, "a point off the plane", named("x", inside.x), named("y", inside.y),
          named("z", inside.z));
  return side > 0 ? Orientation::along_the_cross_product : Orientation::against_the_cross_product;
}

}  // namespace radcert
