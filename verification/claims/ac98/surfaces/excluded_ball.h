// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::verification::ac98 {

/// The parts of the proof of Lemma 2.1 at the tip P = (0,0,c) of an ellipsoid: Int G over T_e, over S without
/// T_e, and over U_e.
/// Maths     T_e = {Q in S : |Q-P| <= e}, U_e = {Q inside : |Q-P| = e} with the normal towards P.
///           T: Q = D u, u = (sin psi cos phi, sin psi sin phi, cos psi), q = sin^2(psi/2), m = a^2 cos^2 phi
///           + b^2 sin^2 phi: G dS = (a b c^2/2) dq dphi/(m + (c^2 - m) q)^2, |Q-P|^2 = 4q(m + (c^2 - m) q),
///           so that the rim is q = e^2/(2(m + (m^2 + (c^2 - m) e^2)^(1/2))), and Int_T G = 2 a b c^2 Int
///           q^2/(m e^2) dphi, Int_(S-T) G = (a b/2) Int (1 - q)/(m + (c^2 - m) q) dphi. U: Q - P = e w, G dS
///           = w_3 dw, w_3 along n_P. With k = cos^2 phi/a^2 + sin^2 phi/b^2 the rim is w_3 = r = e c k/(1 +
///           (1 + e^2 k (c^2 k - 1))^(1/2)), the zero of 2 w_3/c - e (k (1 - w_3^2) + w_3^2/c^2), and Int_U G
///           = Int (1 - r^2)/2 dphi. The angles of T are parameters, those of U are true: the two share no
///           formula
/// Source    [ac98, (8)-(12)]
/// Requires  a, b, c > 0, 0 < radius < 2c
/// Result    enclosed at the current precision to within `error`
class EllipsoidTip {
public:
  EllipsoidTip(const Rational& a, const Rational& b, const Rational& c) : a_(a), b_(b), c_(c) {}

  [[nodiscard]] Ball over_cap(const Rational& radius, double error) const;
  [[nodiscard]] Ball over_rest(const Rational& radius, double error) const;
  [[nodiscard]] Ball over_sphere(const Rational& radius, double error) const;

  /// Enclosures for all 0 < e <= radius at once, by the values on so many panels of phi.
  [[nodiscard]] Ball cap_over_square(const Rational& radius, long panels) const;   ///< Int_T G / e^2
  [[nodiscard]] Ball lack_over_square(const Rational& radius, long panels) const;  ///< (pi - Int_U G) / e^2
  [[nodiscard]] Ball shadow_over_square(const Rational& radius,
                                        long panels) const;  ///< area of T projected along n_P, / e^2

private:
  Rational a_;
  Rational b_;
  Rational c_;
};

}  // namespace radcert::verification::ac98
