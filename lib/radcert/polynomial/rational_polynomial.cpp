// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rational_polynomial.h"

#include <algorithm>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

RationalPolynomial monic(const RationalPolynomial& p) {
  return p.is_zero() ? p : p * RationalPolynomial(1 / p.leading());
}

}  // namespace

RationalPolynomial::RationalPolynomial(const Rational& constant) : coefficients_{constant} { trim(); }

RationalPolynomial::RationalPolynomial(std::vector<Rational> coefficients)
    : coefficients_(std::move(coefficients)) {
  trim();
}

RationalPolynomial RationalPolynomial::variable() { return RationalPolynomial(std::vector<Rational>{0, 1}); }

void RationalPolynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back().sign() == 0) coefficients_.pop_back();
}

Rational RationalPolynomial::coefficient(std::size_t k) const {
  return k < coefficients_.size() ? coefficients_[k] : Rational(0);
}

Rational RationalPolynomial::leading() const {
  return coefficients_.empty() ? Rational(0) : coefficients_.back();
}

Rational RationalPolynomial::operator()(const Rational& x) const {
  Rational value = 0;
  for (std::size_t k = coefficients_.size(); k-- > 0;) value = value * x + coefficients_[k];
  return value;
}

RationalPolynomial RationalPolynomial::derivative() const {
  std::vector<Rational> derived;
  for (std::size_t k = 1; k < coefficients_.size(); ++k) derived.push_back(coefficients_[k] * k);
  return RationalPolynomial(std::move(derived));
}

std::string RationalPolynomial::to_text(std::string_view variable) const {
  if (is_zero()) return "0";
  std::string text;
  for (std::size_t k = coefficients_.size(); k-- > 0;) {
    const Rational& a = coefficients_[k];
    if (a.sign() == 0) continue;
    if (text.empty()) {
      text += a.sign() < 0 ? "-" : "";
    } else {
      text += a.sign() < 0 ? " - " : " + ";
    }
    const bool unit = abs(a) == 1;
    if (k == 0 || !unit) text += abs(a).to_text();
    if (k == 0) continue;
    if (!unit) text += " ";
    text += variable;
    if (k > 1) text += "^" + std::to_string(k);
  }
  return text;
}

RationalPolynomial& RationalPolynomial::operator+=(const RationalPolynomial& other) {
  coefficients_.resize(std::max(coefficients_.size(), other.coefficients_.size()));
  for (std::size_t k = 0; k < other.coefficients_.size(); ++k) coefficients_[k] += other.coefficients_[k];
  trim();
  return *this;
}

RationalPolynomial& RationalPolynomial::operator-=(const RationalPolynomial& other) {
  coefficients_.resize(std::max(coefficients_.size(), other.coefficients_.size()));
  for (std::size_t k = 0; k < other.coefficients_.size(); ++k) coefficients_[k] -= other.coefficients_[k];
  trim();
  return *this;
}

RationalPolynomial& RationalPolynomial::operator*=(const RationalPolynomial& other) {
  if (is_zero() || other.is_zero()) return *this = RationalPolynomial();
  std::vector<Rational> product(coefficients_.size() + other.coefficients_.size() - 1);
  for (std::size_t i = 0; i < coefficients_.size(); ++i)
    for (std::size_t k = 0; k < other.coefficients_.size(); ++k)
      product[i + k] += coefficients_[i] * other.coefficients_[k];
  coefficients_ = std::move(product);
  return *this;
}

RationalPolynomial RationalPolynomial::operator-() const { return RationalPolynomial() - *this; }

Division divide(const RationalPolynomial& a, const RationalPolynomial& b) {
  expects(!b.is_zero(), "a divisor other than zero", named("dividend", a));
  Division result{.quotient = {}, .remainder = a};
  while (result.remainder.degree() >= b.degree()) {
    std::vector<Rational> term(static_cast<std::size_t>(result.remainder.degree() - b.degree()) + 1);
    term.back() = result.remainder.leading() / b.leading();
    const RationalPolynomial step(std::move(term));
    result.quotient += step;
    result.remainder -= step * b;
  }
  return result;
}

RationalPolynomial greatest_common_divisor(RationalPolynomial a, RationalPolynomial b) {
  while (!b.is_zero()) {
    RationalPolynomial rest = monic(divide(a, b).remainder);
    a = std::move(b);
    b = std::move(rest);
  }
  return monic(a);
}

}  // namespace radcert
