// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/expression/expression.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// Largest degree of a SpherePolynomial.
inline constexpr int most_sphere_degree = 64;

/// How far the point at which a SpherePolynomial is evaluated may be from the one that is meant.
inline constexpr double sphere_displacement = 48 * unit_roundoff<double>();

/// A polynomial in x, y, z: coefficients by exponents, none of them zero.
using SpacePolynomial = std::map<std::array<int, 3>, Rational>;

/// The polynomial that an expression is written as.
/// Requires  an expression in x, y, z
/// Result    exact; refused where it is not written as one, or has more than the largest degree
[[nodiscard]] Outcome<SpacePolynomial> space_polynomial(const Expression& f);

/// Two packs of points of the sphere.
using SpherePoints = std::array<Vector<Pack>, 2>;

/// A polynomial on the unit sphere, known exactly, evaluated in double.
/// Maths     f(p) = sum_(m + k <= n) (a_mk Re zeta^m + b_mk Im zeta^m) T_k(z), zeta = x + i y, T_k
///           Chebyshev's polynomials. Harmonics: f = sum_lm c_lm Y_lm, Y_lm real with the mean square 1,
///           P_l^|m|(z) cos(m phi) up to a factor for m >= 0, with the sine of |m| phi for m < 0
/// Source    E. T. Whittaker, G. N. Watson, "A Course of Modern Analysis", chapter 15; recurrence z Y_l =
///           b_(l+1) Y_(l+1) + b_l Y_(l-1), b_l^2 = (l^2 - m^2) / (4 l^2 - 1)
/// Result    the coefficients that are given are exact, and a_mk are enclosed: evaluation and variation
///           account for their rounding
class SpherePolynomial {
public:
  /// Zero.
  SpherePolynomial() : SpherePolynomial(Rational(0)) {}
  explicit SpherePolynomial(const Rational& constant);
  /// Requires  harmonics[l l + l + m] = c_lm, |m| <= l <= degree; 0 <= degree <= most_sphere_degree, else
  ///           ContractViolation
  SpherePolynomial(int degree, std::span<const double> harmonics);
  /// p -> f(A p), A the diagonal matrix of the half axes.
  /// Requires  an expression in x, y, z
  /// Result    exact; refused where the expression is not written as a polynomial, or has more than the
  ///           largest degree
  [[nodiscard]] static Outcome<SpherePolynomial> along(const Expression& f,
                                                       const Vector<Rational>& half_axes);

  [[nodiscard]] int degree() const { return degree_; }
  /// Doubles near a_mk and b_mk, of all functions together within rounding() of f.
  /// Requires  0 <= m, 0 <= k, m + k <= degree()
  [[nodiscard]] std::array<double, 2> coefficients(int m, int k) const {
    const std::size_t at = place(m) + 2 * static_cast<std::size_t>(k);
    return {coefficients_[at], coefficients_[at + 1]};
  }

  /// The values, each off by at most rounding().
  /// Requires  points within sphere_displacement of the exact ones on the sphere
  /// Maths     |fl(T_k) - T_k| <= 0.51 k^2 u, since what is rounded at step j comes in with U_(k-j), |U_n| <=
  ///           n + 1; |T_k'| <= k^2; zeta^m is off by 2 m u, and moves by m times the displacement; a sum of
  ///           n fused products is off by n u times the sum of their sizes
  [[nodiscard]] std::array<Pack, 2> operator()(const SpherePoints& at) const;
  [[nodiscard]] double rounding() const { return rounding_; }

  /// A double within rounding() of a constant c, and a bound of |f - c| around the sphere.
  /// Maths     |f - c| <= variation(tau) at p = x + i y, x.y = 0, |x| = cosh tau, |y| = sinh tau: s -> f at
  ///           (s, a point of a great circle) is a trigonometric polynomial, of degree l for a harmonic of
  ///           degree l, and |t(s + i tau)| <= exp(l tau) max |t| (Bernstein); |f_l| <= (2l+1)^(1/2) (sum_m
  ///           c_lm^2)^(1/2), by the addition theorem
  [[nodiscard]] double constant() const { return constant_; }
  [[nodiscard]] double variation(double tau) const;

  /// A bound of |f| on the sphere.
  [[nodiscard]] double largest() const;

private:
  void allocate(int degree);
  [[nodiscard]] std::size_t place(int m) const { return first_[static_cast<std::size_t>(m)]; }
  void bound_rounding(double enclosing);

  int degree_ = 0;
  std::vector<std::size_t> first_;    ///< of each m, the place of a_m0, b_m0 in coefficients_
  std::vector<double> coefficients_;  ///< a_mk, b_mk by m, k
  std::vector<double> sizes_;         ///< by l: what bounds the part of degree l without c
  double constant_ = 0;
  double rounding_ = 0;
};

}  // namespace radcert
