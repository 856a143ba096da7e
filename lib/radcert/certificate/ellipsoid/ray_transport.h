// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/certificate/ellipsoid/ray_rule.h"
#include "radcert/certificate/ellipsoid/sphere_function.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/approximation.h"

namespace radcert::certificate {

/// T w on an ellipsoid by rays.
/// Maths     (T w)(P) = (1/pi) Int (n.e) w(Q(e)) de over the unit vectors e with n.e > 0, n the inner normal
///           and Q(e) where the ray from P along e leaves: the solid angle of dS is |n_Q.e| dS / |Q - P|^2.
///           With P = A p and d = A^-1 e, Q = A q with q = p - 2 (p.d)/(d.d) d, the reflection of p. In polar
///           coordinates about n, e at the angle psi/2 from it, T w is the mean of w(A q) over cos psi and
///           phi: weights are positive and T 1 = 1. q does not change by e -> -e, so that the mean over phi
///           is an even function of psi with the period 2 pi. Complex angles: psi = .. + i s rotates e by i
///           s/2, phi = .. + i s by asinh(sin(psi/2) sinh s) at most. d is then turned by sigma =
///           EllipsoidStretch::turned of that, and the reflection about it, whose norm is exp(2 sigma), takes
///           the real p to cosh(2 tau) = |q|^2 <= cosh(4 sigma): |w - c| <= rest(2 sigma)
/// Source    ours; nothing of it depends on p
/// Requires  stretch and density outlive it
/// Result    proved: truncation, and rounding of rays, function and sums
/// Limits    no bound of the radius where there is no rule, or where the half axes differ by more than 10^4
class RayTransport {
public:
  RayTransport(const EllipsoidStretch& stretch, const SphereDensity& density, double tolerance);

  [[nodiscard]] bool exists() const { return rule_.nodes > 0; }
  [[nodiscard]] std::size_t nodes() const { return rule_.nodes; }
  /// T w at A p/|p|.
  /// Requires  1/2 <= |p| <= 2
  [[nodiscard]] Approximation operator()(const Vector<double>& p) const;

private:
  const EllipsoidStretch& stretch_;
  const SphereDensity& density_;
  PolarRule rule_;
  double constant_;
  double radius_;
};

/// A bound of |T w - c| where p is rotated by i s.
/// Maths     by theorem E of the kernel: |A^-1 p| (T w)(A p) = det A mean_q (|p-q| / |A (p-q)|)^4 w(A q), and
///           the mean stays what it is where q is rotated with p. d = (p-q)/|p-q| is then a real unit vector
///           rotated by i s: |(A d).(A d)| >= (cosh^2 s - kappa^2 sinh^2 s) / kappa^2 = margin(s) / kappa^2,
///           the smallest half axis being 1/kappa, and |(A^-1 p).(A^-1 p)| >= margin(s): |T w - c| <= det A
///           kappa^4 rest(s) / margin(s)^(5/2). The first formula: dS = det A |A^-1 q| dq, n.(Q-P) = |p-q|^2
///           / (2 |A^-1 p|)
/// Result    rounded up; infinite where margin(s) is 0
[[nodiscard]] double transported_around(const EllipsoidStretch& stretch, const SphereDensity& density,
                                        double s);

/// The mean of w over the surface.
/// Maths     Int w dS / Int dS = mean_p |A^-1 p| w(A p) / mean_p |A^-1 p|. Around the sphere |(A^-1 p).(A^-1
///           p)| <= kappa^2 cosh 2s, and it vanishes nowhere where margin(s) > 0. psi complex rotates p by i
///           Im psi, phi by no more than i Im phi
/// Result    proved, missing about the tolerance beside rounding; no bound of the radius where there is no
///           rule
[[nodiscard]] Approximation mean_over_surface(const EllipsoidStretch& stretch, const SphereDensity& density,
                                              double tolerance);

}  // namespace radcert::certificate
