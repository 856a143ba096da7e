// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// What encloses means, or values at points, as something that can be checked again.
/// Maths     the claims on an element are those that the search has proved, wider: norms by a tenth and a
///           part of the whole norm that is the same on all elements, at least a tenth of what the width has
///           room for beside the other norm; radii of products by a twelfth of the wanted radius in all, half
///           of it at the edges. So they hold by more than a checker's bounds are generous. Then all of them
///           are rounded to a few decimals, bounds upwards, products within their radii
/// Requires  means or values of this problem, pieces by their names; the proof of enclose_means or
///           enclose_values, none where nothing reflects that the numbers depend on
/// Result    sums and means are those of certificate::summed, the width twice the largest radius
[[nodiscard]] certificate::PolyhedronCertificate polyhedron_certificate(
    const PolyhedronProblem& problem, const std::vector<std::string>& pieces, const GoalProof* proof,
    const std::vector<SolutionPoint>& points = {});

/// What encloses the solution itself, as something that can be checked again.
/// Maths     claims of residuals are the largest of all elements that are as far from the vertices, wider by
///           a fifth and a twentieth of what the width has room for: bounds follow from those anyhow, and a
///           checker need not look closer. Bounds at the search's distances and at `outside`, by
///           certificate::bounds_by_distance
/// Requires  a proof of enclose_function of this problem; 0 <= outside
/// Result    `outside` is 0 there where the bound everywhere is within half the wanted width
[[nodiscard]] certificate::PolyhedronCertificate polyhedron_certificate(
    const PolyhedronProblem& problem, const std::vector<std::string>& pieces, const FunctionProof& proof,
    const Rational& wanted, const Rational& outside);

}  // namespace radcert
