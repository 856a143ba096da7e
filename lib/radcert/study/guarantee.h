// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/surface_function.h"

namespace radcert {

struct Problem;
struct LevelResult;

/// What is enclosed of a solution.
enum class EnclosedQuantity {
  means,     ///< its means over the pieces
  values,    ///< its values at points
  function,  ///< itself, everywhere
};

/// An emission by name.
struct NamedEmission {
  std::string name;
  PiecewiseExpression emission;
};

/// An error that the solution of the equation itself is wanted within.
struct Guarantee {
  Rational width;  ///< of an enclosure: twice its radius
  EnclosedQuantity of = EnclosedQuantity::means;
  /// Where the values are asked for; empty: at the centres of the faces, the means of their corners, and at
  /// the ends of the axes of an ellipsoid.
  std::vector<Vector<Rational>> points = {};
  /// Of a function on a polyhedron: how far from the vertices its bound is wanted; absent: a hundredth of the
  /// shortest edge.
  std::optional<Rational> outside = std::nullopt;
  /// Further emissions beside that of the problem, on a polyhedron: the means or values of each of their
  /// solutions are asked for, within the same width, and found together.
  std::vector<NamedEmission> emissions = {};
};

/// The least width that is taken, relative to the largest emission over 1 - sup rho: some hundred times what
/// roundings of sums over a mesh leave.
inline constexpr double least_relative_width = 1e-10;
/// The same where few sums are taken.
inline constexpr double least_relative_width_on_ellipsoids = 1e-12;

/// The value of a solution at a point, proved.
struct EnclosedValue {
  std::string piece;
  Vector<Rational> at;
  Approximation value;
};

/// How near an approximation v is to a solution as a function, proved.
struct FunctionBound {
  double sup = 0;      ///< |u - v| at points that are `outside` or more from all corners of faces
  double outside = 0;  ///< 0: everywhere
  /// Where parts hide each other, faces are cut along the planes of all: corners are those of their parts.
  bool faces_are_cut = false;
  struct AtDistance {
    double outside = 0;
    double sup = 0;
  };
  /// On a polyhedron, from large distances to 0.
  std::vector<AtDistance> by_distance = {};
  struct OnPiece {
    std::string piece;
    double outside = 0;     ///< sup |u - v| where the distance is kept
    double everywhere = 0;  ///< and on all of the piece
  };
  std::vector<OnPiece> pieces = {};
};

/// A function on a plane quadrilateral, and how far the solution may be from it there, proved.
struct EnclosedPatch {
  std::string piece;
  std::array<Vector<double>, 4> corners;  ///< in their order about the patch
  std::array<double, 4> values{};         ///< v there, rounded
  double bound = 0;                       ///< of |u - v|
};

/// Enclosures of the solution of a problem, not of an approximation to it.
struct SolutionEnclosure {
  Guarantee wanted;
  double width = 0;  ///< that was reached
  /// The mean of u over each piece, proved; where means are asked for.
  std::vector<std::pair<std::string, Approximation>> pieces = {};
  std::vector<EnclosedValue> points = {};                ///< where values are asked for
  std::optional<FunctionBound> function = std::nullopt;  ///< where that is asked for
  std::vector<EnclosedPatch> patches = {};               ///< of the function
  /// The same of each further emission, in their order.
  struct OfEmission {
    std::string emission;
    std::vector<std::pair<std::string, Approximation>> pieces = {};
    std::vector<EnclosedValue> points = {};
  };
  std::vector<OfEmission> emissions = {};
  std::string hindrance = {};  ///< where the width is not reached: by what
};

/// How wide an enclosure has become.
struct GuaranteeProgress {
  int layers = 0;  ///< of elements; 0 where there are none
  int degree = 0;
  std::uint64_t unknowns = 0;
  std::uint64_t samples = 0;
  double width = 0;
};

/// Who is told how wide an enclosure has become.
using GuaranteeListener = std::function<void(const GuaranteeProgress&)>;

/// Refuses a problem whose solution cannot be enclosed.
/// Maths     an emission, a width that double can hold. Either a surface of plane charts that is proved to
///           lie in the boundary of a convex body, closed or without some faces of its convex hull
///           (closing_panels), on each face rho a polynomial of degree 8 at most that is proved to lie in
///           [0,1), and E one, or so near one (near_polynomial) that no more than a quarter of the width is
///           lost, points inside faces; or, for means, a closed surface of plane charts whose parts hide each
///           other, with the same data, whose planes cut it into few parts; or a sphere or an ellipsoid, rho
///           and E polynomials, 0 <= rho < 1, points on the surface
/// Result    returns, or throws InputError with the JSON pointer, the value and what is allowed
void check_guarantee(const Problem& problem, const Guarantee& guarantee);

/// For each piece the emission that is 1 there and 0 on all others, by its name.
/// Maths     the means of their solutions are the matrix B_ij: what a unit of emission on piece j makes of
///           the mean over piece i
[[nodiscard]] std::vector<NamedEmission> emissions_by_piece(const std::vector<std::string>& pieces);

/// Encloses the means of u over the pieces, its values at points, or u itself.
/// Maths     enclose_means, enclose_values, enclose_function: the residual of a piecewise polynomial and of
///           one for each number, enclosed over the whole surface; enclose_on_ellipsoid, where patches are
///           those of a grid of angles
/// Source    lib/radcert/continuous
/// Requires  what check_guarantee lets pass, else InputError
/// Result    proved, AccuracyNotReached where nothing is; the level's number is that of the layers of
///           elements, or the degree on an ellipsoid, its errors are absent and its means those of the
///           enclosure, if it has them. The same bits for any number of threads
/// Limits    where the width is not reached the enclosure says so and is the best that was found
[[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve_within(const Problem& problem,
                                                                     const Guarantee& guarantee,
                                                                     const GuaranteeListener& progress = {});

}  // namespace radcert
