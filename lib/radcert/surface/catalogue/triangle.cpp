// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/triangle.h"

#include <utility>

#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {

Chart make_triangle(ChartFacts facts, const Vector<Rational>& a, const Vector<Rational>& b,
                    const Vector<Rational>& c, const Vector<Rational>& inside) {
  facts.domain = ChartDomain::unit_triangle;
  facts.orientation = orientation_towards(inside, a, b - a, c - a);
  facts.plane = Plane(a, b - a, c - a);
  return make_exact_chart<Rectangle>(std::move(facts), a, b - a, c - a);
}

}  // namespace radcert
