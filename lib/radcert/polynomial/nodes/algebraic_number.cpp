// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/algebraic_number.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

Rational common_denominator(std::span<const Rational> values) {
  Rational common = 1;
  for (const Rational& value : values) common *= (common * value).denominator();
  return common;
}

// The largest whole number that divides all of these whole numbers.
Rational common_factor(std::span<const Rational> whole) {
  CValue<__mpq_struct, mpq_init, mpq_clear> factor;
  for (const Rational& value : whole)
    mpz_gcd(mpq_numref(factor), mpq_numref(factor), mpq_numref(static_cast<mpq_srcptr>(value.gmp())));
  return Rational::from_gmp(factor);
}

// The square-free part, with whole coefficients that have no factor in common.
RationalPolynomial primitive(const RationalPolynomial& polynomial) {
  const RationalPolynomial free =
      divide(polynomial, greatest_common_divisor(polynomial, polynomial.derivative())).quotient;
  std::vector<Rational> coefficients;
  for (int k = 0; k <= free.degree(); ++k)
    coefficients.push_back(free.coefficient(static_cast<std::size_t>(k)));
  const Rational denominator = common_denominator(coefficients);
  for (Rational& c : coefficients) c *= denominator;
  const Rational factor = common_factor(coefficients);
  for (Rational& c : coefficients) c /= factor;
  return RationalPolynomial(std::move(coefficients));
}

Ball value_of(const RationalPolynomial& p, const Ball& x) {
  Ball sum(0);
  for (int k = p.degree(); k >= 0; --k) sum = sum * x + Ball(p.coefficient(static_cast<std::size_t>(k)));
  return sum;
}

}  // namespace

AlgebraicNumber::AlgebraicNumber(const RationalPolynomial& polynomial, const RealZero& enclosure)
    : polynomial_(primitive(polynomial)), derivative_(polynomial_.derivative()), enclosure_(enclosure) {
  expects(!enclosure.is_exact() && zeros_between(polynomial, enclosure.lower, enclosure.upper) == 1,
          "an interval with one zero of the polynomial", named("polynomial", polynomial),
          named("lower", enclosure.lower), named("upper", enclosure.upper));
  // A zero at the lower end itself is another one.
  while (!enclosure_.is_exact() && polynomial_(enclosure_.lower).sign() == 0)
    enclosure_ = narrower(enclosure_);
}

RealZero AlgebraicNumber::narrower(const RealZero& zero) const {
  return real_zeros(polynomial_, zero.lower, zero.upper, (zero.upper - zero.lower) / 16).back();
}

Ball AlgebraicNumber::log_measure() const {
  Rational squares = 0;
  for (int k = 0; k <= polynomial_.degree(); ++k) {
    const Rational c = polynomial_.coefficient(static_cast<std::size_t>(k));
    squares += c * c;
  }
  return (log(Ball(squares)) / Ball(2)).upper();
}

Ball AlgebraicNumber::value() const {
  constexpr long guard = 32;
  const BallPrecision scope(BallPrecision::current() + guard);
  RealZero start = enclosure_;
  Ball x = hull(Ball(start.lower), Ball(start.upper));
  if (start.is_exact()) return x;
  // Newton's method in intervals: a zero of p in x lies in m - p(m)/p'(x), m the midpoint.
  Ball slope = value_of(derivative_, x);
  while (slope.contains_zero()) {
    // The derivative is not zero at a zero of a square-free polynomial, and keeps its sign near enough.
    start = narrower(start);
    x = hull(Ball(start.lower), Ball(start.upper));
    if (start.is_exact()) return x;
    slope = value_of(derivative_, x);
  }
  while (true) {
    const Ball middle = x.midpoint();
    const Ball next = intersection(x, middle - value_of(polynomial_, middle) / value_of(derivative_, x));
    const bool shrinks = certainly_less(next.radius_ball() * Ball(2), x.radius_ball());
    x = next;
    if (!shrinks) return x;
  }
}

AlgebraicExpression::AlgebraicExpression(const Rational& value) {
  terms_.push_back({.kind = Kind::rational, .rational = value});
}

AlgebraicExpression AlgebraicExpression::number(std::size_t place) {
  AlgebraicExpression out;
  out.terms_.push_back({.kind = Kind::number, .rational = {}, .place = place});
  return out;
}

AlgebraicExpression AlgebraicExpression::operator-() const {
  if (terms_.size() == 1 && terms_[0].kind == Kind::rational) return -terms_[0].rational;
  AlgebraicExpression out = *this;
  out.terms_.push_back({.kind = Kind::negate});
  return out;
}

