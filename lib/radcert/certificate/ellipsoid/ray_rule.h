// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"

namespace radcert::certificate {

/// How an ellipsoid turns complex points of the sphere.
/// Maths     A diagonal with the half axes over the largest of them, kappa = largest over smallest. For e = x
///           + i y, e.e = 1, |x| = cosh s, |y| = sinh s: |A^-1 x| >= |x| and |A^-1 y| <= kappa |y|, so that d
///           = A^-1 e has |d|^2 / |d.d| <= (1 + r^2) / (1 - r^2), r = kappa tanh s < 1: scaled to d.d = 1, d
///           is such a point itself, with the angle artanh(kappa tanh s) at most
/// Requires  half axes > 0, else ContractViolation
class EllipsoidStretch {
public:
  explicit EllipsoidStretch(const Vector<Rational>& half_axes);

  /// 1 over each half axis of A, within 2 units.
  [[nodiscard]] const Vector<double>& inverse() const { return inverse_; }
  [[nodiscard]] double kappa() const { return kappa_; }              ///< rounded up
  [[nodiscard]] double determinant() const { return determinant_; }  ///< of A, rounded up
  /// artanh(kappa tanh s), rounded up; infinite where there is none.
  [[nodiscard]] double turned(double s) const;
  /// The s up to which there is one, rounded; not more than 6.
  [[nodiscard]] double widest() const;
  /// cosh^2 s - kappa^2 sinh^2 s, rounded down, or 0: at most |A^-1 p|^2 for p rotated by i s.
  [[nodiscard]] double margin(double s) const;

private:
  Vector<double> inverse_;
  double kappa_;
  double determinant_;
};

/// A rule for means over the unit sphere in polar coordinates about (0, 0, 1).
/// Maths     x = cos psi and phi uniform in [-1,1] x [0,2 pi]: Gauss' rule of n nodes in x, and at each of
///           them N nodes alike in phi. Points are given by psi or by psi/2
struct PolarRule {
  std::vector<Vector<double>> points;  ///< filled up to whole packs by points of no weight
  std::vector<double> weights;         ///< with the sum 1, each within 4 units
  std::size_t nodes = 0;               ///< before they are filled up; 0: there is no rule
  double error = 0;                    ///< what is missed, at most
};

/// What a function is bounded by around the sphere.
/// Maths     |f| <= meridian(s) where psi is complex, |Im psi| <= s < meridian_strip, phi real; |f| <= row(s,
///           psi) where phi is, |Im phi| <= s < row_strip(sine), psi real, sine that of psi, or of psi/2. f
///           is holomorphic there, and its mean over phi is an even function of psi of the period 2 pi
struct PolarBounds {
  double meridian_strip = 0;
  std::function<double(double s)> meridian;
  std::function<double(double sine)> row_strip;
  std::function<double(double s, double sine)> row;
};

/// A rule that misses a tolerance at most.
/// Maths     the mean over phi is holomorphic in x in the ellipse with the foci -1, 1 whose half axes sum to
///           r = exp(s), and bounded there by M: Chebyshev's coefficients are 2 M r^-k at most, so that a
///           polynomial of degree 2n - 1 is off by 2 M r^(-2n) / (1 - 1/r), and both means of that count. N
///           nodes in phi miss the Fourier coefficients whose number is a multiple of N, 0 aside: 2 M /
///           (exp(N s) - 1)
/// Result    points on the sphere of psi or, halved, at psi/2, each coordinate within 4 units
[[nodiscard]] PolarRule polar_rule(const PolarBounds& bounds, double tolerance, bool halved);

}  // namespace radcert::certificate
