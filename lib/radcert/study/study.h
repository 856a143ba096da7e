// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/files/kept_numbers.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/geometry/vector.h"
#include "radcert/study/operator_route.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {

/// The numbers of one node of a level.
struct NodeValue {
  std::string piece;
  std::size_t element = 0;
  std::size_t index_in_element = 0;
  Vector<double> point;
  Vector<double> normal;
  Approximation u_n = Approximation::without_radius(0);  ///< guaranteed with `verified`
  double emission = 0;
  std::optional<double> u;  ///< with `solution` only
};

/// The computed function u_n itself on one element, for pictures: corners in space and values there.
struct ElementValue {
  std::string piece;
  std::array<Vector<double>, 3> corners;
  std::array<double, 3> corner_values;
  std::optional<std::array<double, 3>> iterated = std::nullopt;  ///< E + K u_n there, where it is asked for
};

/// How ranks shared a level.
struct SharedWork {
  std::size_t ranks = 1;
  std::uint64_t operator_bytes = 0;  ///< the most that a rank holds of the operator
  std::uint64_t bytes_sent = 0;      ///< the most that a rank sends for a product
};

/// Who solves a level, and what is wanted of one that several ranks share.
/// Requires  ranks that outlive what is given this
struct LevelSharing {
  const Ranks& ranks = one_rank();
  bool fields = true;  ///< nodes and elements, which the first rank then holds all
};

/// Everything that one level leaves.
struct LevelOutcome {
  LevelResult result;
  LevelTiming timing;
  std::optional<SharedWork> shared = std::nullopt;  ///< of a level computed now, by several ranks
  std::vector<NodeValue> nodes;
  std::vector<ElementValue> elements;
  /// Whether nodes and elements were not asked for, or are another rank's.
  [[nodiscard]] bool is_without_fields() const { return nodes.empty(); }
};

/// Solves a problem at one level, by its method. Ratios and orders between levels are left empty; see
/// `collect`.
/// Maths     (I - P_n K) u_n = P_n E, E = u - Ku at the nodes
/// Source    [ac98, (40)-(41)]; the header of each method
/// Requires  a checked problem; `level` need not be one of its levels
/// Result    the same bits for any number of threads; throws InputError naming the node where an expression
///           is not finite or rho leaves [0,1], or where the norm of K is not below 1, or at /solver/name
///           where the matrix has no weighted maximum norm below 1 and the solver needs one;
///           AccuracyNotReached; Interrupted when asked to stop. AccuracyNotReached too where the matrices
///           within the radii are not all regular, where a row of a closed unoccluded surface does not sum to
///           Int G = pi within its radius, and where numbers run over the range of double. Ranks that are
///           given share a level whose operator is h2, and all of them call this together; any other level is
///           the first one's. The outcome is given on the first, with the bits that it has without others,
///           and is empty elsewhere. A level that ranks share is without nodes and elements where these are
///           not wanted: no rank holds all of anything then. Of a level whose operator is h2 Ku and how far
///           the solver has come are kept: who is given what another call for this problem and level has kept
///           goes on from there, to the same bits
/// Limits    radii are estimates, but for a solver that proves; such a one does not take the route
LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route,
                         const LevelSharing& sharing = {}, KeptNumbers* kept = nullptr);

/// The result of finished levels: ratios, orders, fits.
/// Maths     ratio_k = e_{k-1}/e_k, order_k = log(ratio_k)/log(h_{k-1}/h_k)
/// Source    the columns "Ratio" of [ac98, Tables 1-5]
/// Requires  levels ascending
/// Result    exact functions of the levels' figures, rounded
/// Limits    a level whose radius exceeds 5 % of its error is left out of the fit and named, and so are the
///           coarse ones before the problem's fit_from, or without one those that asymptotic_law leaves out
Result collect(const Problem& problem, std::vector<LevelResult> levels, std::vector<LevelTiming> timing);

}  // namespace radcert
