// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace radcert {

/// A complex number enclosed, by a rectangle: what a formula gives on a complex neighbourhood.
/// Maths     the set {x + iy : x in real(), y in imag()}; an operation gives a set that contains its value at
///           all points of the operands. sqrt, log, pow and atan are the principal branches, abs, min, max
///           and select_less the analytic functions that agree with those of real numbers around the operand
/// Source    Arb (acb_t): F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval
///           arithmetic", 2017; the rule that a value means analyticity: F. Johansson, "Numerical integration
///           in arbitrary-precision ball arithmetic", 2018, section 2
/// Requires  precision from BallPrecision::current(), at the time of each operation
/// Result    either finite, or failed as Ball is: failure() names the first operation that could not bound
///           its result or that is not analytic at every point of its operands. Every operation is analytic
///           on a neighbourhood of operands where its result is finite, so a formula whose value over a
///           closed set is finite is analytic around that set, and bounded on it by the value. There is no
///           NaN
/// Limits    a ball around zero has no sqrt and no non-whole power, though the real ones exist there. No ==
///           and no <; certainly_less and the like compare real parts
class ComplexBall {
public:
  /// Exactly zero.
  ComplexBall() noexcept = default;
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool> && sizeof(Integer) <= 8)
  ComplexBall(Integer value) : ComplexBall(Ball(value)) {}  // NOLINT(google-explicit-constructor): exact
  /// The double, exactly; infinities and NaN fail.
  template <std::same_as<double> Double>
  explicit ComplexBall(Double value) : ComplexBall(Ball(value)) {}
  /// At the current precision; exact where the rational has a short binary expansion.
  explicit ComplexBall(const Rational& value) : ComplexBall(Ball(value)) {}
  explicit ComplexBall(const Ball& real);
  ComplexBall(const Ball& real, const Ball& imag);
  ComplexBall(const ComplexBall& other);
  ComplexBall(ComplexBall&& other) noexcept { exchange(other); }
  ComplexBall& operator=(const ComplexBall& other);
  ComplexBall& operator=(ComplexBall&& other) noexcept {
    exchange(other);
    return *this;
  }
  ~ComplexBall();

  /// The whole plane; `reason` is a literal, or lives as long as the program.
  [[nodiscard]] static ComplexBall failed(const char* reason);

  [[nodiscard]] bool is_finite() const { return failure_ == nullptr; }
  /// Which operation failed first; empty if the value is finite.
  [[nodiscard]] std::string_view failure() const {
    return failure_ == nullptr ? std::string_view() : std::string_view(failure_);
  }
  [[nodiscard]] bool contains_zero() const;
  [[nodiscard]] bool contains(const ComplexBall& other) const;
  /// Whether every point is real.
  [[nodiscard]] bool is_real() const;
  /// The parts as balls, with the failure of a failed value.
  [[nodiscard]] Ball real() const;
  [[nodiscard]] Ball imag() const;
  /// Encloses |z|.
  [[nodiscard]] Ball magnitude() const;
  /// A double that |z| does not exceed; infinity if failed.
  [[nodiscard]] double magnitude_bound() const;
  /// "real + imag i", or "unbounded: <failure>".
  [[nodiscard]] std::string to_text(int digits = 20) const;

  ComplexBall& operator+=(const ComplexBall& other) { return *this = *this + other; }
  ComplexBall& operator-=(const ComplexBall& other) { return *this = *this - other; }
  ComplexBall& operator*=(const ComplexBall& other) { return *this = *this * other; }
  ComplexBall& operator/=(const ComplexBall& other) { return *this = *this / other; }
  [[nodiscard]] ComplexBall operator-() const;
  [[nodiscard]] friend ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) { return a.plus(b); }
  [[nodiscard]] friend ComplexBall operator-(const ComplexBall& a, const ComplexBall& b) {
    return a.minus(b);
  }
  [[nodiscard]] friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
    return a.times(b);
  }
  [[nodiscard]] friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) { return a.over(b); }
  friend void swap(ComplexBall& a, ComplexBall& b) noexcept { a.exchange(b); }

  /// 1/x; fails if x may contain zero.
  friend ComplexBall reciprocal(const ComplexBall& x);
  /// x^n, for every n and x except 0^n with n < 0; x^0 = 1.
  friend ComplexBall power(const ComplexBall& x, long n);
  /// Fails if x touches (-inf, 0].
  friend ComplexBall sqrt(const ComplexBall& x);
  friend ComplexBall exp(const ComplexBall& x);
  /// Fails if x touches (-inf, 0].
  friend ComplexBall log(const ComplexBall& x);
  friend ComplexBall sin(const ComplexBall& x);
  friend ComplexBall cos(const ComplexBall& x);
  /// Fails if x may contain a pole.
  friend ComplexBall tan(const ComplexBall& x);
  /// Fails if x touches iy with |y| >= 1.
  friend ComplexBall atan(const ComplexBall& x);
  /// exp(y log x), and the product where y is exactly a whole number; otherwise fails if x touches (-inf, 0].
  friend ComplexBall pow(const ComplexBall& x, const ComplexBall& y);
  /// x or -x, by the sign of the real part; fails where that changes.
  friend ComplexBall abs(const ComplexBall& x);
  /// By the order of the real parts; fail where that changes.
  friend ComplexBall min(const ComplexBall& a, const ComplexBall& b);
  friend ComplexBall max(const ComplexBall& a, const ComplexBall& b);

  /// The smallest rectangle around two, up to rounding.
  friend ComplexBall hull(const ComplexBall& a, const ComplexBall& b);
  /// A rectangle around the common points of two that enclose one number, as for Ball.
  friend ComplexBall intersection(const ComplexBall& a, const ComplexBall& b);

  /// Whether the rectangles have a point in common.
  friend bool overlaps(const ComplexBall& a, const ComplexBall& b);
  /// Whether the real part of every point of a is less than that of every point of b; false if either has
  /// failed.
  friend bool certainly_less(const ComplexBall& a, const ComplexBall& b);
  friend bool certainly_at_most(const ComplexBall& a, const ComplexBall& b);
  friend bool certainly_positive(const ComplexBall& x);
  friend bool certainly_negative(const ComplexBall& x);
  /// Whether x is the point 0.
  friend bool certainly_zero(const ComplexBall& x);
  /// if_less or otherwise by the order of the real parts of a and b; fails where that changes.
  friend ComplexBall select_less(const ComplexBall& a, const ComplexBall& b, const ComplexBall& if_less,
                                 const ComplexBall& otherwise);

  /// Points to the acb_t inside, for sources that include acb.h.
  [[nodiscard]] const void* acb() const noexcept { return storage_.data(); }
  /// The value of an acb_t; one that is not finite fails for this reason, see failed().
  [[nodiscard]] static ComplexBall from_acb(const void* acb, const char* reason);

