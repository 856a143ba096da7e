// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/enclosure_search.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/geometry/vector.h"

namespace radcert {

/// A function on a part of a surface, and how far the solution may be from it there.
struct EnclosedPart {
  std::size_t piece = 0;
  std::array<Vector<double>, 4> corners;  ///< in their order about the part
  std::array<double, 4> values{};         ///< v there
  double bound = 0;                       ///< of |u - v| on the part; of a value above within rounding
};

/// What a FunctionEnclosure is proved from, in the units of ScaledProblem.
/// Result    elements at vertices are cut towards them, down to the smallest distance; q on the parts is
///           within rounding that on the whole, and E + rho q a v as good as the other
struct FunctionProof {
  std::vector<SectorElement> elements;
  SectorFunctions q;  ///< v = E + rho q
  int exponent = 0;
  std::vector<double> residuals = {};  ///< by element: sup |u - v - K(u - v)|
  std::vector<double> farthest = {};   ///< by element: a point's largest distance from its nearest vertex
  std::vector<double> radii = {};      ///< the distances by which the residuals were sorted, descending
};

/// A piecewise polynomial v near the solution u, and how near.
struct FunctionEnclosure {
  /// |u - v| at points that are about `outside` or more from every corner of a panel: 2^-41 of it less.
  double sup = 0;
  double outside = 0;  ///< 0: everywhere
  struct AtDistance {
    double outside = 0;
    double sup = 0;
  };
  std::vector<AtDistance> by_distance;  ///< from large distances to 0
  struct OnPiece {
    double outside = 0;     ///< sup |u - v| where the distance is kept
    double everywhere = 0;  ///< and on all of the piece
  };
  std::vector<OnPiece> pieces;
  std::vector<EnclosedPart> parts;  ///< each element in 4 x 4
  EnclosureProgress last;
  std::string hindrance = {};  ///< where twice the sup is not the wanted width: what stood in the way
  std::shared_ptr<const FunctionProof> proof = nullptr;  ///< where it is asked for
};

/// Encloses u as a function.
/// Maths     v = w_0 = E + rho q for any q, t = T v - q, so that u - v - K(u - v) = rho t, up to the rounding
///           of E, rho and v. |rho t| is bounded on cells (residual_sums); near vertices, where u tends to a
///           function of the direction, no polynomial makes it small. Its largest values by the distance from
///           the vertices give a bound of u - v by the distance (supersolution). Where parts hide each other
///           cells are cut until little of what they see is seen in part (Penumbra)
/// Requires  as enclose_means, one emission; 0 <= outside
/// Result    proved; the mesh as there, until |u - v| <= wanted/2 where the distance from all corners is at
///           least `outside`; 0 there where that holds everywhere. The same bits for any number of threads
/// Limits    edges whose two sides have not the same ends are as bad as vertices, and are not spared: panels
///           are to be with_edges_matched. What is seen in part falls with the size of cells, as for means
[[nodiscard]] FunctionEnclosure enclose_function(const PolyhedronProblem& problem, double wanted,
                                                 double outside, const SearchContext& context = {},
                                                 bool with_proof = false);

}  // namespace radcert
