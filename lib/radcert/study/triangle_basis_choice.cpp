// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/triangle_basis_choice.h"

#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {

std::size_t function_count(const TriangleBasisChoice& basis) {
  return basis.functions ? basis.functions->size() : polynomial_dimension(basis.degree);
}

TriangleBasis<double> triangle_basis(const TriangleBasisChoice& basis) {
  if (basis.functions) return make_triangle_basis<double>(*basis.functions);
  return InsetBasis<double>(basis.degree, basis.alpha.value_or(Rational(0)).to_double());
}

LagrangeFunctions exact_functions(const TriangleBasisChoice& basis) {
  if (basis.functions) return *basis.functions;
  return lagrange_functions(inset_nodes(basis.degree, basis.alpha.value_or(Rational(0)))).value();
}

}  // namespace radcert
