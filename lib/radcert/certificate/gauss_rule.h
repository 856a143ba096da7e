// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert::certificate {

/// Gauss' rule on [-1,1].
/// Maths     exact for polynomials of degree 2n - 1: nodes the zeros of P_n, weights 2/((1-x^2) P_n'(x)^2)
/// Result    nodes ascending and weights enclosed; in double off by 2^-53 of their size at most
struct GaussRule {
  std::vector<Ball> nodes;
  std::vector<Ball> weights;
  std::vector<double> near_nodes;
  std::vector<double> near_weights;
};

/// The most nodes of a rule that is kept.
inline constexpr int most_nodes = 20;

/// The rule of n nodes, proved.
/// Maths     P_n changes its sign n times on disjoint intervals, and has no more zeros
/// Requires  1 <= n <= most_nodes, else ContractViolation
/// Result    made once
[[nodiscard]] const GaussRule& gauss_rule(int n);

/// The most nodes of a rule that is made anew.
inline constexpr int most_long_nodes = 400;

/// The same for 1 <= n <= most_long_nodes, else ContractViolation; made anew.
[[nodiscard]] GaussRule long_gauss_rule(int n);

/// A ball in double.
[[nodiscard]] BoundedDouble bounded(const Ball& x);

/// P_0(x), ..., P_degree(x).
template <class R>
[[nodiscard]] std::vector<R> legendre(int degree, const R& x) {
  std::vector<R> p{R(1)};
  if (degree > 0) p.push_back(x);
  for (int i = 1; i < degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    p.push_back((R(2 * i + 1) * x * p[k] - R(i) * p[k - 1]) / R(i + 1));
  }
  return p;
}

}  // namespace radcert::certificate
