// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "radcert/scalar/rational.h"

namespace radcert {

/// The arithmetic a rational formula needs.
/// Maths     a ring with division: + - * / and unary minus, with the usual laws up to the rounding of the
///           type
/// Source    CONTRIBUTING.md, on arithmetics
/// Requires  operands that are values of the type; division by zero is the type's own business
/// Result    a concept; Rational, every Real, Dual and DividedDifference model it
/// Limits    no order and no comparison: a formula never branches on them
// clang-format off
template <class T>
concept Field = std::copyable<T> && requires(const T& a, const T& b) {
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a * b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { -a } -> std::convertible_to<T>;
};
// clang-format on

/// How an exact number enters an arithmetic.
/// Maths     from_rational<R>(q) is q in R; pi<R>() is the circle number in R
/// Requires  a specialisation for R
/// Result    double, long double, Mpfr: rounded to nearest (long double: within one unit in the last place);
///           Ball: enclosed; Dual: a constant
/// Limits    an arithmetic without a specialisation does not compile
template <class R>
struct Constants;

/// Numbers as they enter double: rounded to nearest.
template <>
struct Constants<double> {
  static double from_rational(const Rational& q) { return q.to_double(); }
  static double pi() { return std::numbers::pi; }
};

/// Numbers as they enter long double: within one unit in the last place.
template <>
struct Constants<long double> {
  static long double from_rational(const Rational& q) {
    const double head = q.to_double();
    const double tail = (q - Rational::exactly(head)).to_double();
    return static_cast<long double>(head) + static_cast<long double>(tail);
  }
  static long double pi() { return std::numbers::pi_v<long double>; }
};

/// An exact number in an arithmetic, see Constants.
template <class R>
R from_rational(const Rational& q) {
  return Constants<R>::from_rational(q);
}

/// The circle number in an arithmetic, see Constants.
template <class R>
R pi() {
  return Constants<R>::pi();
}

namespace detail {
// clang-format off
template <class T>
concept HasElementaryFunctions = requires(const T& a) {
  { sqrt(a) } -> std::convertible_to<T>;
  { exp(a) } -> std::convertible_to<T>;
  { log(a) } -> std::convertible_to<T>;
  { sin(a) } -> std::convertible_to<T>;
  { cos(a) } -> std::convertible_to<T>;
  { atan(a) } -> std::convertible_to<T>;
  { pow(a, a) } -> std::convertible_to<T>;
};
// clang-format on
}  // namespace detail

/// A field with the elementary functions, found by argument-dependent lookup or in std.
/// Maths     sqrt exp log sin cos atan pow
/// Source    CONTRIBUTING.md, on arithmetics
/// Result    a concept; double, long double, Pack, Mpfr, Ball and their Dual model it, others join by
///           providing the functions
/// Limits    as Field
// clang-format off
template <class T>
concept Real = Field<T> && (std::floating_point<T> || detail::HasElementaryFunctions<T>);
// clang-format on

/// The whole power x^n by repeated squaring, the same formula in every field.
/// Maths     x^n, and 1 / x^(-n) for n < 0;  x^0 = 1
/// Requires  x != 0 if n < 0
/// Result    at most 2 log2(n) roundings of the type
template <Field T>
T power(const T& x, long n) {
  unsigned long left = n < 0 ? 0UL - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
  if (left == 0) return T(1);
  T square = x;
  for (; (left & 1U) == 0; left >>= 1U) square = square * square;
  T result = square;
  for (left >>= 1U; left != 0; left >>= 1U) {
    square = square * square;
    if ((left & 1U) != 0) result = result * square;
  }
  return n < 0 ? T(1) / result : result;
}

/// 1/x: arithmetics that divide by the same number several times give it a cheaper form.
template <Field T>
T reciprocal(const T& x) {
  return T(1) / x;
}

/// A product and a sum, for the inner loops.
/// Maths     a b + c
/// Result    one rounding where the arithmetic has a fused operation, else two
template <Field T>
T multiply_add(const T& a, const T& b, const T& c) {
  using std::fma;
  if constexpr (requires { fma(a, b, c); }) {
    return fma(a, b, c);
  } else {
    return a * b + c;
  }
}

/// The double nearest to a number of any arithmetic: it chooses rules and enters no result.
template <class R>
double nearest_double(const R& x) {
  if constexpr (std::floating_point<R>) {
    return static_cast<double>(x);
  } else {
    return x.to_double();
  }
}

/// The largest relative rounding of one operation: half the distance from 1 to the next number. Ball has
/// none: its rounding is in the radius.
template <class R>
  requires(std::numeric_limits<R>::is_specialized || requires { R::unit_roundoff(); })
constexpr R unit_roundoff() {
  if constexpr (requires { R::unit_roundoff(); }) {
    return R::unit_roundoff();
  } else {
    return std::numeric_limits<R>::epsilon() / 2;
  }
}

/// Comparisons that a formula may branch on in every arithmetic.
/// Maths     a < b, a <= b, 0 < x, x < 0, x = 0, each where it is certain
/// Source    CONTRIBUTING.md, on arithmetics
/// Result    numbers: the comparison itself, false for a NaN. Ball: true if it holds for all points of the
///           balls; then neither certainly_less(a, b) nor certainly_less(b, a) need be true: see select_less
/// Limits    of Pack only certainly_zero, which is true if all lanes are zero
template <class T>
  requires requires(const T& a) {
    { a < a } -> std::convertible_to<bool>;
  }
bool certainly_less(const T& a, const T& b) { return a < b; }
template <class T>
  requires requires(const T& a) {
    { a <= a } -> std::convertible_to<bool>;
  }
bool certainly_at_most(const T& a, const T& b) { return a <= b; }
template <class T>
  requires requires(const T& a) {
    { a < a } -> std::convertible_to<bool>;
  }
bool certainly_positive(const T& x) { return T(0) < x; }
template <class T>
  requires requires(const T& a) {
    { a < a } -> std::convertible_to<bool>;
  }
bool certainly_negative(const T& x) { return x < T(0); }
template <class T>
  requires requires(const T& a) {
    { a == a } -> std::convertible_to<bool>;
  }
bool certainly_zero(const T& x) { return x == T(0); }

/// An arithmetic of sets: what cannot be decided is the hull of both cases.
template <class T>
concept Enclosing = requires(const T& a) {
  { hull(a, a) } -> std::convertible_to<T>;
};

/// A branch that every arithmetic can take: both values are there, the comparison chooses.
/// Maths     if_less where a < b, otherwise elsewhere
/// Result    Ball: the hull of both where a and b overlap; Pack: lane by lane; a NaN is not less
/// Limits    a branch that costs much, or that must not be evaluated for the other case, asks certainly_less
///           itself
template <class T>
  requires(!Enclosing<T>)
T select_less(const T& a, const T& b, const T& if_less, const T& otherwise) {
  return certainly_less(a, b) ? if_less : otherwise;
}

/// The smaller and the larger of two values of any arithmetic.
/// Maths     min(a, b), max(a, b)
/// Result    exact; the first where they are equal; a NaN on either side is a NaN, unlike std::min
template <class T>
T smaller_of(const T& a, const T& b) {
  if constexpr (std::floating_point<T>) {
    return b < a ? b : (a <= b ? a : a + b);
  } else if constexpr (requires { min(a, b); }) {
    return min(a, b);
  } else {
    return b < a ? b : a;
  }
}
template <class T>
T larger_of(const T& a, const T& b) {
  if constexpr (std::floating_point<T>) {
    return a < b ? b : (b <= a ? a : a + b);
  } else if constexpr (requires { max(a, b); }) {
    return max(a, b);
  } else {
    return a < b ? b : a;
  }
}

}  // namespace radcert
