// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/method.h"

#include "radcert/core/contract.h"

namespace radcert {

const TriangleBasisChoice* find_triangle_basis(const Method& method) {
  const auto* collocation = std::get_if<Collocation>(&method);
  return collocation != nullptr ? &collocation->basis : nullptr;
}

const TriangleBasisChoice& triangle_basis_of(const Method& method) {
  const TriangleBasisChoice* basis = find_triangle_basis(method);
  expects(basis != nullptr, "a method with a basis on triangles");
  return *basis;
}

std::optional<int> find_degree(const Method& method) {
  if (const auto* galerkin = std::get_if<Galerkin>(&method)) return galerkin->degree;
  const TriangleBasisChoice* basis = find_triangle_basis(method);
  return basis != nullptr ? std::optional(basis->degree) : std::nullopt;
}

TriangleBasisChoice& triangle_basis_of(Method& method) {
  return const_cast<TriangleBasisChoice&>(triangle_basis_of(static_cast<const Method&>(method)));
}

}  // namespace radcert
