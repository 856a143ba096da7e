// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/polynomial/nodes/ball_system.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The weight and the coordinates of an orbit, enclosed.
/// Result    unknowns: the weight, then the coordinates that are not held; coordinates: of the first point
struct OrbitBox {
  int size = 1;
  bool is_held = false;
  Ball weight;
  Ball a;
  Ball b;

  [[nodiscard]] std::vector<Ball*> unknowns() {
    std::vector<Ball*> list{&weight};
    if (size >= 3 && !is_held) list.push_back(&a);
    if (size == 6) list.push_back(&b);
    return list;
  }
  template <Field V>
  [[nodiscard]] std::array<V, 3> coordinates(const V& first, const V& second) const {
    if (size == 1) return {V(1) / V(3), V(1) / V(3), V(1) / V(3)};
    if (size == 3) return {V(1) - first - first, first, first};
    return {first, second, V(1) - first - second};
  }
};
using SymmetricBox = std::vector<OrbitBox>;

/// The unknowns of all orbits, in their order.
[[nodiscard]] std::vector<Ball*> unknowns_of(SymmetricBox& box);

/// F and F' on a box.
/// Maths     F_k = sum over orbits of size w (e_2^i e_3^j)(q) / Int e_2^i e_3^j - 1 for all 2i + 3j <=
///           precision
/// Source    certify
/// Result    derivatives by unknowns_of; enclosed
[[nodiscard]] BallResiduals symmetric_residuals(const SymmetricBox& box, int precision, std::size_t unknowns);

/// An approximate inverse of the midpoints, by Gauss and Jordan; nothing where a pivot vanishes.
[[nodiscard]] std::optional<Matrix<Ball>> approximate_inverse(Matrix<Ball> a);

/// For elimination: the row from p on whose entry in column p is largest, and the exchange of two rows.
[[nodiscard]] std::size_t pivot_row(const Matrix<Ball>& a, std::size_t p);
void exchange_rows(Matrix<Ball>& a, std::size_t i, std::size_t k);

/// n!, exactly.
[[nodiscard]] Rational factorial(int n);

}  // namespace radcert
