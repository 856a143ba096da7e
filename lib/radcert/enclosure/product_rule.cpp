// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/product_rule.h"

#include <cstddef>
#include <memory>
#include <vector>

#include "radcert/enclosure/gauss_legendre.h"

namespace radcert {

RuleInOneVariable rule_for_ellipse(int nodes, double rho, double bound) {
  return {.nodes = nodes, .error = gauss_error_factor(nodes, rho) * Ball(bound)};
}

ProductRuleValue by_product_rule(const SquareFunction& f, const SquareCell& cell,
                                 const RuleInOneVariable& in_x, const RuleInOneVariable& in_y) {
  const std::shared_ptr<const IntervalRule<Ball>> rule_x = enclosed_gauss_rule(in_x.nodes);
  const std::shared_ptr<const IntervalRule<Ball>> rule_y = enclosed_gauss_rule(in_y.nodes);
  const Ball half_x = (Ball(cell.x_high) - Ball(cell.x_low)) / 2;
  const Ball half_y = (Ball(cell.y_high) - Ball(cell.y_low)) / 2;
  const Ball middle_x = (Ball(cell.x_low) + Ball(cell.x_high)) / 2;
  const Ball middle_y = (Ball(cell.y_low) + Ball(cell.y_high)) / 2;
  std::vector<Ball> abscissae_y;
  for (const Ball& node : rule_y->nodes) abscissae_y.push_back(middle_y + half_y * node);
  Ball sum;
  for (std::size_t i = 0; i < rule_x->nodes.size(); ++i) {
    const Ball at_x = middle_x + half_x * rule_x->nodes[i];
    Ball row;
    for (std::size_t j = 0; j < abscissae_y.size(); ++j) {
      row = fma(rule_y->weights[j], f.in_balls(at_x, abscissae_y[j]), row);
    }
    sum = fma(rule_x->weights[i], row, sum);
  }
  const Ball area = half_x * half_y;
  const Ball error = 2 * area * (in_x.error + in_y.error);
  return {.value = widened(area * sum, error), .error = error};
}

}  // namespace radcert
