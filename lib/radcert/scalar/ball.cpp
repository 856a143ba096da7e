// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/ball.h"

#include <arb.h>
#include <arf.h>
#include <cmath>
#include <flint/fmpq.h>
#include <limits>
#include <utility>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball_access.h"

namespace radcert {

namespace {

arb_ptr in(Ball& ball) { return static_cast<arb_ptr>(BallAccess::storage(ball)); }
arb_srcptr in(const Ball& ball) { return static_cast<arb_srcptr>(BallAccess::storage(ball)); }
const char* failure_of(const Ball& ball) { return BallAccess::failure(ball); }

slong bits() { return BallPrecision::current(); }

struct Quotient : CValue<fmpq, fmpq_init, fmpq_clear> {
  explicit Quotient(const Rational& q) { fmpq_set_mpq(*this, static_cast<mpq_srcptr>(q.gmp())); }
};

using Float = CValue<arf_struct, arf_init, arf_clear>;

/// The least radius that is not below |x|: exact for 30 bits, which arf_get_mag is not.
void set_radius(mag_ptr radius, arf_srcptr x) {
  Float rounded;
  arf_set_round(rounded, x, MAG_BITS, ARF_RND_UP);
  arf_get_mag_lower(radius, rounded);
  if (arf_cmpabs_mag(x, radius) > 0) arf_get_mag(radius, x);
}

/// [0, u] or, for u < 0, [u, 0]: an end at zero that rounding does not move.
void set_from_zero(arb_ptr ball, arf_srcptr u) {
  Float half;
  arf_mul_2exp_si(half, u, -1);
  set_radius(arb_radref(ball), half);
  arf_set_mag(arb_midref(ball), arb_radref(ball));
  if (arf_sgn(u) < 0) arf_neg(arb_midref(ball), arb_midref(ball));
}

/// A ball around [low, high]; an end of one sign keeps it.
void set_interval(arb_ptr ball, arf_srcptr low, arf_srcptr high) {
  arf_add(arb_midref(ball), low, high, bits(), ARF_RND_NEAR);
  arf_mul_2exp_si(arb_midref(ball), arb_midref(ball), -1);
  Float below;
  Float above;
  arf_sub(below, arb_midref(ball), low, MAG_BITS, ARF_RND_UP);
  arf_sub(above, high, arb_midref(ball), MAG_BITS, ARF_RND_UP);
  set_radius(arb_radref(ball), arf_cmp(below, above) < 0 ? above : below);
  if (arf_sgn(low) >= 0 && arb_is_nonnegative(ball) == 0) set_from_zero(ball, high);
  if (arf_sgn(high) <= 0 && arb_is_nonpositive(ball) == 0) set_from_zero(ball, low);
}

const char* first_failure(const Ball& a, const Ball& b) {
  return failure_of(a) != nullptr ? failure_of(a) : failure_of(b);
}

bool both_finite(const Ball& a, const Ball& b) { return a.is_finite() && b.is_finite(); }

}  // namespace

static_assert(sizeof(arb_t) == 48 && alignof(arb_t) <= 8, "the storage in the header holds an arb_t");

void BallAccess::fail(Ball& ball, const char* reason) {
  arb_zero_pm_inf(in(ball));
  ball.failure_ = reason;
}

bool BallAccess::is_wide(const Ball& ball) {
  constexpr long few_bits = 24;
  arb_srcptr x = in(ball);
  if (mag_is_zero(arb_radref(x)) != 0) return false;
  if (arf_is_special(arb_midref(x)) != 0 || COEFF_IS_MPZ(ARF_EXP(arb_midref(x))) ||
      COEFF_IS_MPZ(MAG_EXP(arb_radref(x)))) {
    return arb_rel_accuracy_bits(x) < few_bits;
  }
  return ARF_EXP(arb_midref(x)) - MAG_EXP(arb_radref(x)) < few_bits;
}

Ball BallAccess::nonnegative(Ball ball) {
  if (is_wide(ball) && ball.is_finite() && arb_is_nonnegative(in(ball)) == 0) {
    Float upper;
    arb_get_ubound_arf(upper, in(ball), bits());
    set_from_zero(in(ball), upper);
  }
  return ball;
}

Ball::Ball(const Rational& value) : Ball() { arb_set_fmpq(in(*this), Quotient(value), bits()); }

Ball::Ball(const Ball& other) : Ball() {
  arb_set(in(*this), in(other));
  failure_ = other.failure_;
}

Ball& Ball::operator=(const Ball& other) {
  if (this == &other) return *this;
  arb_set(in(*this), in(other));
  failure_ = other.failure_;
  return *this;
}

Ball::~Ball() { arb_clear(in(*this)); }

void Ball::set_signed(long value) { arb_set_si(in(*this), value); }

void Ball::set_unsigned(unsigned long value) { arb_set_ui(in(*this), value); }

void Ball::set_double(double value) {
  if (std::isfinite(value)) {
    arb_set_d(in(*this), value);
  } else {
    BallAccess::fail(*this, "a double that is not finite");
  }
}

Ball Ball::failed(const char* reason) {
  expects(reason != nullptr && *reason != '\0', "a failure with a reason");
  Ball result;
  BallAccess::fail(result, reason);
  return result;
}

Ball Ball::from_arb(const void* arb, const char* reason) {
  const auto* value = static_cast<arb_srcptr>(arb);
  if (arb_is_finite(value) == 0) return failed(reason);
  Ball result;
  arb_set(in(result), value);
  return result;
}

Ball Ball::pi() {
  Ball result;
  arb_const_pi(in(result), bits());
  return result;
}

bool Ball::is_exact() const { return arb_is_exact(in(*this)) != 0; }

bool Ball::contains_zero() const { return arb_contains_zero(in(*this)) != 0; }

bool Ball::contains(double value) const {
  expects(std::isfinite(value), "a finite double", named("value", value));
  Float exact;
  arf_set_d(exact, value);
  return arb_contains_arf(in(*this), exact) != 0;
}

bool Ball::contains(const Rational& value) const {
  return arb_contains_fmpq(in(*this), Quotient(value)) != 0;
}

bool Ball::contains(const Ball& other) const { return arb_contains(in(*this), in(other)) != 0; }

Ball Ball::midpoint() const {
  if (!is_finite()) return failed(failure_);
  Ball result;
  arf_set(arb_midref(in(result)), arb_midref(in(*this)));
  return result;
}

double Ball::radius() const { return is_finite() ? mag_get_d(arb_radref(in(*this))) : HUGE_VAL; }

Ball Ball::radius_ball() const {
  if (!is_finite()) return failed(failure_);
  Ball result;
  arf_set_mag(arb_midref(in(result)), arb_radref(in(*this)));
  return result;
}

Ball Ball::lower() const {
  if (!is_finite()) return failed(failure_);
  Ball result;
  arb_get_lbound_arf(arb_midref(in(result)), in(*this), bits());
  return result;
}

Ball Ball::upper() const {
  if (!is_finite()) return failed(failure_);
  Ball result;
  arb_get_ubound_arf(arb_midref(in(result)), in(*this), bits());
  return result;
}

double Ball::lower_double() const {
  if (!is_finite()) return -HUGE_VAL;
  Float end;
  arb_get_lbound_arf(end, in(*this), 64);
  return arf_get_d(end, ARF_RND_FLOOR);
}

double Ball::upper_double() const {
  if (!is_finite()) return HUGE_VAL;
  Float end;
  arb_get_ubound_arf(end, in(*this), 64);
  return arf_get_d(end, ARF_RND_CEIL);
}

double Ball::to_double() const {
  expects(is_finite(), "a finite ball", named("failure", failure()));
  return arf_get_d(arb_midref(in(*this)), ARF_RND_NEAR);
}

long Ball::accurate_bits() const { return arb_rel_accuracy_bits(in(*this)); }

Ball Ball::operator-() const {
  Ball result;
  arb_neg(in(result), in(*this));
  result.failure_ = failure_;
  return result;
}

Ball Ball::plus(const Ball& other) const {
  if (!both_finite(*this, other)) return failed(first_failure(*this, other));
  Ball result;
  arb_add(in(result), in(*this), in(other), bits());
  return result;
}

Ball Ball::minus(const Ball& other) const {
  if (!both_finite(*this, other)) return failed(first_failure(*this, other));
  Ball result;
  arb_sub(in(result), in(*this), in(other), bits());
  return result;
}

Ball Ball::times(const Ball& other) const {
  if (!both_finite(*this, other)) return failed(first_failure(*this, other));
  if (this == &other) return power(*this, 2);
  Ball result;
  arb_mul(in(result), in(*this), in(other), bits());
  return result;
}

Ball Ball::over(const Ball& other) const {
  if (!both_finite(*this, other)) return failed(first_failure(*this, other));
  Ball result;
  arb_div(in(result), in(*this), in(other), bits());
  if (arb_is_finite(in(result)) == 0) BallAccess::fail(result, "division by a ball that contains zero");
  return result;
}

Ball& Ball::operator+=(const Ball& other) {
  if (!both_finite(*this, other)) return *this = failed(first_failure(*this, other));
  arb_add(in(*this), in(*this), in(other), bits());
  return *this;
}

Ball& Ball::operator-=(const Ball& other) {
  if (!both_finite(*this, other)) return *this = failed(first_failure(*this, other));
  arb_sub(in(*this), in(*this), in(other), bits());
  return *this;
}

Ball& Ball::operator*=(const Ball& other) {
  if (this == &other || !both_finite(*this, other)) return *this = times(other);
  arb_mul(in(*this), in(*this), in(other), bits());
  return *this;
}

Ball reciprocal(const Ball& x) {
  if (!x.is_finite()) return x;
  Ball result;
  arb_inv(in(result), in(x), bits());
  if (arb_is_finite(in(result)) == 0) BallAccess::fail(result, "division by a ball that contains zero");
  if (!BallAccess::is_wide(result)) return result;
  return arb_is_positive(in(x)) != 0 ? BallAccess::nonnegative(std::move(result))
                                     : -BallAccess::nonnegative(-result);
}

Ball fma(const Ball& a, const Ball& b, const Ball& c) {
  if (!both_finite(a, b)) return Ball::failed(first_failure(a, b));
  if (!c.is_finite()) return c;
  if (&a == &b) return a * b + c;
  Ball result;
  arb_fma(in(result), in(a), in(b), in(c), bits());
  return result;
}

Ball hull(const Ball& a, const Ball& b) {
  if (!both_finite(a, b)) return Ball::failed(first_failure(a, b));
  if (a.contains(b)) return a;
  if (b.contains(a)) return b;
  Float low;
  Float high;
  Float other;
  arb_get_lbound_arf(low, in(a), bits());
  arb_get_lbound_arf(other, in(b), bits());
  if (arf_cmp(other, low) < 0) arf_swap(other, low);
  arb_get_ubound_arf(high, in(a), bits());
  arb_get_ubound_arf(other, in(b), bits());
  if (arf_cmp(other, high) > 0) arf_swap(other, high);
  Ball result;
  set_interval(in(result), low, high);
  return result;
}

Ball intersection(const Ball& a, const Ball& b) {
  if (!b.is_finite()) return a;
  if (!a.is_finite()) return b;
  expects(overlaps(a, b), "balls with a common point", named("a", a), named("b", b));
  if (a.contains(b)) return b;
  if (b.contains(a)) return a;
  Float low;
  Float high;
  Float other;
  arb_get_lbound_arf(low, in(a), bits());
  arb_get_lbound_arf(other, in(b), bits());
  if (arf_cmp(other, low) > 0) arf_swap(other, low);
  arb_get_ubound_arf(high, in(a), bits());
  arb_get_ubound_arf(other, in(b), bits());
  if (arf_cmp(other, high) < 0) arf_swap(other, high);
  Ball result;
  set_interval(in(result), low, high);
  // Rounded outwards, the common part may be wider than one of the two.
  if (mag_cmp(arb_radref(in(a)), arb_radref(in(result))) <= 0) result = a;
  if (mag_cmp(arb_radref(in(b)), arb_radref(in(result))) < 0) result = b;
  return result;
}

Ball widened(const Ball& x, const Ball& by) {
  if (!both_finite(x, by)) return Ball::failed(first_failure(x, by));
  Ball result(x);
  Float largest;
  arb_get_abs_ubound_arf(largest, in(by), bits());
  CValue<mag_struct, mag_init, mag_clear> error;
  set_radius(error, largest);
  if (x.is_exact()) {
    mag_swap(arb_radref(in(result)), error);
  } else {
    mag_add(arb_radref(in(result)), arb_radref(in(result)), error);
  }
  return result;
}

bool overlaps(const Ball& a, const Ball& b) { return arb_overlaps(in(a), in(b)) != 0; }

bool certainly_less(const Ball& a, const Ball& b) { return both_finite(a, b) && arb_lt(in(a), in(b)) != 0; }

bool certainly_at_most(const Ball& a, const Ball& b) {
  return both_finite(a, b) && arb_le(in(a), in(b)) != 0;
}

bool certainly_positive(const Ball& x) { return x.is_finite() && arb_is_positive(in(x)) != 0; }

bool certainly_negative(const Ball& x) { return x.is_finite() && arb_is_negative(in(x)) != 0; }

bool certainly_zero(const Ball& x) { return x.is_finite() && arb_is_zero(in(x)) != 0; }

Ball select_less(const Ball& a, const Ball& b, const Ball& if_less, const Ball& otherwise) {
  if (!both_finite(a, b)) return Ball::failed(first_failure(a, b));
  if (certainly_less(a, b)) return if_less;
  if (certainly_less(b, a)) return otherwise;
  return hull(if_less, otherwise);
}

}  // namespace radcert
