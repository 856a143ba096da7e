// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/gauss_orders.h"

#include <cmath>

#include "radcert/enclosure/gauss_legendre.h"
#include "radcert/quadrature/certified/bounded_chart.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {

GaussOrders::GaussOrders() {
  // Beyond the digits of a double, so that conversion is all that rounds.
  constexpr long bits = 80;
  const BallPrecision precision(bits);
  for (std::size_t m = 0; m < orders.size(); ++m) {
    const auto rule = enclosed_gauss_rule(orders[m]);
    for (const Ball& node : rule->nodes) rules[m].nodes.push_back(bounded((1 + node) / 2));
    for (const Ball& weight : rule->weights) rules[m].weights.push_back(bounded(weight / 2));
    for (std::size_t r = 0; r < ellipses.size(); ++r)
      factors[m][r] = gauss_error_factor(orders[m], ellipses[r]).upper_double();
  }
}

Disks disks_around(const SquareCell& cell, SquareAxis axis, double ellipse) {
  constexpr double up = 1 + 0x1p-40;
  const auto side = [](double low, double high, double factor, bool complex) {
    const double half = (high - low) / 2;
    const double radius = half * factor * up + 0x1p-50 * (std::abs(low) + std::abs(high));
    const ComplexDouble centre{.real = low + half};
    return complex ? TaylorModel::variable_u(centre, radius) : TaylorModel::variable_v(centre, radius);
  };
  const double longest = (ellipse + 1 / ellipse) / 2;
  const bool in_x = axis == SquareAxis::x;
  return {side(cell.x_low, cell.x_high, in_x ? longest : 1, in_x),
          side(cell.y_low, cell.y_high, in_x ? 1 : longest, !in_x)};
}

}  // namespace radcert
