// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/collocation/certified/certified_entries.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lagrange_functions.h"

namespace radcert {

inline LagrangeFunctions inset_functions(int degree, const Rational& inset) {
  return lagrange_functions(inset_nodes(degree, inset)).value();
}

/// All entries and radii, to be compared bit by bit.
inline std::vector<double> numbers_of(const CertifiedEntries& matrix) {
  std::vector<double> numbers;
  for (std::size_t j = 0; j < matrix.entries.columns(); ++j)
    for (std::size_t i = 0; i < matrix.entries.rows(); ++i) {
      numbers.push_back(matrix.entries(i, j));
      numbers.push_back(matrix.radius(i, j));
    }
  return numbers;
}

/// The linear functions and x1 x2, at nodes that are symmetric to the exchange of x2 and x3.
inline LagrangeFunctions lopsided_functions() {
  const Rational half(1, 2);
  const PolynomialSpace space{.degree = 2,
                              .functions = {{1, half, half, 0, 0, 0},
                                            {0, half, 0, 1, half, 0},
                                            {0, 0, half, 0, half, 1},
                                            {0, half, 0, 0, 0, 0}}};
  const std::vector<Barycentric<Rational>> nodes{{{Rational(5, 8), Rational(3, 16), Rational(3, 16)}},
                                                 {{Rational(3, 16), Rational(5, 8), Rational(3, 16)}},
                                                 {{Rational(3, 16), Rational(3, 16), Rational(5, 8)}},
                                                 {{Rational(1, 4), Rational(3, 8), Rational(3, 8)}}};
  return lagrange_functions(space, nodes).value();
}

}  // namespace radcert
