// SPDX-License-Identifier: GPL-3.0-or-later

// The symbol of K at an edge and its zeros, by two routes: Gauss's series with Newton's method, and the
// integral with Rouche's theorem.
//
// Checked      edge_symbol: the closed form against the integral, continued by its series, at four angles and
//              four exponents, in the strip of convergence and beyond, complex ones too. Rejected: the angle
//              that the other sides of the faces make, x = sin^2(w/2).
//              edge_exponents_certified: the digits of the smallest exponent at right angles, and at seven
//              angles all exponents up to 9/2 found again. Rejected: those of other reflectivities.
//              corner_exponents_certified: the exponent at the cube's corner lies within 0.01 of what
//              Nystrom's method finds, and below that of the edges. Rejected: that of another reflectivity.
// Not checked  other angles and exponents; the theorem that no exponent is left out, whose proof stands in
//              edge_exponents.h and which tests hold against the argument principle.

#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/edge/corner_enclosure.h"
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/contract.h"
#include "radcert/reference/edge_symbol_integral.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::radcert {
namespace {

Ball radians(const Rational& degrees) { return Ball::pi() * Ball(degrees / Rational(180)); }

std::string text_of(const ComplexBall& b) {
  std::string text = b.real().to_text(6);
  if (!b.is_real()) text += " + " + b.imag().to_text(6) + " i";
  return text;
}

Ball distance(const ComplexBall& a, const ComplexBall& b) {
  return abs(a.real() - b.real()) + abs(a.imag() - b.imag());
}

Ball at_right_angles(const Rational& rho) {
  return smallest_edge_exponent(edge_of_degrees(90, rho, rho), Rational(1) / power(Rational(10), 20)).value();
}

}  // namespace

Finding edge_symbol(const Bench&) {
  const BallPrecision precision(160);
  Finding finding;
  const AgreesWith zero{.value = Ball(0), .within = 1e-15};
  const std::vector<ComplexBall> exponents{{Ball(Rational(1, 3)), Ball(0)},
                                           {Ball(Rational(-3, 2)), Ball(Rational(1, 2))},
                                           {Ball(Rational(5, 2)), Ball(0)},
                                           {Ball(Rational(7, 2)), Ball(Rational(3, 2))}};
  for (const long degrees : {20L, 60L, 90L, 150L}) {
    const EdgeSymbol symbol(radians(degrees));
    const EdgeSymbol of_the_other_side(radians(180 - degrees));
    const reference::EdgeSymbolIntegral integral(radians(degrees));
    for (const ComplexBall& b : exponents) {
      const ComplexBall k = integral.at(b, 0, 1e-20).value();
      const std::string where = std::to_string(degrees) + " degrees, b = " + text_of(b);
      finding.require("k by the series less k by the integral, " + where, zero, distance(symbol(b), k));
      if (degrees == 60)
        finding.control("the same with x = sin^2(w/2), " + where, zero, distance(of_the_other_side(b), k));
    }
  }
  return finding;
}

Finding edge_exponents_certified(const Bench&) {
  const BallPrecision precision(128);
  Finding finding;
  finding.require(
      "b at 90 degrees, rho = 1/2",
      LiesIn{Rational::parse("0.7633620752195").value(), Rational::parse("0.7633620752196").value()},
      at_right_angles(Rational(1, 2)));
  finding.require("b at 90 degrees, rho = 9/10",
                  LiesIn{Rational::parse("0.58199259417").value(), Rational::parse("0.58199259418").value()},
                  at_right_angles(Rational(9, 10)));
  finding.control(
      "b at 90 degrees, rho = 3/4, as that of 1/2",
      LiesIn{Rational::parse("0.7633620752195").value(), Rational::parse("0.7633620752196").value()},
      at_right_angles(Rational(3, 4)));
  const AgreesWith zero{.value = Ball(0), .within = 1e-14};
  const Rational radius = Rational(1) / power(Rational(10), 16);
  for (const long degrees : {30L, 45L, 60L, 90L, 120L, 135L, 150L}) {
    const Rational rho = degrees == 90 ? Rational(9, 10) : Rational(1, 2);
    const Edge edge = edge_of_degrees(degrees, rho, rho);
    for (const EdgeExponent& exponent : edge_exponents(edge, Rational(9, 2), 20).value()) {
      const std::string which = (exponent.symmetric ? "symmetric, " : "antisymmetric, ") +
                                std::to_string(degrees) + " degrees, rho = " + rho.to_text() +
                                ", b = " + text_of(exponent.value);
      const ComplexBall again =
          reference::edge_zero_near(degrees, rho * rho, exponent.symmetric ? 1 : -1, exponent.value, radius)
              .value();
      finding.require("b by the series less b by the integral, " + which, zero,
                      distance(exponent.value, again));
      if (degrees == 60 && exponent.symmetric) {
        const ComplexBall other =
            reference::edge_zero_near(degrees, Rational(3, 10), 1, exponent.value, radius).value();
        finding.control("the same for the product of reflectivities 3/10, " + which, zero,
                        distance(exponent.value, other));
      }
    }
  }
  finding.show(Approximation{
      .value = at_right_angles(Rational(1, 2)).to_double(), .radius = 1e-15, .guaranteed = true});
  return finding;
}

Finding corner_exponents_certified(const Bench&) {
  Finding finding;
  struct Corner {
    Rational rho;
    LiesIn where;
  };
  const auto three = [](const Rational& rho) {
    return enclosed_octant_exponent({rho, rho, rho}, Rational(1, 150)).value();
  };
  const std::vector<Corner> corners{{Rational(1, 2), {Rational(735, 1000), Rational(755, 1000)}},
                                    {Rational(9, 10), {Rational(446, 1000), Rational(466, 1000)}}};
  for (const auto& [rho, where] : corners) {
    const Ball g = three(rho);
    const std::string with = ", rho = " + rho.to_text();
    finding.require("g" + with, where, g);
    finding.require("b of the edges less g" + with, LiesIn{0, 1}, at_right_angles(rho) - g);
    if (rho == Rational(1, 2)) finding.show(proved(g));
  }
  finding.control("g, rho = 3/4, as that of 1/2", corners[0].where, three(Rational(3, 4)));
  return finding;
}

}  // namespace radcert::verification::radcert
