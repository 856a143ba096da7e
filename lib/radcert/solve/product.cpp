// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/product.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

template <class Entry>
void multiply_entries(const Matrix<double>& a, std::span<const double> x, std::span<double> y, Entry entry) {
  expects(a.columns() == x.size() && a.rows() == y.size(), "vectors of the matrix's shape",
          named("rows", a.rows()), named("columns", a.columns()), named("x", x.size()), named("y", y.size()));
  parallel_for(a.rows(), rows_at_a_time, [&](std::size_t begin, std::size_t end) {
    std::array<double, rows_at_a_time> sum{};
    const std::size_t rows = end - begin;
    for (std::size_t j = 0; j < a.columns(); ++j) {
      const double* column = a.column(j).data() + begin;
      const double factor = x[j];
      for (std::size_t i = 0; i < rows; ++i) sum[i] += entry(column[i]) * factor;
    }
    std::copy_n(sum.begin(), rows, y.begin() + static_cast<std::ptrdiff_t>(begin));
  });
}

}  // namespace

void multiply(const Matrix<double>& a, std::span<const double> x, std::span<double> y) {
  multiply_entries(a, x, y, [](double value) { return value; });
}

void multiply_sizes(const Matrix<double>& a, std::span<const double> x, std::span<double> y) {
  multiply_entries(a, x, y, [](double value) { return std::abs(value); });
}

}  // namespace radcert
