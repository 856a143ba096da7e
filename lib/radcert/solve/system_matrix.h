// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/core/matrix.h"
#include "radcert/core/ranks/vector_parts.h"

namespace radcert {

/// A square matrix that is known by its products alone.
/// Result    multiply: y = K x, wrong by rounding() max|x| in each entry at most; multiply_sizes, for x >= 0:
///           y_i >= sum_j |k_ij| x_j but for rounding; multiply_accurately: y = K x with as much of it as
///           possible in twice the precision, and within rounding() max|x| too. The same bits for any number
///           of threads; Interrupted when asked to stop
/// Requires  of the caller: vectors of size() entries, none shared
class ProductOperator {
public:
  ProductOperator() = default;
  ProductOperator(const ProductOperator&) = delete;
  ProductOperator& operator=(const ProductOperator&) = delete;
  virtual ~ProductOperator() = default;

  /// The entries of a vector here: all of them but where ranks share the work.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// How the entries lie on the ranks; by default all of them here.
  [[nodiscard]] virtual VectorParts parts() const { return VectorParts(size()); }
  virtual void multiply(std::span<const double> x, std::span<double> y) const = 0;
  virtual void multiply_sizes(std::span<const double> x, std::span<double> y) const = 0;
  virtual void multiply_accurately(std::span<const double> x, std::span<double> y) const = 0;
  [[nodiscard]] virtual double rounding() const = 0;
};

/// The products of a system's matrix, be it one of entries or an operator: all that an iteration may ask for,
/// so that each serves both.
/// Requires  what it is made of outlives it
/// Result    a reference; with entries the functions of product.h and accurate_dot.h, to the bit
class SystemProducts {
public:
  SystemProducts(const Matrix<double>& entries)  // NOLINT(google-explicit-constructor): a view
      : entries_(&entries) {}
  SystemProducts(const ProductOperator& products)  // NOLINT(google-explicit-constructor): a view
      : products_(&products) {}

  [[nodiscard]] std::size_t rows() const { return entries_ ? entries_->rows() : products_->size(); }
  [[nodiscard]] std::size_t columns() const { return entries_ ? entries_->columns() : products_->size(); }
  [[nodiscard]] VectorParts parts() const { return entries_ ? VectorParts(rows()) : products_->parts(); }

  void multiply(std::span<const double> x, std::span<double> y) const;
  void multiply_sizes(std::span<const double> x, std::span<double> y) const;
  /// See accurate_product.
  void accurate_product(std::span<const double> x, std::span<double> y) const;
  /// r = e - v + K v; see accurate_residual.
  void accurate_residual(std::span<const double> v, std::span<const double> e, std::span<double> r) const;
  /// What a product or a residual may be wrong by in an entry, in parts of max|x|, beside what their
  /// descriptions say of entries: 0 there, an estimate for operators.
  [[nodiscard]] double rounding() const { return entries_ ? 0 : products_->rounding(); }

protected:
  [[nodiscard]] const Matrix<double>* stored() const { return entries_; }

private:
  const Matrix<double>* entries_ = nullptr;
  const ProductOperator* products_ = nullptr;
};

/// A system's matrix with its entries where there are some.
class SystemMatrix : public SystemProducts {
public:
  using SystemProducts::SystemProducts;

  [[nodiscard]] bool has_entries() const { return stored() != nullptr; }
  /// ContractViolation where there are none.
  [[nodiscard]] const Matrix<double>& entries() const;
};

}  // namespace radcert
