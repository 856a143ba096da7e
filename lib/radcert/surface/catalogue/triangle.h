// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/chart.h"

namespace radcert {

/// A triangle as a chart whose inner normal points to the side of a given point.
/// Maths     F(s,t) = a + s (b-a) + t (c-a) on the unit triangle
/// Source    the faces of a polyhedron
/// Requires  a, b, c not in one line; `inside` off their plane, else ContractViolation
/// Result    domain, plane and orientation of the facts are set, all exactly
Chart make_triangle(ChartFacts facts, const Vector<Rational>& a, const Vector<Rational>& b,
                    const Vector<Rational>& c, const Vector<Rational>& inside);

}  // namespace radcert
