// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/rules/gauss.h"

namespace radcert {

/// The rules with up to this many nodes that the continuous problem is integrated by.
inline constexpr int most_gauss_nodes = 16;

/// Gauss-Legendre on [-1,1]: nodes and weights within two units in the last place, weights with the sum 2.
/// Requires  1 <= n <= most_gauss_nodes, else ContractViolation
/// Result    made once, safe to ask for from several threads
[[nodiscard]] const IntervalRule<double>& gauss_on_interval(int n);

}  // namespace radcert
