// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <span>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {

/// A type with nodes and functions that can be asked in exact arithmetic.
template <class Basis>
concept ExactBasis = requires(const Basis& basis, const Barycentric<Rational>& x, std::span<Rational> out) {
  { basis.degree() } -> std::convertible_to<int>;
  { basis.size() } -> std::convertible_to<std::size_t>;
  { basis.nodes() } -> std::convertible_to<std::vector<Barycentric<Rational>>>;
  basis.values(x, out);
};

/// A basis of one's own, a C++ type, as the Lagrange functions that problems, facts and certificates are made
/// of.
/// Maths     l_j in P_D, D = degree(), by its values at the principal lattice of degree D
/// Requires  functions that are polynomials of degree D at most, seen at the lattice of degree D + 1;
///           l_j(q_i) = delta_ij; else ContractViolation. The law is_a_lagrange_basis of
///           tests/laws/basis_laws.h says which law is broken, where and by how much
/// Result    the same functions, exactly
/// Limits    asks for values at (D + 1)(D + 2)/2 + (D + 2)(D + 3)/2 points
template <ExactBasis Basis>
[[nodiscard]] LagrangeFunctions lagrange_functions_of(const Basis& basis) {
  const int degree = basis.degree();
  const std::vector<Barycentric<Rational>> nodes = basis.nodes();
  expects(nodes.size() == basis.size(), "a function for each node", named("nodes", nodes.size()),
          named("functions", basis.size()));
  const auto values = [&basis](const Barycentric<Rational>& x) {
    std::vector<Rational> out(basis.size());
    basis.values(x, std::span<Rational>(out));
    return out;
  };
  const std::vector<Barycentric<Rational>> lattice = inset_nodes(degree, Rational(0));
  const LagrangeFunctions on_lattice = lagrange_functions(lattice).value();
  PolynomialSpace space{.degree = degree, .functions = {}};
  space.functions.assign(basis.size(), std::vector<Rational>(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const std::vector<Rational> at_point = values(lattice[i]);
    const std::span<const Rational> c = on_lattice.bernstein_coefficients(i);
    for (std::size_t j = 0; j < basis.size(); ++j)
      for (std::size_t k = 0; k < lattice.size(); ++k) space.functions[j][k] += at_point[j] * c[k];
  }
  Outcome<LagrangeFunctions, NotUnisolvent> functions = lagrange_functions(space, nodes);
  expects(functions.has_value(), "functions that the nodes determine");
  std::vector<Rational> again(basis.size());
  for (const Barycentric<Rational>& x : inset_nodes(degree + 1, Rational(0))) {
    functions->values(x, again);
    expects(again == values(x),
            "polynomials of the degree that the basis says, each 1 at its node and 0 at the others",
            named("degree", degree));
  }
  return *std::move(functions);
}

}  // namespace radcert
