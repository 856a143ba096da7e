// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/polynomial/barycentric.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The points that the permutations of the vertices make of one.
/// Maths     size 1: the centroid; 3: (1 - 2a, a, a) and its permutations; 6: (a, b, 1 - a - b) and its
///           permutations
/// Result    plain data
/// Limits    a = 1/3 and points on a median in an orbit of six give fewer points than `size`
struct SymmetricOrbit {
  int size = 1;
  Rational a{};
  Rational b{};
  bool is_held = false;  ///< a is a number that was chosen; all other coordinates approximate a solution's
};

/// The permutations that make an orbit of its first point x.
/// Maths     node m of the orbit is (x_p1, x_p2, x_p3), p the m-th permutation
/// Requires  size 1, 3 or 6, else ContractViolation
/// Result    of three: the different coordinate x_1 at vertex 1, 2, 3; of six: (a,b,c), (a,c,b), (b,a,c),
///           (b,c,a), (c,a,b), (c,b,a); numbers from 0
[[nodiscard]] std::span<const std::array<std::size_t, 3>> symmetric_places(int size);

/// Nodes that the permutations of the vertices exchange, and what is said of them.
/// Maths     nodes() lie close to nodes of which the interpolatory rule is exact of degree `precision`: see
///           certify
/// Requires  nodes(): orbits of size 1, 3 or 6, else ContractViolation
/// Result    nodes(): orbit after orbit, as symmetric_places has them; coordinates with the exact sum 1
struct SymmetricNodes {
  int degree = 0;
  int precision = 0;
  std::vector<SymmetricOrbit> orbits;
  [[nodiscard]] std::vector<Barycentric<Rational>> nodes() const;
};

/// The degrees for which there are sets.
inline constexpr int smallest_symmetric_degree = 1;
inline constexpr int largest_symmetric_degree = 6;

/// The sets that come with radcert.
/// Maths     r = 1: inset 1/6, precision 2; r = 2: precision 4; 3: 5; 4: 7; 5: 9; 6: 10. There are as many
///           free numbers (weights and coordinates) as invariant polynomials of degree <= precision, after
///           one coordinate is held (r = 3, 4) or two are (r = 6)
/// Source    r = 2: Strang and Fix 1973, Cowper 1973; the others: Newton's method from random starts, of the
///           solutions found with nodes inside and positive weights the one with the least norm of
///           interpolation
/// Requires  smallest_symmetric_degree <= degree <= largest_symmetric_degree, else ContractViolation
/// Result    coordinates to 60 digits
/// Limits    that no set has a higher degree of precision, or a smaller norm, is not claimed
[[nodiscard]] const SymmetricNodes& symmetric_nodes(int degree);

}  // namespace radcert
