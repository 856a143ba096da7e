// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert::certificate {
namespace {

/// P_n'(x) = n (x P_n - P_(n-1)) / (x^2 - 1).
Ball slope(int n, const Ball& x, const std::vector<Ball>& p) {
  const auto last = static_cast<std::size_t>(n);
  return Ball(n) * (x * p[last] - p[last - 1]) / (x * x - Ball(1));
}

}  // namespace

GaussRule long_gauss_rule(int n) {
  expects(n >= 1 && n <= most_long_nodes, "1 <= n <= most_long_nodes", named("n", n));
  // A step of the recurrence in balls may cost a bit and a half.
  const int more = 2 * std::max(0, n - most_nodes);
  const BallPrecision precision(256 + 2 * more);
  GaussRule rule;
  const Ball reach(std::ldexp(1.0, -200 - more));
  for (int k = 0; k < n; ++k) {
    Ball x(-std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5)));
    constexpr int steps = 8;
    for (int step = 0; step < steps; ++step) {
      const std::vector<Ball> p = legendre(n, x);
      x = (x - p.back() / slope(n, x, p)).midpoint();
    }
    const Ball before = legendre(n, x - reach).back();
    const Ball after = legendre(n, x + reach).back();
    expects((certainly_negative(before) && certainly_positive(after)) ||
                (certainly_positive(before) && certainly_negative(after)),
            "a zero between the ends", named("n", n));
    const Ball node = widened(x, reach);
    if (k > 0) expects(certainly_less(rule.nodes.back(), node), "zeros apart from each other");
    const Ball derivative = slope(n, node, legendre(n, node));
    rule.nodes.push_back(node);
    rule.weights.push_back(Ball(2) / ((Ball(1) - node * node) * derivative * derivative));
    rule.near_nodes.push_back(rule.nodes.back().to_double());
    rule.near_weights.push_back(rule.weights.back().to_double());
  }
  return rule;
}

const GaussRule& gauss_rule(int n) {
  expects(n >= 1 && n <= most_nodes, "1 <= n <= most_nodes", named("n", n));
  static const std::vector<GaussRule> rules = [] {
    std::vector<GaussRule> all;
    for (int count = 1; count <= most_nodes; ++count) all.push_back(long_gauss_rule(count));
    return all;
  }();
  return rules[static_cast<std::size_t>(n - 1)];
}

BoundedDouble bounded(const Ball& x) {
  const double value = x.to_double();
  return {value, abs(x - Ball(value)).upper_double()};
}

}  // namespace radcert::certificate
