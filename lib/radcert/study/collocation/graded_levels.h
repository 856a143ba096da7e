// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/study/problem.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The levels of a graded problem whose vertices are not all those of the grading, but these rounded to
/// double. What is proved at them is about the rounded ones.
/// Source    grading_in_double
[[nodiscard]] std::vector<int> rounded_levels(const Problem& problem, const Surface& surface);

/// InputError where double does not know the layers of elements at a level: a proof would be about another
/// triangulation.
/// Source    grading_in_double
void require_known_layers(const Problem& problem, const Surface& surface, int level);

/// What is to be said of a level of the problem whose layers double does not know, in words; else nothing.
/// Source    grading_in_double
[[nodiscard]] std::vector<std::string> grading_remarks(const Problem& problem, const Surface& surface);

}  // namespace radcert
