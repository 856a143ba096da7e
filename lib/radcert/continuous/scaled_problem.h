// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/polyhedron_problem.h"

namespace radcert {

/// The data of a problem in double.
/// Maths     E and u are 2^exponent times those that are computed with: all functions are of one size
/// Requires  at least one panel, else ContractViolation
struct ScaledProblem {
  explicit ScaledProblem(const PolyhedronProblem& problem);

  const PolyhedronProblem& exact;
  SectorScene scene;
  std::vector<double> reflectivity;  ///< by panel
  int exponent = 0;
  int degree = 0;  ///< of E
  double gap = 0;  ///< 1 - max rho, from below
  bool reflects = false;
};

}  // namespace radcert
