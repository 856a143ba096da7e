// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/neumann.h"

namespace radcert {

Outcome<IterativeSolution, NotReached> solve_by_neumann(const Matrix<double>& k,
                                                        const Contraction& contraction,
                                                        std::span<const double> e,
                                                        std::optional<double> tolerance) {
  const auto residual_itself = [](std::span<double>, double) { return std::size_t{1}; };
  return iterate(k, contraction, e, tolerance, {.apply = residual_itself});
}

}  // namespace radcert
