// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/real_zeros.h"

#include "radcert/core/contract.h"

namespace radcert {
namespace {

// p/gcd(p, p'), its derivative, and the negated remainders of Euclid's algorithm, each scaled by a positive
// number.
class SturmChain {
public:
  explicit SturmChain(const RationalPolynomial& p) {
    chain_.push_back(divide(p, greatest_common_divisor(p, p.derivative())).quotient);
    chain_.push_back(chain_.front().derivative());
    while (!chain_.back().is_zero()) {
      const RationalPolynomial rest = -divide(chain_[chain_.size() - 2], chain_.back()).remainder;
      chain_.push_back(rest.is_zero() ? rest : rest * RationalPolynomial(1 / abs(rest.leading())));
    }
  }
  const RationalPolynomial& square_free() const { return chain_.front(); }
  int zeros_between(const Rational& lower, const Rational& upper) const {
    return sign_changes(lower) - sign_changes(upper);
  }

private:
  int sign_changes(const Rational& x) const {
    int changes = 0;
    int before = 0;
    for (const RationalPolynomial& p : chain_) {
      const int sign = p(x).sign();
      if (sign == 0) continue;
      if (before != 0 && sign != before) ++changes;
      before = sign;
    }
    return changes;
  }
  std::vector<RationalPolynomial> chain_;
};

Rational floor_of(const Rational& x) {
  // Long division in base 2.
  const Rational n = x.numerator();
  const Rational d = x.denominator();
  Rational step = d;
  while (step <= abs(n)) step *= 2;
  Rational rest = abs(n);
  Rational quotient = 0;
  for (; step >= d; step /= 2) {
    quotient *= 2;
    if (rest >= step) {
      rest -= step;
      quotient += 1;
    }
  }
  if (n.sign() >= 0) return quotient;
  return rest.sign() == 0 ? -quotient : -quotient - 1;
}

// The fraction with the smallest denominator in [lower, upper], by continued fractions.
Rational simplest_between(const Rational& lower, const Rational& upper) {
  const Rational whole = floor_of(lower);
  if (whole == lower) return whole;
  if (whole + 1 <= upper) return whole + 1;
  return whole + 1 / simplest_between(1 / (upper - whole), 1 / (lower - whole));
}

void isolate(const SturmChain& chain, const Rational& lower, const Rational& upper, const Rational& width,
             std::vector<RealZero>& zeros) {
  const int count = chain.zeros_between(lower, upper);
  if (count == 0) return;
  if (count == 1 && upper - lower <= width) {
    const Rational simplest = simplest_between(lower, upper);
    const bool exact = simplest != lower && chain.square_free()(simplest).sign() == 0;
    zeros.push_back(exact ? RealZero{simplest, simplest} : RealZero{lower, upper});
    return;
  }
  const Rational middle = (lower + upper) / 2;
  isolate(chain, lower, middle, width, zeros);
  isolate(chain, middle, upper, width, zeros);
}

}  // namespace

int zeros_between(const RationalPolynomial& p, const Rational& lower, const Rational& upper) {
  expects(!p.is_zero(), "a polynomial other than zero");
  expects(lower <= upper, "lower <= upper", named("lower", lower), named("upper", upper));
  return SturmChain(p).zeros_between(lower, upper);
}

std::vector<RealZero> real_zeros(const RationalPolynomial& p, const Rational& lower, const Rational& upper,
                                 const Rational& width) {
  expects(!p.is_zero(), "a polynomial other than zero");
  expects(lower <= upper, "lower <= upper", named("lower", lower), named("upper", upper));
  expects(width.sign() > 0, "width > 0", named("width", width));
  const SturmChain chain(p);
  std::vector<RealZero> zeros;
  if (p(lower).sign() == 0) zeros.push_back({lower, lower});
  isolate(chain, lower, upper, width, zeros);
  return zeros;
}

}  // namespace radcert
