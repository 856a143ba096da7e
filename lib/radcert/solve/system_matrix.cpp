// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/system_matrix.h"

#include <algorithm>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/solve/product.h"
#include "radcert/solve/rounding/accurate_dot.h"

namespace radcert {

const Matrix<double>& SystemMatrix::entries() const {
  expects(has_entries(), "a matrix of entries");
  return *stored();
}

void SystemProducts::multiply(std::span<const double> x, std::span<double> y) const {
  if (entries_)
    radcert::multiply(*entries_, x, y);
  else
    products_->multiply(x, y);
}

void SystemProducts::multiply_sizes(std::span<const double> x, std::span<double> y) const {
  if (entries_)
    radcert::multiply_sizes(*entries_, x, y);
  else
    products_->multiply_sizes(x, y);
}

void SystemProducts::accurate_product(std::span<const double> x, std::span<double> y) const {
  if (entries_)
    std::ranges::copy(radcert::accurate_product(*entries_, x), y.begin());
  else
    products_->multiply_accurately(x, y);
}

void SystemProducts::accurate_residual(std::span<const double> v, std::span<const double> e,
                                       std::span<double> r) const {
  if (entries_) {
    radcert::accurate_residual(*entries_, v, e, r);
    return;
  }
  products_->multiply_accurately(v, r);
  for (std::size_t i = 0; i < r.size(); ++i) r[i] += e[i] - v[i];
}

}  // namespace radcert
