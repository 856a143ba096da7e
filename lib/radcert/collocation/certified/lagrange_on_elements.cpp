// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/lagrange_on_elements.h"

#include <algorithm>

#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr int largest_degree = 8;

}  // namespace

LagrangeOnElements::LagrangeOnElements(const LagrangeFunctions& functions)
    : functions_(functions), indices_(lattice_indices(functions.degree())) {
  const auto factorial = [](int n) {
    Rational product = 1;
    for (int i = 2; i <= n; ++i) product *= Rational(i);
    return product;
  };
  Rational largest = 0;
  for (std::size_t j = 0; j < functions.size(); ++j) {
    const std::span<const Rational> c = functions.bernstein_coefficients(j);
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      const auto [k1, k2, k3] = indices_[k];
      const Rational multinomial =
          factorial(functions.degree()) / (factorial(k1) * factorial(k2) * factorial(k3));
      coefficients_.push_back(from_rational<BoundedDouble>(c[k] * multinomial));
      largest = std::max(largest, abs(c[k]));
    }
  }
  largest_ = largest.to_double() * (1 + 4 * unit);
}

void LagrangeOnElements::values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const {
  std::array<std::array<BoundedDouble, largest_degree + 1>, 3> powers;
  for (std::size_t i = 0; i < 3; ++i) {
    powers[i][0] = 1;
    for (int k = 1; k <= functions_.degree(); ++k) {
      const auto place = static_cast<std::size_t>(k);
      powers[i][place] = powers[i][place - 1] * at.in_element.x[i];
    }
  }
  for (BoundedDouble& value : out) value = 0;
  for (std::size_t k = 0; k < indices_.size(); ++k) {
    const auto [k1, k2, k3] = indices_[k];
    const BoundedDouble monomial = powers[0][static_cast<std::size_t>(k1)] *
                                   powers[1][static_cast<std::size_t>(k2)] *
                                   powers[2][static_cast<std::size_t>(k3)];
    for (std::size_t j = 0; j < size(); ++j)
      out[j] = out[j] + coefficients_[j * indices_.size() + k] * monomial;
  }
}

double LagrangeOnElements::bound(const ElementPoint<TaylorModel>& at) const {
  double sum = 0;
  for (const TaylorModel& x : at.in_element.x) sum += x.magnitude_bound();
  double product = largest_;
  for (int k = 0; k < functions_.degree(); ++k) product *= sum * (1 + 4 * unit);
  return product * (1 + 32 * unit);
}

}  // namespace radcert
