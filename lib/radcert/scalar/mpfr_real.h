// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

#include <array>
#include <compare>
#include <concepts>
#include <string>
#include <string_view>

namespace radcert {

/// A floating-point number with a fixed count of decimal digits.
/// Maths     sign mantissa 2^exponent with `bits` binary digits, bits = ceil(Digits log2 10) + 1, |exponent|
///           < 2^62
/// Source    MPFR: L. Fousse et al., "MPFR: a multiple-precision binary floating-point library with correct
///           rounding", 2007
/// Requires  Digits 50, 100 or 200: what the library compiles
/// Result    every operation and function is rounded to nearest, ties to even; infinities and NaN as in IEEE
///           754, comparisons included. A double or a whole number up to 64 bits enters exactly, a decimal by
///           Rational or parse()
/// Limits    a rounded number: nothing is proved by it, see Ball. min, max of a NaN is NaN. The value is its
///           own storage: no heap, copied as bytes
template <int Digits>
class Mpfr {
  static_assert(Digits == 50 || Digits == 100 || Digits == 200,
                "the numbers of digits that the library compiles");

public:
  static constexpr int digits = Digits;
  /// log2(10) < 3.3219281
  static constexpr int bits = static_cast<int>((Digits * 33219281L + 9999999L) / 10000000L) + 1;
  /// So many digits of to_text() read back as the same number.
  static constexpr int round_trip_digits = static_cast<int>(bits * 30103L / 100000L) + 2;

  /// Zero.
  Mpfr() noexcept : kind_(zero_kind) {}
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool> && sizeof(Integer) <= 8)
  Mpfr(Integer value) {  // NOLINT(google-explicit-constructor): exact
    if constexpr (std::signed_integral<Integer>) {
      set_signed(value);
    } else {
      set_unsigned(value);
    }
  }
  /// Exactly; infinities and NaN stay what they are.
  template <std::same_as<double> Double>
  explicit Mpfr(Double value) {
    set_double(value);
  }
  /// Rounded to nearest.
  explicit Mpfr(const Rational& value) { set_rational(value); }

  [[nodiscard]] static Mpfr pi();
  /// 2^-bits: the largest relative rounding of one operation.
  [[nodiscard]] static Mpfr unit_roundoff();
  /// A decimal or a fraction of decimals as Rational reads it, rounded to nearest.
  [[nodiscard]] static Outcome<Mpfr> parse(std::string_view text);

  [[nodiscard]] bool is_finite() const;
  [[nodiscard]] bool is_nan() const;
  /// Rounded to nearest, ties to even; subnormals and infinity as in IEEE 754.
  [[nodiscard]] double to_double() const;
  /// Exactly; ContractViolation where it is not finite. Costs memory in proportion to the binary exponent.
  [[nodiscard]] Rational to_rational() const;
  /// "-123.45", or "-1.2345e-7", with so many significant digits, rounded to nearest; "inf", "-inf", "nan".
  /// ContractViolation unless 1 <= count.
  [[nodiscard]] std::string to_text(int count = Digits) const;

  Mpfr& operator+=(const Mpfr& other) { return *this = plus(other); }
  Mpfr& operator-=(const Mpfr& other) { return *this = minus(other); }
  Mpfr& operator*=(const Mpfr& other) { return *this = times(other); }
  Mpfr& operator/=(const Mpfr& other) { return *this = over(other); }
  [[nodiscard]] Mpfr operator-() const;
  [[nodiscard]] friend Mpfr operator+(const Mpfr& a, const Mpfr& b) { return a.plus(b); }
  [[nodiscard]] friend Mpfr operator-(const Mpfr& a, const Mpfr& b) { return a.minus(b); }
  [[nodiscard]] friend Mpfr operator*(const Mpfr& a, const Mpfr& b) { return a.times(b); }
  [[nodiscard]] friend Mpfr operator/(const Mpfr& a, const Mpfr& b) { return a.over(b); }
  [[nodiscard]] friend bool operator==(const Mpfr& a, const Mpfr& b) { return a.compare(b) == 0; }
  [[nodiscard]] friend std::partial_ordering operator<=>(const Mpfr& a, const Mpfr& b) {
    return a.compare(b);
  }

  /// a b + c with one rounding.
  [[nodiscard]] friend Mpfr fma(const Mpfr& a, const Mpfr& b, const Mpfr& c) { return a.times_plus(b, c); }
  [[nodiscard]] friend Mpfr sqrt(const Mpfr& a) { return a.root(); }
  [[nodiscard]] friend Mpfr exp(const Mpfr& a) { return a.exponential(); }
  [[nodiscard]] friend Mpfr log(const Mpfr& a) { return a.logarithm(); }
  [[nodiscard]] friend Mpfr sin(const Mpfr& a) { return a.sine(); }
  [[nodiscard]] friend Mpfr cos(const Mpfr& a) { return a.cosine(); }
  [[nodiscard]] friend Mpfr tan(const Mpfr& a) { return a.tangent(); }
  [[nodiscard]] friend Mpfr atan(const Mpfr& a) { return a.arc_tangent(); }
  [[nodiscard]] friend Mpfr pow(const Mpfr& a, const Mpfr& b) { return a.to_the(b); }
  [[nodiscard]] friend Mpfr abs(const Mpfr& a) { return a.magnitude(); }
  [[nodiscard]] friend Mpfr min(const Mpfr& a, const Mpfr& b) { return a.smaller(b); }
  [[nodiscard]] friend Mpfr max(const Mpfr& a, const Mpfr& b) { return a.larger(b); }

private:
  struct View;
  static constexpr int zero_kind = 2;
  static constexpr std::size_t limb_count = (bits + 63) / 64;

  void set_signed(long value);
  void set_unsigned(unsigned long value);
  void set_double(double value);
  void set_rational(const Rational& value);
  [[nodiscard]] Mpfr plus(const Mpfr& other) const;
  [[nodiscard]] Mpfr minus(const Mpfr& other) const;
  [[nodiscard]] Mpfr times(const Mpfr& other) const;
  [[nodiscard]] Mpfr over(const Mpfr& other) const;
  [[nodiscard]] Mpfr times_plus(const Mpfr& factor, const Mpfr& term) const;
  [[nodiscard]] std::partial_ordering compare(const Mpfr& other) const;
  [[nodiscard]] Mpfr root() const;
  [[nodiscard]] Mpfr exponential() const;
  [[nodiscard]] Mpfr logarithm() const;
  [[nodiscard]] Mpfr sine() const;
  [[nodiscard]] Mpfr cosine() const;
  [[nodiscard]] Mpfr tangent() const;
  [[nodiscard]] Mpfr arc_tangent() const;
  [[nodiscard]] Mpfr to_the(const Mpfr& exponent) const;
  [[nodiscard]] Mpfr magnitude() const;
  [[nodiscard]] Mpfr smaller(const Mpfr& other) const;
  [[nodiscard]] Mpfr larger(const Mpfr& other) const;

  std::array<unsigned long, limb_count> limbs_{};
  long exponent_ = 0;
  int kind_;  ///< of MPFR's custom interface, with the sign
};

extern template class Mpfr<50>;
extern template class Mpfr<100>;
extern template class Mpfr<200>;

/// Numbers as they enter so many digits: rounded to nearest.
template <int Digits>
struct Constants<Mpfr<Digits>> {
  static Mpfr<Digits> from_rational(const Rational& q) { return Mpfr<Digits>(q); }
  static Mpfr<Digits> pi() { return Mpfr<Digits>::pi(); }
};

}  // namespace radcert
