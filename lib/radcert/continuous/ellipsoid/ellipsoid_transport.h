// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "radcert/continuous/ellipsoid/sphere_polynomial.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// An ellipsoid up to its size, and how far its kernel can be continued.
/// Maths     P = A p, |p| = 1, A diagonal with the half axes over the largest of them: 1 = the largest, a =
///           the smallest. For a real unit vector d and a rotation R(tau) by the angle i tau about an axis
///           n, R d = d_n + cosh(tau) d_t + i sinh(tau) n x d with d_n along n, d_t across, so that
///               Re (A R d).(A R d) >= a^2 (1 + sinh^2(tau) |d_t|^2) - sinh^2(tau) |d_t|^2
///                                  = a^2 - (1 - a^2) sinh^2(tau) |d_t|^2 =: margin(tau, |d_t|^2),
///           while d.d = 1 is kept. Likewise Re |A^-1 R p|^2 >= margin(tau, 1) / a^2
/// Source    ours
/// Requires  half axes > 0, else ContractViolation
class EllipsoidShape {
public:
  explicit EllipsoidShape(const Vector<Rational>& half_axes);

  [[nodiscard]] const Vector<double>& axes() const { return axes_; }  ///< each rounded once
  [[nodiscard]] double smallest() const { return smallest_; }         ///< a, rounded down
  [[nodiscard]] double determinant() const { return determinant_; }   ///< of A, within 5 units
  /// Rounded down; where it is positive the kernel is holomorphic.
  [[nodiscard]] double margin(double tau, double across = 1) const;
  /// The tau up to which the margin is positive, rounded, and not more than 6.
  [[nodiscard]] double widest(double across = 1) const;

private:
  Vector<double> axes_;
  double smallest_;
  double least_;   ///< a^2, rounded down
  double spread_;  ///< 1 - a^2, rounded up
  double determinant_;
};

/// w = E + rho q on the ellipsoid, as functions of p.
struct EllipsoidDensity {
  SpherePolynomial emission;
  SpherePolynomial reflectivity;
  SpherePolynomial reflected;  ///< q

  /// The values of w, each off by at most rounding().
  [[nodiscard]] std::array<Pack, 2> operator()(const SpherePoints& at) const;
  [[nodiscard]] double rounding() const;
  /// A double c, and a bound of |w - c| as SpherePolynomial has it.
  [[nodiscard]] double constant() const;
  [[nodiscard]] double variation(double tau) const;
  [[nodiscard]] double largest() const;
  /// How many products an evaluation takes, about.
  [[nodiscard]] double cost() const;
};

/// A rule for means over the sphere, about a pole.
/// Maths     psi the angle from the pole, phi the one about it: Gauss-Legendre in cos(psi), and for each psi
///           the trapezoidal rule in phi, with its own number of nodes
struct SphereRule {
  std::vector<double> cos_psi, sin_psi, cos_half, sin_half, cos_phi, sin_phi;
  std::vector<double> weights;  ///< with the sum 1
  std::size_t nodes = 0;        ///< before they are filled up to whole pairs of packs by nodes of no weight
  double error = 0;             ///< a bound of what the rule misses

  [[nodiscard]] bool exists() const { return nodes > 0; }
};

/// What bounds a function around the sphere, for a SphereRule.
/// Maths     |f| <= row(tau, psi) where phi is complex with |Im phi| <= tau < row_strip(psi), psi real; |f|
///           <= meridian(tau) where psi is, phi real, |Im psi| <= tau < meridian_strip; f is holomorphic
///           there, of period 2 pi in both, and f(-psi, phi) = f(psi, phi + pi). psi is given by sin(psi) and
///           cos^2(psi/2)
struct SphereBounds {
  double meridian_strip = 0;
  std::function<double(double tau)> meridian;
  std::function<double(double sine, double half)> row_strip;
  std::function<double(double tau, double sine, double half)> row;
};

/// A rule that misses at most about the tolerance.
/// Maths     Phi = Int_0^2pi f dphi is an even function of psi with the period 2 pi, hence holomorphic in
///           cos(psi) in the ellipse with the foci -1, 1 whose half axes sum to exp(tau): n nodes of
///           Gauss-Legendre miss at most (4 + 4/(4n^2-1)) 2 pi meridian(tau) exp(-2 n tau) / (1 - exp(-2
///           tau)); n nodes of the trapezoidal rule miss at most 4 pi row / (exp(n tau) - 1)
/// Source    N. Trefethen, "Approximation Theory and Approximation Practice", theorem 19.3, with the constant
///           that gauss_error_factor proves; N. Trefethen, J. Weideman, "The exponentially convergent
///           trapezoidal rule", 2014, theorem 3.2
/// Result    values within four units, error proved. No rule where it would have more nodes than the limit
[[nodiscard]] SphereRule sphere_rule(const SphereBounds& bounds, double tolerance);

