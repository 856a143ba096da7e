// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/surface/surface.h"

namespace radcert {

/// The boundary of a regular tetrahedron, whose corners are four of the cube [-1,1]^3.
/// Maths     corners (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1); edges of length 2 sqrt(2), centre 0
/// Source    two faces of it exchange 1/3: see regular_tetrahedron in closed_form/factor_catalogue.h
/// Result    pieces face_mmm, face_mpp, face_pmp, face_ppm, each named by the signs of its outer normal, and
///           opposite to the corner in the other direction
/// Limits    one size: the corners of a regular tetrahedron are rational at few others
Surface tetrahedron();

}  // namespace radcert
