// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/complex_ball.h"

#include <acb.h>
#include <arb.h>
#include <cmath>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"

namespace radcert {

/// The inside of a complex ball, for this source.
/// Source    Arb
/// Requires  whoever writes into storage() leaves a finite acb_t, or calls fail()
/// Result    storage() is the acb_t
/// Limits    not for formulas
struct ComplexBallAccess {
  static void* storage(ComplexBall& z) noexcept { return z.storage_.data(); }
  static const void* storage(const ComplexBall& z) noexcept { return z.storage_.data(); }
  static const char* failure(const ComplexBall& z) noexcept { return z.failure_; }
  static void fail(ComplexBall& z, const char* reason);
  static void inherit(ComplexBall& z, const ComplexBall& from) { z.failure_ = from.failure_; }
};

namespace {

acb_ptr in(ComplexBall& z) { return static_cast<acb_ptr>(ComplexBallAccess::storage(z)); }
acb_srcptr in(const ComplexBall& z) { return static_cast<acb_srcptr>(ComplexBallAccess::storage(z)); }
arb_srcptr in(const Ball& ball) { return static_cast<arb_srcptr>(ball.arb()); }

slong bits() { return BallPrecision::current(); }

bool both_finite(const ComplexBall& a, const ComplexBall& b) { return a.is_finite() && b.is_finite(); }

ComplexBall first_failure(const ComplexBall& a, const ComplexBall& b) {
  const char* reason = ComplexBallAccess::failure(a);
  return ComplexBall::failed(reason != nullptr ? reason : ComplexBallAccess::failure(b));
}

/// Whether z has a point on (-inf, 0].
bool touches_the_cut(const ComplexBall& z) {
  return arb_contains_zero(acb_imagref(in(z))) != 0 && arb_is_positive(acb_realref(in(z))) == 0;
}

/// A function of Arb on a finite value; what is not finite fails for the reason.
template <class Function>
ComplexBall applied(const ComplexBall& z, const char* reason, Function function) {
  if (!z.is_finite()) return z;
  ComplexBall result;
  function(in(result), in(z), bits());
  if (acb_is_finite(in(result)) == 0) ComplexBallAccess::fail(result, reason);
  return result;
}

constexpr const char* division_by_zero = "division by a complex ball that contains zero";

}  // namespace

static_assert(sizeof(acb_t) == 96 && alignof(acb_t) <= 8, "the storage in the header holds an acb_t");

void ComplexBallAccess::fail(ComplexBall& z, const char* reason) {
  arb_zero_pm_inf(acb_realref(in(z)));
  arb_zero_pm_inf(acb_imagref(in(z)));
  z.failure_ = reason;
}

ComplexBall::ComplexBall(const Ball& real) : ComplexBall() {
  arb_set(acb_realref(in(*this)), in(real));
  if (!real.is_finite()) ComplexBallAccess::fail(*this, real.failure().data());
}

ComplexBall::ComplexBall(const Ball& real, const Ball& imag) : ComplexBall(real) {
  if (!is_finite()) return;
  arb_set(acb_imagref(in(*this)), in(imag));
  if (!imag.is_finite()) ComplexBallAccess::fail(*this, imag.failure().data());
}

ComplexBall::ComplexBall(const ComplexBall& other) : ComplexBall() {
  acb_set(in(*this), in(other));
  failure_ = other.failure_;
}

ComplexBall& ComplexBall::operator=(const ComplexBall& other) {
  if (this == &other) return *this;
  acb_set(in(*this), in(other));
  failure_ = other.failure_;
  return *this;
}

ComplexBall::~ComplexBall() { acb_clear(in(*this)); }

ComplexBall ComplexBall::failed(const char* reason) {
  expects(reason != nullptr && *reason != '\0', "a failure with a reason");
  ComplexBall result;
  ComplexBallAccess::fail(result, reason);
  return result;
}

ComplexBall ComplexBall::from_acb(const void* acb, const char* reason) {
  const auto* value = static_cast<acb_srcptr>(acb);
  if (acb_is_finite(value) == 0) return failed(reason);
  ComplexBall result;
  acb_set(in(result), value);
  return result;
}

bool ComplexBall::contains_zero() const { return acb_contains_zero(in(*this)) != 0; }

bool ComplexBall::contains(const ComplexBall& other) const { return acb_contains(in(*this), in(other)) != 0; }

bool ComplexBall::is_real() const { return is_finite() && acb_is_real(in(*this)) != 0; }

Ball ComplexBall::real() const {
  return is_finite() ? Ball::from_arb(acb_realref(in(*this)), "a complex ball without a bound")
                     : Ball::failed(failure_);
}

Ball ComplexBall::imag() const {
  return is_finite() ? Ball::from_arb(acb_imagref(in(*this)), "a complex ball without a bound")
                     : Ball::failed(failure_);
}

Ball ComplexBall::magnitude() const {
  if (!is_finite()) return Ball::failed(failure_);
  return sqrt(power(real(), 2) + power(imag(), 2));
}

double ComplexBall::magnitude_bound() const {
  if (!is_finite()) return HUGE_VAL;
  CValue<mag_struct, mag_init, mag_clear> bound;
  acb_get_mag(bound, in(*this));
  // mag_get_d is exact within the range of double and infinite beyond; below it would be rounded.
  if (mag_is_zero(bound) != 0) return 0;
  return mag_cmp_2exp_si(bound, -1000) < 0 ? 0x1p-1000 : mag_get_d(bound);
}

std::string ComplexBall::to_text(int digits) const {
  if (!is_finite()) return "unbounded: " + std::string(failure());
  return "(" + real().to_text(digits) + ") + (" + imag().to_text(digits) + ") i";
}

ComplexBall ComplexBall::operator-() const {
  ComplexBall result;
  acb_neg(in(result), in(*this));
  ComplexBallAccess::inherit(result, *this);
  return result;
}

ComplexBall ComplexBall::plus(const ComplexBall& other) const {
  if (!both_finite(*this, other)) return first_failure(*this, other);
  ComplexBall result;
  acb_add(in(result), in(*this), in(other), bits());
  return result;
}

ComplexBall ComplexBall::minus(const ComplexBall& other) const {
  if (!both_finite(*this, other)) return first_failure(*this, other);
  ComplexBall result;
  acb_sub(in(result), in(*this), in(other), bits());
  return result;
}

ComplexBall ComplexBall::times(const ComplexBall& other) const {
  if (!both_finite(*this, other)) return first_failure(*this, other);
  if (this == &other) return power(*this, 2);
  ComplexBall result;
  acb_mul(in(result), in(*this), in(other), bits());
  return result;
}

ComplexBall ComplexBall::over(const ComplexBall& other) const {
  if (!both_finite(*this, other)) return first_failure(*this, other);
  ComplexBall result;
  acb_div(in(result), in(*this), in(other), bits());
  if (acb_is_finite(in(result)) == 0) ComplexBallAccess::fail(result, division_by_zero);
  return result;
}

ComplexBall reciprocal(const ComplexBall& x) { return applied(x, division_by_zero, acb_inv); }

ComplexBall power(const ComplexBall& x, long n) {
  if (!x.is_finite()) return x;
  if (n == 0) return 1;
  if (n < 0 && x.contains_zero()) {
    return ComplexBall::failed("a negative power of a complex ball that contains zero");
  }
  ComplexBall result;
  if (n == 2) {
    // (x + iy)^2 = x^2 - y^2 + 2ixy, the squares as squares: closer than a product where the ball is wide.
    if (acb_is_real(in(x)) != 0) return ComplexBall(power(x.real(), 2));
    const Ball real = x.real();
    const Ball imag = x.imag();
    return ComplexBall(power(real, 2) - power(imag, 2), 2 * real * imag);
  }
  acb_pow_si(in(result), in(x), n, bits());
  if (acb_is_finite(in(result)) == 0) ComplexBallAccess::fail(result, division_by_zero);
  return result;
}

ComplexBall sqrt(const ComplexBall& x) {
  if (x.is_finite() && touches_the_cut(x))
    return ComplexBall::failed("sqrt of a complex ball that touches its cut");
  return applied(x, "sqrt without a bound", acb_sqrt);
}

ComplexBall exp(const ComplexBall& x) { return applied(x, "exp beyond all exponents", acb_exp); }

ComplexBall log(const ComplexBall& x) {
  if (x.is_finite() && touches_the_cut(x))
    return ComplexBall::failed("log of a complex ball that touches its cut");
  return applied(x, "log without a bound", acb_log);
}

ComplexBall sin(const ComplexBall& x) { return applied(x, "sin without a bound", acb_sin); }

ComplexBall cos(const ComplexBall& x) { return applied(x, "cos without a bound", acb_cos); }

ComplexBall tan(const ComplexBall& x) {
  return applied(x, "tan of a complex ball that may contain a pole", acb_tan);
}

ComplexBall atan(const ComplexBall& x) {
  if (x.is_finite() && arb_contains_zero(acb_realref(in(x))) != 0 &&
      !certainly_less(abs(x.imag()), Ball(1))) {
    return ComplexBall::failed("atan of a complex ball that touches its cut");
  }
  return applied(x, "atan without a bound", acb_atan);
}

ComplexBall pow(const ComplexBall& x, const ComplexBall& y) {
  if (!both_finite(x, y)) return first_failure(x, y);
  if (acb_is_int(in(y)) != 0) {
    arf_srcptr whole = arb_midref(acb_realref(in(y)));
    if (arf_cmpabs_2exp_si(whole, 62) < 0) return power(x, arf_get_si(whole, ARF_RND_DOWN));
  }
  if (touches_the_cut(x)) return ComplexBall::failed("pow of a complex ball that touches its cut");
  ComplexBall result;
  acb_pow(in(result), in(x), in(y), bits());
  if (acb_is_finite(in(result)) == 0) ComplexBallAccess::fail(result, "pow without a bound");
  return result;
}

ComplexBall abs(const ComplexBall& x) {
  if (!x.is_finite() || certainly_positive(x)) return x;
  if (certainly_negative(x)) return -x;
  return ComplexBall::failed("abs where the sign changes is not analytic");
}

ComplexBall min(const ComplexBall& a, const ComplexBall& b) {
  if (!both_finite(a, b)) return first_failure(a, b);
  if (certainly_less(a, b)) return a;
  if (certainly_less(b, a)) return b;
  return ComplexBall::failed("min where the order changes is not analytic");
}

ComplexBall max(const ComplexBall& a, const ComplexBall& b) {
  if (!both_finite(a, b)) return first_failure(a, b);
  if (certainly_less(a, b)) return b;
  if (certainly_less(b, a)) return a;
  return ComplexBall::failed("max where the order changes is not analytic");
}

ComplexBall hull(const ComplexBall& a, const ComplexBall& b) {
  if (!both_finite(a, b)) return first_failure(a, b);
  return ComplexBall(hull(a.real(), b.real()), hull(a.imag(), b.imag()));
}

ComplexBall intersection(const ComplexBall& a, const ComplexBall& b) {
  if (!b.is_finite()) return a;
  if (!a.is_finite()) return b;
  return ComplexBall(intersection(a.real(), b.real()), intersection(a.imag(), b.imag()));
}

bool overlaps(const ComplexBall& a, const ComplexBall& b) { return acb_overlaps(in(a), in(b)) != 0; }

bool certainly_less(const ComplexBall& a, const ComplexBall& b) {
  return both_finite(a, b) && arb_lt(acb_realref(in(a)), acb_realref(in(b))) != 0;
}

bool certainly_at_most(const ComplexBall& a, const ComplexBall& b) {
  return both_finite(a, b) && arb_le(acb_realref(in(a)), acb_realref(in(b))) != 0;
}

bool certainly_positive(const ComplexBall& x) {
  return x.is_finite() && arb_is_positive(acb_realref(in(x))) != 0;
}

bool certainly_negative(const ComplexBall& x) {
  return x.is_finite() && arb_is_negative(acb_realref(in(x))) != 0;
}

bool certainly_zero(const ComplexBall& x) { return x.is_finite() && acb_is_zero(in(x)) != 0; }

ComplexBall select_less(const ComplexBall& a, const ComplexBall& b, const ComplexBall& if_less,
                        const ComplexBall& otherwise) {
  if (!both_finite(a, b)) return first_failure(a, b);
  if (certainly_less(a, b)) return if_less;
  if (certainly_less(b, a)) return otherwise;
  return ComplexBall::failed("a choice by an order that changes is not analytic");
}

ComplexBall bend_of_power(const ComplexBall& a, const ComplexBall& b, const ComplexBall& d,
                          const ComplexBall& e) {
  const ComplexBall around = hull(a, b);
  if (around.is_finite() && touches_the_cut(around)) {
    return ComplexBall::failed("a divided difference of a power that touches its cut");
  }
  const ComplexBall by_mean = e * (e - 1) / 2 * pow(around, e - 2);
  if (d.contains_zero()) return by_mean;
  const ComplexBall by_definition = (pow(b, e) - pow(a, e) - e * pow(a, e - 1) * d) / power(d, 2);
  return intersection(by_mean, by_definition);
}

ComplexBall first_of_power(const ComplexBall& a, const ComplexBall& b, const ComplexBall& d,
                           const ComplexBall& e, const ComplexBall& bend) {
  const ComplexBall around = hull(a, b);
  if (around.is_finite() && touches_the_cut(around)) {
    return ComplexBall::failed("a divided difference of a power that touches its cut");
  }
  const ComplexBall by_mean = intersection(e * pow(around, e - 1), e * pow(a, e - 1) + d * bend);
  if (d.contains_zero()) return by_mean;
  return intersection(by_mean, (pow(b, e) - pow(a, e)) / d);
}

}  // namespace radcert
