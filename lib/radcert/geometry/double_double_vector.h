// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/double_double.h"

namespace radcert {

/// A vector of double-doubles.
/// Result    of a product of two: about 2^-100 of the product of their lengths, beside the rounding to the
///           two doubles
struct DoubleDoubleVector {
  std::array<double, 3> head{};
  std::array<double, 3> tail{};
};

/// A vector of 50 digits, each coordinate rounded to two doubles.
inline DoubleDoubleVector double_double(const Vector<Mpfr<50>>& a) {
  const std::array parts{double_double(a.x), double_double(a.y), double_double(a.z)};
  DoubleDoubleVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.head[i] = parts[i].head;
    result.tail[i] = parts[i].tail;
  }
  return result;
}

/// p - a, within 2^-105 (|p| + |a|), and the head within 2^-53 of itself and that: where p and a are close,
/// the tail of a may be of the size of the difference of the heads.
inline DoubleDoubleVector difference(const std::array<double, 3>& p, const DoubleDoubleVector& a) {
  DoubleDoubleVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble heads = exact_sum(p[i], -a.head[i]);
    const DoubleDouble d = exact_sum(heads.head, heads.tail - a.tail[i]);
    result.head[i] = d.head;
    result.tail[i] = d.tail;
  }
  return result;
}

/// direction . difference: the products and sums of the heads are exact, the tails' are rounded.
inline DoubleDouble product_in_double_double(const DoubleDoubleVector& direction,
                                             const DoubleDoubleVector& difference) {
  double sum = 0;
  double tail = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double head = direction.head[i] * difference.head[i];
    const DoubleDouble next = exact_sum(sum, head);
    sum = next.head;
    tail += next.tail + std::fma(direction.head[i], difference.head[i], -head) +
            (direction.head[i] * difference.tail[i] + direction.tail[i] * difference.head[i]);
  }
  return exact_sum(sum, tail);
}

/// The error bound of product_in_double_double, as two doubles.
/// Maths     Let m bound the sum of the largest coordinates whose difference was taken, and |direction| <= 1.
///           What is added up in `tail` is at most (2 + 1 + 2 + 1) sqrt(3) 2^-53 m: the roundings of two sums
///           and of three products, and the products with either tail. Each part of it suffers at most five
///           roundings. The products of two tails, and what is wrong with the tails themselves, are at most
///           11 2^-106 m. Together less than 40 2^-106 (3 m)
/// Requires  size >= 3 m |direction|; or, where the second factor is an exact vector, size >= the product of
///           the lengths. size >= 1e-200: then nothing is lost by underflow
inline double product_error(double size) { return 40 * 0x1p-106 * size; }

/// The head alone: rounded once more. Requires what product_error does.
inline BoundedDouble product(const DoubleDoubleVector& direction, const DoubleDoubleVector& difference,
                             double size) {
  const double value = product_in_double_double(direction, difference).head;
  return {value, 0x1.04p-53 * std::abs(value) + product_error(size)};
}

/// The same in doubles: both factors are rounded, the product, and two sums; and the difference itself is
/// known to 2^-105 of what it was taken of. Requires what product_error does.
inline BoundedDouble plain_product(const DoubleDoubleVector& direction, const DoubleDoubleVector& difference,
                                   double size) {
  double sum = 0;
  double absolute = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double term = direction.head[i] * difference.head[i];
    sum += term;
    absolute += std::abs(term);
  }
  return {sum, 5.1 * 0x1p-53 * absolute + product_error(size)};
}

/// The length of an exact vector whose largest part is in [1, 2): three roundings of a positive sum, which
/// the root halves, and its own.
inline BoundedDouble bounded_length(const std::array<double, 3>& a) {
  double squared = 0;
  for (const double part : a) squared = std::fma(part, part, squared);
  const double length = std::sqrt(squared);
  return {length, 3 * 0x1p-53 * length};
}

}  // namespace radcert
