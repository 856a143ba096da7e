// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/orbit_structure.h"

#include "radcert/core/contract.h"

namespace radcert {

int invariant_count(int degree) {
  int count = 0;
  for (int three = 0; 3 * three <= degree; ++three) count += (degree - 3 * three) / 2 + 1;
  return count;
}

OrbitStructure orbit_structure(int degree) {
  expects(degree >= 0, "degree >= 0", named("degree", degree));
  const int ones = degree % 3 == 0 ? 1 : 0;
  const int threes = degree / 2 + 1 - ones;
  return {.ones = ones, .threes = threes, .sixes = ((degree + 1) * (degree + 2) / 2 - ones - 3 * threes) / 6};
}

int largest_regular_precision(int degree) {
  const OrbitStructure structure = orbit_structure(degree);
  const int numbers = structure.orbits() + structure.coordinates();
  int precision = degree;
  while (invariant_count(precision + 1) <= numbers) ++precision;
  return precision;
}

}  // namespace radcert
