// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/lagrange_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/upward.h"

namespace radcert {

LagrangeTable::LagrangeTable(int nodes, const PartOfInterval& part, int at)
    : nodes_(static_cast<std::size_t>(nodes)) {
  const std::vector<double>& x = gauss_on_interval(nodes).nodes;
  for (const double node : gauss_on_interval(at).nodes) {
    const double place = part.place(node);
    double moduli = 0;
    for (std::size_t a = 0; a < nodes_; ++a) {
      double value = 1;
      for (std::size_t b = 0; b < nodes_; ++b)
        if (b != a) value *= (place - x[b]) / (x[a] - x[b]);
      values_.push_back(value);
      moduli += std::abs(value);
    }
    largest_ = std::max(largest_, moduli * upward);
  }
}

double lagrange_moduli_at_the_ends(int nodes) {
  static const std::array<double, most_gauss_nodes + 1> table = [] {
    std::array<double, most_gauss_nodes + 1> made{};
    for (int n = 1; n <= most_gauss_nodes; ++n)
      made[static_cast<std::size_t>(n)] = LagrangeTable(n, {.middle = 1, .half = 0}, 1).largest();
    return made;
  }();
  return table[static_cast<std::size_t>(nodes)];
}

}  // namespace radcert
