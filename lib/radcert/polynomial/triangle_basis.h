// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lagrange_basis.h"

namespace radcert {

/// The type of all bases in the collocation pipeline.
/// Maths     nodes q_j and functions l_j of degree r on the reference triangle, l_j(q_i) = delta_ij
/// Source    [m06, (13)-(15)]
/// Requires  made of an InsetBasis, which keeps its product formula, or of exact Lagrange functions
/// Result    as the basis that it was made of, to the bit
/// Limits    degrees 0 to 10
template <Field R>
class TriangleBasis {
public:
  TriangleBasis(InsetBasis<R> basis)  // NOLINT(google-explicit-constructor): the same functions
      : basis_(std::move(basis)) {}
  explicit TriangleBasis(LagrangeBasis<R> basis) : basis_(std::move(basis)) {}

  int degree() const {
    return std::visit([](const auto& basis) { return basis.degree(); }, basis_);
  }
  std::size_t size() const {
    return std::visit([](const auto& basis) { return basis.size(); }, basis_);
  }
  /// The nodes q_j.
  std::vector<Barycentric<R>> nodes() const {
    return std::visit([](const auto& basis) -> std::vector<Barycentric<R>> { return basis.nodes(); }, basis_);
  }
  /// The values l_j(x) of all basis functions; `out` has size() places. V is R or something that R goes into:
  /// a Pack.
  template <Field V>
  void values(const Barycentric<V>& x, std::span<V> out) const {
    if (const auto* inset = std::get_if<InsetBasis<R>>(&basis_)) {
      inset->template values<V>(x, out);
    } else {
      std::get_if<LagrangeBasis<R>>(&basis_)->template values<V>(x, out);
    }
  }
  void values(const Barycentric<R>& x, std::span<R> out) const { values<R>(x, out); }

private:
  std::variant<InsetBasis<R>, LagrangeBasis<R>> basis_;
};

/// The basis of exact Lagrange functions, in the arithmetic of the pipeline.
/// Maths     nodes and Bernstein coefficients, rounded once
/// Requires  0 <= degree <= 10, else ContractViolation
/// Result    see LagrangeBasis
template <Field R>
TriangleBasis<R> make_triangle_basis(const LagrangeFunctions& functions) {
  return TriangleBasis<R>(LagrangeBasis<R>(functions));
}

}  // namespace radcert
