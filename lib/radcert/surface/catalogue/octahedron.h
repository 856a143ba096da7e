// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"

namespace radcert {

/// The boundary of the regular octahedron.
/// Maths     |x| + |y| + |z| = 1
/// Result    pieces face_ppp, face_mpp, ..., face_mmm, each named by the signs of its coordinates, in the
///           order of the sphere's octants
Surface octahedron();

}  // namespace radcert
