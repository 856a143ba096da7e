// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/gauss_tables.h"

#include <cstddef>

#include "radcert/core/contract.h"

namespace radcert {

const IntervalRule<double>& gauss_on_interval(int n) {
  expects(n >= 1 && n <= most_gauss_nodes, "1 <= n <= most_gauss_nodes", named("n", n));
  static const std::vector<IntervalRule<double>> rules = [] {
    std::vector<IntervalRule<double>> made;
    for (int count = 1; count <= most_gauss_nodes; ++count) {
      const IntervalRule<Ball> enclosed = legendre_rule(count);
      IntervalRule<double>& rule = made.emplace_back();
      for (const Ball& node : enclosed.nodes) rule.nodes.push_back(node.to_double());
      for (const Ball& weight : enclosed.weights) rule.weights.push_back(weight.to_double());
    }
    return made;
  }();
  return rules[static_cast<std::size_t>(n - 1)];
}

}  // namespace radcert
