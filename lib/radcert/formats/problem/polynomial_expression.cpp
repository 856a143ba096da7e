// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/polynomial_expression.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"

namespace radcert {

namespace {

using Polynomial = PlanePolynomial<Rational>;

// The same polynomial with no more degrees than it has.
Polynomial trimmed(const Polynomial& p) {
  int degree = p.degree();
  const auto is_zero_at = [&](int total) {
    for (int j = 0; j <= total; ++j)
      if (p(total - j, j) != 0) return false;
    return true;
  };
  while (degree > 0 && is_zero_at(degree)) --degree;
  Polynomial out(degree);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) out(i, j) = p(i, j);
  return out;
}

Polynomial constant(const Rational& value) { return constant_polynomial(value); }

Polynomial coordinate(int variable) {
  if (variable == 1) return affine_polynomial<Rational>(0, 0, 1);
  if (variable == 2) return affine_polynomial<Rational>(0, 1, 0);
  return affine_polynomial<Rational>(1, -1, -1);
}

bool is_zero(const Polynomial& p) { return p.degree() == 0 && p(0, 0) == 0; }

std::string name_of(ExpressionKind kind) {
  switch (kind) {
    case ExpressionKind::pi: return "pi, which is no fraction,";
    case ExpressionKind::sqrt: return "sqrt";
    case ExpressionKind::exp: return "exp";
    case ExpressionKind::log: return "log";
    case ExpressionKind::sin: return "sin";
    case ExpressionKind::cos: return "cos";
    case ExpressionKind::tan: return "tan";
    case ExpressionKind::atan: return "atan";
    case ExpressionKind::abs: return "abs";
    case ExpressionKind::min: return "min";
    case ExpressionKind::max: return "max";
    default: return "an operation";
  }
}

class Walk {
public:
  explicit Walk(int largest_degree) : largest_degree_(largest_degree) {}

  Outcome<Polynomial> value(const ExpressionNode& node) const {
    switch (node.kind) {
      case ExpressionKind::literal: return constant(node.literal);
      case ExpressionKind::variable: return coordinate(node.variable);
      case ExpressionKind::negate: return trimmed(sum(constant(0), Rational(-1), at(node.left)));
      case ExpressionKind::add: return trimmed(sum(at(node.left), Rational(1), at(node.right)));
      case ExpressionKind::subtract: return trimmed(sum(at(node.left), Rational(-1), at(node.right)));
      case ExpressionKind::multiply: return bounded_product(at(node.left), at(node.right));
      case ExpressionKind::divide: return quotient(at(node.left), at(node.right));
      case ExpressionKind::power: return whole_power(at(node.left), node.whole_exponent);
      default: return because("has " + name_of(node.kind) + " and is no polynomial");
    }
  }
  void keep(Polynomial p) { values_.push_back(std::move(p)); }
  [[nodiscard]] const Polynomial& last() const { return values_.back(); }

private:
  [[nodiscard]] const Polynomial& at(int place) const { return values_[static_cast<std::size_t>(place)]; }

  [[nodiscard]] Outcome<Polynomial> bounded_product(const Polynomial& a, const Polynomial& b) const {
    if (is_zero(a) || is_zero(b)) return constant(0);
    if (a.degree() + b.degree() > largest_degree_)
      return because("has a product of degree " + std::to_string(a.degree() + b.degree()));
    return trimmed(product(a, b));
  }

  static Outcome<Polynomial> quotient(const Polynomial& a, const Polynomial& b) {
    if (b.degree() > 0) return because("divides by a coordinate and is no polynomial");
    if (is_zero(b)) return because("divides by zero");
    return trimmed(product(a, constant(1 / b(0, 0))));
  }

  [[nodiscard]] Outcome<Polynomial> whole_power(const Polynomial& base,
                                                const std::optional<long>& exponent) const {
    if (!exponent || *exponent < 0 || *exponent > largest_degree_)
      return because("has an exponent that is not a whole number from 0 to " +
                     std::to_string(largest_degree_));
    Polynomial out = constant(1);
    for (long k = 0; k < *exponent; ++k) {
      Outcome<Polynomial> next = bounded_product(out, base);
      if (!next) return because(next.reason());
      out = *std::move(next);
    }
    return out;
  }

  int largest_degree_;
  std::vector<Polynomial> values_;
};

}  // namespace

Outcome<PlanePolynomial<Rational>> polynomial_of(const Expression& expression, int largest_degree) {
  expects(expression.variables() == ExpressionVariables::barycentric, "an expression in x1, x2, x3",
          named("text", expression.text()));
  Walk walk(largest_degree);
  for (const ExpressionNode& node : expression.nodes()) {
    Outcome<Polynomial> value = walk.value(node);
    if (!value) return because(value.reason());
    walk.keep(*std::move(value));
  }
  return walk.last();
}

std::vector<Rational> bernstein_coefficients(const PlanePolynomial<Rational>& polynomial, int degree) {
  expects(polynomial.degree() <= degree, "a degree that holds the polynomial",
          named("polynomial", polynomial.degree()), named("degree", degree));
  const auto multinomial = [](int k1, int k2, int k3) {
    Rational value = 1;
    int above = 0;
    for (const int exponent : {k1, k2, k3})
      for (int m = 1; m <= exponent; ++m) value *= Rational(++above, m);
    return value;
  };
  std::vector<Rational> out;
  for (const auto& [k1, k2, k3] : lattice_indices(degree)) {
    Rational sum = 0;
    for (int a = 0; a <= std::min(k3, polynomial.degree()); ++a)
      for (int b = 0; b <= std::min(k2, polynomial.degree() - a); ++b)
        sum += polynomial(a, b) * multinomial(k1, k2 - b, k3 - a);
    out.push_back(sum / multinomial(k1, k2, k3));
  }
  return out;
}

}  // namespace radcert
