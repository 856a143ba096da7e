// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/factors/factor_matrix.h"
#include "radcert/formats/table/factors_csv.h"

namespace radcert {

/// How a claimed value compares with a number with a radius.
enum class Agreement {
  agrees,     ///< all that our factor may be lies within the claim
  differs,    ///< none of it does
  undecided,  ///< our radius is too large to tell, or the claim's digits are finer than it
};

/// How far a claim may be off beside what its own digits leave.
struct FactorTolerance {
  double absolute = 0;
  double relative = 0;  ///< of our factor
};

/// One pair of surfaces in two matrices.
struct FactorComparison {
  std::string from;
  std::string to;
  Approximation ours = Approximation::exact(0);  ///< zero where the matrix has no entry
  ClaimedFactor theirs;
  bool is_claimed = false;  ///< whether theirs is in their file, and not taken as 0
  Agreement agreement = Agreement::undecided;
  std::string cause{};  ///< of one that differs: a guess; see explain
  /// |ours - theirs|, rounded to nearest.
  [[nodiscard]] double difference() const;
};

/// Every pair that either matrix has, the largest differences first.
/// Maths     with d = |ours - theirs|, r our radius, h the largest of their halfwidth, the absolute tolerance
///           and the relative one of |ours|: agrees if d + r <= h, differs if d - r > h for all that ours may
///           be, else undecided
/// Requires  a name for each row; tolerances >= 0
/// Result    InputError, without a source, for a name that no surface has
/// Limits    proved where our radii are: nothing is rounded
[[nodiscard]] std::vector<FactorComparison> compared(const FactorMatrix& matrix,
                                                     std::span<const std::string> names,
                                                     const ClaimedFactors& claimed,
                                                     const FactorTolerance& tolerance);

/// The factor of two rows if nothing stood between them, where it is to be had.
using UnoccludedFactor = std::function<std::optional<double>(std::size_t from, std::size_t to)>;

/// Fills in why pairs may differ.
/// Maths     a cause is named where the number that it would lead to is closer to the claim than a fiftieth
///           of the difference, or within radius and halfwidth: below 0; not in the file; two surfaces or two
///           rows swapped, where all of both rows fits then; transposed, F_JI; exchange area, A_I F_IJ, with
///           the same constant for four pairs in five of those that differ also in another unit; a share of
///           all areas; without 1/pi; occlusion missed, the factor if nothing stood between. Else reciprocity
///           broken, where A_I F_IJ and A_J F_JI of the claims differ by more than their halfwidths
/// Source    ours
/// Requires  as compared
/// Limits    a guess: several causes may lead to one number, and the first in this list is named. Swapped
///           surfaces are looked for among at most 300
void explain(std::vector<FactorComparison>& pairs, const FactorMatrix& matrix,
             std::span<const std::string> names, const ClaimedFactors& claimed,
             const UnoccludedFactor& unoccluded);

/// "agrees", "differs", "undecided".
[[nodiscard]] std::string agreement_word(Agreement agreement);

/// All pairs as CSV, in their order.
/// Source    the columns from, to, ours, radius, guaranteed, theirs, halfwidth, difference, verdict, cause
/// Result    theirs and halfwidth in doubles: the nearest, and what holds all of the claim
[[nodiscard]] std::string comparison_csv(std::span<const FactorComparison> pairs);

/// The matrix as a picture: a cell for each pair, rows from, columns to.
/// Source    SVG 1.1
/// Requires  a name for each row, all names of the pairs among them
/// Result    white where both are zero or agree, the darker the larger our factor; those that differ are red,
///           undecided ones amber, each with a title that says the numbers
/// Limits    at most comparison_picture_rows rows, else ContractViolation
[[nodiscard]] std::string comparison_svg(std::span<const FactorComparison> pairs,
                                         std::span<const std::string> names);

/// The most rows of a matrix that is drawn.
inline constexpr std::size_t comparison_picture_rows = 400;

}  // namespace radcert
