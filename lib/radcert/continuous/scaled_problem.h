// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/continuous/reflectivity.h"

namespace radcert {

/// The data of a problem in double.
/// Maths     each E and u are 2^exponent times those that are computed with: the functions are of one size
/// Requires  at least one panel, else ContractViolation
struct ScaledProblem {
  explicit ScaledProblem(const PolyhedronProblem& problem);

  const PolyhedronProblem& exact;
  SectorScene scene;
  Reflectivity reflectivity;
  int exponent = 0;
  int degree = 0;  ///< of each E
  double gap = 0;  ///< 1 - sup rho, from below
  bool reflects = false;

  /// The emission and further ones.
  [[nodiscard]] std::size_t emissions() const { return 1 + exact.further_emissions.size(); }
  [[nodiscard]] const std::vector<PlanePolynomial<Rational>>& emission(std::size_t k) const {
    return k == 0 ? exact.emission : exact.further_emissions[k - 1];
  }
  /// The degree of q for which so many layers ask: that of E at least, as far as E + rho q stays within what
  /// rules integrate.
  [[nodiscard]] int trial_degree(int wanted) const;
};

}  // namespace radcert
