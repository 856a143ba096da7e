// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified_entries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "radcert/closed_form/plane_element.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/lattice.h"
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

/// l_j by its monomials in s = x_2, t = x_3: x_1^k = (1 - s - t)^k, multiplied out.
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

/// A bound of max |l_j| on the triangle for all j: that of the Bernstein coefficients.
double largest_value(const LagrangeFunctions& functions) {
  Rational largest = 0;
  for (std::size_t j = 0; j < functions.size(); ++j)
    for (const Rational& coefficient : functions.bernstein_coefficients(j))
      largest = std::max(largest, abs(coefficient));
  return largest.to_double() * upward;
}

struct ExactNode {
  Vector<Rational> point;
  Vector<Rational> normal;  ///< whole numbers without a common factor
};

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

std::vector<ExactNode> exact_nodes(std::span<const ExactTriangle> elements,
                                   const LagrangeFunctions& functions) {
  std::vector<ExactNode> nodes;
  for (const ExactTriangle& c : elements) {
    const Vector<Rational> normal = cross(c[1] - c[0], c[2] - c[0]);
    expects(normal != Vector<Rational>{}, "an element that is not degenerate");
    for (const Barycentric<Rational>& q : functions.nodes())
      nodes.push_back({q.x[0] * c[0] + q.x[1] * c[1] + q.x[2] * c[2], primitive(normal)});
  }
  return nodes;
}

bool is_double(const Rational& x) {
  const double nearest = x.to_double();
  return std::isfinite(nearest) && Rational::exactly(nearest) == x;
}

bool is_double(const Vector<Rational>& x) { return is_double(x.x) && is_double(x.y) && is_double(x.z); }

Vector<double> in_double(const Vector<Rational>& x) {
  return {x.x.to_double(), x.y.to_double(), x.z.to_double()};
}

/// A node in the unit of length in which it is exact.
struct Node {
  Vector<double> point;
  Vector<double> normal;
};

PlaneElement prepared(const ExactTriangle& c, const Rational& scale,
                      const std::vector<PlanePolynomial<Rational>>& functions) {
  const std::vector<PolygonLoop> loops{{{0, 0}, {1, 0}, {0, 1}}};
  const Outcome<PlanePolygon> polygon =
      plane_polygon(scale * c[0], scale * (c[1] - c[0]), scale * (c[2] - c[0]), loops);
  return {polygon.value(), functions};
}

/// What all integrals of an element from one node may be off by: accuracy Int |G| max |l_j|. Int |G| is at
/// most the size of their sum and what they and the sum are off by.
double error_bound(std::span<const double> values, double largest) {
  const double accuracy = PlaneElement::usual_accuracy * upward;
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  double size = 0;
  for (const double value : values) {
    sum += value;
    size += std::abs(value);
  }
  const double integral =
      (std::abs(sum) + count * unit * size * upward) / (1 - count * accuracy * largest * upward) * upward;
  return accuracy * largest * integral * upward;
}

}  // namespace

Outcome<CertifiedEntries> certified_entries(std::span<const ExactTriangle> elements,
                                            const LagrangeFunctions& functions,
                                            std::span<const double> reflectivity) {
  expects(functions.degree() <= PlaneElement::largest_degree, "functions of degree at most 8",
          named("degree", functions.degree()));
  const std::size_t p = functions.size();
  const std::size_t n = elements.size() * p;
  expects(reflectivity.size() == n && std::all_of(reflectivity.begin(), reflectivity.end(),
                                                  [](double rho) { return std::isfinite(rho); }),
          "a finite reflectivity for every node", named("nodes", n), named("size", reflectivity.size()));
  const double largest = largest_value(functions);
  if (!(static_cast<double>(p) * largest * PlaneElement::usual_accuracy < 0.5))
    return because("the functions are too large for the bound of their integrals");

  const std::vector<ExactNode> exact = exact_nodes(elements, functions);
  Rational scale = 1;
  for (const ExactNode& node : exact) clear_denominators(scale, node.point);
  for (const ExactTriangle& element : elements)
    for (const Vector<Rational>& corner : element) clear_denominators(scale, corner);
  std::vector<Node> nodes;
  for (const ExactNode& node : exact) {
    if (!is_double(scale * node.point) || !is_double(node.normal))
      return because("there is no unit of length in which every node is a double");
    nodes.push_back({in_double(scale * node.point), in_double(node.normal)});
  }
  std::vector<PlanePolynomial<Rational>> polynomials;
  for (std::size_t j = 0; j < p; ++j) polynomials.push_back(by_monomials(functions, j));

  CertifiedEntries result{.entries = Matrix<double>::uninitialised(n, n),
                          .radius = Matrix<double>::uninitialised(n, n)};
  parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> values(p);
    for (std::size_t k = begin; k < end; ++k) {
      const PlaneElement element = prepared(elements[k], scale, polynomials);
      for (std::size_t i = 0; i < n; ++i) {
        element.integrals(nodes[i].point, nodes[i].normal, values);
        const double error = error_bound(values, largest);
        const double factor = reflectivity[i] * std::numbers::inv_pi;
        for (std::size_t j = 0; j < p; ++j) {
          const double entry = factor * values[j];
          result.entries(i, k * p + j) = entry;
          // The factor and the product are rounded, 1/pi as well: three units of the entry.
          result.radius(i, k * p + j) =
              (std::abs(factor) * error * upward + 4 * unit * std::abs(entry)) * upward + 4 * underflow;
        }
      }
    }
  });
  return result;
}

}  // namespace radcert
