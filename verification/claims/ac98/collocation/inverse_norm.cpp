// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/inverse_norm.h"

#include <vector>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/solve/verified_system.h"

namespace radcert::verification::ac98 {
namespace {

// |x| for all x within the radius.
Ball size_of(double value, double radius) {
  const Ball r = Ball(Rational::exactly(radius));
  const Ball x = Ball(Rational::exactly(value));
  return abs(hull(x - r, x + r));
}

}  // namespace

CollocationNorms collocation_norms(const Surface& surface, const Triangulation& triangulation,
                                   const Rational& alpha, double reflectivity) {
  // The radii of a row sum up to this part of the reflectivity.
  constexpr double demand = 1e-5;
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(1, alpha)).value();
  const std::size_t count = 3 * triangulation.triangles.size();
  const std::vector<double> rho(count, reflectivity);
  const Outcome<CertifiedEntries> k = certified_chart_entries(surface, triangulation, functions, rho, demand);
  const Ball failed = Ball::failed("not enclosed");
  if (!k) return {failed, failed};
  CollocationNorms norms{Ball(0), Ball(0)};
  for (std::size_t i = 0; i < count; ++i) {
    Ball row(0);
    for (std::size_t j = 0; j < count; ++j) row += size_of(k->entries(i, j), k->radius(i, j));
    norms.matrix = max(norms.matrix, row);
  }
  const Outcome<VerifiedSystem> system = verified_system(k->entries, k->radius);
  if (!system) return {norms.matrix, failed};
  std::vector<Ball> rows(count, Ball(0));
  std::vector<double> unit(count, 0.0);
  for (std::size_t j = 0; j < count; ++j) {
    unit[j] = 1;
    const Outcome<VerifiedSolution> column = system->solve(unit);
    unit[j] = 0;
    if (!column) return {norms.matrix, failed};
    for (std::size_t i = 0; i < count; ++i) rows[i] += size_of(column->values[i], column->radius[i]);
  }
  for (const Ball& row : rows) norms.inverse = max(norms.inverse, row);
  return norms;
}

}  // namespace radcert::verification::ac98
