// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/mean_value_bounds.h"

#include <array>

namespace radcert::verification {
namespace {

// The antiderivative that is 0 at 0.
RationalPolynomial integral(const RationalPolynomial& p) {
  std::vector<Rational> coefficients{0};
  for (int k = 0; k <= p.degree(); ++k)
    coefficients.push_back(p.coefficient(static_cast<std::size_t>(k)) / Rational(k + 1));
  return RationalPolynomial(std::move(coefficients));
}

Rational sum_of(const std::vector<Rational>& numbers) {
  Rational sum = 0;
  for (const Rational& number : numbers) sum += number;
  return sum;
}

Rational coefficients_of(const RationalPolynomial& p) {
  long count = 0;
  for (int k = 0; k <= p.degree(); ++k)
    if (p.coefficient(static_cast<std::size_t>(k)).sign() != 0) ++count;
  return {count};
}

// 1/2 less a column less the square that shows it not to be negative.
RationalPolynomial beyond_half(const MeanValueKernel& kernel) {
  const RationalPolynomial t = RationalPolynomial::variable();
  return Rational(1, 2) - column(kernel) - Rational(1, 2) * (1 - 2 * t) * (1 - 2 * t);
}

// An affine map of the parameters (s,t), a row a coordinate: constant, by s, by t.
using Reflection = std::array<std::array<Rational, 3>, 2>;

// Coefficients of the map less the identity along s + t = 1.
Rational moved_on_the_third_side(const Reflection& map) {
  const RationalPolynomial s = RationalPolynomial::variable();
  const auto along = [&](std::size_t i) { return map[i][0] + map[i][1] * s + map[i][2] * (1 - s); };
  return coefficients_of(along(0) - s) + coefficients_of(along(1) - (1 - s));
}

// Entries of the map's derivative whose sizes are not those of an exchange of s and t.
Rational not_exchanging(const Reflection& map) {
  long count = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      if (abs(map[i][j + 1]) != Rational(i == j ? 0 : 1)) ++count;
  return {count};
}

const Reflection& mirror_image() {
  static const Reflection map{{{1, 0, -1}, {1, -1, 0}}};
  return map;
}

const Reflection& half_turn() {
  static const Reflection map{{{1, -1, 0}, {1, 0, -1}}};
  return map;
}

}  // namespace

MeanValueKernel mean_value_kernel() {
  const RationalPolynomial t = RationalPolynomial::variable();
  return {t, t - 1};
}

MeanValueKernel end_value_kernel() { return {1, 0}; }

Rational failing_conditions(const MeanValueKernel& kernel) {
  const std::array<bool, 5> conditions{kernel.before.derivative() == 1, kernel.after.derivative() == 1,
                                       kernel.before(0) == 0, kernel.after(1) == 0,
                                       kernel.before - kernel.after == 1};
  return {std::count(conditions.begin(), conditions.end(), false)};
}

RationalPolynomial column(const MeanValueKernel& kernel) {
  expects(kernel.before.degree() <= 1 && kernel.after.degree() <= 1, "pieces of degree <= 1");
  for (const Rational& end : {Rational(0), Rational(1)})
    expects(kernel.before(end).sign() >= 0 && kernel.after(end).sign() <= 0, "before >= 0 >= after");
  const RationalPolynomial t = RationalPolynomial::variable();
  return kernel.before * (1 - t) - kernel.after * t;
}

std::vector<Rational> mean_value_factors(int degree) {
  expects(degree >= 0, "degree >= 0", named("degree", degree));
  const Rational half(1, 2);
  std::vector<Rational> factors{1};
  for (int step = 0; step <= degree; ++step) {
    std::vector<Rational> next(factors.size() + 1, Rational(0));
    for (std::size_t j = 0; j < factors.size(); ++j) {
      next[j] += half * factors[j];
      next[j + 1] += half * factors[j];
    }
    factors = std::move(next);
  }
  return factors;
}

Rational mean_slope_factor() {
  // |s - 1/2| on both halves of [0,1].
  const RationalPolynomial rising = integral(RationalPolynomial::variable() - Rational(1, 2));
  const Rational half(1, 2);
  return 2 * ((rising(1) - rising(half)) - (rising(half) - rising(0)));
}

Rational taylor_factor(int degree) {
  expects(degree >= 0, "degree >= 0", named("degree", degree));
  RationalPolynomial kernel = 1;
  for (int k = 0; k <= degree; ++k) {
    const RationalPolynomial rising = integral(kernel);
    kernel = rising(1) - rising;
  }
  return kernel(0);
}

void require_mean_values(Finding& finding, int degree) {
  const IsExactly zero{0};
  finding.require("kernel of f - mean f: conditions for integration by parts that fail", zero,
                  failing_conditions(mean_value_kernel()));
  finding.control("kernel of f - f(0): conditions for integration by parts that fail", zero,
                  failing_conditions(end_value_kernel()));
  finding.require("kernel of f - mean f: coefficients of 1/2 - Int |k| ds - (1 - 2t)^2/2", zero,
                  coefficients_of(beyond_half(mean_value_kernel())));
  finding.control("kernel of f - f(0): coefficients of 1/2 - Int |k| ds - (1 - 2t)^2/2", zero,
                  coefficients_of(beyond_half(end_value_kernel())));
  for (int i = 0; i <= degree; ++i)
    finding.require("sum of the factors of ||Phi - phi_" + std::to_string(i) + "||", IsExactly{1},
                    sum_of(mean_value_factors(i)));
  if (degree >= 1)
    finding.require("factor of ||phi_1 - phi_0||: 2 Int |s - 1/2| ds", IsExactly{Rational(1, 2)},
                    mean_slope_factor());
  finding.require("(s,t) -> (1-t,1-s): coefficients of its shift along s + t = 1", zero,
                  moved_on_the_third_side(mirror_image()));
  finding.require("(s,t) -> (1-t,1-s): entries of its derivative that do not exchange s and t", zero,
                  not_exchanging(mirror_image()));
  finding.control("(s,t) -> (1-s,1-t): coefficients of its shift along s + t = 1", zero,
                  moved_on_the_third_side(half_turn()));
}

}  // namespace radcert::verification
