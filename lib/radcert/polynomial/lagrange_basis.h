// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// Lagrange interpolation by polynomials of degree r at any unisolvent nodes of a triangle.
/// Maths     l_j = sum_k c_kj B_k, B_k(x) = r!/(k_1! k_2! k_3!) x_1^k_1 x_2^k_2 x_3^k_3, |k| = r
/// Source    as LagrangeFunctions, whose exact nodes and coefficients are rounded once
/// Requires  0 <= degree <= 10, else ContractViolation
/// Result    values(x)[j] = l_j(x), j in the order of nodes(). In the triangle B_k >= 0 and their sum is 1:
///           the rounding error of l_j is at most about (2 r + (r + 1)(r + 2)/2) max_k |c_kj| units. The same
///           bits on every machine
/// Limits    (r + 1)(r + 2)/2 products a point and function; InsetBasis takes fewer
template <Field R>
class LagrangeBasis {
public:
  static constexpr int largest_degree = largest_basis_degree;

  explicit LagrangeBasis(const LagrangeFunctions& functions) : degree_(functions.degree()) {
    expects(degree_ <= largest_degree, "0 <= degree <= 10", named("degree", degree_));
    for (const Barycentric<Rational>& q : functions.nodes())
      nodes_.push_back({{entered(q.x[0]), entered(q.x[1]), entered(q.x[2])}});
    lattice_ = lattice_indices(degree_);
    for (std::size_t k = 0; k < lattice_.size(); ++k)
      for (std::size_t j = 0; j < size(); ++j) {
        // The multinomial number stands in the coefficient.
        const Rational& c = functions.bernstein_coefficients(j)[k];
        coefficients_.push_back(entered(c * multinomial(lattice_[k])));
      }
  }

  int degree() const { return degree_; }
  std::size_t size() const { return nodes_.size(); }
  const std::vector<Barycentric<R>>& nodes() const { return nodes_; }

  /// The values l_j(x) of all basis functions; `out` has size() places. V is R or something that R goes into:
  /// a Pack.
  template <Field V>
  void values(const Barycentric<V>& x, std::span<V> out) const {
    std::array<std::array<V, largest_degree + 1>, 3> powers;
    for (std::size_t i = 0; i < 3; ++i) {
      powers[i][0] = V(1);
      for (std::size_t m = 1; m <= static_cast<std::size_t>(degree_); ++m)
        powers[i][m] = powers[i][m - 1] * x.x[i];
    }
    for (std::size_t j = 0; j < size(); ++j) out[j] = V(0);
    for (std::size_t k = 0; k < lattice_.size(); ++k) {
      const std::array<int, 3>& index = lattice_[k];
      const V monomial = powers[0][static_cast<std::size_t>(index[0])] *
                         powers[1][static_cast<std::size_t>(index[1])] *
                         powers[2][static_cast<std::size_t>(index[2])];
      const R* const row = &coefficients_[k * size()];
      for (std::size_t j = 0; j < size(); ++j) out[j] = out[j] + V(row[j]) * monomial;
    }
  }
  void values(const Barycentric<R>& x, std::span<R> out) const { values<R>(x, out); }

private:
  static R entered(const Rational& value) {
    if constexpr (std::same_as<R, Rational>) {
      return value;
    } else {
      return from_rational<R>(value);
    }
  }
  static Rational multinomial(const std::array<int, 3>& k) {
    Rational value = 1;
    int above = 0;
    for (const int exponent : k)
      for (int m = 1; m <= exponent; ++m) value *= Rational(++above, m);
    return value;
  }

  int degree_;
  std::vector<Barycentric<R>> nodes_;
  std::vector<std::array<int, 3>> lattice_;
  std::vector<R> coefficients_;  ///< by k, then by j
};

}  // namespace radcert
