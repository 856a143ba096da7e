// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/exact_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radcert/closed_form/plane_element.h"
#include "radcert/core/contract.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
/// Enough for a handful of roundings.
constexpr double upward = 1 + 8 * unit;
constexpr double underflow = std::numeric_limits<double>::denorm_min();

Rational factorial(int n) {
  Rational product = 1;
  for (int i = 2; i <= n; ++i) product *= Rational(i);
  return product;
}

/// n! / (k_1! k_2! k_3!), n the sum.
Rational multinomial(int k1, int k2, int k3) {
  return factorial(k1 + k2 + k3) / (factorial(k1) * factorial(k2) * factorial(k3));
}

/// l_j by its monomials: x_1^k = (1 - s - t)^k, multiplied out.
PlanePolynomial<Rational> by_monomials(const LagrangeFunctions& functions, std::size_t j) {
  PlanePolynomial<Rational> q(functions.degree());
  const std::span<const Rational> coefficients = functions.bernstein_coefficients(j);
  const std::vector<std::array<int, 3>> indices = lattice_indices(functions.degree());
  for (std::size_t place = 0; place < indices.size(); ++place) {
    const auto [k1, k2, k3] = indices[place];
    const Rational leading = coefficients[place] * multinomial(k1, k2, k3);
    for (int a = 0; a <= k1; ++a)
      for (int b = 0; a + b <= k1; ++b) {
        const Rational term = leading * multinomial(a, b, k1 - a - b);
        q(k2 + a, k3 + b) += (a + b) % 2 == 0 ? term : -term;
      }
  }
  return q;
}

/// `scale` becomes a multiple of the denominator of x.
void clear_denominator(Rational& scale, const Rational& x) { scale *= (scale * x).denominator(); }

void clear_denominators(Rational& scale, const Vector<Rational>& x) {
  clear_denominator(scale, x.x);
  clear_denominator(scale, x.y);
  clear_denominator(scale, x.z);
}

/// The vector of that direction in whole numbers without a common factor.
Vector<Rational> primitive(const Vector<Rational>& direction) {
  const Rational& some = direction.x.sign() != 0   ? direction.x
                         : direction.y.sign() != 0 ? direction.y
                                                   : direction.z;
  const Vector<Rational> relative = (Rational(1) / abs(some)) * direction;
  Rational scale = 1;
  clear_denominators(scale, relative);
  return scale * relative;
}

bool is_double(const Rational& x) {
  const double nearest = x.to_double();
  return std::isfinite(nearest) && Rational::exactly(nearest) == x;
}

bool is_double(const Vector<Rational>& x) { return is_double(x.x) && is_double(x.y) && is_double(x.z); }

Vector<double> in_double(const Vector<Rational>& x) {
  return {x.x.to_double(), x.y.to_double(), x.z.to_double()};
}

}  // namespace

Outcome<ExactNodes> exact_nodes(std::span<const ExactTriangle> elements, const LagrangeFunctions& functions) {
  struct Node {
    Vector<Rational> point;
    Vector<Rational> normal;
  };
  std::vector<Node> exact;
  ExactNodes result;
  for (const ExactTriangle& c : elements) {
    const Vector<Rational> normal = cross(c[1] - c[0], c[2] - c[0]);
    expects(normal != Vector<Rational>{}, "an element that is not degenerate");
    for (const Vector<Rational>& corner : c) clear_denominators(result.scale, corner);
    for (const Barycentric<Rational>& q : functions.nodes()) {
      exact.push_back({q.x[0] * c[0] + q.x[1] * c[1] + q.x[2] * c[2], primitive(normal)});
      clear_denominators(result.scale, exact.back().point);
    }
  }
  for (const Node& node : exact) {
    const Vector<Rational> point = result.scale * node.point;
    if (!is_double(point) || !is_double(node.normal))
      return because("there is no unit of length in which every node is a double");
    result.nodes.push_back({in_double(point), in_double(node.normal)});
  }
  return result;
}

std::vector<PlanePolynomial<Rational>> by_monomials(const LagrangeFunctions& functions) {
  std::vector<PlanePolynomial<Rational>> polynomials;
  for (std::size_t j = 0; j < functions.size(); ++j) polynomials.push_back(by_monomials(functions, j));
  return polynomials;
}

PlaneElement plane_element(const ExactTriangle& c, const Rational& scale,
                           const std::vector<PlanePolynomial<Rational>>& functions) {
  const std::vector<PolygonLoop> loops{{{0, 0}, {1, 0}, {0, 1}}};
  const Outcome<PlanePolygon> polygon =
      plane_polygon(scale * c[0], scale * (c[1] - c[0]), scale * (c[2] - c[0]), loops);
  return {polygon.value(), functions};
}

Outcome<IntegralErrors> IntegralErrors::of(const LagrangeFunctions& functions) {
  if (functions.reproduced_degree() < 0)
    return because("the functions do not have the sum 1, which the bound of their integrals rests on");
  Rational largest = 0;
  for (std::size_t j = 0; j < functions.size(); ++j)
    for (const Rational& coefficient : functions.bernstein_coefficients(j))
      largest = std::max(largest, abs(coefficient));
  const double bound = largest.to_double() * upward;
  if (!(static_cast<double>(functions.size()) * bound * PlaneElement::usual_accuracy < 0.5))
    return because("the functions are too large for the bound of their integrals");
  return IntegralErrors(bound);
}

double IntegralErrors::bound(std::span<const double> integrals) const {
  const double accuracy = PlaneElement::usual_accuracy * upward;
  const auto count = static_cast<double>(integrals.size());
  double sum = 0;
  double size = 0;
  for (const double value : integrals) {
    sum += value;
    size += std::abs(value);
  }
  const double integral =
      (std::abs(sum) + count * unit * size * upward) / (1 - count * accuracy * largest_ * upward) * upward;
  // An integral below the normal numbers is rounded to one of them, or to zero.
  return accuracy * largest_ * integral * upward + 2 * underflow;
}

Approximation certified_entry(double reflectivity, double integral, double error) {
  const double factor = reflectivity * std::numbers::inv_pi;
  const double entry = factor * integral;
  // The factor and the product are rounded, 1/pi as well: three units of the entry. A factor below the normal
  // numbers is off by half of the least of all, and so may be what is multiplied with it.
  const double relative = std::abs(factor) * error * upward + 4 * unit * std::abs(entry);
  return Approximation::proved(entry,
                               relative * upward + underflow * (std::abs(integral) + error + 4) * upward);
}

}  // namespace radcert
