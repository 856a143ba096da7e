// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "radcert/polynomial/nodes/symmetric_nodes.h"

namespace radcert {

/// Which symmetric nodes to look for.
struct SymmetricGoal {
  int degree = 0;         ///< r, of the functions
  int precision = 0;      ///< of the rule at the nodes, on the triangle
  bool positive = false;  ///< whether its weights have to be
};

/// Why a goal is none that can be looked for; empty where it is one.
/// Maths     precision = degree, or not above largest_regular_precision, and as many numbers to be held as
///           there are orbits with a coordinate at most: see SymmetricOrbit
/// Requires  degree >= 1, precision >= degree
[[nodiscard]] std::optional<std::string> hindrance(const SymmetricGoal& goal);

/// The degree of precision on parallelograms of a rule that a symmetric one of exactly this degree of
/// precision on the triangle makes.
/// Maths     d for odd d, d + 1 for even d. The error of the rule is a functional that the permutations of
///           the vertices leave as it is. On the parallelogram it misses what it misses on the triangle of
///           polynomials that are even about the middle m of a side, and nothing of odd ones; by symmetry the
///           same about each of the three middles. Even polynomials of degree d about m and m', d even, span
///           all polynomials of degree d together: the leading parts of even degree k <= d are those about
///           m, and p(x - m) - p(x - m') has for homogeneous p of degree k the leading part of the
///           derivative of p along m' - m, which is every one of degree k - 1. So for even d the degree of
///           precision is d or more on the parallelogram if and only if it is on the triangle
/// Source    ours
/// Requires  precision >= 0
[[nodiscard]] constexpr int parallelogram_precision(int precision) {
  return precision + (precision % 2 == 0 ? 1 : 0);
}

/// The least degree of precision with the highest order of convergence at the nodes, of those for which there
/// are goals without a hindrance.
/// Source    predicted_orders; parallelogram_precision
[[nodiscard]] int precision_for_orders(int degree);

/// The least degree of precision on the triangle with the largest one on the parallelogram, likewise.
[[nodiscard]] int precision_for_parallelogram(int degree);

/// How much is tried.
struct SearchEffort {
  int starts = 256;
  int steps = 600;  ///< random ones from each of the best solutions
  std::uint64_t seed = 1;
};
inline constexpr int most_search_starts = 1'000'000;

/// Symmetric nodes as a search leaves them.
/// Result    nodes: to 60 digits, of which certify decides; norm: the largest value of sum |l_j| at points of
///           a lattice, in double
struct SoughtNodes {
  SymmetricNodes nodes;
  double norm = 0;
};

/// What a search looked at.
struct SearchResult {
  std::optional<SoughtNodes> best;
  int starts = 0;     ///< that were tried
  int solutions = 0;  ///< to which the iteration came, with nodes inside, and weights as the goal wants them
};

/// Looks for symmetric nodes inside the triangle, of the least norm of interpolation, whose interpolatory
/// rule has a degree of precision.
/// Maths     unknowns: one weight an orbit of orbit_structure, and its coordinates; equations: the means of
///           the orthonormal polynomials up to the precision. Levenberg's and Marquardt's iteration from
///           random points of the triangle; then small random steps from the best solutions, each followed by
///           the iteration again, while the norm falls. The numbers that the equations leave free are held at
///           six digits where the derivative with the rest is best conditioned, and Newton's method in balls
///           gives the digits of the rest
/// Source    Xiao and Gimbutas 2010 and Witherden and Vincent 2015 for rules alone; here the number of nodes
///           is that of the functions
/// Requires  no hindrance; starts from 1 to most_search_starts, else ContractViolation. `goes_on` is asked
///           after each batch of starts, with what was found so far, and told of the steps
/// Result    the same for any number of threads; where goes_on said no, there are no more starts
/// Limits    proves nothing: what is not found may exist, see certify for what is. Nodes nearer than 1/1000
///           to the border, in barycentric coordinates, are left out, and where weights have to be positive
///           those below 1/1000 of their mean
[[nodiscard]] SearchResult search_symmetric_nodes(const SymmetricGoal& goal, const SearchEffort& effort,
                                                  const std::function<bool(const SearchResult&)>& goes_on);

}  // namespace radcert
