// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"

namespace radcert {

/// B_k(q_j), rows by node.
[[nodiscard]] Matrix<Ball> bernstein_matrix(int degree, const std::vector<Barycentric<Ball>>& nodes);

/// A determinant, by elimination.
/// Requires  as many rows as columns
/// Result    enclosed; a failed ball where a pivot may vanish
[[nodiscard]] Ball determinant_of(Matrix<Ball> a);

/// How far a rule is exact that is known to be up to `degree`: that it is not beyond.
/// Requires  a rule that is exact up to `degree`
/// Result    EnclosedPrecision, or a reason where no monomial of the next degree is certainly missed
[[nodiscard]] Outcome<EnclosedPrecision> ends_at(const TriangleRule<Ball>& rule, Region region, int degree);

}  // namespace radcert
