// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified_chart_entries.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "radcert/collocation/certified_kernel_sums.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/polynomial/lattice.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr int largest_degree = 8;

/// l_j by Bernstein polynomials.
class LagrangeOnElements final : public ElementFunctions {
public:
  explicit LagrangeOnElements(const LagrangeFunctions& functions)
      : functions_(functions), indices_(lattice_indices(functions.degree())) {
    const auto factorial = [](int n) {
      Rational product = 1;
      for (int i = 2; i <= n; ++i) product *= Rational(i);
      return product;
    };
    Rational largest = 0;
    for (std::size_t j = 0; j < functions.size(); ++j) {
      const std::span<const Rational> c = functions.bernstein_coefficients(j);
      for (std::size_t k = 0; k < indices_.size(); ++k) {
        const auto [k1, k2, k3] = indices_[k];
        const Rational multinomial =
            factorial(functions.degree()) / (factorial(k1) * factorial(k2) * factorial(k3));
        coefficients_.push_back(Ball(c[k] * multinomial));
        largest = std::max(largest, abs(c[k]));
      }
    }
    largest_ = largest.to_double() * (1 + 4 * unit);
  }

  std::size_t size() const override { return functions_.size(); }

  void values(const ElementPoint<Ball>& at, std::span<Ball> out) const override {
    std::array<std::array<Ball, largest_degree + 1>, 3> powers;
    for (std::size_t i = 0; i < 3; ++i) {
      powers[i][0] = Ball(1);
      for (int k = 1; k <= functions_.degree(); ++k) {
        const auto place = static_cast<std::size_t>(k);
        powers[i][place] = powers[i][place - 1] * at.in_element.x[i];
      }
    }
    for (Ball& value : out) value = Ball(0);
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      const auto [k1, k2, k3] = indices_[k];
      const Ball monomial = powers[0][static_cast<std::size_t>(k1)] *
                            powers[1][static_cast<std::size_t>(k2)] * powers[2][static_cast<std::size_t>(k3)];
      for (std::size_t j = 0; j < size(); ++j)
        out[j] = fma(coefficients_[j * indices_.size() + k], monomial, out[j]);
    }
  }

  /// |l_j| <= max |c_k| sum_k multinomial |x_1|^k_1 |x_2|^k_2 |x_3|^k_3 = max |c_k| (|x_1| + |x_2| + |x_3|)^r.
  double bound(const ElementPoint<TaylorModel>& at) const override {
    double sum = 0;
    for (const TaylorModel& x : at.in_element.x) sum += x.magnitude_bound();
    double product = largest_;
    for (int k = 0; k < functions_.degree(); ++k) product *= sum * (1 + 4 * unit);
    return product * (1 + 32 * unit);
  }

private:
  const LagrangeFunctions& functions_;
  std::vector<std::array<int, 3>> indices_;
  std::vector<Ball> coefficients_;  ///< of the monomials, for each j in turn
  double largest_ = 0;
};

}  // namespace

std::vector<SurfacePoint<Rational>> exact_collocation_nodes(const Triangulation& triangulation,
                                                            const LagrangeFunctions& functions) {
  std::vector<SurfacePoint<Rational>> nodes;
  nodes.reserve(triangulation.triangles.size() * functions.size());
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    std::array<ParameterPoint<Rational>, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = {Rational::exactly(triangle.vertices[i].s), Rational::exactly(triangle.vertices[i].t)};
    for (const Barycentric<Rational>& q : functions.nodes())
      nodes.push_back({triangle.chart, q.x[0] * v[0] + q.x[1] * v[1] + q.x[2] * v[2]});
  }
  return nodes;
}

Outcome<CertifiedEntries> certified_chart_entries(const Surface& surface, const Triangulation& triangulation,
                                                  const LagrangeFunctions& functions,
                                                  std::span<const double> reflectivity, double demand) {
  expects(functions.degree() <= largest_degree, "functions of degree at most 8",
          named("degree", functions.degree()));
  const std::size_t p = functions.size();
  const std::size_t n = triangulation.triangles.size() * p;
  expects(reflectivity.size() == n && std::all_of(reflectivity.begin(), reflectivity.end(),
                                                  [](double rho) { return std::isfinite(rho); }),
          "a finite reflectivity for every node", named("nodes", n), named("size", reflectivity.size()));
  const LagrangeOnElements on_elements(functions);
  const std::vector<SurfacePoint<Rational>> nodes = exact_collocation_nodes(triangulation, functions);
  const CertifiedKernelSums sums(surface, triangulation, on_elements, nodes, demand);

  CertifiedEntries result{.entries = Matrix<double>::uninitialised(n, n),
                          .radius = Matrix<double>::uninitialised(n, n)};
  std::vector<std::string> refusals(triangulation.triangles.size());
  parallel_for(triangulation.triangles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::span<double> values(&result.entries(0, k * p), n * p);
      const std::span<double> radius(&result.radius(0, k * p), n * p);
      refusals[k] = sums.element(k, values, radius);
      if (!refusals[k].empty()) continue;
      for (std::size_t j = 0; j < p; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          const double factor = reflectivity[i] * std::numbers::inv_pi;
          double& value = values[j * n + i];
          double& r = radius[j * n + i];
          const bool vanishes = factor == 0 || (value == 0 && r == 0);
          value *= factor;
          // The factor and the product are rounded, 1/pi as well: three units of the entry. Zeros are exact.
          r = vanishes
                  ? 0
                  : (std::abs(factor) * r * (1 + 8 * unit) + 4 * unit * std::abs(value)) * (1 + 8 * unit) +
                        4 * std::numeric_limits<double>::denorm_min();
        }
    }
  });
  for (std::string& refusal : refusals)
    if (!refusal.empty()) return because(std::move(refusal));

  std::vector<double> rows(n, 0.0);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) rows[i] += result.radius(i, j);
  for (std::size_t i = 0; i < n; ++i) {
    const double reached = rows[i] * (1 + 2 * static_cast<double>(n) * unit);
    if (!(reached <= demand * std::abs(reflectivity[i])))
      return because("the radii of a row sum to " + shortest(reached) + ", more than the " +
                     shortest(demand * std::abs(reflectivity[i])) +
                     " demanded: roundings in double are wider");
  }
  return result;
}

}  // namespace radcert
