// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radcert/enclosure/square_function.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/functions/taylor_model.h"

namespace radcert {

/// The Gauss rules that integrate the kernel, and what bounds their errors.
/// Maths     nodes and weights on [0, 1]; for f analytic and bounded by M in the ellipse with the half axes
///           (rho +- 1/rho)/2 in units of half the interval, rho = ellipses[r], the rule m is off by at most
///           factors[m][r] M times half the interval
/// Source    enclosed_gauss_rule, gauss_error_factor
/// Result    the factors are rounded up
struct GaussOrders {
  static constexpr std::array<int, 12> orders{2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 17, 20};
  static constexpr std::array<double, 11> ellipses{2, 3, 4, 5.5, 7.5, 10, 14, 20, 30, 50, 100};

  struct Rule {
    std::vector<BoundedDouble> nodes;
    std::vector<BoundedDouble> weights;
  };

  GaussOrders();
  std::array<Rule, orders.size()> rules;
  std::array<std::array<double, ellipses.size()>, orders.size()> factors{};
};

/// A Taylor model's variables over the disk around the ellipse of one side of a rectangle, and over the other
/// side. The disks are made larger than rounding.
struct Disks {
  TaylorModel x;
  TaylorModel y;
};
[[nodiscard]] Disks disks_around(const SquareCell& cell, SquareAxis axis, double ellipse);

}  // namespace radcert
