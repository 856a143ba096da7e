// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "radcert/scalar/rational.h"
#include "radcert/study/study.h"
#include "verification/framework/check.h"
#include "verification/framework/observed_order.h"

namespace radcert::verification {

/// Levels of a problem with more unknowns than a matrix has room for.
struct FineStudy {
  Problem problem;
  int first = 0;
  int last = 0;
  Rational tolerance;  ///< of the operator of clusters at the first level
  int order = 0;       ///< by which errors are expected to fall
};

/// The tolerance of the operator of clusters at a level.
/// Maths     the largest power of ten that is at most tolerance 2^(-order (level - first)), but not less than
///           what the operator allows: the radius of a row falls as the errors are expected to
/// Requires  first <= level, tolerance > 0
[[nodiscard]] Rational tolerance_at(const FineStudy& study, int level);

/// A number of a level that is told from level to level, and what it is called.
struct LevelFigure {
  std::string name;
  std::function<Approximation(const LevelOutcome& level)> of;
};

/// max |u - u_n| and max |K(I - P_n)u| over the nodes, with their radii.
[[nodiscard]] LevelFigure node_error_figure();
[[nodiscard]] LevelFigure discretisation_error_figure();

/// Figures of the levels of a study.
/// Maths     h = 2^(1/2) 2^-level
/// Requires  a problem that the operator `auto` serves; figures of different names, found in each level
/// Result    for each figure its values, which are kept; the values at the nodes are not, as there are too
///           many. One level at a time is computed, whichever checks run beside each other. Radii are those
///           of the level: the operator's radius is part of them
/// Limits    InputError where a level does not fit into memory
[[nodiscard]] std::vector<LevelErrors> fine_levels(const Bench& bench, const FineStudy& study,
                                                   const std::vector<LevelFigure>& figures);

}  // namespace radcert::verification
