// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/rounding/accurate_dot.h"

#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/solve/product.h"

namespace radcert {
namespace {

/// Sums of some rows, each an unevaluated sum of a value and a much smaller error.
struct AccurateSums {
  std::array<double, rows_at_a_time> value{};
  std::array<double, rows_at_a_time> error{};

  void add(std::size_t i, double term, double term_error) {
    const double before = value[i];
    const double after = before + term;
    const double back = after - before;
    value[i] = after;
    error[i] += term_error + ((before - (after - back)) + (term - back));
  }

  void add_products(const Matrix<double>& a, std::span<const double> x, std::size_t begin, std::size_t rows) {
    for (std::size_t j = 0; j < a.columns(); ++j) {
      const double* column = a.column(j).data() + begin;
      const double factor = x[j];
      for (std::size_t i = 0; i < rows; ++i) {
        const double product = column[i] * factor;
        add(i, product, std::fma(column[i], factor, -product));
      }
    }
  }
};

}  // namespace

std::vector<double> accurate_product(const Matrix<double>& a, std::span<const double> x) {
  expects(a.columns() == x.size(), "a vector of the matrix's width", named("columns", a.columns()),
          named("size", x.size()));
  std::vector<double> y(a.rows());
  parallel_for(a.rows(), rows_at_a_time, [&](std::size_t begin, std::size_t end) {
    AccurateSums sums;
    sums.add_products(a, x, begin, end - begin);
    for (std::size_t i = begin; i < end; ++i) y[i] = sums.value[i - begin] + sums.error[i - begin];
  });
  return y;
}

void accurate_residual(const Matrix<double>& k, std::span<const double> v, std::span<const double> e,
                       std::span<double> r) {
  expects(k.rows() == k.columns() && v.size() == k.rows() && e.size() == k.rows() && r.size() == k.rows(),
          "a square matrix and vectors of its size", named("rows", k.rows()), named("columns", k.columns()),
          named("v", v.size()), named("e", e.size()), named("r", r.size()));
  parallel_for(k.rows(), rows_at_a_time, [&](std::size_t begin, std::size_t end) {
    AccurateSums sums;
    for (std::size_t i = begin; i < end; ++i) {
      sums.add(i - begin, e[i], 0);
      sums.add(i - begin, -v[i], 0);
    }
    sums.add_products(k, v, begin, end - begin);
    for (std::size_t i = begin; i < end; ++i) r[i] = sums.value[i - begin] + sums.error[i - begin];
  });
}

}  // namespace radcert
