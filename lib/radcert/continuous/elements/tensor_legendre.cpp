// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/elements/tensor_legendre.h"

#include <algorithm>

namespace radcert {

PolynomialSizes polynomial_sizes(const SectorFunctions& functions, std::size_t element, std::size_t first,
                                 std::size_t last) {
  const auto powers = static_cast<std::size_t>(functions.degree() + 1);
  PolynomialSizes sizes{.by_s = std::vector<double>(powers), .by_t = std::vector<double>(powers)};
  for (std::size_t k = first; k < last; ++k) {
    const std::span<const double> c = functions.of(element, k);
    for (std::size_t i = 0; i < powers; ++i) {
      double of_s = 0;
      double of_t = 0;
      for (std::size_t j = 0; j < powers; ++j) {
        if (!std::isfinite(c[i * powers + j])) of_s = of_t = HUGE_VAL;
        of_s += std::abs(c[i * powers + j]);
        of_t += std::abs(c[j * powers + i]);
      }
      sizes.by_s[i] = std::max(sizes.by_s[i], of_s);
      sizes.by_t[i] = std::max(sizes.by_t[i], of_t);
    }
  }
  return sizes;
}

double size_around(const SectorFunctions& functions, std::size_t element, double along, double across) {
  const auto powers = static_cast<std::size_t>(functions.degree() + 1);
  double largest = 0;
  for (std::size_t k = 0; k < functions.count(); ++k) {
    const std::span<const double> c = functions.of(element, k);
    double sum = 0;
    for (std::size_t i = powers; i-- > 0;) {
      double inner = 0;
      for (std::size_t j = powers; j-- > 0;) inner = inner * across + std::abs(c[i * powers + j]);
      sum = sum * along + inner;
    }
    if (!std::isfinite(sum)) return HUGE_VAL;
    largest = std::max(largest, sum);
  }
  return largest * upward;
}

}  // namespace radcert
