// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "radcert/core/contract.h"
#include "radcert/polynomial/barycentric.h"

namespace radcert {

/// The largest degree of these polynomials.
inline constexpr int largest_mode_degree = 22;

/// The dimension of the polynomials of a degree in two variables.
constexpr std::size_t mode_count(int degree) {
  return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
}

/// The orthonormal polynomials on a triangle, by ascending degree.
/// Maths     D_ij = sqrt((2i+1)(i+j+1)) s^i P_i((x_2 - x_1)/s) P_j^(2i+1,0)(2 x_3 - 1), s = x_1 + x_2, of
///           degree i + j; the mean of D_n D_m over the triangle is delta_nm.  s^i P_i(d/s) is a polynomial
///           in s and d: (i+1) p_(i+1) = (2i+1) d p_i - i s^2 p_(i-1)
/// Source    Dubiner (1991), Koornwinder (1975); recurrences: DLMF 18.9
/// Requires  0 <= degree <= largest_mode_degree; mode_count(degree) places, else ContractViolation
/// Result    out[m (m+1)/2 + i] = D_(i,m-i), so that the first mode_count(p) places hold those of degree <=
///           p; rounded
/// Limits    R is double or long double; Ball or BoundedDouble where the polynomials are enclosed; Dual where
///           they are differentiated
template <class R>
void triangle_modes(int degree, const Barycentric<R>& x, std::span<R> out) {
  using std::sqrt;
  expects(0 <= degree && degree <= largest_mode_degree, "0 <= degree <= 22", named("degree", degree));
  expects(out.size() >= mode_count(degree), "a place a polynomial", named("places", out.size()));
  const R s = x.x[0] + x.x[1];
  const R d = x.x[1] - x.x[0];
  const R b = R(2) * x.x[2] - R(1);
  std::array<R, largest_mode_degree + 2> legendre{};
  legendre[0] = R(1);
  legendre[1] = d;
  for (int i = 1; i < degree; ++i)
    legendre[static_cast<std::size_t>(i) + 1] = (R(2 * i + 1) * d * legendre[static_cast<std::size_t>(i)] -
                                                 R(i) * s * s * legendre[static_cast<std::size_t>(i) - 1]) /
                                                R(i + 1);
  for (int i = 0; i <= degree; ++i) {
    const R a = R(2 * i + 1);
    R before = R(0);
    R now = R(1);
    for (int j = 0; i + j <= degree; ++j) {
      const auto m = static_cast<std::size_t>(i + j);
      out[m * (m + 1) / 2 + static_cast<std::size_t>(i)] =
          sqrt(R((2 * i + 1) * (i + j + 1))) * legendre[static_cast<std::size_t>(i)] * now;
      const R n = R(j);
      const R next =
          j == 0 ? ((a + R(2)) * b + a) / R(2)
                 : ((R(2) * n + a + R(1)) * (a * a + (R(2) * n + a) * (R(2) * n + a + R(2)) * b) * now -
                    R(2) * (n + a) * n * (R(2) * n + a + R(2)) * before) /
                       (R(2) * (n + R(1)) * (n + a + R(1)) * (R(2) * n + a));
      before = now;
      now = next;
    }
  }
}

}  // namespace radcert
