// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace radcert {

/// An allocator that leaves new numbers as they are: memory is first touched by the thread that fills it.
template <class R>
class UninitialisedAllocator : public std::allocator<R> {
public:
  template <class Other>
  struct rebind {
    using other = UninitialisedAllocator<Other>;
  };
  template <class Item, class... Arguments>
  void construct(Item* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0)
      ::new (static_cast<void*>(at)) Item;
    else
      ::new (static_cast<void*>(at)) Item(std::forward<Arguments>(arguments)...);
  }
};

/// A dense matrix, stored by columns.
/// Maths     A = (a_ij), 0 <= i < rows, 0 <= j < columns
/// Requires  indices in range; not checked
/// Result    zero at first, or `uninitialised`; column(j) is contiguous
/// Limits    storage only; the algebra lives in `solve`
template <class R>
class Matrix {
public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), entries_(rows * columns, R()) {}
  /// A matrix of which every entry is still to be written.
  static Matrix uninitialised(std::size_t rows, std::size_t columns) {
    Matrix matrix;
    matrix.rows_ = rows;
    matrix.columns_ = columns;
    matrix.entries_ = Storage(rows * columns);
    return matrix;
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  R& operator()(std::size_t i, std::size_t j) { return entries_[j * rows_ + i]; }
  const R& operator()(std::size_t i, std::size_t j) const { return entries_[j * rows_ + i]; }
  std::span<R> column(std::size_t j) { return std::span<R>(entries_).subspan(j * rows_, rows_); }
  std::span<const R> column(std::size_t j) const {
    return std::span<const R>(entries_).subspan(j * rows_, rows_);
  }

private:
  using Storage = std::vector<R, UninitialisedAllocator<R>>;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  Storage entries_;
};

}  // namespace radcert
