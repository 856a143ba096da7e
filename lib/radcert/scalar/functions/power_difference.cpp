// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/power_difference.h"

#include "radcert/core/work_limit.h"

namespace radcert {

namespace {

const WorkLimit terms_a_bit("scalar/power_difference: terms of the binomial series for each bit", 16, 0,
                            "what is left out is bounded by the last term, and widens the ball");

/// Of two enclosures of one number, where either may have failed.
Ball better(const Ball& x, const Ball& y) { return intersection(x, y); }

/// a^(e-2) sum_{k >= 2} binom(e, k) x^(k-2) for x = d/a with |x| <= 3/4. From k >= (e-1)/2 on the quotient of
/// a term and the one before is at most q = |x| max(1, (k-e)/(k+1)), which does not grow with k: where q < 1,
/// the last one times q/(1-q) bounds what is left out.
Ball bend_by_series(const Ball& a, const Ball& d, const Ball& e) {
  if (!certainly_positive(a)) return Ball::failed("the binomial series at zero");
  const Ball x = d / a;
  const Ball ratio = abs(x).upper();
  if (!certainly_at_most(ratio, Ball(0.75))) return Ball::failed("the binomial series far from its centre");
  const Ball negligible = power(Ball(2), -BallPrecision::current() - 8);
  const Ball falls_from = (e - 1) / 2;
  const long most_terms = terms_a_bit.value() * BallPrecision::current();
  Ball term = e * (e - 1) / 2;
  Ball sum = term;
  for (long k = 2;; ++k) {
    const bool last = k > most_terms;
    if (certainly_at_most(falls_from, k) &&
        (last || certainly_at_most(abs(term), negligible * abs(sum).upper()))) {
      const Ball quotient = ratio * max(Ball(1), (k - e) / (k + 1)).upper();
      if (certainly_less(quotient, Ball(1)))
        return widened(sum, term * quotient / (1 - quotient)) * pow(a, e - 2);
    }
    if (last) return Ball::failed("the binomial series has too many terms");
    term = term * x * ((e - k) / (k + 1));
    sum += term;
  }
}

Ball bend_by_definition(const Ball& a, const Ball& b, const Ball& d, const Ball& e) {
  return (pow(b, e) - pow(a, e) - e * pow(a, e - 1) * d) / (d * d);
}

}  // namespace

Ball bend_of_power(const Ball& a, const Ball& b, const Ball& d, const Ball& e) {
  const Ball by_mean_value = e * (e - 1) / 2 * pow(hull(a, b), e - 2);
  const Ball near = better(by_mean_value, bend_by_series(a, d, e));
  return d.contains_zero() ? near : better(near, bend_by_definition(a, b, d, e));
}

Ball first_of_power(const Ball& a, const Ball& b, const Ball& d, const Ball& e, const Ball& bend) {
  const Ball near = better(e * pow(hull(a, b), e - 1), e * pow(a, e - 1) + d * bend);
  return d.contains_zero() ? near : better(near, (pow(b, e) - pow(a, e)) / d);
}

}  // namespace radcert
