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

}  // namespace radcert
