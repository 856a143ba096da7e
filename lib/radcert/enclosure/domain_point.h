// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/chart.h"

namespace radcert {

/// A chart's domain as the image of the unit square, for functions whose largest or smallest value over it is
/// wanted.
/// Maths     (a, b) on a square; (a (1 - b), a b) on a triangle: onto, and one-to-one but for a = 0
/// Source    Duffy's map
/// Requires  0 <= a, b <= 1
/// Result    a point of the domain, as the arithmetic T rounds; four coordinates give a pair of points of two
///           domains
/// Limits    for balls somewhat more than the domain
template <Field T>
[[nodiscard]] ParameterPoint<T> domain_point(ChartDomain domain, const T& a, const T& b) {
  if (domain == ChartDomain::unit_square) return {a, b};
  return {a * (T(1) - b), a * b};
}

}  // namespace radcert
