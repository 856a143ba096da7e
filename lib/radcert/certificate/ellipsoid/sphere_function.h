// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/certificate/ellipsoid/ellipsoid_certificate.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// What bounds a polynomial around the sphere.
/// Maths     |f - constant| <= sum_n of_degree[n] g^n at p = x + i y, x.y = 0, |x| = cosh tau, |y| = sinh
///           tau, where g = exp(tau)
struct SphereSizes {
  double constant = 0;
  std::vector<double> of_degree;

  [[nodiscard]] double rest(double tau) const;
  [[nodiscard]] double all(double tau) const;
};

/// q: sum_(m + k <= n) (a_mk Re zeta^m + b_mk Im zeta^m) T_k(z).
/// Maths     value: Clenshaw's rule in z for each m, b_k = c_k + 2 z b_(k+1) - b_(k+2): an error of b_k is
///           one of c_k, and moves the sum by no more, since |T_k| <= 1; |b_k| <= sum_(j >= k) (j - k + 1)
///           |c_j|. Then Horner's rule in zeta, |zeta| <= 1. A point that is off by d moves a term by (m +
///           k^2) d at most. Around the sphere |x_1 + i x_2|, |x_1 - i x_2| <= exp(tau) for unit vectors
///           across each other, and z lies in the ellipse with the half axes cosh tau and sinh tau, where
///           |T_k| <= cosh(k tau): a term is at most |(a, b)| exp((m + k) tau)
/// Result    values within error(d), rounding included; bounds rounded up
class TurnedPolynomial {
public:
  TurnedPolynomial(int degree, std::span<const double> cosines, std::span<const double> sines);

  [[nodiscard]] int degree() const { return degree_; }
  /// Requires  points within 1e-5 of the sphere, |z| <= 1
  [[nodiscard]] Pack operator()(const Vector<Pack>& p) const;
  /// Of a value at a point that is off by d.
  [[nodiscard]] double error(double d) const;
  [[nodiscard]] const SphereSizes& sizes() const { return sizes_; }
  /// At an exact point of the sphere.
  [[nodiscard]] Ball at(const Vector<Rational>& p) const;

private:
  int degree_;
  std::vector<double> cosines_;
  std::vector<double> sines_;
  SphereSizes sizes_;
  double rounding_ = 0;
  double slope_ = 0;
};

/// E or rho: p -> f(A p), f a sum of monomials.
/// Maths     on the sphere |x|, |y|, |z| <= 1, so that a monomial of n factors is off by its own products and
///           n d where the point is off by d; around it |x_i|^2 <= cosh^2 tau
/// Result    as TurnedPolynomial
class StretchedPolynomial {
public:
  StretchedPolynomial(const std::vector<Monomial>& f, const Vector<Rational>& half_axes);

  [[nodiscard]] int degree() const { return degree_; }
  /// Whether all coefficients are within the range of double.
  [[nodiscard]] bool is_finite() const { return is_finite_; }
  [[nodiscard]] Pack operator()(const Vector<Pack>& p) const;
  [[nodiscard]] double error(double d) const;
  [[nodiscard]] const SphereSizes& sizes() const { return sizes_; }

private:
  struct Term {
    std::array<std::size_t, 3> powers{};
    double coefficient = 0;
  };
  int degree_ = 0;
  bool is_finite_ = true;
  std::vector<Term> terms_;
  SphereSizes sizes_;
  double rounding_ = 0;
  double slope_ = 0;
};

/// f(P), exactly.
[[nodiscard]] Rational value_of(const std::vector<Monomial>& f, const Vector<Rational>& at);

/// w = E + rho q.
/// Maths     with the constants E_0, rho_0, q_0 of the three: w - E_0 - rho_0 q_0 = (E - E_0) + rho_0 (q -
///           q_0) + (rho - rho_0) q
struct SphereDensity {
  StretchedPolynomial emission;
  StretchedPolynomial reflectivity;
  TurnedPolynomial q;

  /// Of a certificate.
  explicit SphereDensity(const EllipsoidCertificate& certificate);
  [[nodiscard]] Pack operator()(const Vector<Pack>& p) const;
  [[nodiscard]] double error(double d) const;
  /// A double c near w, and a bound of |w - c| around the sphere.
  [[nodiscard]] double constant() const;
  [[nodiscard]] double rest(double tau) const;
};

}  // namespace radcert::certificate
