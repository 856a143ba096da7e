// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radcert/geometry/double_double_vector.h"
#include "radcert/scalar/pack.h"

namespace radcert {

/// A rule on the triangle of corners 0, 1, 2: Gauss points in both directions of the square collapsed at
/// corner 0.
/// Maths     exact for degree 2 points - 1
/// Source    conical products: Stroud
/// Result    weights sum to 1/2; padded to whole packs with weights zero. Coordinates and weights rounded
///           once, so that each has a small relative error, also where a node lies close to a side
struct PaddedRule {
  int points = 0;
  std::array<std::vector<double>, 3> barycentric;
  std::vector<double> weights;
};

/// The rule with fewest points that integrates the kernel times a polynomial over a small triangle.
/// Maths     |Q-P|^-4 = D^-4 sum_k C_k^(2)(cos) (|Q-c|/D)^k, D = |P-c|, |C_k^(2)| <= (k+1)(k+2)(k+3)/6: the
///           tail beyond the degree m that the rule leaves to the sum is at most `needed` where |Q-c| <=
///           ratio D
/// Source    Gegenbauer's generating function
/// Requires  0 < ratio < 1
/// Result    a pointer for the life of the program; null where no rule of at most 40^2 points does
/// Limits    the kernel's numerator is linear, which takes one degree
const PaddedRule* fitting_rule(double ratio, double needed, int degree);

/// A corner of what is integrated at one go.
struct PieceCorner {
  DoubleDouble x;  ///< about the foot of P
  DoubleDouble y;
  DoubleDouble level;                   ///< (corner - P) . n_P
  std::array<double, 3> barycentric{};  ///< in the triangle that was cut
};

/// Part of a triangle.
struct KernelPiece {
  std::array<PieceCorner, 3> corner;
  double double_area = 0;  ///< signed
  double distance = 0;     ///< from P to the mean of the corners, rounded down
  double radius = 0;       ///< about that mean, rounded up
  bool whole = true;       ///< whether it is its triangle
  bool cut = false;        ///< whether it is part of a triangle that the tangent plane cuts
  int halvings = 0;        ///< of the triangle, or of its visible part
  std::size_t triangle = 0;
};

/// The part of a piece with levels that are not negative, in at most two triangles.
/// Maths     cut at level 0
/// Requires  levels whose signs are those of the exact numbers, or zero
/// Result    appended; a cut's place on an edge, l_a / (l_a - l_b) for levels of opposite signs, is rounded
///           to 2^-100 of itself from either end. Errors e of the levels shift it by at most 2 e / (|l_a| +
///           |l_b|) of the edge where they are at most a quarter of the levels, and change areas by twice
///           that part of the smaller level
void append_visible(const KernelPiece& piece, std::vector<KernelPiece>& to);

/// Appends the four triangles between the corners and the middles of the sides.
void append_quarters(const KernelPiece& piece, std::vector<KernelPiece>& to);

/// Sets distance and radius, for a height of P over the plane; what they are off by is below 2^-48 of the
/// distance where the radius is less than the distance.
void measure(KernelPiece& piece, double squared_height);

/// The tail that a rule over a piece may leave, for fitting_rule.
/// Maths     truncation is at most 2 |area| sup level D^-4 tail sup |q|, D the distance: with this tail, the
///           pieces' sum to `allowed` at most where their areas sum to `area` and sup |q| <= size
/// Requires  allowed, area, size > 0
/// Result    infinite where no corner has a positive level: there is nothing to integrate
double needed_tail(const KernelPiece& piece, double allowed, double area, double size);

/// A bound of Int |h level| / |Q-P|^4 dS over the part of a polygon that the tangent plane hides.
/// Maths     Along every ray from the corner of the largest level L on to the boundary of the convex hull the
///           level falls linearly from L to -e at the lowest, and is negative on a part e / (L + e) of it at
///           most: the area is at most 2 e / L of the hull's. There the integrand is at most h e / h^4
/// Requires  area >= that of the convex hull, levels >= -lowest, L >= 3/4 largest, 0 < height <= |h|
double integral_behind(double area, double lowest, double largest, double height);

/// Sums of a rule over pieces of one triangle.
/// Maths     Int (Q-P).n_P / |Q-P|^4 lambda^alpha dS for all products of so many barycentric coordinates. The
///           order: those of one factor less, in the same order, times lambda_0; then lambda_1^n,
///           lambda_1^(n-1) lambda_2, ..., lambda_2^n
/// Requires  degree <= 8
/// Result    blocks of rule_block packs are summed plainly, and added to the total with its rounding kept
/// Limits    the order of the pieces matters to the last bits
class PieceSums {
public:
  static constexpr std::size_t most_monomials = 45;
  static constexpr std::size_t rule_block = 4;

  /// The roundings that a summand may suffer, and its factor of height over the length of the normal, in
  /// units of 2^-53 of it, where pieces have at most this radius against their distance D.
  static double summand_roundings(double ratio);
  /// Those of the sums, and of products with coefficients, in units of the largest Bernstein coefficient
  /// times the sum; whole: for pieces that are their triangles.
  static double sum_roundings(int degree, bool whole);

  explicit PieceSums(int degree);
  void clear();
  void add(const KernelPiece& piece, const PaddedRule& rule, double squared_height);
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] long double moment(std::size_t k) const {
    return static_cast<long double>(totals_[k].sum()) + static_cast<long double>(rests_[k].sum());
  }

private:
  template <int known>
  void add_in(const KernelPiece& piece, const PaddedRule& rule, double squared_height);

  int degree_;
  std::size_t count_;
  std::array<Pack, most_monomials> totals_;
  std::array<Pack, most_monomials> rests_;
};

}  // namespace radcert
