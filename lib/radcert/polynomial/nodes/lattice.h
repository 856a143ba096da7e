// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// How many polynomials of two variables and degree r are linearly independent.
/// Maths     dim P_r = (r + 1)(r + 2)/2
/// Requires  0 <= degree <= 1000, else ContractViolation
/// Result    exact
inline std::size_t polynomial_dimension(int degree) {
  expects(0 <= degree && degree <= 1000, "0 <= degree <= 1000", named("degree", degree));
  const auto r = static_cast<std::size_t>(degree);
  return (r + 1) * (r + 2) / 2;
}

/// The degree whose space has that dimension: 0 for 1, 1 for 3, 2 for 6, ...; nothing for a number in
/// between.
inline std::optional<int> degree_of_dimension(std::size_t dimension) {
  for (int degree = 0; degree <= 1000 && polynomial_dimension(degree) <= dimension; ++degree)
    if (polynomial_dimension(degree) == dimension) return degree;
  return std::nullopt;
}

/// The multi-indices of the principal lattice, and of the Bernstein polynomials.
/// Maths     k = (k_1, k_2, k_3) >= 0, k_1 + k_2 + k_3 = r
/// Source    the order is that of [ac98, (33)] for r = 1
/// Requires  as polynomial_dimension
/// Result    k_1 falling, then k_2 falling; k stands at the place m (m + 1)/2 + k_3, m = k_2 + k_3
inline std::vector<std::array<int, 3>> lattice_indices(int degree) {
  std::vector<std::array<int, 3>> indices;
  indices.reserve(polynomial_dimension(degree));
  for (int k1 = degree; k1 >= 0; --k1)
    for (int k2 = degree - k1; k2 >= 0; --k2) indices.push_back({k1, k2, degree - k1 - k2});
  return indices;
}

/// The place of a multi-index in lattice_indices.
inline std::size_t lattice_place(const std::array<int, 3>& k) {
  const auto m = static_cast<std::size_t>(k[1] + k[2]);
  return m * (m + 1) / 2 + static_cast<std::size_t>(k[2]);
}

/// The principal lattice of a triangle pulled in from its sides, for any degree.
/// Maths     q = inset + (1 - 3 inset) k/r;  r = 0: the centroid
/// Source    [m06, (13)]; r = 0: [ac98, (38)]
/// Requires  0 <= inset < 1/3 unless degree = 0, degree as polynomial_dimension, else ContractViolation
/// Result    in the order of lattice_indices; the nodes of InsetBasis, whose degree is bounded
/// Limits    degree 0 does not use the inset
template <Field R>
std::vector<Barycentric<R>> inset_nodes(int degree, const R& inset) {
  std::vector<Barycentric<R>> nodes;
  nodes.reserve(polynomial_dimension(degree));
  if (degree == 0) {
    const R third = R(1) / R(3);
    nodes.push_back({{third, third, third}});
    return nodes;
  }
  expects(!certainly_negative(inset) && certainly_less(R(3) * inset, R(1)), "0 <= inset < 1/3",
          named("inset", inset));
  for (const std::array<int, 3>& k : lattice_indices(degree)) {
    Barycentric<R> q;
    for (std::size_t i = 0; i < 3; ++i) q.x[i] = inset + (R(1) - R(3) * inset) * (R(k[i]) / R(degree));
    nodes.push_back(q);
  }
  return nodes;
}

}  // namespace radcert
