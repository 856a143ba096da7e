// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>

namespace radcert {

/// A complex number in doubles.
struct ComplexDouble {
  double real = 0;
  double imag = 0;
};

/// An analytic function of two complex variables on a product of disks, enclosed: what a formula gives when
/// its arguments run through disks, without forgetting how its parts depend on each other.
/// Maths     f(u,v) = sum_{i+j <= 4} c_ij u^i v^j + rest(u,v), rest analytic and |rest| <= remainder for |u|,
///           |v| < 1. Norm: |f| = sum |c_ij| + remainder. A product keeps the terms up to degree 4, the
///           remainder takes the norms of the others; phi(c + h) with c = c_00 is sum_k phi_k h^k, where |h|
///           is less than the distance from c to the singularities of phi, and the remainder takes a bound of
///           the tail
/// Source    M. Berz, K. Makino, "Verified integration of ODEs and flows using differential algebraic methods
///           on high-order Taylor models", 1998; here with complex disks for variables, so that the sum of
///           |c_ij| is the range's bound. sqrt, log, pow and atan are the principal branches; abs, min, max
///           and select_less the analytic functions that agree with those of real numbers
/// Requires  variables u and v made by variable(); Ball and Rational enter with their radius
/// Result    either finite, and then every operation made on the way was analytic on the product of the
///           disks; or failed, and failure() names the first operation of which that was not shown. Rounding
///           is in the remainder: a result of doubles errs by less than 2^-46 of the norms that entered, and
///           norms are rounded up. There is no NaN
/// Limits    doubles: a range of size 10^-13 of the numbers on the way is not resolved; numbers beyond 10^150
///           fail, divisors and radicands beyond 10^45 or below 10^-45. Wide disks fail where narrow ones do
///           not
class TaylorModel {
public:
  static constexpr int highest_degree = 4;
  static constexpr std::size_t coefficient_count =
      static_cast<std::size_t>(highest_degree + 1) * (highest_degree + 2) / 2;

  /// Exactly zero.
  TaylorModel() = default;
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool> && sizeof(Integer) <= 4)
  TaylorModel(Integer value) {  // NOLINT(google-explicit-constructor): exact
    real_[0] = static_cast<double>(value);
  }
  template <std::same_as<long> Long>
  TaylorModel(Long value) : TaylorModel(Ball(value)) {}  // NOLINT(google-explicit-constructor): enclosed
  /// The double, exactly; infinities and NaN fail.
  template <std::same_as<double> Double>
  explicit TaylorModel(Double value) : TaylorModel(Ball(value)) {}
  explicit TaylorModel(const Rational& value);
  explicit TaylorModel(const Ball& value);

  /// centre + radius u, or centre + radius v. Radius >= 0 and all finite, else ContractViolation.
  [[nodiscard]] static TaylorModel variable_u(const ComplexDouble& centre, double radius);
  [[nodiscard]] static TaylorModel variable_v(const ComplexDouble& centre, double radius);
  /// `reason` is a literal, or lives as long as the program.
  [[nodiscard]] static TaylorModel failed(const char* reason);

  [[nodiscard]] bool is_finite() const { return failure_ == nullptr; }
  [[nodiscard]] std::string_view failure() const {
    return failure_ == nullptr ? std::string_view() : std::string_view(failure_);
  }
  /// A bound of |f| on the disks; infinity if failed.
  [[nodiscard]] double magnitude_bound() const;
  /// c_00 and a bound of |f - c_00| on the disks. ContractViolation with the failure if failed.
  [[nodiscard]] ComplexDouble centre() const;
  [[nodiscard]] double deviation() const;
  [[nodiscard]] double remainder() const { return remainder_; }
  /// The polynomial's part c_ij u^i v^j. ContractViolation unless i, j >= 0 and i + j <= 4.
  [[nodiscard]] ComplexDouble coefficient(int i, int j) const;

  TaylorModel& operator+=(const TaylorModel& other) { return *this = *this + other; }
  TaylorModel& operator-=(const TaylorModel& other) { return *this = *this - other; }
  TaylorModel& operator*=(const TaylorModel& other) { return *this = *this * other; }
  [[nodiscard]] TaylorModel operator-() const;
  friend TaylorModel operator+(const TaylorModel& a, const TaylorModel& b);
  friend TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) { return a + (-b); }
  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b);
  friend TaylorModel operator/(const TaylorModel& a, const TaylorModel& b) { return a * reciprocal(b); }

  friend TaylorModel reciprocal(const TaylorModel& x);
  friend TaylorModel sqrt(const TaylorModel& x);
  friend TaylorModel exp(const TaylorModel& x);
  friend TaylorModel log(const TaylorModel& x);
  friend TaylorModel sin(const TaylorModel& x);
  friend TaylorModel cos(const TaylorModel& x);
  friend TaylorModel tan(const TaylorModel& x);
  friend TaylorModel atan(const TaylorModel& x);
  /// The product where y is exactly a whole number, else exp(y log x).
  friend TaylorModel pow(const TaylorModel& x, const TaylorModel& y);
  friend TaylorModel abs(const TaylorModel& x);
  friend TaylorModel min(const TaylorModel& a, const TaylorModel& b);
  friend TaylorModel max(const TaylorModel& a, const TaylorModel& b);
  /// A model that contains both.
  friend TaylorModel hull(const TaylorModel& a, const TaylorModel& b);

  /// By the real parts of all values; false if either has failed.
  friend bool certainly_less(const TaylorModel& a, const TaylorModel& b);
  friend bool certainly_at_most(const TaylorModel& a, const TaylorModel& b) { return certainly_less(a, b); }
  friend bool certainly_positive(const TaylorModel& x);
  friend bool certainly_negative(const TaylorModel& x) { return certainly_positive(-x); }
  /// Whether x is the function 0.
  friend bool certainly_zero(const TaylorModel& x);
  friend TaylorModel select_less(const TaylorModel& a, const TaylorModel& b, const TaylorModel& if_less,
                                 const TaylorModel& otherwise);

private:
  friend struct TaylorModelAccess;
  std::array<double, coefficient_count> real_{};  ///< by degree, then by the power of v
  std::array<double, coefficient_count> imag_{};
  int degree_ = 0;  ///< no coefficient beyond is other than 0
  double remainder_ = 0;
  const char* failure_ = nullptr;
};

/// Numbers as they enter Taylor models: constants, enclosed.
template <>
struct Constants<TaylorModel> {
  static TaylorModel from_rational(const Rational& q) { return TaylorModel(q); }
  static TaylorModel pi() { return TaylorModel(Ball::pi()); }
};

/// First and second divided differences of a power, as for ComplexBall.
/// Maths     phi(x) = x^e, b = a + d:  first = phi[a,b], bend = phi[a,a,b]
/// Source    the means over the segment, the definitions
/// Requires  b = a + d
/// Result    contains the function; the narrower of the two enclosures
/// Limits    fails where a model around a and b touches (-inf, 0]
[[nodiscard]] TaylorModel bend_of_power(const TaylorModel& a, const TaylorModel& b, const TaylorModel& d,
                                        const TaylorModel& e);
[[nodiscard]] TaylorModel first_of_power(const TaylorModel& a, const TaylorModel& b, const TaylorModel& d,
                                         const TaylorModel& e, const TaylorModel& bend);

}  // namespace radcert
