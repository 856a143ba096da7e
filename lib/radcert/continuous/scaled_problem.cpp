// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/scaled_problem.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/upward.h"
#include "radcert/core/contract.h"

namespace radcert {

ScaledProblem::ScaledProblem(const PolyhedronProblem& problem)
    : exact(problem), scene(problem.panels, problem.blockers), reflectivity(problem.reflectivity) {
  Rational sup = 0;
  for (const PanelReflectivity& rho : problem.reflectivity) sup = std::max(sup, rho.largest);
  gap = (Rational(1) - sup).to_double() / upward;
  expects(gap > 0, "rho < 1");
  reflects = sup.sign() > 0;
  for (std::size_t k = 0; k < emissions(); ++k)
    for (const PlanePolynomial<Rational>& f : emission(k)) degree = std::max(degree, f.degree());
  const std::vector<SectorElement> whole = graded_elements(scene, 1);
  double largest = 0;
  for (std::size_t k = 0; k < emissions(); ++k) {
    const SectorFunctions f = plane_functions(emission(k), scene, whole, 1, degree, 0);
    for (std::size_t e = 0; e < whole.size(); ++e) largest = std::max(largest, size_around(f, e, 1, 1));
  }
  if (largest > 0) std::frexp(largest, &exponent);
}

int ScaledProblem::trial_degree(int wanted) const {
  return std::min(std::max(wanted, degree), most_gauss_nodes - 1 - reflectivity.degree());
}

}  // namespace radcert
