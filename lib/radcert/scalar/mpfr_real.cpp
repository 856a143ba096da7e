// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/mpfr_real.h"

#include <algorithm>
#include <gmp.h>
#include <mpfr.h>
#include <type_traits>
#include <vector>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"

namespace radcert {

namespace {

/// MPFR keeps constants for each thread: given back when the thread ends. Touched by the functions that use
/// them.
struct ThreadCache {
  ~ThreadCache() { mpfr_free_cache(); }
  bool used = false;
};
thread_local ThreadCache thread_cache;

}  // namespace

static_assert(MPFR_ZERO_KIND == 2, "the kind of zero in the header");
static_assert(std::is_same_v<mp_limb_t, unsigned long> && std::is_same_v<mpfr_exp_t, long>,
              "the storage in the header");

/// A number as MPFR sees it, its digits in the number's own storage.
template <int Digits>
struct Mpfr<Digits>::View {
  // MPFR does not write through the pointer of an operand.
  explicit View(const Mpfr& number) {
    mpfr_custom_init_set(value, number.kind_, number.exponent_, bits,
                         const_cast<unsigned long*>(number.limbs_.data()));
  }

  /// The number that `compute` writes.
  template <class Compute>
  static Mpfr result(const Compute& compute) {
    Mpfr number;
    View view(number);
    compute(view.value);
    number.kind_ = mpfr_custom_get_kind(view.value);
    number.exponent_ = mpfr_custom_get_exp(view.value);
    return number;
  }

  template <class Function>
  static Mpfr of(Function function, const Mpfr& a) {
    const View x(a);
    return result([&](mpfr_ptr r) { function(r, x.value, MPFR_RNDN); });
  }
  template <class Function>
  static Mpfr of(Function function, const Mpfr& a, const Mpfr& b) {
    const View x(a);
    const View y(b);
    return result([&](mpfr_ptr r) { function(r, x.value, y.value, MPFR_RNDN); });
  }
  template <class... Operands>
  static Mpfr with_cache(const Operands&... operands) {
    thread_cache.used = true;
    return of(operands...);
  }

  mpfr_t value;
};

template <int Digits>
void Mpfr<Digits>::set_signed(long value) {
  *this = View::result([&](mpfr_ptr r) { mpfr_set_si(r, value, MPFR_RNDN); });
}

template <int Digits>
void Mpfr<Digits>::set_unsigned(unsigned long value) {
  *this = View::result([&](mpfr_ptr r) { mpfr_set_ui(r, value, MPFR_RNDN); });
}

template <int Digits>
void Mpfr<Digits>::set_double(double value) {
  *this = View::result([&](mpfr_ptr r) { mpfr_set_d(r, value, MPFR_RNDN); });
}

template <int Digits>
void Mpfr<Digits>::set_rational(const Rational& value) {
  *this = View::result([&](mpfr_ptr r) { mpfr_set_q(r, static_cast<mpq_srcptr>(value.gmp()), MPFR_RNDN); });
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::pi() {
  thread_cache.used = true;
  return View::result([](mpfr_ptr r) { mpfr_const_pi(r, MPFR_RNDN); });
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::unit_roundoff() {
  return View::result([](mpfr_ptr r) { mpfr_set_ui_2exp(r, 1, -bits, MPFR_RNDN); });
}

template <int Digits>
Outcome<Mpfr<Digits>> Mpfr<Digits>::parse(std::string_view text) {
  const Outcome<Rational> exact = Rational::parse(text);
  if (!exact) return because(exact.reason());
  return Mpfr(*exact);
}

template <int Digits>
bool Mpfr<Digits>::is_finite() const {
  return mpfr_number_p(View(*this).value) != 0;
}

template <int Digits>
bool Mpfr<Digits>::is_nan() const {
  return mpfr_nan_p(View(*this).value) != 0;
}

template <int Digits>
double Mpfr<Digits>::to_double() const {
  return mpfr_get_d(View(*this).value, MPFR_RNDN);
}

template <int Digits>
Rational Mpfr<Digits>::to_rational() const {
  expects(is_finite(), "a finite number", named("value", *this));
  const View x(*this);
  CValue<__mpq_struct, mpq_init, mpq_clear> quotient;
  mpfr_get_q(quotient, x.value);
  mpq_canonicalize(quotient);
  return Rational::from_gmp(quotient);
}

template <int Digits>
std::string Mpfr<Digits>::to_text(int count) const {
  expects(count >= 1, "count >= 1", named("count", count));
  const View x(*this);
  if (mpfr_nan_p(x.value) != 0) return "nan";
  if (mpfr_inf_p(x.value) != 0) return mpfr_signbit(x.value) != 0 ? "-inf" : "inf";
  if (mpfr_zero_p(x.value) != 0) return "0";
  // 0.d1 d2 ... times 10^exponent, with a sign in front
  std::vector<char> letters(static_cast<std::size_t>(count) + 8);
  mpfr_exp_t exponent = 0;
  mpfr_get_str(letters.data(), &exponent, 10, static_cast<std::size_t>(count), x.value, MPFR_RNDN);
  std::string text(letters.data());
  const std::size_t sign = text.front() == '-' ? 1 : 0;
  if (0 < exponent && exponent < count) return text.insert(sign + static_cast<std::size_t>(exponent), ".");
  if (exponent == count) return text;
  if (count > 1) text.insert(sign + 1, ".");
  return text + "e" + std::to_string(exponent - 1);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::operator-() const {
  return View::of(mpfr_neg, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::plus(const Mpfr& other) const {
  return View::of(mpfr_add, *this, other);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::minus(const Mpfr& other) const {
  return View::of(mpfr_sub, *this, other);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::times(const Mpfr& other) const {
  return View::of(mpfr_mul, *this, other);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::over(const Mpfr& other) const {
  return View::of(mpfr_div, *this, other);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::times_plus(const Mpfr& factor, const Mpfr& term) const {
  const View x(*this);
  const View y(factor);
  const View z(term);
  return View::result([&](mpfr_ptr r) { mpfr_fma(r, x.value, y.value, z.value, MPFR_RNDN); });
}

template <int Digits>
std::partial_ordering Mpfr<Digits>::compare(const Mpfr& other) const {
  const View x(*this);
  const View y(other);
  if (mpfr_unordered_p(x.value, y.value) != 0) return std::partial_ordering::unordered;
  return mpfr_cmp(x.value, y.value) <=> 0;
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::root() const {
  return View::of(mpfr_sqrt, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::exponential() const {
  return View::with_cache(mpfr_exp, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::logarithm() const {
  return View::with_cache(mpfr_log, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::sine() const {
  return View::with_cache(mpfr_sin, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::cosine() const {
  return View::with_cache(mpfr_cos, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::tangent() const {
  return View::with_cache(mpfr_tan, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::arc_tangent() const {
  return View::with_cache(mpfr_atan, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::to_the(const Mpfr& exponent) const {
  return View::with_cache(mpfr_pow, *this, exponent);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::magnitude() const {
  return View::of(mpfr_abs, *this);
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::smaller(const Mpfr& other) const {
  if (is_nan()) return *this;
  return other.is_nan() || other < *this ? other : *this;
}

template <int Digits>
Mpfr<Digits> Mpfr<Digits>::larger(const Mpfr& other) const {
  if (is_nan()) return *this;
  return other.is_nan() || other > *this ? other : *this;
}

template class Mpfr<50>;
template class Mpfr<100>;
template class Mpfr<200>;

}  // namespace radcert
