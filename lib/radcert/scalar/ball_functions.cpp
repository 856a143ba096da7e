// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <arb.h>
#include <limits>
#include <utility>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_access.h"

namespace radcert {

namespace {

arb_ptr in(Ball& ball) { return static_cast<arb_ptr>(BallAccess::storage(ball)); }
arb_srcptr in(const Ball& ball) { return static_cast<arb_srcptr>(BallAccess::storage(ball)); }

slong bits() { return BallPrecision::current(); }

/// A function of Arb on a finite ball; what is not finite fails for the reason.
template <class Function>
Ball applied(const Ball& x, const char* reason, Function function) {
  if (!x.is_finite()) return x;
  Ball result;
  function(in(result), in(x), bits());
  if (arb_is_finite(in(result)) == 0) BallAccess::fail(result, reason);
  return result;
}

/// As applied(), for an increasing function: the values at the ends bound that of a wide ball closely.
template <class Function>
Ball increasing(const Ball& x, bool wide, const char* reason, Function function) {
  if (!wide) return applied(x, reason, function);
  return hull(applied(x.lower(), reason, function), applied(x.upper(), reason, function));
}

/// x^n for n >= 1.
Ball positive_power(const Ball& x, unsigned long n) {
  Ball result;
  if (n == 2) {
    arb_sqr(in(result), in(x), bits());
  } else {
    arb_pow_ui(in(result), in(x), n, bits());
  }
  return result;
}

/// x^y = exp(y log x) for x > 0.
Ball power_of_positive(const Ball& x, const Ball& y) {
  // The logarithm of the result is about y log2(x) in size: so many bits of it stand before the point.
  const slong exponent = arf_abs_bound_lt_2exp_si(arb_midref(in(x)));
  const slong size = arf_abs_bound_lt_2exp_si(arb_midref(in(y)));
  const slong guard =
      std::clamp<slong>(size, 0, 64) + static_cast<slong>(FLINT_BIT_COUNT(FLINT_ABS(exponent))) + 4;
  Ball result;
  arb_pow(in(result), in(x), in(y), bits() + guard);
  arb_set_round(in(result), in(result), bits());
  if (arb_is_finite(in(result)) == 0) BallAccess::fail(result, "pow beyond all exponents");
  return BallAccess::nonnegative(std::move(result));
}

constexpr const char* negative_base = "pow of a base that is not positive";

}  // namespace

Ball sqrt(const Ball& x) {
  if (x.is_finite() && arb_is_nonnegative(in(x)) == 0) {
    return Ball::failed("sqrt of a ball that reaches below zero");
  }
  return BallAccess::nonnegative(increasing(x, BallAccess::is_wide(x), "sqrt without a bound", arb_sqrt));
}

Ball exp(const Ball& x) {
  // The relative width of the result is the absolute one of x.
  const bool wide = mag_cmp_2exp_si(arb_radref(in(x)), -24) > 0;
  return BallAccess::nonnegative(increasing(x, wide, "exp beyond all exponents", arb_exp));
}

Ball log(const Ball& x) {
  if (x.is_finite() && arb_is_positive(in(x)) == 0) return Ball::failed("log of a ball that is not positive");
  return increasing(x, BallAccess::is_wide(x), "log without a bound", arb_log);
}

Ball sin(const Ball& x) { return applied(x, "sin without a bound", arb_sin); }

Ball cos(const Ball& x) { return applied(x, "cos without a bound", arb_cos); }

Ball tan(const Ball& x) { return applied(x, "tan of a ball that may contain a pole", arb_tan); }

Ball atan(const Ball& x) { return increasing(x, BallAccess::is_wide(x), "atan without a bound", arb_atan); }

Ball abs(const Ball& x) {
  if (!x.is_finite() || arb_is_nonnegative(in(x)) != 0) return x;
  if (arb_is_nonpositive(in(x)) != 0) return -x;
  return hull(Ball(), max(-x.lower(), x.upper()));
}

Ball min(const Ball& a, const Ball& b) {
  if (!a.is_finite()) return a;
  if (!b.is_finite()) return b;
  Ball result;
  arb_min(in(result), in(a), in(b), bits());
  return result;
}

Ball max(const Ball& a, const Ball& b) {
  if (!a.is_finite()) return a;
  if (!b.is_finite()) return b;
  Ball result;
  arb_max(in(result), in(a), in(b), bits());
  return result;
}

Ball power(const Ball& x, long n) {
  if (!x.is_finite()) return x;
  if (n == 0) return 1;
  if (n < 0) {
    if (x.contains_zero()) return Ball::failed("a negative power of a ball that contains zero");
    if (n == std::numeric_limits<long>::min()) return power(power(x, n / 2), 2);
    return BallAccess::is_wide(x) ? power(reciprocal(x), -n) : reciprocal(power(x, -n));
  }
  const auto exponent = static_cast<unsigned long>(n);
  if (n == 1) return x;
  const bool even = n % 2 == 0;
  if (!BallAccess::is_wide(x)) {
    Ball result = positive_power(x, exponent);
    return even ? BallAccess::nonnegative(std::move(result)) : result;
  }
  if (even) {
    const Ball size = abs(x);
    return BallAccess::nonnegative(hull(positive_power(BallAccess::nonnegative(size.lower()), exponent),
                                        positive_power(size.upper(), exponent)));
  }
  return hull(positive_power(x.lower(), exponent), positive_power(x.upper(), exponent));
}

Ball pow(const Ball& x, const Ball& y) {
  if (!x.is_finite()) return x;
  if (!y.is_finite()) return y;
  if (y.is_exact() && arb_is_int(in(y)) != 0) {
    if (arf_cmpabs_2exp_si(arb_midref(in(y)), 62) < 0) {
      Ball result = power(x, arf_get_si(arb_midref(in(y)), ARF_RND_DOWN));
      return certainly_positive(x) ? BallAccess::nonnegative(std::move(result)) : result;
    }
  }
  if (arb_is_positive(in(x)) != 0) {
    // t^y lies between the powers of the ends of x, whatever y.
    return BallAccess::is_wide(x) ? hull(power_of_positive(x.lower(), y), power_of_positive(x.upper(), y))
                                  : power_of_positive(x, y);
  }
  if (arb_is_nonnegative(in(x)) == 0 || arb_is_positive(in(y)) == 0) return Ball::failed(negative_base);
  // 0 <= x <= u and y > 0: 0 <= x^y <= u^y.
  const Ball upper = x.upper();
  if (certainly_zero(upper)) return 0;
  return hull(Ball(), power_of_positive(upper, y));
}

}  // namespace radcert
