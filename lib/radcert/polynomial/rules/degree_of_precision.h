// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <string>

#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A monomial in the coordinates s = x_3 and t = x_2 of the reference triangle.
/// Maths     s^a t^b
/// Source    [m06, (12)]
/// Requires  exponents that are not negative, where it is integrated
/// Result    plain data; to_text() is "1", "s", "s^2 t"
struct Monomial {
  int s = 0;
  int t = 0;
  [[nodiscard]] int degree() const { return s + t; }
  [[nodiscard]] std::string to_text() const;
  friend bool operator==(const Monomial&, const Monomial&) = default;
};

/// The region a rule on the reference triangle is meant for.
enum class Region {
  triangle,  ///< sigma: s, t >= 0, s + t <= 1
  /// Sigma and its image under (s,t) -> (1 - s, 1 - t), each with the rule: the square [0,1]^2
  parallelogram,
};

/// By how much a rule misses the integral of a monomial.
/// Maths     triangle: Q(f) - Int_sigma f,  Int_sigma s^a t^b = a! b!/(a + b + 2)!;
///           parallelogram: Q(f) + Q(f(1 - s, 1 - t)) - Int_0^1 Int_0^1 f,  the integral is 1/((a + 1)(b +
///           1))
/// Source    [ac98, (54)-(55)]
/// Requires  as many points as weights, exponents >= 0, else ContractViolation
/// Result    exact
[[nodiscard]] Rational defect(const TriangleRule<Rational>& rule, Region region, const Monomial& monomial);

/// How far a rule is exact, and where it ceases to be.
struct Precision {
  int degree = -1;         ///< exact for every polynomial up to it; -1: not even for constants
  Monomial first_failure;  ///< of degree + 1; the one with the highest power of s
  Rational defect;         ///< rule minus integral there, not zero
};

/// The degree of precision of a rule.
/// Maths     the largest d such that the defect of every polynomial of degree <= d is zero
/// Source    [ac98, (53)-(59)], [m06, section 3]. An affine map keeps it: sigma stands for every triangle,
///           and the square for every parallelogram whose two triangles are each other's image under a half
///           turn
/// Requires  at least one point, as many points as weights, else ContractViolation
/// Result    exact
/// Limits    the parallelogram is glued along the side x_1 = 0. Rules that are symmetric in the vertices have
///           the same degree along the others; of another rule, permute the coordinates of the points
[[nodiscard]] Precision degree_of_precision(const TriangleRule<Rational>& rule, Region region);

}  // namespace radcert
