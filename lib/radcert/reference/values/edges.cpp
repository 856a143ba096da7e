// SPDX-License-Identifier: GPL-3.0-or-later

// Exponents of the solution at edges of any angle: the symbol's closed form, and its integral.
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/work_limit.h"
#include "radcert/reference/edge_symbol_integral.h"
#include "radcert/reference/values/families.h"

namespace radcert::reference::values {
namespace {

constexpr int digits_of_a_search = 100;
const WorkLimit halvings("reference/values/edges: halvings towards an exponent", 60, 1,
                         "refused: the sign of the symbol was not decided");

Outcome<Ball> by_closed_form(const Arguments& a, const Rational& radius) {
  return smallest_edge_exponent(edge_of_degrees(a[0], a[1], a[2]), radius);
}

/// R k(b) - 1 increases in 0 < b < 1 from R cos^2(w/2) - 1 < 0 to infinity; from a coarse bracket Newton's
/// method.
Outcome<Ball> by_integral_of_symbol(const Arguments& a, const Rational& radius) {
  const Rational product = a[1] * a[2];
  Rational lower = 0;
  Rational upper = 1;
  {
    const BallPrecision precision(128);
    const EdgeSymbolIntegral symbol(Ball::pi() * Ball(a[0] / Rational(180)));
    // The distance to the pole at 1, relative to itself.
    for (long halved = 0; upper - lower > (Rational(1) - lower) / Rational(16); ++halved) {
      const Rational middle = (lower + upper) / Rational(2);
      const Outcome<ComplexBall> value = symbol.at(ComplexBall(middle), 0, 1e-6);
      if (!value) return because(value.reason());
      const Ball f = sqrt(Ball(product)) * value->real() - Ball(1);
      if (halved == halvings.value() || !(certainly_positive(f) || certainly_negative(f)))
        return because("the sign at " + middle.to_text() + " was not decided");
      (certainly_positive(f) ? upper : lower) = middle;
    }
  }
  // The ball about the disk is a rounding larger.
  const Outcome<ComplexBall> zero =
      edge_zero_near(a[0], product, 1, ComplexBall((lower + upper) / Rational(2)), Rational(15, 16) * radius);
  if (!zero) return because(zero.reason());
  return zero->real();
}

}  // namespace

Theme edges() {
  const ValueParameter reflectivity = strictly_between("rho", "1/2", 0, 1);
  ValueParameter other = reflectivity;
  other.name = "rho_other";
  Theme theme;
  theme.families = {
      {.name = "edge_exponent",
       .summary =
           "the smallest exponent b with which radiosity behaves like u_0 + c r^b beside an edge at which "
           "two half planes meet at an angle, in degrees",
       .formula = "sqrt(rho rho_other) x pi b (b+1)/sin(pi b) F(-b, b+1; 2; x) = 1, x = cos^2(angle/2)",
       .source = "Mellin symbol of the operator between two half planes; Gradshteyn and Ryzhik 3.252.10",
       .parameters = {strictly_between("angle", "90", 0, 180), reflectivity, other},
       .route = {.how = "Newton's method in balls on the symbol by Gauss's hypergeometric series",
                 .enclose = by_closed_form},
       .second_route = {.how = "Rouche's theorem on the symbol as a series and an enclosed integral",
                        .enclose = by_integral_of_symbol,
                        .most_digits = digits_of_a_search}},
  };
  const auto name = [&](int angle) {
    theme.named.push_back({"edge_exponent_" + std::to_string(angle) + "_degrees",
                           "edge_exponent",
                           {angle, Rational(1, 2), Rational(1, 2)}});
  };
  for (const int angle : {30, 45, 60, 90, 120, 135, 150}) name(angle);
  return theme;
}

}  // namespace radcert::reference::values
