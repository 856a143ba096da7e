// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/cubature/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/real.h"

namespace radcert::reference {
namespace {

const WorkLimit newton_steps("reference/gauss_rule: steps to a zero", 6, 0, "no rule: AccuracyNotReached");

/// P_0(x) ... P_n(x) by the recurrence of Legendre's polynomials.
using Values = std::array<long double, GaussRule::largest + 1>;

Values legendre(std::size_t n, long double x) {
  Values p{1, x};
  for (std::size_t k = 2; k <= n; ++k) {
    const auto degree = static_cast<long double>(k);
    p[k] = ((2 * degree - 1) * x * p[k - 1] - (degree - 1) * p[k - 2]) / degree;
  }
  return p;
}

struct Zero {
  long double x;
  long double slope;  // P_n'(x)
};

/// The zero of P_n number i from the right.
Zero zero(std::size_t n, std::size_t i) {
  const auto degree = static_cast<long double>(n);
  Zero z{std::cos(std::numbers::pi_v<long double> * (static_cast<long double>(i) + 0.75L) / (degree + 0.5L)),
         1};
  long double change = 1;
  // Newton's method doubles the digits of a guess that has two; the slope is one step behind.
  for (long step = 0; step < newton_steps.value(); ++step) {
    const Values p = legendre(n, z.x);
    z.slope = degree * (p[n - 1] - z.x * p[n]) / (1 - z.x * z.x);
    change = p[n] / z.slope;
    z.x -= change;
  }
  if (!(std::abs(change) <= 16 * degree * degree * unit_roundoff<long double>()))
    throw AccuracyNotReached(
        "Gauss' rule of " + std::to_string(n) + " points",
        "its zeros were not found by " + std::to_string(newton_steps.value()) + " steps");
  return z;
}

}  // namespace

GaussRule::GaussRule(std::size_t n) : size_(n), pairs_(std::min(most_pairs, (n - 2) / 2)) {
  expects(smallest <= n && n <= largest, "a number of points in the table", named("n", n));
  for (std::size_t i = 0; i < n; ++i) {
    const Zero z = zero(n, n - 1 - i);
    const long double weight = 1 / ((1 - z.x * z.x) * z.slope * z.slope);
    nodes_[i] = static_cast<double>((1 + z.x) / 2);
    weights_[i] = static_cast<double>(weight);
    const Values p = legendre(n - 1, z.x);
    for (std::size_t k = 0; k < 2 * pairs_; ++k) {
      const std::size_t degree = n - 2 * pairs_ + k;
      const long double norm = std::sqrt(static_cast<long double>(2 * degree + 1));
      null_[i][k] = static_cast<double>(weight * norm * p[degree]);
    }
  }
  for (std::size_t i = n; i < largest; ++i) nodes_[i] = nodes_[n - 1];
}

const GaussRule& GaussRule::of(std::size_t n) {
  static const std::vector<GaussRule> table = [] {
    std::vector<GaussRule> rules;
    for (std::size_t size = smallest; size <= largest; ++size) rules.emplace_back(size);
    return rules;
  }();
  expects(smallest <= n && n <= largest, "a number of points in the table", named("n", n));
  return table[n - smallest];
}

double GaussRule::integral(const Samples& g) const {
  double sum = 0;
  for (std::size_t i = 0; i < size_; ++i) sum = std::fma(weights_[i], g[i], sum);
  return sum;
}

GaussRule::Error GaussRule::error(const Samples& g, std::size_t continued) const {
  Pack sum(0.0);
  for (std::size_t i = 0; i < size_; ++i) sum = fma(Pack(g[i]), Pack::load(null_[i].data()), sum);
  // Two neighbouring degrees together: an even function has no odd coefficients.
  std::array<double, most_pairs> pair{};
  for (std::size_t k = 0; k < pairs_; ++k)
    pair[k] = std::sqrt(sum.lane(2 * k) * sum.lane(2 * k) + sum.lane(2 * k + 1) * sum.lane(2 * k + 1));
  double decay = 0;
  for (std::size_t k = 1; k < pairs_; ++k)
    decay = std::max(decay, pair[k] < pair[k - 1] ? pair[k] / pair[k - 1] : 1.0);
  const double last = pair[pairs_ - 1];
  // Without a clear fall nothing is continued.
  if (decay > 0.5) return {4 * std::max(last, decay * pair[pairs_ - 2]), decay};
  double value = 4 * last;
  for (std::size_t k = 0; k < continued; ++k) value *= decay;
  return {value, decay};
}

}  // namespace radcert::reference