/// T w on an ellipsoid, T = (1/pi) Int G . dS.
/// Maths     with P = A p, Q = A q, dS = det A |A^-1 q| dq, n = -A^-1 p / |A^-1 p|: (Q-P).n_P = (1 - p.q) /
///           |A^-1 p| = |p-q|^2 / (2 |A^-1 p|), so that
///               |A^-1 p| (T w)(A p) = det A mean_q (|p-q| / |A(p-q)|)^4 w(A q).
///           q = p cos(psi) + s sin(psi), s across p, and (p-q)/|p-q| = d = p sin(psi/2) - s cos(psi/2), so
///           that the kernel is |A d|^-4. Complex phi rotates d and q about p: |d_t|^2 = cos^2(psi/2), and q
///           is moved off the sphere by sin(psi) sinh(tau). Complex psi rotates q by psi and d by psi/2 in
///           their plane. Where p and q are rotated together, by i tau, means over q stay what they are:
///           |A^-1 p| T w is holomorphic around the sphere, bounded by det A |w| / margin(tau)^2, and
///           |A^-1 p| is at least margin(tau)^(1/2) / a there. T 1 = 1, so that all of this is done for w - c
/// Source    ours; the first formula by cofactors
/// Requires  shape and density outlive it
/// Result    proved: truncation, rounding of points, kernel, function and sums
/// Limits    a radius without bound where there is no rule
class EllipsoidTransport {
public:
  EllipsoidTransport(const EllipsoidShape& shape, const EllipsoidDensity& density, double tolerance);

  [[nodiscard]] bool exists() const { return rule_.exists(); }
  [[nodiscard]] std::size_t nodes() const { return rule_.nodes; }
  /// T w at A p/|p|.
  /// Requires  a finite p of a size between 1/2 and 2
  [[nodiscard]] Approximation operator()(const Vector<double>& p) const;

private:
  const EllipsoidShape& shape_;
  const EllipsoidDensity& density_;
  SphereRule rule_;
  double constant_;
  double variation_;  ///< of w - c on the sphere, its rounding included
  double rounding_;
};

/// A bound of |T w - c| around the sphere, where p is rotated by the angle i tau.
/// Maths     det A a variation(tau) / margin(tau)^(5/2), as EllipsoidTransport has it
/// Result    infinite where the margin is not positive
[[nodiscard]] double bound_around(const EllipsoidShape& shape, const EllipsoidDensity& density, double tau);

/// What T w is off its harmonics up to a degree, at most.
/// Maths     f = T w - c with |f| <= B = bound_around(tau). The part of degree l at p is the
///           Legendre coefficient a_l of F(cos s) = mean of f over the circle at the distance s from p, which
///           is the mean over the great circles through p, so that F is holomorphic and bounded by B in the
///           ellipse with the foci -1, 1 whose half axes sum to e = exp(tau): polynomials of degree l-1
///           approximate F to 2 B e^(1-l) / (e-1), and the integral of |P_l| is at most 2 (2l+1)^(-1/2), so
///           that |a_l| <= (2l+1)^(1/2) 2 B e^(1-l) / (e-1). Their sum over l > degree is bounded by a
///           geometric one
/// Source    ours; N. Trefethen, "Approximation Theory and Approximation Practice", theorem 8.2
/// Result    proved
[[nodiscard]] double harmonic_tail(const EllipsoidShape& shape, const EllipsoidDensity& density, int degree);

/// The mean of w over the surface.
/// Maths     Int w dS / Int dS = mean_p |A^-1 p| w / mean_p |A^-1 p|; around the sphere | |A^-1 p|^2 | <=
///           cosh(2 tau) / a^2
/// Result    proved, missing about the tolerance; no bound of the radius where there is no rule
[[nodiscard]] Approximation surface_mean(const EllipsoidShape& shape, const EllipsoidDensity& density,
                                         double tolerance);

/// Points of the sphere such that every other is within this distance of one of them.
/// Maths     rows at the colatitudes (i + 1/2) pi / r; between points with the colatitudes t, t' and the
///           longitudes apart by f the distance d has sin^2(d/2) = sin^2((t-t')/2) + sin(t) sin(t')
///           sin^2(f/2)
/// Requires  1e-4 <= distance <= 1
[[nodiscard]] std::vector<Vector<double>> sphere_cover(double distance);

/// A bound of |f| on the sphere, f a real polynomial, from a bound at the points of a cover.
/// Maths     f is a trigonometric polynomial of its degree n on every great circle, and where such a one has
///           its largest modulus X, it has at least X cos(n d) at the distance d < pi/(2n). Taken on the
///           great circle from the largest modulus on the sphere to the nearest of the points
/// Source    M. Riesz, "Eine trigonometrische Interpolationsformel", 1914
/// Requires  degree * distance < 3/2, else ContractViolation
[[nodiscard]] double bound_between(double at_points, int degree, double distance);

}  // namespace radcert
