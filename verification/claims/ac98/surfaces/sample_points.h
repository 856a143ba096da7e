// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// A point of the unit sphere with rational coordinates.
/// Maths     (2u, 2v, 1 - u^2 - v^2)/(1 + u^2 + v^2)
/// Source    stereographic projection from (0,0,-1)
/// Result    exact
[[nodiscard]] Vector<Rational> sphere_point(const Rational& u, const Rational& v);

}  // namespace radcert::verification::ac98
