// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

struct Problem;
struct LevelResult;

/// An error that the solution of the equation itself is wanted within.
struct Guarantee {
  Rational width;  ///< of an enclosure: twice its radius; of the means over the pieces
};

/// The least width that is taken, relative to the largest emission over 1 - sup rho: some hundred times what
/// roundings of sums over a mesh leave.
inline constexpr double least_relative_width = 1e-10;

/// Enclosures of the solution of a problem, not of an approximation to it.
struct SolutionEnclosure {
  Guarantee wanted;
  double width = 0;                                           ///< that was reached
  std::vector<std::pair<std::string, Approximation>> pieces;  ///< the mean of u over each, proved
  std::string hindrance = {};                                 ///< where the width is not reached: by what
};

/// How wide the enclosure of a mesh has become.
struct GuaranteeProgress {
  int layers = 0;
  int degree = 0;
  std::uint64_t unknowns = 0;
  std::uint64_t samples = 0;
  double width = 0;
};

/// Refuses a problem whose solution cannot be enclosed.
/// Maths     a closed surface of plane charts that is proved to lie in the boundary of a convex body; an
///           emission; rho and E constant on each plane of a piece, 0 <= rho < 1; a width that double can
///           hold
/// Result    returns, or throws InputError with the JSON pointer, the value and what is allowed
void check_guarantee(const Problem& problem, const Guarantee& guarantee);

/// Encloses the means of u over the pieces.
/// Maths     enclose_means: the residual of a piecewise polynomial and of one for each mean, enclosed over
///           the whole surface
/// Source    lib/radcert/continuous
/// Requires  what check_guarantee lets pass, else InputError
/// Result    proved, AccuracyNotReached where nothing is; the level's number is that of the layers of
///           elements, its errors are absent and its means those of the enclosure. The same bits for any
///           number of threads
/// Limits    where the width is not reached the enclosure says so and is the best that was found
[[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve_within(
    const Problem& problem, const Guarantee& guarantee,
    const std::function<void(const GuaranteeProgress&)>& progress = {});

}  // namespace radcert
