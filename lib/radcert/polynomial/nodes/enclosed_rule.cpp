// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/enclosed_rule.h"

#include <array>
#include <string>

#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/symmetric_system.h"
#include "radcert/scalar/real.h"

namespace radcert {
namespace {

Ball defect(const TriangleRule<Ball>& rule, Region region, const Monomial& monomial) {
  // The empty rule misses the integral itself.
  Ball sum(radcert::defect(TriangleRule<Rational>{}, region, monomial));
  for (std::size_t j = 0; j < rule.points.size(); ++j) {
    const Ball& s = rule.points[j].x[2];
    const Ball& t = rule.points[j].x[1];
    Ball value = power(s, monomial.s) * power(t, monomial.t);
    if (region == Region::parallelogram)
      value += power(Ball(1) - s, monomial.s) * power(Ball(1) - t, monomial.t);
    sum += rule.weights[j] * value;
  }
  return sum;
}

}  // namespace

Matrix<Ball> bernstein_matrix(int degree, const std::vector<Barycentric<Ball>>& nodes) {
  const std::vector<std::array<int, 3>> indices = lattice_indices(degree);
  Matrix<Ball> a(nodes.size(), indices.size());
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const auto& [k1, k2, k3] = indices[k];
      a(j, k) = Ball(factorial(degree) / (factorial(k1) * factorial(k2) * factorial(k3))) *
                power(nodes[j].x[0], k1) * power(nodes[j].x[1], k2) * power(nodes[j].x[2], k3);
    }
  return a;
}

Ball determinant_of(Matrix<Ball> a) {
  Ball determinant(1);
  for (std::size_t p = 0; p < a.rows(); ++p) {
    const std::size_t row = pivot_row(a, p);
    exchange_rows(a, p, row);
    if (row != p) determinant = -determinant;
    determinant *= a(p, p);
    for (std::size_t i = p + 1; i < a.rows(); ++i) {
      const Ball factor = a(i, p) / a(p, p);
      for (std::size_t j = p + 1; j < a.columns(); ++j) a(i, j) -= factor * a(p, j);
    }
  }
  return determinant;
}

Outcome<EnclosedPrecision> ends_at(const TriangleRule<Ball>& rule, Region region, int degree) {
  for (int t = 0; t <= degree + 1; ++t) {
    const Monomial monomial{degree + 1 - t, t};
    const Ball missed = defect(rule, region, monomial);
    if (!missed.contains_zero())
      return EnclosedPrecision{.degree = degree, .first_failure = monomial, .defect = missed};
  }
  return because("no monomial of degree " + std::to_string(degree + 1) + " is certainly missed");
}

}  // namespace radcert
