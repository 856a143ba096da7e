// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/basis_facts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/superconvergent_inset.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/polynomial/rules/product_precision.h"

namespace radcert {
namespace {

EnclosedPrecision enclosed(const Precision& precision) {
  return {
      .degree = precision.degree, .first_failure = precision.first_failure, .defect = Ball(precision.defect)};
}

Rational condition_of(const LagrangeFunctions& functions) {
  std::vector<Rational> sums(functions.bernstein_coefficients(0).size());
  for (std::size_t j = 0; j < functions.size(); ++j) {
    const std::span<const Rational> coefficients = functions.bernstein_coefficients(j);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += abs(coefficients[k]);
  }
  return *std::max_element(sums.begin(), sums.end());
}

Rational multinomial(const std::array<int, 3>& k) {
  Rational value = 1;
  int above = 0;
  for (const int exponent : k)
    for (int m = 1; m <= exponent; ++m) value *= Rational(++above, m);
  return value;
}

Ball value(const RationalPolynomial& p, const Ball& x) {
  Ball sum(0);
  for (int k = p.degree(); k >= 0; --k) sum = sum * x + Ball(p.coefficient(static_cast<std::size_t>(k)));
  return sum;
}

// At most max_j sum_i |l_i(q'_j) - delta_ij|; nothing where it may be 1/2 or more.
std::optional<Rational> change_of(const LagrangeFunctions& functions,
                                  std::span<const Barycentric<Ball>> nodes) {
  const std::vector<std::array<int, 3>> indices = lattice_indices(functions.degree());
  Ball change(0);
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    std::vector<Ball> bernstein;
    for (const auto& [k1, k2, k3] : indices)
      bernstein.push_back(Ball(multinomial({k1, k2, k3})) * power(nodes[j].x[0], k1) *
                          power(nodes[j].x[1], k2) * power(nodes[j].x[2], k3));
    Ball sum(0);
    for (std::size_t i = 0; i < functions.size(); ++i) {
      Ball entry(i == j ? -1 : 0);
      const std::span<const Rational> c = functions.bernstein_coefficients(i);
      for (std::size_t k = 0; k < c.size(); ++k) entry += Ball(c[k]) * bernstein[k];
      sum += abs(entry);
    }
    change = max(change, sum);
  }
  if (!certainly_less(change, Ball(Rational(1, 2)))) return std::nullopt;
  return Rational::exactly(change.upper_double());
}

constexpr long bits_at_true_nodes = 512;  // more than the digits of any node file

}  // namespace

BasisFacts basis_facts(const LagrangeFunctions& functions, const Rational& tolerance) {
  const TriangleRule<Rational> rule = interpolatory_rule(functions);
  BasisFacts facts;
  facts.degree = functions.degree();
  facts.reproduced = functions.reproduced_degree();
  facts.nodes = functions.nodes();
  facts.weights = rule.weights;
  facts.determinant = functions.determinant();
  facts.condition = condition_of(functions);
  facts.norm = lebesgue_constant(functions, tolerance);
  facts.triangle = enclosed(degree_of_precision(rule, Region::triangle));
  facts.parallelogram = enclosed(degree_of_precision(rule, Region::parallelogram));
  if (facts.reproduced < facts.degree || !products_follow(facts.triangle.degree, facts.parallelogram.degree))
    facts.products = {.triangle = product_precision(functions, Region::triangle),
                      .parallelogram = product_precision(functions, Region::parallelogram)};
  return facts;
}

Outcome<BasisFacts> at_true_nodes(BasisFacts facts, const LagrangeFunctions& functions,
                                  std::span<const Barycentric<Ball>> nodes) {
  expects(nodes.size() == functions.size(), "a ball for each node", named("balls", nodes.size()),
          named("nodes", functions.size()));
  const BallPrecision scope(std::max(bits_at_true_nodes, BallPrecision::current()));
  const std::optional<Rational> change = change_of(functions, nodes);
  if (!change) return because("the nodes are not certainly unisolvent");
  const Rational& e = *change;
  facts.norm.lower /= 1 + e;
  facts.norm.upper /= 1 - e;
  facts.condition /= 1 - e;
  return facts;
}

