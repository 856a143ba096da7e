// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/degree_of_precision.h"

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

Rational integral(Region region, const Monomial& m) {
  if (region == Region::parallelogram) return 1 / (Rational(m.s + 1) * Rational(m.t + 1));
  Rational value = 1 / (Rational(m.s + m.t + 1) * Rational(m.s + m.t + 2));
  for (int k = 1; k <= m.t; ++k) value *= Rational(k, m.s + k);
  return value;
}

Rational at(const Rational& s, const Rational& t, const Monomial& m) { return power(s, m.s) * power(t, m.t); }

std::string factor(const char* name, int exponent) {
  return exponent == 1 ? name : std::string(name) + "^" + std::to_string(exponent);
}

}  // namespace

std::string Monomial::to_text() const {
  if (s == 0 && t == 0) return "1";
  if (t == 0) return factor("s", s);
  if (s == 0) return factor("t", t);
  return factor("s", s) + " " + factor("t", t);
}

Rational defect(const TriangleRule<Rational>& rule, Region region, const Monomial& monomial) {
  expects(rule.points.size() == rule.weights.size(), "as many weights as points",
          named("points", rule.points.size()), named("weights", rule.weights.size()));
  expects(monomial.s >= 0 && monomial.t >= 0, "exponents that are not negative", named("s", monomial.s),
          named("t", monomial.t));
  Rational sum = 0;
  for (std::size_t j = 0; j < rule.points.size(); ++j) {
    const Rational& s = rule.points[j].x[2];
    const Rational& t = rule.points[j].x[1];
    Rational value = at(s, t, monomial);
    if (region == Region::parallelogram) value += at(1 - s, 1 - t, monomial);
    sum += rule.weights[j] * value;
  }
  return sum - integral(region, monomial);
}

Precision degree_of_precision(const TriangleRule<Rational>& rule, Region region) {
  expects(!rule.points.empty(), "a rule with at least one point");
  // Ends: the square of a polynomial that vanishes at all points has a positive integral.
  for (int degree = 0;; ++degree)
    for (int t = 0; t <= degree; ++t) {
      const Monomial monomial{degree - t, t};
      const Rational missed = defect(rule, region, monomial);
      if (missed.sign() != 0) return {.degree = degree - 1, .first_failure = monomial, .defect = missed};
    }
}

}  // namespace radcert
