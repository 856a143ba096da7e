// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/exact_function.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

/// Made when it is first asked for: a constant of another source may be made before those of this one.
const std::array<Rational, 2>& constant_exponents() {
  static const std::array<Rational, 2> zeros{0, 0};
  return zeros;
}

/// The number of coefficients grows with its square.
const WorkLimit highest_bernstein_degree("surface/exact_function: degree of Bernstein's coefficients", 64, 0,
                                         "the sign is not shown: boxes are tried");

void add_to(PowerSum& sum, const std::array<Rational, 2>& exponents, const Rational& coefficient) {
  const auto [at, added] = sum.try_emplace(exponents, coefficient);
  if (!added) at->second += coefficient;
  if (at->second.sign() == 0) sum.erase(at);
}

PowerSum sum_of(const PowerSum& a, const PowerSum& b) {
  PowerSum result = a;
  for (const auto& [exponents, coefficient] : b) add_to(result, exponents, coefficient);
  return result;
}

PowerSum product_of(const PowerSum& a, const PowerSum& b) {
  PowerSum result;
  for (const auto& [i, x] : a)
    for (const auto& [j, y] : b) add_to(result, {i[0] + j[0], i[1] + j[1]}, x * y);
  return result;
}

PowerSum constant(const Rational& value) {
  PowerSum result;
  if (value.sign() != 0) result.emplace(constant_exponents(), value);
  return result;
}

std::optional<Rational> constant_of(const PowerSum& sum) {
  if (sum.empty()) return Rational(0);
  if (sum.size() == 1 && sum.begin()->first == constant_exponents()) return sum.begin()->second;
  return std::nullopt;
}

/// With the denominator 1 where it is constant, so that equal functions meet more often.
PowerQuotient quotient_of(PowerSum numerator, PowerSum denominator) {
  if (const std::optional<Rational> value = constant_of(denominator)) {
    for (auto& [exponents, coefficient] : numerator) coefficient /= *value;
    denominator = constant(1);
  }
  if (numerator == denominator) return {.numerator = constant(1), .denominator = constant(1)};
  return {.numerator = std::move(numerator), .denominator = std::move(denominator)};
}

PowerQuotient product_of(const PowerQuotient& a, const PowerQuotient& b) {
  return quotient_of(product_of(a.numerator, b.numerator), product_of(a.denominator, b.denominator));
}

PowerQuotient sum_of(const PowerQuotient& a, const PowerQuotient& b) {
  if (a.denominator == b.denominator) return quotient_of(sum_of(a.numerator, b.numerator), a.denominator);
  return quotient_of(sum_of(product_of(a.numerator, b.denominator), product_of(b.numerator, a.denominator)),
                     product_of(a.denominator, b.denominator));
}

/// The root of a square of a rational number.
std::optional<Rational> rational_root(const Rational& square) {
  if (square.sign() < 0) return std::nullopt;
  // By halving the interval of integers; the numbers are small or the root is kept as a root.
  const auto integer_root = [](const Rational& n) -> std::optional<Rational> {
    const std::optional<long> value = n.to_long();
    if (!value) return std::nullopt;
    long low = 0;
    long high = 3037000499;  // the largest whose square is a long
    while (low < high) {
      const long middle = low + (high - low + 1) / 2;
      if (middle * middle <= *value)
        low = middle;
      else
        high = middle - 1;
    }
    return low * low == *value ? std::optional<Rational>(low) : std::nullopt;
  };
  const std::optional<Rational> numerator = integer_root(square.numerator());
  const std::optional<Rational> denominator = integer_root(square.denominator());
  if (!numerator || !denominator) return std::nullopt;
  return *numerator / *denominator;
}

PowerSum where_t_is_zero_in(const PowerSum& sum) {
  PowerSum result;
  for (const auto& [exponents, coefficient] : sum)
    if (exponents[1].sign() == 0) result.emplace(exponents, coefficient);
  return result;
}

