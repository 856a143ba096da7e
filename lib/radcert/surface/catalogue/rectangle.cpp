// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/catalogue/rectangle.h"

#include <utility>

#include "radcert/surface/exact_chart.h"

namespace radcert {

Chart make_rectangle(ChartFacts facts, const Vector<Rational>& origin, const Vector<Rational>& first,
                     const Vector<Rational>& second) {
  facts.domain = ChartDomain::unit_square;
  facts.plane = Plane(origin, first, second);
  return make_exact_chart<Rectangle>(std::move(facts), origin, first, second);
}

}  // namespace radcert
