// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace radcert {

/// A dense matrix, stored by columns.
/// Maths     A = (a_ij), 0 <= i < rows, 0 <= j < columns
/// Source    -
/// Requires  indices in range; not checked
/// Result    zero at first; column(j) is contiguous
/// Limits    storage only; the algebra lives in `solve`
template <class R>
class Matrix {
public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), entries_(rows * columns) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  R& operator()(std::size_t i, std::size_t j) { return entries_[j * rows_ + i]; }
  const R& operator()(std::size_t i, std::size_t j) const { return entries_[j * rows_ + i]; }
  std::span<R> column(std::size_t j) { return std::span<R>(entries_).subspan(j * rows_, rows_); }
  std::span<const R> column(std::size_t j) const {
    return std::span<const R>(entries_).subspan(j * rows_, rows_);
  }

private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<R> entries_;
};

}  // namespace radcert
