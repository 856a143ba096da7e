// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "radcert/certificate/enclosure.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// c x^i y^j z^k.
struct Monomial {
  std::array<int, 3> powers{};  ///< i, j, k
  Rational coefficient;
};

/// Largest i + j + k of a monomial, and largest degree of q.
inline constexpr int most_sphere_powers = 64;
/// The same of rho, whose supremum is looked for.
inline constexpr int most_reflectivity_powers = 16;

/// What of the solution on an ellipsoid is enclosed.
enum class OnEllipsoid : std::uint8_t { mean, values, function };

/// What encloses the solution of a radiosity equation inside an ellipsoid, to be checked again.
/// Maths     u = E + rho T u on (x/a)^2 + (y/b)^2 + (z/c)^2 = 1, T u(P) = (1/pi) Int G(P,Q) u(Q) dS_Q; E and
///           rho are polynomials of P. P = A p, |p| = 1, A diagonal with a, b, c: q(p) = sum_(m + k <= n)
///           (a_mk Re zeta^m + b_mk Im zeta^m) T_k(z), zeta = x + i y, T_k Chebyshev's. w = E + rho q, t =
///           T w - q: |u - w| <= sup |rho| sup |t| / (1 - sup |rho|)
/// Source    lib/radcert/certificate/ellipsoid/ellipsoid_check.h
/// Result    plain data; nothing here is known to be true
struct EllipsoidCertificate {
  std::string piece;
  Vector<Rational> half_axes;
  std::vector<Monomial> reflectivity;
  std::vector<Monomial> emission;
  OnEllipsoid of = OnEllipsoid::mean;
  std::vector<Vector<Rational>> points;  ///< on the surface, of values
  int degree = 0;
  std::vector<double> cosines;        ///< a_mk by m, k
  std::vector<double> sines;          ///< b_mk by m, k
  Rational largest_reflectivity;      ///< at least sup |rho|
  double residual = 0;                ///< at least sup |t|
  Rational bound;                     ///< at least sup |u - w|
  std::vector<Enclosure> enclosures;  ///< the mean, or values by point; of the function none
  Rational width;                     ///< twice the largest radius, of the function twice the bound, or more

  /// How many coefficients of one kind a degree has.
  [[nodiscard]] static std::size_t count(int degree) {
    const auto n = static_cast<std::size_t>(degree);
    return (n + 1) * (n + 2) / 2;
  }
};

}  // namespace radcert::certificate
