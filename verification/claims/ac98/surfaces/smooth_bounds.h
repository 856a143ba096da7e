// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "radcert/enclosure/demand.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// A smooth surface with the least constants of (5) and (6), enclosed from above and from below.
/// Maths     cosine = sup |cos theta_P|/|P-Q|, kernel = sup |G(P,Q)| over P != Q of the surface. Both suprema
///           are limits Q -> P or values of a continuous function on a compact set of (P, direction):
///           two_piece(p), roof: with RoofPair and e = 0, where both are largest, bend_p/(stretch_p chord)
///           and bend_p bend_q/(stretch_p stretch_q chord^2), maxima over 0 <= x, xi <= 1. Ellipsoid with
///           half axes a <= b <= c, A = diag(a^-2, b^-2, c^-2), Q = P + h: n_P = -AP/|AP| and 0 = 2 h.AP +
///           h.Ah give (Q-P).n_P = h.Ah/(2|AP|) and the like at Q: with e = h/|h|  e.Ae/(2|AP|) <= c/(2a^2)
///           and (e.Ae)^2/(4 |AP| |AQ|) <= c^2/(4a^4), reached as Q -> P = (0,0,c) along the axis of a
/// Source    [ac98, (5)-(6)]
/// Result    cosine and kernel: upper bounds by branch and bound, of a small radius, lower ends included;
///           cosine_pair, kernel_pair: one pair of points through the charts of the library, P != Q
struct SmoothBounds {
  std::string name;
  Ball cosine;
  Ball kernel;
  Ball cosine_pair;
  Ball kernel_pair;
};
[[nodiscard]] SmoothBounds roof_bounds(int p, double radius);
[[nodiscard]] SmoothBounds ellipsoid_bounds(const Rational& a, const Rational& b, const Rational& c,
                                            double radius);

/// The largest kernel between the square and the roof of two_piece(p).
/// Maths     z (z + p xi^(p-1) (xi - x))/(stretch (d^2 + z^2)^2), z = 2 - xi^p, at e = 0
/// Source    [ac98, (2), (94)]
/// Requires  p >= 2
/// Result    enclosed, over all pairs
[[nodiscard]] Ball largest_kernel_between_the_pieces(int p, double radius);

}  // namespace radcert::verification::ac98
