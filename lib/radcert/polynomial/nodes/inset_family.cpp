// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/inset_family.h"

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

const RationalPolynomial& alpha() {
  static const RationalPolynomial variable = RationalPolynomial::variable();
  return variable;
}

// 1 - 3 alpha.
const RationalPolynomial& shrinkage() {
  static const RationalPolynomial polynomial(std::vector<Rational>{1, -3});
  return polynomial;
}

RationalPolynomial to_the(int exponent, const RationalPolynomial& base) {
  RationalPolynomial result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

// prod_{a < k} (r (x - alpha) - a (1 - 3 alpha))/(k - a) by powers of x.
std::vector<RationalPolynomial> factor_in_x(int r, int k) {
  std::vector<RationalPolynomial> product{RationalPolynomial(1)};
  for (int a = 0; a < k; ++a) {
    const RationalPolynomial slope(Rational(r, k - a));
    const RationalPolynomial constant =
        (RationalPolynomial(-r) * alpha() - RationalPolynomial(a) * shrinkage()) *
        RationalPolynomial(Rational(1, k - a));
    std::vector<RationalPolynomial> next(product.size() + 1);
    for (std::size_t m = 0; m < product.size(); ++m) {
      next[m] += product[m] * constant;
      next[m + 1] += product[m] * slope;
    }
    product = std::move(next);
  }
  return product;
}

// Int_sigma x_1^a x_2^b x_3^c.
Rational integral(std::size_t a, std::size_t b, std::size_t c) {
  Rational value = 1 / (Rational(a + b + c + 1) * Rational(a + b + c + 2));
  for (std::size_t k = 1; k <= b; ++k) value *= Rational(k) / Rational(a + k);
  for (std::size_t k = 1; k <= c; ++k) value *= Rational(k) / Rational(a + b + k);
  return value;
}

RationalPolynomial integral_of_numerator(int r, const std::array<int, 3>& k) {
  const std::vector<RationalPolynomial> first = factor_in_x(r, k[0]);
  const std::vector<RationalPolynomial> second = factor_in_x(r, k[1]);
  const std::vector<RationalPolynomial> third = factor_in_x(r, k[2]);
  RationalPolynomial sum;
  for (std::size_t a = 0; a < first.size(); ++a)
    for (std::size_t b = 0; b < second.size(); ++b) {
      const RationalPolynomial product = first[a] * second[b];
      for (std::size_t c = 0; c < third.size(); ++c)
        sum += product * third[c] * RationalPolynomial(integral(a, b, c));
    }
  return sum;
}

}  // namespace

Rational InsetFunction::operator()(const Rational& at) const {
  return numerator(at) / power(1 - 3 * at, pole_order);
}

std::string InsetFunction::to_text() const {
  const std::string above = numerator.to_text("alpha");
  if (pole_order == 0) return above;
  return "(" + above + ") / (1 - 3 alpha)" + (pole_order == 1 ? "" : "^" + std::to_string(pole_order));
}

InsetFamily::InsetFamily(int degree) : degree_(degree) {
  expects(0 <= degree && degree <= 30, "0 <= degree <= 30", named("degree", degree));
  indices_ = lattice_indices(degree);
  for (const std::array<int, 3>& k : indices_) weight_numerators_.push_back(integral_of_numerator(degree, k));
}

std::array<RationalPolynomial, 3> InsetFamily::node(std::size_t j) const {
  expects(j < size(), "the number of a node", named("node", j), named("nodes", size()));
  std::array<RationalPolynomial, 3> q;
  for (std::size_t i = 0; i < 3; ++i)
    q[i] = degree_ == 0 ? RationalPolynomial(Rational(1, 3))
                        : alpha() + shrinkage() * RationalPolynomial(Rational(indices_[j][i], degree_));
  return q;
}

InsetFunction InsetFamily::reduced(RationalPolynomial numerator) const {
  InsetFunction function{.numerator = std::move(numerator), .pole_order = degree_};
  if (function.numerator.is_zero()) function.pole_order = 0;
  while (function.pole_order > 0) {
    Division division = divide(function.numerator, shrinkage());
    if (!division.remainder.is_zero()) break;
    function.numerator = std::move(division.quotient);
    --function.pole_order;
  }
  return function;
}

InsetFunction InsetFamily::value(std::size_t j, const Barycentric<Rational>& x) const {
  expects(j < size(), "the number of a function", named("function", j), named("functions", size()));
  expects(x.x[0] + x.x[1] + x.x[2] == 1, "barycentric coordinates with the sum 1");
  RationalPolynomial product = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<RationalPolynomial> factor = factor_in_x(degree_, indices_[j][i]);
    RationalPolynomial sum;
    for (std::size_t m = 0; m < factor.size(); ++m)
      sum += factor[m] * RationalPolynomial(power(x.x[i], static_cast<long>(m)));
    product *= sum;
  }
  return reduced(std::move(product));
}

InsetFunction InsetFamily::weight(std::size_t j) const {
  expects(j < size(), "the number of a weight", named("weight", j), named("weights", size()));
  return reduced(weight_numerators_[j]);
}

InsetFunction InsetFamily::defect(Region region, const Monomial& monomial) const {
  // The empty rule misses the integral itself.
  const Rational missing = radcert::defect(TriangleRule<Rational>{}, region, monomial);
  RationalPolynomial sum = RationalPolynomial(missing) * to_the(degree_, shrinkage());
  for (std::size_t j = 0; j < size(); ++j) {
    const std::array<RationalPolynomial, 3> q = node(j);
    RationalPolynomial value = to_the(monomial.s, q[2]) * to_the(monomial.t, q[1]);
    if (region == Region::parallelogram)
      value +=
          to_the(monomial.s, RationalPolynomial(1) - q[2]) * to_the(monomial.t, RationalPolynomial(1) - q[1]);
    sum += weight_numerators_[j] * value;
  }
  return reduced(std::move(sum));
}

RationalPolynomial InsetFamily::condition(Region region, int precision) const {
  expects(precision >= 0, "precision >= 0", named("precision", precision));
  RationalPolynomial common;
  for (int t = 0; t <= precision; ++t)
    common = greatest_common_divisor(common, defect(region, {precision - t, t}).numerator);
  return common;
}

}  // namespace radcert
