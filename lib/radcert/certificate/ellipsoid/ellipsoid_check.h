// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/certificate/ellipsoid/ellipsoid_certificate.h"
#include "radcert/certificate/ellipsoid/ray_transport.h"
#include "radcert/certificate/part.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/ball.h"

namespace radcert::certificate {

/// Points of the sphere such that every other is within a distance of one of them.
/// Maths     r rows at the colatitudes t_i = (i + 1/2) pi/r, m_i points in row i. From a point of the band
///           about row i a curve leads to the row's nearest point whose colatitude and longitude change
///           alike: it is no longer than ((pi/2r)^2 + (S pi/m_i)^2)^(1/2), S the largest sine in the band
/// Requires  1e-4 <= distance <= 1, else ContractViolation
class SphereCover {
public:
  explicit SphereCover(double distance);
  [[nodiscard]] std::size_t rows() const { return counts_.size(); }
  [[nodiscard]] std::size_t count(std::size_t row) const { return counts_[row]; }
  [[nodiscard]] Vector<double> point(std::size_t row, std::size_t place) const;

private:
  std::vector<std::size_t> counts_;
};

/// What lies between points.
/// Maths     f real on the sphere, on each great circle f = g + e with g a trigonometric polynomial of degree
///           L, |e| <= left, |e'| <= slope_left. With X = max |f| at p, and a point at the distance h from p
///           on a great circle, f' = 0 at p, so that |g'| <= slope_left there, and |g''| <= L^2 (X + left) by
///           Bernstein's inequality: |f| at the point is at least X - 2 left - h slope_left - (L h)^2 (X +
///           left)/2. So where |f| is at most M at points that are within h of all others, X (1 - (L h)^2 /
///           2) <= M + (2 + (L h)^2 / 2) left + h slope_left
/// Source    ours; S. Bernstein's inequality |g'| <= L max |g|, twice
struct BetweenPoints {
  int degree = 0;  ///< L
  double distance = 0;
  double left = 0;
  double slope_left = 0;

  /// The M from which X <= bound follows; negative where there is none.
  [[nodiscard]] double at_points(double bound) const;
};

/// For t = T w - q: what Fourier's coefficients leave.
/// Maths     on a great circle t + q - c is holomorphic with the period 2 pi in |Im s| < s_0, bounded by B =
///           transported_around(s): its coefficients are at most B exp(-|k| s), so that left = 2 B exp(-L s)
///           / (exp(s) - 1), slope_left = 2 B exp(-(L+1) s) ((L+1) - L exp(-s)) / (1 - exp(-s))^2. q is a
///           trigonometric polynomial of its degree there
/// Result    with the least L, at least that of q, for which both cost a thirtieth of the residual; degree 0:
///           there is none
[[nodiscard]] BetweenPoints between_points(const EllipsoidStretch& stretch, const SphereDensity& density,
                                           double residual);

/// The mean, or the values, that follow from the bound.
/// Maths     u - w = rho t + rho T (u - w) and |T f| <= sup |f|, so that |u - w| <= s sup |t| / (1 - s), s =
///           sup |rho|. Values: w at the point in balls, within the bound. The mean: that of w within the
///           bound, or, where rho is constant, that of E over 1 - rho, since Int T u = Int u; whichever is
///           narrower
/// Requires  faults of data have been looked for
/// Result    enclosed; without bound where nothing is known
[[nodiscard]] std::vector<Ball> enclosed(const EllipsoidCertificate& certificate);

/// How much more a residual has to be claimed because of the errors of its check: a few times those of T w -
/// q.
/// Requires  as enclosed; a residual > 0, else no room is said to be enough
[[nodiscard]] double room_for_check(const EllipsoidCertificate& certificate);

/// The rows of points that the residual is looked at.
[[nodiscard]] std::size_t part_count(const EllipsoidCertificate& certificate);

/// Checks a certificate, by means that share no function with the search that made it.
/// Maths     sup |rho| by BetweenPoints at points of a cover, or exactly where rho is constant, and rho >= 0
///           at these points, of which the theorem has no need; sup |t| by
///           the same at points of the rows that are looked at, T w by RayTransport; bound, enclosures and
///           width follow exactly. Points of values lie on the surface, exactly
/// Source    enclosed, BetweenPoints and RayTransport for the theorems. The search takes the kernel about
///           each point, harmonics and Riesz's theorem
/// Requires  lists of the lengths that EllipsoidCertificate states, finite numbers, 0 <= i + j + k <=
///           most_sphere_powers, of rho most_reflectivity_powers
/// Result    no refusal: what was looked at is proved, and the enclosures are, if all rows are looked at.
///           Depends on the certificate and the part alone, whatever the number of threads
/// Limits    a residual that holds by less than the bounds here are generous is refused
[[nodiscard]] Report check(const EllipsoidCertificate& certificate, const Part& part,
                           const CheckListener& progress = {});

}  // namespace radcert::certificate
