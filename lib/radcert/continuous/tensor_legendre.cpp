// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/tensor_legendre.h"

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

}  // namespace radcert
