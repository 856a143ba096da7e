// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/polynomial/rational_polynomial.h"

namespace radcert {

/// How many different real zeros a polynomial has on an interval.
/// Maths     the number of x with lower < x <= upper and p(x) = 0, each counted once
/// Source    Sturm's theorem, for the square-free part of p
/// Requires  p != 0, lower <= upper, else ContractViolation
/// Result    exact
[[nodiscard]] int zeros_between(const RationalPolynomial& p, const Rational& lower, const Rational& upper);

/// A real zero, enclosed.
/// Maths     exactly one zero x with lower < x <= upper, or x = lower = upper
/// Result    plain data
struct RealZero {
  Rational lower;
  Rational upper;
  [[nodiscard]] bool is_exact() const { return lower == upper; }
};

/// The different real zeros on a closed interval, in ascending order.
/// Maths     all x with lower <= x <= upper and p(x) = 0
/// Source    Sturm's theorem and bisection
/// Requires  p != 0, lower <= upper, width > 0, else ContractViolation
/// Result    as many enclosures as zeros, each at most so wide; a zero that is the fraction with the smallest
///           denominator in its enclosure is found exactly
/// Limits    a rational zero with a denominator that is large for `width` stays an interval
[[nodiscard]] std::vector<RealZero> real_zeros(const RationalPolynomial& p, const Rational& lower,
                                               const Rational& upper, const Rational& width);

}  // namespace radcert
