// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace radcert {

/// A Gauss rule on [0,1] of the tests' own, by Newton's iteration: (node, weight).
inline std::vector<std::pair<double, double>> gauss_legendre(int count) {
  std::vector<std::pair<double, double>> rule;
  for (int k = 0; k < count; ++k) {
    long double x = std::cos(std::numbers::pi_v<long double> * (k + 0.75L) / (count + 0.5L));
    long double slope = 0;
    for (int step = 0; step < 8; ++step) {
      long double before = 1;
      long double here = x;
      for (int n = 2; n <= count; ++n)
        before = std::exchange(here, ((2 * n - 1) * x * here - (n - 1) * before) / n);
      slope = count * (x * here - before) / (x * x - 1);
      x -= here / slope;
    }
    rule.emplace_back(static_cast<double>((1 + x) / 2),
                      static_cast<double>(1 / ((1 - x * x) * slope * slope)));
  }
  return rule;
}

/// Int_low^high f by the rule.
template <class Function>
double integral(const std::vector<std::pair<double, double>>& rule, double low, double high,
                const Function& f) {
  double sum = 0;
  for (const auto& [node, weight] : rule) sum += weight * f(low + (high - low) * node);
  return (high - low) * sum;
}

}  // namespace radcert
