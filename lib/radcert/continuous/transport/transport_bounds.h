// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "radcert/continuous/upward.h"

namespace radcert {

/// What bounds T_j around lines of observers c + z e, the lines of one parameter of a cell.
/// Maths     T_j w(P) = (1/pi) Int_{Q_j} G(P,Q) w(Q) dS_Q for a plane panel Q_j with the inner normal n_j.
///           The panel of the observers is in front of Q_j and parallel to e; c is real, z in the ellipse
///           with the foci -1 and 1 and the half axes A and B, A^2 - B^2 = 1
struct ObserverLines {
  double half = 0;                                        ///< |e| at most
  double distance = 0;                                    ///< of c from Q_j at least
  double height = 0;                                      ///< of c above the plane of Q_j at least
  double highest = 0;                                     ///< and at most
  double turned = 0;                                      ///< |e.n_j| at most
  double mass = 1;                                        ///< T_j 1(c) at most
  double area = std::numeric_limits<double>::infinity();  ///< of Q_j at most
  /// Whether the foot of c in the plane of Q_j may lie in Q_j: it lies before the observer, n_P.n_j < 0, and
  /// may be no further than Q_j.
  bool rings = true;
};

/// sup |T_j w| / sup |w| by the distance of the panel.
/// Maths     |T_j w| <= (1 + a |e.n_j|/(|e| d)) T_j(|w| (r/(r-a))^4)(c), a = A |e|, r = |c-Q|, d the height
///           of c: |P-Q|^2 = (P-Q).(P-Q) has two factors of modulus >= r - a, n_P.(Q-P) does not change,
///           n_j.(P-Q) by A |e.n_j| at most. With D the distance of c from Q_j,
///             by the nearest point   T_j (r/(r-a))^4 <= (D/(D-a))^4 T_j 1
///           and, also where Q_j lies in a plane through c, since n_j.(P-Q) is at most h' = h + A |e.n_j|,
///           h the largest height of c, and n_P.(Q-P) at most r,
///             by rings               h' m Int_D^oo r^2/(r-a)^4 dr = h' m (1/g + a/g^2 + a^2/(3 g^3)),
///                                    g = D - a, on rings about the foot of c, m = 2; where that is not in
///                                    the convex Q_j, on half rings, m = 1
///             by the area            h' |Q_j| D/(pi (D-a)^4): r/(r-a)^4 falls
/// Result    rounded up; infinite where the ellipse comes near the panel
[[nodiscard]] double tube_bound(const ObserverLines& lines, double axis);

/// How far Q_j may slide where e is parallel to it, as a part of the distance of its points from sides.
/// Maths     P = p + i tau e with p real, and Q moves to Q + i tau phi e, phi = max(0, 1 - |Q-p|/r), r at
///           most the distance of p from all sides of elements of Q_j that are not parallel to e: Cauchy's
///           theorem on each line along e. Im(P-Q) = tau (1-phi) e is no longer than theta |p-Q|, theta =
///           |tau e|/r, so that |T_j w| <= (1+theta^2)^(1/2) (1-theta^2)^-2 sup |w| on the points that are
///           reached. r is Lipschitz: theta = b/(r^2 - a^2)^(1/2), a = A |e|, b = B |e|, holds on the
///           ellipse, r = `reach` taken at its middle
/// Result    theta, rounded up; infinite where it reaches 1
[[nodiscard]] double slide_part(double half, double reach, double axis);
/// sup |T_j w| / sup |w| where Q slides by such a part.
/// Result    rounded up; infinite where it is 1 or more
[[nodiscard]] double slide_bound(double part);

/// Where Q slides by a part theta <= 1, Legendre's polynomials of the parameters of its element grow by this
/// a degree at most.
/// Maths     both parameters stay in the lens between the circles through -1, 1 and +-i theta: the real
///           segment on either side of Q of 1/theta times the length that Q moves lies in the element. The
///           parameters are affine or quotients of affine functions of the way, which keep circles and angles
///           and take the segment to a part of [-1,1], that is seen under a smaller angle than [-1,1]. Of
///           points that see [-1,1] under one angle, |z-1| + |z+1| is largest at i theta: |P_i| <= (theta +
///           (1 + theta^2)^(1/2))^i
/// Result    rounded up
[[nodiscard]] inline double slid_growth(double theta) {
  return (theta + std::sqrt(1 + theta * theta)) * upward;
}

/// The modulus of the kernel's form at complex observers beside that at real ones, where Q turns.
/// Maths     P = x + t g and Q = x + e^(i alpha) q h with unit vectors g and h, 0 <= alpha <= arg t <= pi/2
///           and q >= k |t|, k >= 3. With tau = |t|, beta = arg t - alpha, c = g.h, m = 2 tau q, s = tau^2 +
///           q^2:  |(P-Q)^2|^2 = s^2 - m^2 sin^2 beta - 2 s m c cos beta + m^2 c^2, against (s - m c)^2 at t
///           = tau, alpha = 0. For c >= 0 the quotient is at least 1 - m^2/s^2 (in cos beta a parabola; its
///           least value (s^2-m^2)(1-c^2)/(s-mc)^2 grows with c until c = m/s, where it is 1, and from there
///           on beta = 0 is the worst). For c < 0 it falls with cos beta, and at beta = pi/2 with c, as long
///           as s^2 >= m^2 + m s: c = -1, (1 + m/s)^-2, which is less than 1 - m^2/s^2. Since m/s <=
///           2k/(k^2+1) <= 3/5:  |(P-Q)^2| is at least (k^2+1)/(k+1)^2 of its real value. Both scalar
///           products keep their moduli. Where alpha falls by a in all with log q, `logarithm` long, the area
///           element has the modulus |1 - i a/logarithm| times the real one, a <= pi/2: ((k+1)^2/(k^2+1))^2
///           (1 + (pi/2 / logarithm)^2)^(1/2)
/// Result    to be rounded up; 3 <= k, logarithm > 0
[[nodiscard]] double turned_kernel(double k, double logarithm);

/// Where Q turns, Legendre's polynomials grow by this a degree at most, along the edge and away from it.
/// Maths     A + sqrt(A^2 - 1): x no further than 1/2 from [-1,1], A = 3/2; y no further than 1 from -1,
///           A = 2
inline constexpr double turned_along = 2.6181;
inline constexpr double turned_across = 3.7321;

/// sup |T_j w| / sup |w| where Q_j touches the line from which the observers run, about which it turns.
/// Maths     P = x + t g, x on the edge and t complex with |t g| <= size, |arg t| <= pi/2. Q turns about x to
///           x + e^(i alpha) (Q-x), alpha = arg t for |Q-x| <= k size, falling to 0 with log|Q-x| at the
///           distance r = `reach`, up to which Q_j has no side of an element but the one along the edge
///           (Stokes: the border moves in the complex line of the edge, on which the form vanishes). Up to k
///           size the form keeps its modulus, and beyond it grows by f = turned_kernel at most; the mass of
///           what is further than (k-1) size is at most 2/(k-1), and that of all 1: |T_j w| <= (1 + 2/(k-1)
///           (f-1)) sup |w| on the points that are reached. The least of k = 3, 5, 9, 20
/// Result    rounded up; infinite where size is not small beside the reach
[[nodiscard]] double turn_bound(double size, double reach);

}  // namespace radcert