private:
  friend struct ComplexBallAccess;
  [[nodiscard]] ComplexBall plus(const ComplexBall& other) const;
  [[nodiscard]] ComplexBall minus(const ComplexBall& other) const;
  [[nodiscard]] ComplexBall times(const ComplexBall& other) const;
  [[nodiscard]] ComplexBall over(const ComplexBall& other) const;
  void exchange(ComplexBall& other) noexcept {
    std::swap(storage_, other.storage_);
    std::swap(failure_, other.failure_);
  }

  /// An acb_t, which may be moved as bytes; all zero it is 0.
  alignas(8) std::array<std::byte, 96> storage_{};
  const char* failure_ = nullptr;
};

/// Numbers as they enter complex balls: enclosed, with the imaginary part 0.
template <>
struct Constants<ComplexBall> {
  static ComplexBall from_rational(const Rational& q) { return ComplexBall(q); }
  static ComplexBall pi() { return ComplexBall(Ball::pi()); }
};

/// First and second divided differences of a power in the plane cut along (-inf, 0], enclosed.
/// Maths     phi(x) = x^e, b = a + d:  first = phi[a,b] = Int_0^1 phi'(a + l d) dl,
///           bend = phi[a,a,b] = Int_0^1 (1-l) phi''(a + l d) dl
/// Source    both are means over the segment from a to b, and a rectangle that contains phi'' (or phi') there
///           contains them; the definitions
/// Requires  b contains a + d for the a and d that are meant
/// Result    contains the value for all such a, b, d, also where d contains 0; a failure where the smallest
///           rectangle around a and b touches the cut
/// Limits    as for bend_of_power of Ball, which is closer
[[nodiscard]] ComplexBall bend_of_power(const ComplexBall& a, const ComplexBall& b, const ComplexBall& d,
                                        const ComplexBall& e);
[[nodiscard]] ComplexBall first_of_power(const ComplexBall& a, const ComplexBall& b, const ComplexBall& d,
                                         const ComplexBall& e, const ComplexBall& bend);

}  // namespace radcert
