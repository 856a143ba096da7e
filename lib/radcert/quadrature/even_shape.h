// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// Whether a chart changes evenly along a line of parameters, as far as three points tell: only then does the agreement of two rules on it
/// mean that they converge. A layer that both miss, such as that of z = 2 - s^1000 at s = 1, does not pass.
/// Maths     N = D_s F x D_t F at the ends a, b and in the middle m:  |N_m - (N_a + N_b)/2| <= 0.3 max |N|
/// Source    ours. Where N changes monotonically from a to b it changes between a and m or between m and b: a layer in one half leaves N_m
///           at one of the ends, half of the change off their mean. G J is a formula in F and N, of which N varies the faster one
/// Requires  -
/// Result    true where an N is not finite: singular lines have rules of their own
/// Limits    what turns back between the three points is not seen; no chart of the catalogue does
template <Real R>
bool is_even(const Vector<R>& a, const Vector<R>& m, const Vector<R>& b) {
  const R largest = std::max({norm(a), norm(m), norm(b)});
  const R off = norm(m - (R(1) / R(2)) * (a + b));
  return !(off > R(3) / R(10) * largest);
}

}  // namespace radcert
