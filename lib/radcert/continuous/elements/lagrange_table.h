// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"

namespace radcert {

/// Lagrange's polynomials of Gauss nodes at the nodes of a rule on a part of the interval.
/// Maths     l_a(x) = prod_(b != a) (x - x_b)/(x_a - x_b), x_a the nodes as doubles
/// Requires  1 <= nodes, at <= most_gauss_nodes, else ContractViolation
/// Result    each off by 4 n u of itself, for x as it is rounded: within 16 u of its place, two units of a
///           node and at most 11 u of the part
class LagrangeTable {
public:
  LagrangeTable(int nodes, const PartOfInterval& part, int at);

  /// l_a at node i.
  [[nodiscard]] double operator()(std::size_t i, std::size_t a) const { return values_[i * nodes_ + a]; }
  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  /// The largest sum_a |l_a| at a node, rounded up.
  [[nodiscard]] double largest() const { return largest_; }

private:
  std::size_t nodes_;
  std::vector<double> values_;
  double largest_ = 0;
};

/// sum_a |l_a| at the ends of the interval, where it is largest.
/// Requires  1 <= nodes <= most_gauss_nodes
/// Result    rounded up
[[nodiscard]] double lagrange_moduli_at_the_ends(int nodes);

}  // namespace radcert
