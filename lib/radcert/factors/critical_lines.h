// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "radcert/factors/contour_edges.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert {

/// What an edge contributes to an exchange area, and the lines that matter for the rest of a piece of it.
struct EdgeContribution {
  BoundedDouble value;
  double error = 0;  ///< besides that of the value; infinite where nothing was bounded
  std::vector<std::size_t> sides;
  double cut = 0;  ///< where to cut the piece, if not 0: what is seen changes there
};

/// The lines through an edge of a contour and the sides of all else that stands about.
/// Maths     With X = X(t) on the edge, u its vector, n the receiver's normal, G(t) the part of the receiver
///           from which the edge's factor of visibility is 1 at X, an edge contributes
///             1/(2 pi) Int dt Int_G(t) n . ((X - P) x u) / |X - P|^2 dP
///               = -1/(4 pi) Int dt Int_dG(t) log |P - X|^2 u . dP,
///           for n x u lies in the receiver's plane and the integrand is a derivative of log |P - X|^2 along
///           it. dG(t) is where the line from X through a point Y(s) = C + s v of a side of receiver, source
///           or screen ends on the receiver. That line meets a convex polygon where its moments about all
///           sides, det(Y - X, C' - X, D' - X), have one sign, bilinear in t and s: for each t between those
///           s_c(t) = p(t) / (p(t) - q(t)), p and q linear, where a moment vanishes. What is seen of a side
///           is what is within the source, within the receiver and not within a screen. On it, with
///           m = (X - C) x v, h = n . (X - O), T = n x m, x = (P - X) . T, P(s) the end of the line,
///             Int log |P - X|^2 u . dP = F(s_1) - F(s_2),
///             F = (u . T) / |T|^2 (x (log |P - X|^2 - 2) + 2 h |m| atan(x / (h |m|)))
/// Source    ours; Stokes' theorem twice, as for Sparrow's contour form, with the contours that are seen
/// Requires  lengths up to about 1; BallPrecision does not matter
class CriticalLines {
public:
  CriticalLines(const ExactCorners& receiver, const ExactCorners& source,
                const std::vector<ExactCorners>& screens, const ContourEdge& edge,
                const ContourEdge::Part& part);
  ~CriticalLines();
  CriticalLines(CriticalLines&&) noexcept;
  CriticalLines& operator=(CriticalLines&&) noexcept;

  /// All sides, for the whole edge.
  [[nodiscard]] std::vector<std::size_t> sides() const;

  /// The contribution of t in [begin, end], `part.seen` times what is seen less `part.whole` times the whole.
  /// Theorem   The order of the s_c in the middle of [begin, end] gives a sum of F whose Taylor polynomial of
  ///           degree 7 is integrated; the remainder's coefficient is enclosed on [begin, end]. Where the
  ///           order of two s_c changes within, the sum is off by at most three times the integral over what
  ///           lies between the two.
  /// Proof     Whether a line is seen depends only on the set L of those s_c that are less than s. If no pair
  ///           that has changed its order lies about s, L is one of the first sets of the middle's order, and
  ///           the sum counts it as there. Else let k be the number of such pairs about s. Two neighbours of
  ///           the middle's order, the first not in L and the second in it, exist as long as k > 0;
  ///           exchanging them changes what is seen by at most 1, the sum's count by at most 2, since entries
  ///           and ends of what is seen take turns, and k by 1: the two differ by at most 3 k
  /// Requires  0 <= begin < end <= 1, multiples of 2^-50; sides: those of an interval around this one
  /// Result    |contribution - value| <= error + the value's own, together at most most_per_length (end -
  ///           begin): that alone where an s_c is not bounded, or changes of order leave more than `wanted`
  [[nodiscard]] EdgeContribution on(double begin, double end, const std::vector<std::size_t>& sides,
                                    double wanted) const;

  /// A bound of the contribution over the length of an interval of t, whatever is seen.
  /// Maths     |u| (A / pi)^(1/2): |n . ((X - P) x u)| <= |X - P| |u|, and Int dP / |X - P| over an area A is
  ///           largest for the disk about X's foot, 2 (pi A)^(1/2)
  [[nodiscard]] double most_per_length() const;

private:
  class Lines;
  std::unique_ptr<Lines> lines_;
};

}  // namespace radcert
