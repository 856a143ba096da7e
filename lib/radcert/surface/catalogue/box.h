// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"

namespace radcert {

/// The boundary of a rectangular solid.
/// Maths     the boundary of [0,a] x [0,b] x [0,c]; the face normal to axis i has the axes i+1, i+2 (mod 3)
///           as its parameters in that order, and the face with x_i = 0 is cut along the other diagonal than
///           its opposite
/// Source    [ac98, section 2.2]; the cut was recovered from the digits of [ac98, Tables 4 and 5]
/// Requires  a, b, c > 0, else ContractViolation
/// Result    pieces west, east (x = 0, a), south, north (y = 0, b), floor, ceiling (z = 0, c)
Surface box(const Rational& a, const Rational& b, const Rational& c);

/// The boundary of the unit cube: the box with a = b = c = 1, under its own name.
Surface cube();

}  // namespace radcert