Rational binomial(long n, long k) {
  Rational result = 1;
  for (long i = 0; i < k; ++i) result *= Rational(n - i, i + 1);
  return result;
}

/// The coefficients of a sum of powers, all exponents made whole by s = x^k, t = y^l.
struct WholePowers {
  std::vector<std::array<long, 2>> exponents;
  std::vector<Rational> coefficients;
  std::array<long, 2> degrees{0, 0};
  long total_degree = 0;
};

std::optional<WholePowers> whole_powers(const PowerSum& sum, ParameterRegion region) {
  std::array<Rational, 2> scale{1, 1};
  for (const auto& [exponents, coefficient] : sum)
    for (std::size_t i = 0; i < 2; ++i)
      if (!(scale[i] * exponents[i]).is_integer()) scale[i] *= (scale[i] * exponents[i]).denominator();
  if (region == ParameterRegion::triangle && (scale[0] != 1 || scale[1] != 1)) return std::nullopt;
  WholePowers result;
  const long highest = highest_bernstein_degree.value();
  for (const auto& [exponents, coefficient] : sum) {
    const std::optional<long> i = (scale[0] * exponents[0]).to_long();
    const std::optional<long> j = (scale[1] * exponents[1]).to_long();
    if (!i || !j || *i > highest || *j > highest) return std::nullopt;
    result.exponents.push_back({*i, *j});
    result.coefficients.push_back(coefficient);
    result.degrees = {std::max(result.degrees[0], *i), std::max(result.degrees[1], *j)};
    result.total_degree = std::max(result.total_degree, *i + *j);
  }
  return result;
}

/// 1 where all coefficients are >= 0, -1 where all are <= 0, 0 where neither is shown; 1 for the zero
/// function.
int sign_over(const PowerSum& sum, ParameterRegion region) {
  const std::optional<WholePowers> powers = whole_powers(sum, region);
  if (!powers) return 0;
  const bool triangle = region == ParameterRegion::triangle;
  const long n = triangle ? powers->total_degree : powers->degrees[0];
  const long m = triangle ? powers->total_degree : powers->degrees[1];
  bool positive = false;
  bool negative = false;
  for (long k = 0; k <= n; ++k)
    for (long l = 0; l <= (triangle ? n - k : m); ++l) {
      Rational b = 0;
      for (std::size_t term = 0; term < powers->exponents.size(); ++term) {
        const auto [i, j] = powers->exponents[term];
        if (i > k || j > l) continue;
        // s^i t^j in Bernstein's basis, of the total degree n or of the degrees n and m.
        const Rational of_power =
            triangle ? binomial(n, i + j) * binomial(i + j, i) : binomial(n, i) * binomial(m, j);
        b += powers->coefficients[term] * binomial(k, i) * binomial(l, j) / of_power;
      }
      positive = positive || b.sign() > 0;
      negative = negative || b.sign() < 0;
    }
  if (positive && negative) return 0;
  return negative ? -1 : 1;
}

}  // namespace

ExactFunction::ExactFunction(const Rational& value) {
  add({}, {.numerator = constant(value), .denominator = constant(1)});
}

ExactFunction ExactFunction::s() {
  ExactFunction f;
  f.add({}, {.numerator = {{{1, 0}, 1}}, .denominator = constant(1)});
  return f;
}

ExactFunction ExactFunction::t() {
  ExactFunction f;
  f.add({}, {.numerator = {{{0, 1}, 1}}, .denominator = constant(1)});
  return f;
}

ExactFunction ExactFunction::unknown() {
  ExactFunction f;
  f.known_ = false;
  return f;
}

void ExactFunction::add(const Radicands& radicands, const PowerQuotient& factor) {
  if (factor.numerator.empty()) return;
  const auto [at, added] = terms_.try_emplace(radicands, factor);
  if (added) return;
  at->second = sum_of(at->second, factor);
  if (at->second.numerator.empty()) terms_.erase(at);
}

