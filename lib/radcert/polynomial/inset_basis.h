// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {

/// Lagrange interpolation of degree r at the principal lattice of a triangle pulled in from its sides.
/// Maths     nodes  q = inset + (1 - 3 inset) k/r,  k = (k_1,k_2,k_3) >= 0, |k| = r, in barycentric
///           coordinates; with y = (x - inset)/(1 - 3 inset):  l_k(x) = prod_i prod_{a < k_i} (r y_i -
///           a)/(k_i - a);  l_k(q_m) = delta_km
/// Source    [m06, (13)-(15)]; r = 1: [ac98, (33)-(34)]; r = 0, the centroid: [ac98, (38)]; the product form
///           is Silvester's
/// Requires  0 <= degree <= 10, 0 <= inset < 1/3, else ContractViolation; degree 0 does not use the inset
/// Result    values(x)[j] = l_j(x), j in the order of nodes(): k_1 falling, then k_2 falling, so that degree
///           1 has the order of [ac98, (33)]; two roundings a factor
/// Limits    interpolants jump across triangle edges unless inset = 0
template <Field R>
class InsetBasis {
public:
  static constexpr int largest_degree = largest_basis_degree;

  InsetBasis(int degree, const R& inset)
      : degree_(degree), inset_(degree == 0 ? R(0) : inset), scale_(R(degree) / (R(1) - R(3) * inset_)) {
    expects(0 <= degree && degree <= largest_degree, "0 <= degree <= 10", named("degree", degree));
    expects(!certainly_negative(inset_) && certainly_less(R(3) * inset_, R(1)), "0 <= inset < 1/3",
            named("inset", inset_));
    lattice_ = lattice_indices(degree);
  }

  int degree() const { return degree_; }
  const R& inset() const { return inset_; }
  std::size_t size() const { return lattice_.size(); }

  /// The nodes q_j.
  std::vector<Barycentric<R>> nodes() const { return inset_nodes(degree_, inset_); }

  /// The values l_j(x) of all basis functions; `out` has size() places. V is R or something that R goes into:
  /// a Pack.
  template <Field V>
  void values(const Barycentric<V>& x, std::span<V> out) const {
    std::array<std::array<V, largest_degree + 1>, 3>
        factors;  // factors[i][m] = prod_{a < m} (r y_i - a)/(m - a)
    for (std::size_t i = 0; i < 3; ++i) {
      const V scaled = V(scale_) * (x.x[i] - V(inset_));
      factors[i][0] = V(1);
      for (int m = 1; m <= degree_; ++m) {
        const V factor = m == 1 ? scaled : (scaled - V(m - 1)) * V(R(1) / R(m));
        factors[i][static_cast<std::size_t>(m)] = factors[i][static_cast<std::size_t>(m - 1)] * factor;
      }
    }
    for (std::size_t j = 0; j < lattice_.size(); ++j) {
      const std::array<int, 3>& k = lattice_[j];
      out[j] = factors[0][static_cast<std::size_t>(k[0])] * factors[1][static_cast<std::size_t>(k[1])] *
               factors[2][static_cast<std::size_t>(k[2])];
    }
  }
  void values(const Barycentric<R>& x, std::span<R> out) const { values<R>(x, out); }

private:
  int degree_;
  R inset_;
  R scale_;  ///< degree / (1 - 3 inset)
  std::vector<std::array<int, 3>> lattice_;
};

}  // namespace radcert
