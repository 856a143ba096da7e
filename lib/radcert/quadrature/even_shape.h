// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// How unevenly a chart changes along a line of parameters, as far as three points tell: only where it does
/// so evenly does the agreement of two rules mean that they converge. A layer that both miss, such as that of
/// z = 2 - s^1000 at s = 1, comes near 1/2.
/// Maths     |N_m - (N_a + N_b)/2| / max |N|,  N = D_s F x D_t F at the ends a, b and in the middle m
/// Source    ours. Where N changes monotonically from a to b it changes between a and m or between m and b: a
///           layer in one half leaves N_m at one of the ends, half of the change off their mean. G J is a
///           formula in F and N, of which N varies the faster one
/// Result    0 or more; 0 where an N is not finite: singular lines have rules of their own
/// Limits    what turns back between the three points is not seen; no chart of the catalogue does
template <Real R>
R unevenness(const Vector<R>& a, const Vector<R>& m, const Vector<R>& b) {
  const R largest = std::max({norm(a), norm(m), norm(b)});
  const R off = norm(m - (R(1) / R(2)) * (a + b));
  return off > R(0) ? R(off / largest) : R(0);
}

/// How the normal of a chart changes over a cell, as its corners and the middles of its sides tell it.
/// Maths     turn = max |N - N'| / max |N|;  unevenness, the largest along a side
struct ElementShape {
  double turn = 0;
  double unevenness = 0;
};

/// From here on the parts of an element are looked at before rules on them are compared, rules are compared
/// at a greater distance, and the element is halved: the second as soon as convergence may be slow, the third
/// where it may not have begun.
inline constexpr double uneven_for_few_points = 0.05;
inline constexpr double uneven_for_close_rules = 0.2;
inline constexpr double uneven_for_any_rule = 0.45;

}  // namespace radcert