std::optional<PowerQuotient> ExactFunction::quotient() const {
  if (!known_) return std::nullopt;
  if (terms_.empty()) return PowerQuotient{.numerator = {}, .denominator = constant(1)};
  if (terms_.size() != 1 || !terms_.begin()->first.empty()) return std::nullopt;
  return terms_.begin()->second;
}

ExactFunction ExactFunction::where_t_is_zero() const {
  if (!known_) return unknown();
  ExactFunction result;
  for (const auto& [radicands, factor] : terms_) {
    PowerSum denominator = where_t_is_zero_in(factor.denominator);
    if (!radicands.empty() || denominator.empty()) return unknown();
    result.add({}, quotient_of(where_t_is_zero_in(factor.numerator), std::move(denominator)));
  }
  return result;
}

ExactFunction operator-(const ExactFunction& f) { return ExactFunction(-1) * f; }

ExactFunction operator+(const ExactFunction& f, const ExactFunction& g) {
  if (!f.known_ || !g.known_) return ExactFunction::unknown();
  ExactFunction result = f;
  for (const auto& [radicands, factor] : g.terms_) result.add(radicands, factor);
  return result;
}

ExactFunction operator*(const ExactFunction& f, const ExactFunction& g) {
  if (!f.known_ || !g.known_) return ExactFunction::unknown();
  ExactFunction result;
  for (const auto& [a, x] : f.terms_)
    for (const auto& [b, y] : g.terms_) {
      PowerQuotient factor = product_of(x, y);
      ExactFunction::Radicands radicands;
      std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(radicands));
      ExactFunction::Radicands twice;
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(twice));
      for (const PowerQuotient& squared : twice) factor = product_of(factor, squared);
      result.add(radicands, factor);
    }
  return result;
}

ExactFunction reciprocal(const ExactFunction& f) {
  if (!f.known_ || f.terms_.size() != 1) return ExactFunction::unknown();
  const auto& [radicands, factor] = *f.terms_.begin();
  PowerQuotient inverse = quotient_of(factor.denominator, factor.numerator);
  for (const PowerQuotient& g : radicands)
    inverse = product_of(inverse, quotient_of(g.denominator, g.numerator));
  ExactFunction result;
  result.add(radicands, inverse);
  return result;
}

ExactFunction sqrt(const ExactFunction& f) {
  const std::optional<PowerQuotient> radicand = f.quotient();
  if (!radicand) return ExactFunction::unknown();
  const std::optional<Rational> value =
      constant_of(radicand->denominator) ? constant_of(radicand->numerator) : std::nullopt;
  if (const std::optional<Rational> root = value ? rational_root(*value) : std::nullopt)
    return ExactFunction(*root);
  ExactFunction result;
  result.add({*radicand}, {.numerator = constant(1), .denominator = constant(1)});
  return result;
}

ExactFunction pow(const ExactFunction& f, const ExactFunction& exponent) {
  const std::optional<PowerQuotient> base = f.quotient();
  const std::optional<PowerQuotient> power = exponent.quotient();
  if (!base || !power || constant_of(base->denominator) != Rational(1) || base->numerator.size() != 1 ||
      constant_of(power->denominator) != Rational(1))
    return ExactFunction::unknown();
  const std::optional<Rational> p = constant_of(power->numerator);
  const auto& [exponents, coefficient] = *base->numerator.begin();
  if (!p || p->sign() < 0 || coefficient != 1) return ExactFunction::unknown();
  ExactFunction result;
  result.add({}, {.numerator = {{{*p * exponents[0], *p * exponents[1]}, 1}}, .denominator = constant(1)});
  return result;
}

bool is_nowhere_negative(const ExactFunction& f, ParameterRegion region) {
  return f.known_ && std::all_of(f.terms_.begin(), f.terms_.end(), [region](const auto& term) {
           const PowerQuotient& factor = term.second;
           return sign_over(factor.numerator, region) * sign_over(factor.denominator, region) > 0;
         });
}

}  // namespace radcert
