// SPDX-License-Identifier: GPL-3.0-or-later

// With D = s^2 + eta^2 + z^2, s = xi - x: -z s/(2D) is an antiderivative of z eta s/D^2 by eta, and (z/4) log
// g, g = (s^2 + z^2)/(s^2 + 1 + z^2), one of its difference between eta = 1 and eta = 0, by s. The ends s =
// -x and s = 1 - x give (23). Near the edge: with a = 1 - x and q = z^2, (z/4) log g(a)/g(x) has the
// logarithm's derivative 1/((a^2+q)(a^2+1+q)) - 1/((x^2+q)(x^2+1+q)) by q, and each of these falls with q, so
// that replacing q by 0 changes it by no more than z^3/4 times the larger of 1/(a^2 (a^2+1)) and 1/(x^2
// (x^2+1)).
//
// Checked      For all x and z of 0 < x, z < 1 at once: both antiderivatives and the derivative by q, as
//              identities of rational functions, with (log g)' = g'/g. Degrees: 4 at most in each variable
//              over D^2 and (s^2 + z^2)(s^2 + 1 + z^2), and over the four factors of the quotient. Beside
//              that enclosures of the double integral, at points and on boxes, and the bound near the edge,
//              which holds for all x and z, at points down to z = 2^-60. That both sides have one derivative
//              by x, and are 0 at x = 1/2.
// Not checked  the remark that x = 0 and x = 1 have problems: (z/4) log of the quotient tends to infinity
// there.

#include "radcert/closed_form/two_squares.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/printed_integral.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// The quotient of (23).
Ball quotient(const Ball& x, const Ball& z) {
  const Ball a = Ball(1) - x;
  return (a * a + z * z) * (x * x + Ball(1) + z * z) / ((a * a + Ball(1) + z * z) * (x * x + z * z));
}

Ball printed(const Ball& x, const Ball& z, long divisor) { return z / Ball(divisor) * log(quotient(x, z)); }

template <class R>
R inner(const R& s, const R& eta, const R& z) {
  return -z * s / (R(2) * (s * s + eta * eta + z * z));
}

Rational integrand(const Rational& s, const Rational& eta, const Rational& z) {
  const Rational d = s * s + eta * eta + z * z;
  return z * eta * s / (d * d);
}

Rational inner_slope(const Rational& s, const Rational& eta, const Rational& z) {
  return inner(Dual<Rational>(s), Dual<Rational>(eta, 1, 0), Dual<Rational>(z)).by_s;
}

Rational between_the_ends(const Rational& s, const Rational&, const Rational& z) {
  return inner(s, Rational(1), z) - inner(s, Rational(0), z);
}

// d/ds (z/divisor) log g.
Rational outer_slope(const Rational& s, const Rational& z, long divisor) {
  const Dual<Rational> at(s, 1, 0);
  const Dual<Rational> g = (at * at + Dual<Rational>(z * z)) / (at * at + Dual<Rational>(1 + z * z));
  return z / divisor * g.by_s / g.value;
}

// d/dq log of the quotient, with the squares A = (1-x)^2 and B = x^2 for s and eta.
Rational quotient_slope(const Rational& a, const Rational& b, const Rational& at) {
  const Dual<Rational> q(at, 1, 0);
  const Dual<Rational> g = (a + q) * (1 + b + q) / ((1 + a + q) * (b + q));
  return g.by_s / g.value;
}

Rational printed_quotient_slope(const Rational& a, const Rational& b, const Rational& q,
                                const Rational& sign) {
  return 1 / ((a + q) * (a + 1 + q)) + sign / ((b + q) * (b + 1 + q));
}

Rational shifted(const Rational& s) { return s + 2; }  // the grid's s is -3/4 at least

}  // namespace

