// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// How many polynomials of a degree the permutations of the vertices leave as they are.
/// Maths     the number of e_2^i e_3^j with 2i + 3j <= degree, e_2 and e_3 the elementary symmetric functions
///           of the barycentric coordinates; 0 below degree 0
/// Source    the fundamental theorem of symmetric polynomials, e_1 = 1
[[nodiscard]] int invariant_count(int degree);

/// How many orbits of each size symmetric nodes of a degree have.
/// Maths     there is no choice. The values at unisolvent nodes and P_r are the same representation of the
///           permutations, and these permute the nodes as they do the monomials x^k, |k| = r, which span P_r.
///           An exchange of two vertices leaves one node of each orbit of one or three where it is, and the
///           floor(r/2) + 1 monomials with two equal exponents; a rotation leaves an orbit of one, and x^k
///           with three equal exponents if there is one. So ones = 1 where 3 divides r, else 0, ones + threes
///           = floor(r/2) + 1, and ones + 3 threes + 6 sixes = (r+1)(r+2)/2
/// Source    ours: equal representations have equal characters
/// Requires  degree >= 0, else ContractViolation
/// Result    exact
struct OrbitStructure {
  int ones = 0;
  int threes = 0;
  int sixes = 0;

  [[nodiscard]] int orbits() const { return ones + threes + sixes; }
  /// Coordinates that can be chosen.
  [[nodiscard]] int coordinates() const { return threes + 2 * sixes; }
};
[[nodiscard]] OrbitStructure orbit_structure(int degree);

/// The largest degree of precision for which a rule at symmetric nodes has no fewer numbers, weights and
/// coordinates, than equations.
/// Maths     max d with I(d) <= orbits + coordinates
/// Requires  degree >= 0, else ContractViolation
/// Limits    that no rule has a larger one is not said
[[nodiscard]] int largest_regular_precision(int degree);

}  // namespace radcert