AlgebraicExpression AlgebraicExpression::joined(const AlgebraicExpression& other, Kind kind) const {
  const auto is_rational = [](const AlgebraicExpression& a) {
    return a.terms_.size() == 1 && a.terms_[0].kind == Kind::rational;
  };
  if (is_rational(*this) && is_rational(other)) {
    const Rational& a = terms_[0].rational;
    const Rational& b = other.terms_[0].rational;
    switch (kind) {
      case Kind::add: return a + b;
      case Kind::subtract: return a - b;
      case Kind::multiply: return a * b;
      default: return a / b;
    }
  }
  AlgebraicExpression out = *this;
  out.terms_.insert(out.terms_.end(), other.terms_.begin(), other.terms_.end());
  out.terms_.push_back({.kind = kind});
  return out;
}

Ball AlgebraicExpression::value(std::span<const Ball> numbers) const {
  std::vector<Ball> open;
  for (const Term& term : terms_) {
    if (term.kind == Kind::rational) {
      open.emplace_back(term.rational);
    } else if (term.kind == Kind::number) {
      open.push_back(numbers[term.place]);
    } else if (term.kind == Kind::negate) {
      open.back() = -open.back();
    } else {
      const Ball right = std::move(open.back());
      open.pop_back();
      Ball& left = open.back();
      switch (term.kind) {
        case Kind::add: left += right; break;
        case Kind::subtract: left -= right; break;
        case Kind::multiply: left *= right; break;
        default: left /= right; break;
      }
    }
  }
  return open.back();
}

Ball AlgebraicExpression::height(const AlgebraicField& field) const {
  std::vector<Ball> open;
  for (const Term& term : terms_) {
    if (term.kind == Kind::rational) {
      open.push_back(field.height(term.rational));
    } else if (term.kind == Kind::number) {
      open.push_back(field.height(term.place));
    } else if (term.kind != Kind::negate) {
      const Ball right = std::move(open.back());
      open.pop_back();
      open.back() += right;
      if (term.kind == Kind::add || term.kind == Kind::subtract) open.back() += field.degree() * log(Ball(2));
    }
  }
  return open.back();
}

AlgebraicField::AlgebraicField(std::vector<AlgebraicNumber> numbers)
    : numbers_(std::move(numbers)), degree_(1) {
  for (const AlgebraicNumber& number : numbers_) degree_ *= Ball(number.degree());
}

std::vector<Ball> AlgebraicField::values() const {
  std::vector<Ball> out;
  for (const AlgebraicNumber& number : numbers_) out.push_back(number.value());
  return out;
}

Ball AlgebraicField::height(std::size_t place) const {
  const AlgebraicNumber& number = numbers_.at(place);
  return degree_ / Ball(number.degree()) * number.log_measure();
}

Ball AlgebraicField::height(const Rational& value) const {
  return height(std::span<const Rational>(&value, 1));
}

Ball AlgebraicField::height(std::span<const Rational> values) const {
  // The absolute values that primes give contribute the common denominator, the others the largest value.
  const Rational denominator = common_denominator(values);
  Rational largest = 1;
  for (const Rational& value : values) largest = std::max(largest, abs(value));
  return degree_ * log(Ball(denominator * largest));
}

Outcome<int> AlgebraicField::sign(const AlgebraicExpression& a, long most_bits) const {
  const Ball bound = a.height(*this);
  constexpr long first_bits = 128;
  for (long bits = first_bits;; bits = more_bits(bits, bits_for(bound))) {
    if (bits > most_bits)
      return because("more than " + std::to_string(most_bits) + " bits would be needed to tell it from zero");
    const BallPrecision scope(bits);
    const Ball value = a.value(values());
    if (certainly_positive(value)) return 1;
    if (certainly_negative(value)) return -1;
    if (is_zero(value, bound) == true) return 0;
  }
}

std::optional<bool> is_zero(const Ball& value, const Ball& height) {
  if (!value.is_finite()) return std::nullopt;
  if (!value.contains_zero()) return false;
  const Ball largest = abs(value).upper();
  if (certainly_zero(largest) || certainly_less(log(largest), -height)) return true;
  return std::nullopt;
}

long more_bits(long bits, long wanted) { return wanted < 4 * bits ? std::max(2 * bits, wanted) : 2 * bits; }

long bits_for(const Ball& height) {
  constexpr long guard = 128;
  const double bits = (height / log(Ball(2))).upper_double();
  if (!(bits < static_cast<double>(std::numeric_limits<long>::max() / 2)))
    return std::numeric_limits<long>::max() / 2;
  return static_cast<long>(std::ceil(bits)) + guard;
}

}  // namespace radcert
