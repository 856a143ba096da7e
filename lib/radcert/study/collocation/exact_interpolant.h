// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/study/collocation/level_geometry.h"

namespace radcert {

/// Whether an interpolated surface is the interpolant of the exact surface, its numbers not being rounded.
/// Maths     m~_k(a/r, b/r) = m_k(a/r, b/r) for every point of the lattice of every element
/// Source    [ac98, section 4.1]; exact images of charts against polynomials in balls
/// Requires  integrals as LevelGeometry makes it from data, by polynomials of this degree
/// Result    proved; refused with the element's chart where the two differ or are not known exactly: charts
///           that are no polynomials with rational coefficients
[[nodiscard]] Outcome<void> is_exact_interpolant(const NodedSurface& data, const NodedSurface& integrals,
                                                 int degree);

}  // namespace radcert
