// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace radcert {

/// A ball as two decimals, midpoint and radius.
struct BallDecimal {
  std::string midpoint;
  std::string radius;
};

/// A binary number as two decimal integers: mantissa 2^exponent.
struct BinaryNumber {
  std::string mantissa;
  std::string exponent;
};

/// A real number enclosed: a midpoint and a radius that bounds all error.
/// Maths     the set [m - r, m + r]; an operation on balls gives a ball that contains its value at all points
///           of the operands
/// Source    Arb (arb_t): F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval
///           arithmetic", 2017
/// Requires  precision from BallPrecision::current(), at the time of each operation; a double or a whole
///           number enters exactly, 0.1 as the double that it is: a decimal enters as Rational or by parse()
/// Result    the exact value is always enclosed. A ball is either finite, or the whole line with failure()
///           naming the first operation that could not bound its result: division by a ball that contains
///           zero, sqrt or log outside the domain, and so on. A failure stays: every operation on such a ball
///           has the same failure, sin and atan, products with zero and zeroth powers included, intersection
///           alone excepted; so a finite ball proves that the formula has a value for every point of its
///           operands. There is no NaN. x * x with one and the same object is a square, and never negative
/// Limits    no == and no <: ask certainly_less, contains, overlaps. Mantissas beyond 128 bits are kept on
///           the heap, by Arb. An exponent grows as far as memory goes; exp beyond 2^(2^60) or so is a
///           failure
class Ball {
public:
  /// Exactly zero.
  Ball() noexcept = default;
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool> && sizeof(Integer) <= 8)
  Ball(Integer value) : Ball() {  // NOLINT(google-explicit-constructor): exact
    if constexpr (std::signed_integral<Integer>) {
      set_signed(value);
    } else {
      set_unsigned(value);
    }
  }
  /// The double, exactly; infinities and NaN fail.
  template <std::same_as<double> Double>
  explicit Ball(Double value) : Ball() {
    set_double(value);
  }
  /// At the current precision; exact where the rational has a short binary expansion.
  explicit Ball(const Rational& value);
  Ball(const Ball& other);
  Ball(Ball&& other) noexcept { exchange(other); }
  Ball& operator=(const Ball& other);
  Ball& operator=(Ball&& other) noexcept {
    exchange(other);
    return *this;
  }
  ~Ball();

  /// The whole line; `reason` is a literal, or lives as long as the program.
  [[nodiscard]] static Ball failed(const char* reason);
  [[nodiscard]] static Ball pi();
  /// "0.1", "-1.5e-3", "1/6", "[0.1 +/- 1e-3]", "0.1 +/- 1e-3": a ball that contains all that the text says.
  [[nodiscard]] static Outcome<Ball> parse(std::string_view text);
  /// What midpoint_binary() and radius_binary() wrote, to the bit; another radius is rounded up. Refused: an
  /// exponent of more than 30 digits.
  [[nodiscard]] static Outcome<Ball> from_binary(const BinaryNumber& midpoint, const BinaryNumber& radius);

  [[nodiscard]] bool is_finite() const { return failure_ == nullptr; }
  /// Which operation failed first; empty if the ball is finite.
  [[nodiscard]] std::string_view failure() const {
    return failure_ == nullptr ? std::string_view() : std::string_view(failure_);
  }
  /// Whether the radius is zero.
  [[nodiscard]] bool is_exact() const;
  [[nodiscard]] bool contains_zero() const;
  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] bool contains(const Rational& value) const;
  [[nodiscard]] bool contains(const Ball& other) const;

  /// The midpoint as an exact ball; a failed ball has that failure.
  [[nodiscard]] Ball midpoint() const;
  /// An upper bound of the radius, exact from 2^-1000 to 2^1000; infinity if failed.
  [[nodiscard]] double radius() const;
  /// The radius as an exact ball; a failed ball has that failure.
  [[nodiscard]] Ball radius_ball() const;
  /// The ends as exact balls, rounded outwards at the current precision; a failed ball has that failure.
  [[nodiscard]] Ball lower() const;
  [[nodiscard]] Ball upper() const;
  /// Doubles that bound the ball, the nearest such beside at most one step; infinite if failed.
  [[nodiscard]] double lower_double() const;
  [[nodiscard]] double upper_double() const;
  /// The double nearest to the midpoint; ContractViolation with the failure if there is none.
  [[nodiscard]] double to_double() const;
  /// About -log2(radius / |midpoint|): how many bits of the midpoint are known. Not positive if none, very
  /// large if exact.
  [[nodiscard]] long accurate_bits() const;

  /// Midpoint and radius in decimal, with at most so many digits of the midpoint and no more than the radius
  /// leaves a meaning; the radius is rounded up after the midpoint has been rounded, so that what is printed
  /// encloses the ball. ContractViolation with the failure if failed, and unless 1 <= digits.
  [[nodiscard]] BallDecimal decimal(int digits) const;
  /// "midpoint +/- radius", "midpoint" if that is exact, or "unbounded: <failure>".
  [[nodiscard]] std::string to_text(int digits = 20) const;
  /// Exactly; ContractViolation with the failure if failed.
  [[nodiscard]] BinaryNumber midpoint_binary() const;
  [[nodiscard]] BinaryNumber radius_binary() const;

  Ball& operator+=(const Ball& other);
  Ball& operator-=(const Ball& other);
  Ball& operator*=(const Ball& other);
  Ball& operator/=(const Ball& other) { return *this = *this / other; }
  [[nodiscard]] Ball operator-() const;
  [[nodiscard]] friend Ball operator+(const Ball& a, const Ball& b) { return a.plus(b); }
  [[nodiscard]] friend Ball operator-(const Ball& a, const Ball& b) { return a.minus(b); }
  [[nodiscard]] friend Ball operator*(const Ball& a, const Ball& b) { return a.times(b); }
  [[nodiscard]] friend Ball operator/(const Ball& a, const Ball& b) { return a.over(b); }
  friend void swap(Ball& a, Ball& b) noexcept { a.exchange(b); }

  // Found by their arguments alone, so that abs(3) in a file that knows balls stays a whole number.

  /// 1/x; fails if x contains zero.
  friend Ball reciprocal(const Ball& x);
  /// x^n, for every n and x except 0^n with n < 0; x^0 = 1. Close to the range of the power also where x is
  /// wide; never negative for even n.
  friend Ball power(const Ball& x, long n);
  /// a b + c.
  friend Ball fma(const Ball& a, const Ball& b, const Ball& c);

  /// Fails if x reaches below zero.
  friend Ball sqrt(const Ball& x);
  friend Ball exp(const Ball& x);
  /// Fails unless x is positive.
  friend Ball log(const Ball& x);
  friend Ball sin(const Ball& x);
  friend Ball cos(const Ball& x);
  /// Fails if x may contain a pole.
  friend Ball tan(const Ball& x);
  /// In [-pi/2, pi/2], up to rounding.
  friend Ball atan(const Ball& x);
  /// x^y as std::pow has it: x >= 0, where x = 0 needs y > 0 or y exactly 0 (then 1); x < 0 with y exactly a
  /// whole number. Fails otherwise.
  friend Ball pow(const Ball& x, const Ball& y);
  /// Never negative.
  friend Ball abs(const Ball& x);
  friend Ball min(const Ball& a, const Ball& b);
  friend Ball max(const Ball& a, const Ball& b);

  /// The smallest ball around two balls, up to rounding.
  friend Ball hull(const Ball& a, const Ball& b);
  /// A ball around the common points of two balls that enclose one number. A failed ball bounds nothing: then
  /// the other, and the failure of `a` if both have failed. ContractViolation if the balls have no point in
  /// common: then one of them is wrong.
  friend Ball intersection(const Ball& a, const Ball& b);
  /// [x - |by|, x + |by|].
  friend Ball widened(const Ball& x, const Ball& by);

  /// Whether the balls have a point in common.
  friend bool overlaps(const Ball& a, const Ball& b);
  /// Whether every point of a is less than every point of b; false if either has failed, as for all that
  /// follow.
  friend bool certainly_less(const Ball& a, const Ball& b);
  /// Whether no point of a exceeds a point of b.
  friend bool certainly_at_most(const Ball& a, const Ball& b);
  friend bool certainly_positive(const Ball& x);
  friend bool certainly_negative(const Ball& x);
  /// Whether x is the point 0.
  friend bool certainly_zero(const Ball& x);
  /// if_less where a < b, otherwise where b < a, the hull of both where that is not certain; fails if a or b
  /// has failed.
  friend Ball select_less(const Ball& a, const Ball& b, const Ball& if_less, const Ball& otherwise);

  /// Points to the arb_t inside, for sources that include arb.h.
  [[nodiscard]] const void* arb() const noexcept { return storage_.data(); }
  /// The ball of an arb_t; one that is not finite fails for this reason, see failed().
  [[nodiscard]] static Ball from_arb(const void* arb, const char* reason);

private:
  friend struct BallAccess;
  void set_signed(long value);
  void set_unsigned(unsigned long value);
  void set_double(double value);
  [[nodiscard]] Ball plus(const Ball& other) const;
  [[nodiscard]] Ball minus(const Ball& other) const;
  [[nodiscard]] Ball times(const Ball& other) const;
  [[nodiscard]] Ball over(const Ball& other) const;
  void exchange(Ball& other) noexcept {
    std::swap(storage_, other.storage_);
    std::swap(failure_, other.failure_);
  }

  /// An arb_t, which may be moved as bytes; all zero it is 0.
  alignas(8) std::array<std::byte, 48> storage_{};
  const char* failure_ = nullptr;
};

/// Numbers as they enter balls: enclosed, at the precision of the moment.
template <>
struct Constants<Ball> {
  static Ball from_rational(const Rational& q) { return Ball(q); }
  static Ball pi() { return Ball::pi(); }
};

}  // namespace radcert
