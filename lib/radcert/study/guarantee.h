// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

struct Problem;
struct LevelResult;

/// What is enclosed of a solution.
enum class EnclosedQuantity {
  means,   ///< its means over the pieces
  values,  ///< its values at points
};

/// An error that the solution of the equation itself is wanted within.
struct Guarantee {
  Rational width;  ///< of an enclosure: twice its radius
  EnclosedQuantity of = EnclosedQuantity::means;
  /// Where the values are asked for; empty: at the centres of the faces, the means of their corners.
  std::vector<Vector<Rational>> points = {};
};

/// The least width that is taken, relative to the largest emission over 1 - sup rho: some hundred times what
/// roundings of sums over a mesh leave.
inline constexpr double least_relative_width = 1e-10;

/// The value of a solution at a point, proved.
struct EnclosedValue {
  std::string piece;
  Vector<Rational> at;
  Approximation value;
};

/// Enclosures of the solution of a problem, not of an approximation to it.
struct SolutionEnclosure {
  Guarantee wanted;
  double width = 0;  ///< that was reached
  /// The mean of u over each piece, proved; where means are asked for.
  std::vector<std::pair<std::string, Approximation>> pieces = {};
  std::vector<EnclosedValue> points = {};  ///< where values are asked for
  std::string hindrance = {};              ///< where the width is not reached: by what
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
///           emission; on each face rho constant, 0 <= rho < 1, and E a polynomial of degree 8 at most; a width
///           that double can hold; points inside faces
/// Result    returns, or throws InputError with the JSON pointer, the value and what is allowed
void check_guarantee(const Problem& problem, const Guarantee& guarantee);

/// Encloses the means of u over the pieces, or its values at points.
/// Maths     enclose_means, enclose_values: the residual of a piecewise polynomial and of one for each number,
///           enclosed over the whole surface
/// Source    lib/radcert/continuous
/// Requires  what check_guarantee lets pass, else InputError
/// Result    proved, AccuracyNotReached where nothing is; the level's number is that of the layers of
///           elements, its errors are absent and its means those of the enclosure, if it has them. The same
///           bits for any number of threads
/// Limits    where the width is not reached the enclosure says so and is the best that was found
[[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve_within(
    const Problem& problem, const Guarantee& guarantee,
    const std::function<void(const GuaranteeProgress&)>& progress = {});

}  // namespace radcert
