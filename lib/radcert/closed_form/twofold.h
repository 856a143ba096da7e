// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "radcert/closed_form/bounded_double.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/mpfr_real.h"

namespace radcert {

/// A number as the sum of two doubles, and vectors of such.
/// Maths     head + tail, |tail| <= 2^-53 |head|
/// Source    Dekker, A floating-point technique for extending the available precision, 1971; Knuth's exact sum
/// Requires  nothing overflows or underflows
/// Result    of a product of vectors: about 2^-100 of the product of their lengths, beside the rounding to the two doubles
/// Limits    + - * / and sqrt to about 2^-100 of the result, for preparing directions; formulas run in other arithmetics
struct Twofold {
  double head = 0;
  double tail = 0;
};
struct TwofoldVector {
  std::array<double, 3> head{};
  std::array<double, 3> tail{};
};

inline Twofold twofold(const Mpfr<50>& x) {
  const double head = x.to_double();
  return {head, (x - Mpfr<50>(head)).to_double()};
}

inline TwofoldVector twofold(const Vector<Mpfr<50>>& a) {
  const std::array parts{twofold(a.x), twofold(a.y), twofold(a.z)};
  TwofoldVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.head[i] = parts[i].head;
    result.tail[i] = parts[i].tail;
  }
  return result;
}

/// a + b and its rounding, exactly.
inline Twofold exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

inline Twofold operator-(const Twofold& a) { return {-a.head, -a.tail}; }
inline Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold heads = exact_sum(a.head, b.head);
  const Twofold tails = exact_sum(a.tail, b.tail);
  const Twofold sum = exact_sum(heads.head, heads.tail + tails.head);
  return exact_sum(sum.head, sum.tail + tails.tail);
}
inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }
inline Twofold operator*(const Twofold& a, const Twofold& b) {
  const double head = a.head * b.head;
  return exact_sum(head, std::fma(a.head, b.head, -head) + (a.head * b.tail + a.tail * b.head));
}
inline Twofold operator/(const Twofold& a, const Twofold& b) {
  const double first = a.head / b.head;
  const Twofold rest = a - Twofold{first, 0} * b;
  const double second = rest.head / b.head;
  const double third = (rest - Twofold{second, 0} * b).head / b.head;
  return exact_sum(first, second) + Twofold{third, 0};
}
/// Of a positive number.
inline Twofold sqrt(const Twofold& a) {
  const double root = std::sqrt(a.head);
  return exact_sum(root, (a - Twofold{root, 0} * Twofold{root, 0}).head / (2 * root));
}

/// p - a, within 2^-105 (|p| + |a|), and the head within 2^-53 of itself and that: where p and a are close, the tail of a may be of the
/// size of the difference of the heads.
inline TwofoldVector difference(const std::array<double, 3>& p, const TwofoldVector& a) {
  TwofoldVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Twofold heads = exact_sum(p[i], -a.head[i]);
    const Twofold d = exact_sum(heads.head, heads.tail - a.tail[i]);
    result.head[i] = d.head;
    result.tail[i] = d.tail;
  }
  return result;
}

/// direction . difference: the products and sums of the heads are exact, the tails' are rounded.
inline Twofold twofold_product(const TwofoldVector& direction, const TwofoldVector& difference) {
  double sum = 0;
  double tail = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double head = direction.head[i] * difference.head[i];
    const Twofold next = exact_sum(sum, head);
    sum = next.head;
    tail += next.tail + std::fma(direction.head[i], difference.head[i], -head) +
            (direction.head[i] * difference.tail[i] + direction.tail[i] * difference.head[i]);
  }
  return exact_sum(sum, tail);
}

/// What twofold_product, as two doubles, is off by.
/// Maths     Let m bound the sum of the largest coordinates whose difference was taken, and |direction| <= 1. What is added up in
///           `tail` is at most (2 + 1 + 2 + 1) sqrt(3) 2^-53 m: the roundings of two sums and of three products, and the
///           products with either tail. Each part of it suffers at most five roundings. The products of two tails, and what is
///           wrong with the tails themselves, are at most 11 2^-106 m. Together less than 40 2^-106 (3 m)
/// Requires  size >= 3 m |direction|; or, where the second factor is an exact vector, size >= the product of the lengths.
///           size >= 1e-200: then nothing is lost by underflow
inline double twofold_product_error(double size) { return 40 * 0x1p-106 * size; }

/// The head alone: rounded once more. Requires what twofold_product_error does.
inline BoundedDouble product(const TwofoldVector& direction, const TwofoldVector& difference, double size) {
  const double value = twofold_product(direction, difference).head;
  return {value, 0x1.04p-53 * std::abs(value) + twofold_product_error(size)};
}

/// a + s (b - a), within 2^-102 (|a| + |b|).
inline Twofold between(const Twofold& a, const Twofold& b, const Twofold& s) { return a + s * (b - a); }
/// The same.
inline Twofold between(const Twofold& a, const Twofold& b, double s) {
  const Twofold difference = exact_sum(b.head, -a.head);
  const double head = s * difference.head;
  const Twofold sum = exact_sum(a.head, head);
  return exact_sum(sum.head, sum.tail + std::fma(s, difference.head, -head) +
                                 s * (difference.tail + b.tail - a.tail) + a.tail);
}

}  // namespace radcert
