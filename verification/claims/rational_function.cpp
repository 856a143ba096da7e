// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/rational_function.h"

#include <algorithm>

#include "radcert/core/contract.h"

namespace radcert::verification {

Polynomial::Polynomial(const Rational& constant) { add({}, constant); }

Polynomial Polynomial::variable(const std::string& name) {
  Polynomial result;
  result.add({{name, 1}}, 1);
  return result;
}

void Polynomial::add(const Monomial& monomial, const Rational& coefficient) {
  if (coefficient.sign() == 0) return;
  const auto [place, is_new] = terms_.try_emplace(monomial, coefficient);
  if (is_new) return;
  place->second += coefficient;
  if (place->second.sign() == 0) terms_.erase(place);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum = a;
  for (const auto& [monomial, coefficient] : b.terms_) sum.add(monomial, coefficient);
  return sum;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial difference = a;
  for (const auto& [monomial, coefficient] : b.terms_) difference.add(monomial, -coefficient);
  return difference;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product;
  for (const auto& [left, left_coefficient] : a.terms_)
    for (const auto& [right, right_coefficient] : b.terms_) {
      Polynomial::Monomial monomial = left;
      for (const auto& [name, exponent] : right) monomial[name] += exponent;
      product.add(monomial, left_coefficient * right_coefficient);
    }
  return product;
}

Polynomial Polynomial::with_square(const std::string& name, const Polynomial& square) const {
  for (const auto& [monomial, coefficient] : square.terms_)
    expects(!monomial.contains(name), "a square without the variable", named("name", name));
  Polynomial result;
  for (const auto& [monomial, coefficient] : terms_) {
    Monomial rest = monomial;
    const auto place = rest.find(name);
    const int exponent = place == rest.end() ? 0 : place->second;
    if (place != rest.end()) rest.erase(place);
    if (exponent % 2 != 0) rest.emplace(name, 1);
    Polynomial term;
    term.add(rest, coefficient);
    for (int k = 0; k < exponent / 2; ++k) term = term * square;
    result = result + term;
  }
  return result;
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  RationalFunction sum;
  const bool is_shared = a.below == b.below;
  sum.above = is_shared ? a.above + b.above : a.above * b.below + b.above * a.below;
  sum.below = is_shared ? a.below : a.below * b.below;
  return sum;
}

RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return a + -b; }

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  RationalFunction product = a.above * b.above;
  product.below = a.below * b.below;
  return product;
}

RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  expects(b.above != Polynomial(), "a divisor that is not 0");
  RationalFunction quotient = a.above * b.below;
  quotient.below = a.below * b.above;
  return quotient;
}

RationalFunction RationalFunction::operator-() const {
  RationalFunction negative = -above;
  negative.below = below;
  return negative;
}

Rational differing_terms(const RationalFunction& a, const RationalFunction& b,
                         std::span<const SquareRule> rules) {
  Polynomial difference = a.above * b.below - b.above * a.below;
  for (const SquareRule& rule : rules) difference = difference.with_square(rule.name, rule.square);
  return static_cast<long>(difference.terms().size());
}

Rational negative_terms(const RationalFunction& f) {
  const auto of = [](const Polynomial& polynomial) {
    return std::count_if(polynomial.terms().begin(), polynomial.terms().end(),
                         [](const auto& term) { return term.second.sign() < 0; });
  };
  return static_cast<long>(of(f.above) + of(f.below));
}

}  // namespace radcert::verification