Finding equation_23(const Bench& bench) {
  Finding finding;
  finding.require("points where d/deta (-z s/(2D)) differs from z eta s/D^2", IsExactly{0},
                  differing_points(inner_slope, integrand));
  const auto slope_with = [](long divisor) {
    return [divisor](const Rational& s, const Rational&, const Rational& z) {
      return outer_slope(s, z, divisor);
    };
  };
  finding.require("points where d/ds (z/4) log g differs from -z s/(2D) between the ends", IsExactly{0},
                  differing_points(slope_with(4), between_the_ends));
  finding.control("points where d/ds (z/2) log g differs from it", IsExactly{0},
                  differing_points(slope_with(2), between_the_ends));
  // The ends: the integral from s = -x to 1 - x has the derivative g(-x) - g(1-x) by x, and is 0 at x = 1/2,
  // as (23) is.
  const auto by_x = [](long divisor) {
    return [divisor](const Rational& at, const Rational&, const Rational& z) {
      const Rational x = shifted(at);
      return outer_slope(1 - x, z, divisor) * -1 + outer_slope(-x, z, divisor);
    };
  };
  const auto printed_by_x = [](const Rational& at, const Rational&, const Rational& z) {
    const Dual<Rational> x(shifted(at), 1, 0);
    const Dual<Rational> a = Dual<Rational>(Rational(1)) - x;
    const Dual<Rational> q(z * z);
    const Dual<Rational> one(Rational(1));
    const Dual<Rational> g = (a * a + q) * (x * x + one + q) / ((a * a + one + q) * (x * x + q));
    return z / 4 * g.by_s / g.value;
  };
  finding.require("points where the derivative of (23) by x differs from that of the integral", IsExactly{0},
                  differing_points(printed_by_x, by_x(4)));
  finding.control("points where it differs from twice that", IsExactly{0},
                  differing_points(printed_by_x, by_x(2)));
  require_values(finding, bench,
                 {.name = "(23)",
                  .integral = &UnitSquareIntegrals::offset,
                  .printed = [](const Ball& x, const Ball& z) { return printed(x, z, 4); },
                  .library = [](const Ball& x, const Ball& z) { return TwoSquares<Ball>(x, z).offset(); },
                  .wrong = [](const Ball& x, const Ball& z) { return printed(x, z, 2) + z / Ball(20); },
                  .mistake = "z/2 for z/4, and z/20 added so that x = 1/2 sees it"});
  return finding;
}

Finding equation_23_near_edge(const Bench&) {
  const BallPrecision precision(320);
  Finding finding;
  const auto slope_with = [](const Rational& sign) {
    return [sign](const Rational& s, const Rational& eta, const Rational& z) {
      return printed_quotient_slope(shifted(s), eta, z, sign);
    };
  };
  const auto slope = [](const Rational& s, const Rational& eta, const Rational& z) {
    return quotient_slope(shifted(s), eta, z);
  };
  finding.require("points where the logarithm's derivative by z^2 differs from 1/(A (A+1)) - 1/(B (B+1))",
                  IsExactly{0}, differing_points(slope, slope_with(-1)));
  finding.control("points where it differs from the sum", IsExactly{0},
                  differing_points(slope, slope_with(1)));
  // With A = s^2 for each of the two terms, q = z^2: each is largest at q = 0, so that the difference of the
  // two is at most the larger of them there, and its integral over 0 to z^2 at most z^2 times that.
  const auto fall = [](const Rational& sign) {
    return [sign](const Rational&, const Rational& a, const Rational& q) {
      return q * (2 * a + 1 + sign * q) / (a * (a + 1) * (a + q) * (a + 1 + q));
    };
  };
  const auto difference = [](const Rational&, const Rational& a, const Rational& q) {
    return 1 / (a * (a + 1)) - 1 / ((a + q) * (a + 1 + q));
  };
  finding.require("points where 1/(A (A+1)) falls by another amount than q (2A+1+q)/(A (A+1) (A+q) (A+1+q))",
                  IsExactly{0}, differing_points(difference, fall(1)));
  finding.control("points where it falls by another amount than q (2A+1-q)/(A (A+1) (A+q) (A+1+q))",
                  IsExactly{0}, differing_points(difference, fall(-1)));
  for (const Rational& at : {Rational(1, 2), Rational(1, 3), Rational(9, 10), Rational(1, 100)})
    for (const int halvings : {8, 60}) {
      const Ball x(at);
      const Ball z = power(Ball(2), -halvings);
      const Ball a = Ball(1) - x;
      const Ball near = log(a * a * (x * x + Ball(1)) / ((a * a + Ball(1)) * (x * x)));
      const Ball bound =
          z * z * max(reciprocal(a * a * (a * a + Ball(1))), reciprocal(x * x * (x * x + Ball(1))));
      const std::string place = ", x = " + at.to_text() + ", z = 2^-" + std::to_string(halvings);
      const Ball exact = Ball(4) / z * TwoSquares<Ball>(x, z).offset();
      finding.require("4 Ku/z against the logarithm of the text" + place,
                      AgreesWith{.value = near, .within = bound.upper_double()}, exact);
      finding.control("4 Ku/z for u = eta" + place, AgreesWith{.value = near, .within = bound.upper_double()},
                      Ball(4) / z * TwoSquares<Ball>(x, z).distance());
    }
  return finding;
}

}  // namespace radcert::verification::ac98
