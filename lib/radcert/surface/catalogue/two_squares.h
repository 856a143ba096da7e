// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"

namespace radcert {

/// Two unit squares that meet at a right angle along an edge.
/// Maths     S_xz = {(x,0,z)}, S_xy = {(x,y,0)}, 0 <= x, y, z <= 1; inner normals +y and +z
/// Source    [ac98, (20)]
/// Result    pieces `xz` and `xy`
/// Limits    not closed
Surface two_squares();

}  // namespace radcert
