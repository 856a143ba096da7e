// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"

namespace radcert {

/// A ball about observers.
struct ObserverBall {
  Vector<double> centre;
  double radius = 0;
};

/// The ball about points, rounded up.
/// Requires  at least one point
[[nodiscard]] ObserverBall ball_about(std::span<const Vector<double>> points, double extent);

/// A part of an element as observers in a ball see it.
/// Result    distances from below, all else from above
struct SeenPart {
  double area = 0;
  double half_s = 0;  ///< the largest half length of a line in s, and in t
  double half_t = 0;
  double to_s = 0;  ///< at most the distance of the ball from the middles of those lines
  double to_t = 0;
  double part_s = 0;  ///< half lengths relative to those of the element
  double part_t = 0;
  double jacobian_part = 0;  ///< (1-t) varies by this part of its mean

  [[nodiscard]] double least_distance() const;
};

/// A part of an element, by its box, as the observers in a ball see it. Result as SeenPart.
[[nodiscard]] SeenPart seen_part(const SectorScene& scene, const SectorElement& element, const SectorBox& box,
                                 const ObserverBall& ball);

/// sup |G(P,Q)| for Q on complex lines.
/// Maths     Q runs along a straight line with the half length h; for its parameter in the ellipse with the
///           larger half axis A, a = h A = `reach`, and D the distance of P from the middle of the line, D >
///           a: w = P - Q(z) is linear in z, and w.w has two factors with conjugate zeros, each at least D/h
///           from the middle, of the moduli m_1, m_2 >= D - a. |n_P.w|^2 <= |w|^2 = (m_1^2 + m_2^2)/2, and
///           n_Q.w is the height of P over the plane of Q, which is at most D: |G| <= min(D,height) ((m_1^2 +
///           m_2^2)/2)^(1/2) / (m_1 m_2)^2, which decreases in both, so that
///           |G| <= min(D,height) / (D-a)^3, which decreases in D
/// Result    to be rounded up
[[nodiscard]] double kernel_in_ellipse(double distance, double reach, double height);

/// A Gauss rule for one parameter, and what it misses.
struct RuleChoice {
  int nodes = 0;  ///< 0: none is good enough
  double error = 0;
};

/// The least rule for G f on the lines of a part in one parameter.
/// Maths     a rule of n nodes is off by gauss_mean_error_factor times the area and the bounds of the kernel
///           and of f on the ellipse whose half axes sum to rho; sizes bound f as in PolynomialSizes. Two
///           ellipses are tried, a = D/2 and 7/10 D
/// Result    rounded up
[[nodiscard]] RuleChoice rule_in_s(const SeenPart& part, double height, std::span<const double> sizes,
                                   double allowed);
[[nodiscard]] RuleChoice rule_in_t(const SeenPart& part, double height, std::span<const double> sizes,
                                   double allowed);

/// The largest such rule; a part that would need more is cut.
inline constexpr int most_source_nodes = 10;

}  // namespace radcert
