// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// On which side of a plane a point lies.
/// Maths     sign of det(b - a, c - a, d - a): positive where the triangle a, b, c runs counterclockwise as
///           seen from d
/// Source    CGAL, exact predicates behind floating-point filters
/// Requires  finite coordinates
/// Result    -1, 0 or 1, exact for these doubles
[[nodiscard]] int orientation(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c,
                              const Vector<double>& d);

/// Which way three points of a plane turn.
/// Maths     sign of det(b - a, c - a): positive for a left turn
/// Source    CGAL, exact predicates behind floating-point filters
/// Requires  finite coordinates
/// Result    -1, 0 or 1, exact for these doubles
[[nodiscard]] int orientation(const ParameterPoint<double>& a, const ParameterPoint<double>& b,
                              const ParameterPoint<double>& c);

/// Whether three points of space lie on one line, equal points included; exact.
[[nodiscard]] bool collinear(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c);

/// The same point with exact coordinates.
[[nodiscard]] Vector<Rational> exactly(const Vector<double>& point);

}  // namespace radcert
