// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "radcert/scalar/mpfr_real.h"

namespace radcert {

/// A double-double: a number as the sum of two doubles.
/// Maths     head + tail, |tail| <= 2^-53 |head|
/// Source    Dekker, A floating-point technique for extending the available precision, 1971; Knuth's exact
///           sum
/// Requires  nothing overflows or underflows
/// Limits    + - * / and sqrt to about 2^-100 of the result, for preparing directions; formulas run in other
///           arithmetics
struct DoubleDouble {
  double head = 0;
  double tail = 0;
};

/// A number of 50 digits, rounded to the sum of two doubles.
inline DoubleDouble double_double(const Mpfr<50>& x) {
  const double head = x.to_double();
  return {head, (x - Mpfr<50>(head)).to_double()};
}

/// a + b and its rounding, exactly.
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// The four operations, to about 2^-100 of the result.
inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.head, -a.tail}; }
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble heads = exact_sum(a.head, b.head);
  const DoubleDouble tails = exact_sum(a.tail, b.tail);
  const DoubleDouble sum = exact_sum(heads.head, heads.tail + tails.head);
  return exact_sum(sum.head, sum.tail + tails.tail);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double head = a.head * b.head;
  return exact_sum(head, std::fma(a.head, b.head, -head) + (a.head * b.tail + a.tail * b.head));
}
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.head / b.head;
  const DoubleDouble rest = a - DoubleDouble{first, 0} * b;
  const double second = rest.head / b.head;
  const double third = (rest - DoubleDouble{second, 0} * b).head / b.head;
  return exact_sum(first, second) + DoubleDouble{third, 0};
}
/// Of a positive number.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  const double root = std::sqrt(a.head);
  return exact_sum(root, (a - DoubleDouble{root, 0} * DoubleDouble{root, 0}).head / (2 * root));
}

/// a + s (b - a), within 2^-102 (|a| + |b|).
inline DoubleDouble between(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& s) {
  return a + s * (b - a);
}
/// The same.
inline DoubleDouble between(const DoubleDouble& a, const DoubleDouble& b, double s) {
  const DoubleDouble difference = exact_sum(b.head, -a.head);
  const double head = s * difference.head;
  const DoubleDouble sum = exact_sum(a.head, head);
  return exact_sum(sum.head, sum.tail + std::fma(s, difference.head, -head) +
                                 s * (difference.tail + b.tail - a.tail) + a.tail);
}

}  // namespace radcert