Outcome<BasisFacts> certified_facts(BasisFacts facts, const LagrangeFunctions& functions,
                                    const SymmetricCertificate& certificate) {
  if (facts.degree > facts.reproduced + 1)
    return because(
        "functions of degree " + std::to_string(facts.degree) + " with all polynomials of degree " +
        std::to_string(facts.reproduced) +
        " alone: what a certificate says of a rule does not decide what products miss; \"numbers\" "
        "with polynomials do");
  Outcome<BasisFacts> moved = at_true_nodes(std::move(facts), functions, certificate.rule.points);
  if (!moved) return moved;
  moved->triangle = certificate.triangle;
  moved->parallelogram = certificate.parallelogram;
  moved->proof = PrecisionProof::certificate;
  moved->products.reset();
  const int d = certificate.triangle.degree;
  if (!products_follow(d, certificate.parallelogram.degree)) {
    const BallPrecision scope(std::max(bits_at_true_nodes, BallPrecision::current()));
    const std::optional<Rational> change = change_of(functions, certificate.rule.points);
    if (!change || !products_certainly_missed(functions, certificate.rule.points, *change, d + 2))
      return because("products of degree " + std::to_string(d + 2) + " are not certainly missed");
    moved->products = ProductPrecision{.triangle = d, .parallelogram = d + 1};
  } else if (moved->reproduced < moved->degree) {
    moved->products = ProductPrecision{.triangle = d, .parallelogram = certificate.parallelogram.degree};
  }
  return moved;
}

EnclosedPrecision precision_at_superconvergent_inset(int degree, Region region) {
  const SuperconvergentInsets answer = superconvergent_insets(degree, region);
  expects(!answer.insets.empty(), "a degree with a superconvergent inset", named("degree", degree));
  const SuperconvergentInset& inset = answer.insets.front();
  // As narrow as the balls that it goes into.
  const Rational width = 1 / power(Rational(2), BallPrecision::current());
  const RealZero zero =
      inset.enclosure.is_exact()
          ? inset.enclosure
          : real_zeros(answer.condition, inset.enclosure.lower, inset.enclosure.upper, width).back();
  const Ball alpha = hull(Ball(zero.lower), Ball(zero.upper));
  const InsetFamily family(degree);
  for (int t = 0; t <= inset.precision + 1; ++t) {
    const Monomial monomial{inset.precision + 1 - t, t};
    const InsetFunction missed = family.defect(region, monomial);
    const Ball defect = value(missed.numerator, alpha) / power(Ball(1) - Ball(3) * alpha, missed.pole_order);
    if (!defect.contains_zero())
      return {.degree = inset.precision, .first_failure = monomial, .defect = defect};
  }
  expects(false, "a precision of balls that tells a defect from zero",
          named("bits", BallPrecision::current()));
  return {};
}

PredictedOrders predicted_orders(int reproduced_degree, int triangle_precision, int parallelogram_precision) {
  const int pairs = parallelogram_precision + 1;
  const int single = triangle_precision + 2;
  const int own = reproduced_degree + 3;
  PredictedOrders orders;
  orders.everywhere = reproduced_degree + 1;
  orders.curved = std::min({pairs, single, own});
  orders.curved_has_logarithm = pairs == own && orders.curved == own;
  orders.smooth_kernel = std::min(pairs, single);
  orders.at_edges = reproduced_degree + 1;
  return orders;
}

ProductPrecision product_precision(const BasisFacts& facts) {
  if (facts.products) return *facts.products;
  expects(products_follow(facts.triangle.degree, facts.parallelogram.degree),
          "products that follow the precision of the rule", named("triangle", facts.triangle.degree),
          named("parallelogram", facts.parallelogram.degree));
  return {.triangle = facts.triangle.degree, .parallelogram = facts.parallelogram.degree};
}

PredictedOrders predicted_orders(const BasisFacts& facts) {
  const ProductPrecision precision = product_precision(facts);
  return predicted_orders(facts.reproduced, precision.triangle, precision.parallelogram);
}

}  // namespace radcert
