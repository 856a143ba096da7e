// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"

namespace radcert {

/// The boundary of a circular cylinder: the truncated cone whose ends are equal, under its own name.
/// Maths     x^2 + y^2 <= radius^2,  0 <= z <= height
/// Requires  radius, height > 0, else ContractViolation
/// Result    pieces floor, ceiling and mantle, four charts each
Surface cylinder(const Rational& radius, const Rational& height);

}  // namespace radcert
