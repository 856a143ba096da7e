// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/mode_products.h"

#include <array>

#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

/// The product for `Many` vectors at a time: a block of the matrix is loaded once for all of them.
template <std::size_t Many>
void add_products(const Matrix<double>& a, std::size_t rows, std::size_t columns,
                  const std::array<const double*, Many>& x, const std::array<double*, Many>& y) {
  for (std::size_t i = 0; i < rows; i += Pack::lanes) {
    std::array<Pack, Many> sum;
    for (std::size_t c = 0; c < Many; ++c) sum[c] = Pack::load(y[c] + i);
    const double* entry = a.column(0).data() + i;
    for (std::size_t j = 0; j < columns; ++j, entry += a.rows()) {
      const Pack block = Pack::load(entry);
      for (std::size_t c = 0; c < Many; ++c) sum[c] = fma(block, Pack(x[c][j]), sum[c]);
    }
    for (std::size_t c = 0; c < Many; ++c) sum[c].store(y[c] + i);
  }
}

}  // namespace

void add_mode_product(const Matrix<double>& a, std::size_t rows, std::size_t columns,
                      std::span<const double* const> x, std::span<double* const> y) {
  if (rows == 0 || columns == 0) return;
  constexpr std::size_t many = 4;
  std::size_t c = 0;
  for (; c + many <= x.size(); c += many)
    add_products<many>(a, rows, columns, {x[c], x[c + 1], x[c + 2], x[c + 3]},
                       {y[c], y[c + 1], y[c + 2], y[c + 3]});
  for (; c < x.size(); ++c) add_products<1>(a, rows, columns, {x[c]}, {y[c]});
}

}  // namespace radcert
