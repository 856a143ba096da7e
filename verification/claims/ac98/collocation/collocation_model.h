// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

using RationalMatrix = Matrix<Rational>;
using RationalVector = std::vector<Rational>;

[[nodiscard]] RationalMatrix identity(std::size_t size);
[[nodiscard]] RationalMatrix operator*(const RationalMatrix& a, const RationalMatrix& b);
[[nodiscard]] RationalMatrix operator+(const RationalMatrix& a, const RationalMatrix& b);
[[nodiscard]] RationalMatrix operator-(const RationalMatrix& a, const RationalMatrix& b);
[[nodiscard]] RationalVector operator*(const RationalMatrix& a, const RationalVector& x);
[[nodiscard]] RationalVector operator+(RationalVector a, const RationalVector& b);
[[nodiscard]] RationalVector operator-(RationalVector a, const RationalVector& b);
/// ContractViolation if there is none.
[[nodiscard]] RationalMatrix inverse(const RationalMatrix& a);
/// The norms of the maximum: max |x_i|, and the largest row sum of |a_ij|.
[[nodiscard]] Rational norm(const RationalVector& x);
[[nodiscard]] Rational norm(const RationalMatrix& a);
/// How many entries of a and b are different.
[[nodiscard]] Rational differing(const RationalVector& a, const RationalVector& b);
[[nodiscard]] Rational differing(const RationalMatrix& a, const RationalMatrix& b);

/// An integral equation with its collocation method, exactly: functions on finitely many points of a surface.
/// Maths     three triangles with six points each: the three nodes of (33), and three that are none.
///           P = B R: R takes the values at the nodes, B is the linear interpolation (34) on each triangle. K
///           is an arbitrary matrix of whole numbers over a common denominator, with norm at most 1/4, so
///           that norm of P K < 1; E = u - K u
/// Source    [ac98, (33)-(46)]
/// Requires  0 <= alpha <= 1/6 (the norm of P is at most 7/3), and a seed of its own for each equation
/// Result    exact. nodes are the places of the nodes among the points
/// Limits    algebra alone: nothing is continuous, and K is no integral
struct CollocationModel {
  RationalMatrix k;
  RationalMatrix r;
  RationalMatrix b;
  RationalMatrix p;
  RationalVector u;
  RationalVector emission;
  std::vector<std::size_t> nodes;

  /// The values at the nodes that solve (40).
  [[nodiscard]] RationalVector node_values() const;
  /// (39): those values, interpolated.
  [[nodiscard]] RationalVector collocation_solution() const { return b * node_values(); }
  /// (42).
  [[nodiscard]] RationalVector iterated_solution() const { return emission + k * collocation_solution(); }
};
[[nodiscard]] CollocationModel collocation_model(const Rational& alpha, unsigned seed);

}  // namespace radcert::verification::ac98
