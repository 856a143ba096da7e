// SPDX-License-Identifier: GPL-3.0-or-later

// (26): in polar coordinates the integrand is z rho/(rho^2 + z^2), the derivative of (z/2) log(rho^2 + z^2)
// by rho; the angle runs over pi. The sentence after it: the unit square contains the half-disk of radius r =
// min(x, 1-x) around (x,0) and lies in that of radius sqrt 2, and the integrand is positive. So, with (24)
// and s = -z/(2w) {...}, -pi z/(4w) * 2 <= s <= 0 for u = eta
//     (26)_r / 2 + s <= Ku <= (26)_sqrt(2) / 2 + s,
// and Ku/(z log z) -> -pi/2: half of what the sentence says, as the 1/2 before the last integral of (24) was
// lost. More exactly, as (26)_r = pi z log(1/z) + (pi z/2) log(r^2 + z^2) and s >= -z/2,
//     (pi/2) log r - 1/2 <= Ku/z - (pi/2) log(1/z) <= (pi/4) log 3    for all 0 < x, z < 1.
// Ku tends to 0 with z, and its difference quotient Ku/z grows beyond all bounds: no derivative by z at the
// edge, at any x.
//
// Checked      equation_26: for all r and z at once the antiderivative, as an identity of rational functions
//              of degree 4 at most, with (log g)' = g'/g; the formula and the library's against enclosures by
//              Gauss rules, at points and on boxes. equation_26_dominating_term: Ku/(-pi z log z) between the
//              two half-disks, at z = 2^-1000000, and the coefficient of z log z from Ku at z and z/2;
//              instead of it -(pi/2) z log z, and -pi z log z for the last integral of (24) by itself.
//              equation_26_not_c1: the bound of atan that gives s >= -z/2, by its derivative; the bounds,
//              which hold for all x and z by (24) and (26), at points down to z = 2^-1000000; the coefficient
//              of z log z.
// Not checked  nothing is left out.

#include "radcert/closed_form/two_squares.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/unit_square_integrals.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

Ball printed(const Ball& r, const Ball& z, long coefficient) {
  return Ball::pi() * z / Ball(2) * log(r * r + z * z) - Ball(coefficient) * Ball::pi() * z * log(z);
}

// Disjoint enclosures of formula and integral, on boxes that cover 1/4 <= r <= 1/2, 1/4 <= z <= 3/4.
Rational disjoint_boxes(long coefficient, int per_half) {
  const BallPrecision precision(64);
  constexpr int points = 12;
  const Ball half(Rational(1, 4L * per_half));
  long count = 0;
  for (int i = 0; 2 * i < per_half; ++i)
    for (int j = 0; j < per_half; ++j) {
      const Ball r = widened(Ball(Rational(1, 4) + Rational(2L * i + 1, 4L * per_half)), half);
      const Ball z = widened(Ball(Rational(1, 4) + Rational(2L * j + 1, 4L * per_half)), half);
      if (!overlaps(half_disk_integral(r, z, points), printed(r, z, coefficient))) ++count;
    }
  return {count};
}

// Ku for u = eta between half of (26) for the half-disk inside and half of (26) for the one around, less what
// (24) has beside.
Ball between_half_disks(const Ball& x, const Ball& z) {
  const Ball w = sqrt(Ball(1) + z * z);
  const Ball part = -z / (Ball(2) * w) * (atan(x / w) + atan((Ball(1) - x) / w));
  const Ball inside = printed(min(x, Ball(1) - x).lower(), z, 1);
  const Ball around = printed(sqrt(Ball(2)), z, 1);
  return part + hull(inside, around) / Ball(2);
}

// c of Ku = ... + c z log z + O(z^3), from the growth of Ku/z when z is halved.
template <class Value>
Ball coefficient(const Value& value, const Ball& z) {
  const Ball half = z / Ball(2);
  return (value(z) / z - value(half) / half) / log(Ball(2));
}

// Ku/z - (pi/2) log(1/z) for one of the three densities.
template <class Value>
Ball beyond_the_logarithm(const Value& value, const Ball& z) {
  return value(z) / z - Ball::pi() / Ball(2) * log(reciprocal(z));
}

}  // namespace

Finding equation_26(const Bench& bench) {
  Finding finding;
  const auto slope_with = [](long divisor) {
    return [divisor](const Rational&, const Rational& rho, const Rational& z) {
      const Dual<Rational> at(rho, 1, 0);
      const Dual<Rational> g = at * at + Dual<Rational>(z * z);
      return z / divisor * g.by_s / g.value;
    };
  };
  const auto integrand = [](const Rational&, const Rational& rho, const Rational& z) {
    return z * rho / (rho * rho + z * z);
  };
  finding.require("points where d/drho (z/2) log(rho^2 + z^2) differs from z rho/(rho^2 + z^2)", IsExactly{0},
                  differing_points(slope_with(2), integrand));
  finding.control("points where d/drho z log(rho^2 + z^2) differs from it", IsExactly{0},
                  differing_points(slope_with(1), integrand));
  for (const auto& [radius, height] :
       {std::pair<Rational, Rational>{{1, 2}, {1, 3}}, {{1, 3}, {1, 20}}, {{1, 100}, {1, 2}}}) {
    const BallPrecision precision(192);
    const Ball r(radius);
    const Ball z(height);
    const std::string at = ", r = " + radius.to_text() + ", z = " + height.to_text();
    const AgreesWith integral{.value = half_disk_integral(r, z, 60), .within = 1e-30};
    finding.require("(26) as printed against its integral" + at, integral, printed(r, z, 1));
    finding.require("(26) of the library against its integral" + at, integral,
                    inverse_square_over_half_disk(r, z));
    finding.control("(26) with 2 pi z log z" + at, integral, printed(r, z, 2));
  }
  const int per_half = bench.budget == Budget::quick ? 16 : bench.budget == Budget::standard ? 32 : 64;
  const std::string boxes = "disjoint enclosures, boxes of width 1/" + std::to_string(2 * per_half);
  finding.require("(26): " + boxes, IsExactly{0}, disjoint_boxes(1, per_half));
  finding.control("(26) with 2 pi z log z: " + boxes, IsExactly{0}, disjoint_boxes(2, per_half));
  return finding;
}

Finding equation_26_dominating_term(const Bench&) {
  const BallPrecision precision(320);
  Finding finding;
  const Ball x(Rational(1, 3));
  const Ball tiny = power(Ball(2), -1000000);
  const Ball said = -Ball::pi() * tiny * log(tiny);
  const AgreesWith whole{.value = Ball(1), .within = 1e-3};
  const std::string place = ", x = 1/3, z = 2^-1000000";
  finding.require("Ku/(-pi z log z), u = eta, between two half-disks" + place, whole,
                  between_half_disks(x, tiny) / said);
  finding.require("Ku/(-pi z log z), u = eta, by the closed form" + place, whole,
                  TwoSquares<Ball>(x, tiny).distance() / said);
  const Ball z = power(Ball(2), -60);
  const auto of_distance = [&](const Ball& at) { return TwoSquares<Ball>(x, at).distance(); };
  const auto of_offset = [&](const Ball& at) { return TwoSquares<Ball>(x, at).offset(); };
  const AgreesWith minus_pi{.value = -Ball::pi(), .within = 1e-20};
  finding.require("coefficient of z log z, u = eta, x = 1/3", minus_pi, coefficient(of_distance, z));
  finding.control("Ku/(-pi z log z), u = xi - x" + place, whole, TwoSquares<Ball>(x, tiny).offset() / said);
  finding.control("coefficient of z log z, u = xi - x, x = 1/3", minus_pi, coefficient(of_offset, z));
  // What -pi z log z dominates is the last integral of (24), which stands in Ku with the factor 1/2.
  const auto of_last = [&](const Ball& at) { return TwoSquares<Ball>(x, at).inverse_square(); };
  finding.instead("coefficient of z log z of the last integral of (24) by itself, x = 1/3", minus_pi,
                  coefficient(of_last, z));
  finding.instead("the last integral of (24)/(-pi z log z)" + place, whole, of_last(tiny) / said);
  const Ball half = said / Ball(2);
  finding.instead("Ku/(-(pi/2) z log z), u = eta, between two half-disks" + place, whole,
                  between_half_disks(x, tiny) / half);
  finding.instead("Ku/(-(pi/2) z log z), u = eta, by the closed form" + place, whole,
                  TwoSquares<Ball>(x, tiny).distance() / half);
  const Ball found = coefficient(of_distance, z);
  finding.show(proved(found));
  return finding;
}

Finding equation_26_not_c1(const Bench&) {
  const BallPrecision precision(320);
  Finding finding;
  // atan t <= t for t >= 0, and w^2 = 1 + z^2 >= 1: what (24) has beside its integral is -z/2 at least.
  const auto slope = [](const Rational&, const Rational& t, const Rational&) { return 1 - 1 / (1 + t * t); };
  const auto square = [](const Rational& sign) {
    return [sign](const Rational&, const Rational& t, const Rational&) { return t * t / (1 + sign * t * t); };
  };
  finding.require("points where the derivative of t - atan t differs from t^2/(1 + t^2)", IsExactly{0},
                  differing_points(slope, square(1)));
  finding.control("points where it differs from t^2/(1 + t^2/25)", IsExactly{0},
                  differing_points(slope, square(Rational(1, 25))));
  const Ball growth = Ball::pi() / Ball(2);
  for (const Rational& at : {Rational(1, 2), Rational(1, 7), Rational(99, 100)}) {
    const Ball x(at);
    const Ball r = min(x, Ball(1) - x);
    const Ball least = growth * log(r) - Ball(Rational(1, 2));
    const Ball largest = growth / Ball(2) * log(Ball(3));
    const EdgeExpansion<Ball> expansion = TwoSquares<Ball>::expansion_of_distance(x);
    const auto value = [&](const Ball& where) { return TwoSquares<Ball>(x, where).distance(); };
    for (const int halvings : {1, 20, 60, 1000000}) {
      const Ball z = power(Ball(2), -halvings);
      const std::string place = ", x = " + at.to_text() + ", z = 2^-" + std::to_string(halvings);
      const Ball beyond = beyond_the_logarithm(value, z);
      finding.require("(pi/2) log r - 1/2 less Ku/z - (pi/2) log(1/z)" + place, AtMost{},
                      proved(least - beyond));
      finding.require("Ku/z - (pi/2) log(1/z) less (pi/4) log 3" + place, AtMost{}, proved(beyond - largest));
      if (halvings >= 20)
        finding.control(
            "the first for u = xi - x" + place, AtMost{},
            proved(least - beyond_the_logarithm(
                               [&](const Ball& where) { return TwoSquares<Ball>(x, where).offset(); }, z)));
    }
    for (const int halvings : {20, 60}) {
      const Ball z = power(Ball(2), -halvings);
      const auto smooth = [&](const Ball& where) {
        return TwoSquares<Ball>(x, where).inverse_square_outside((Ball(1) - x) * x);
      };
      const std::string place = ", x = " + at.to_text() + ", z = 2^-" + std::to_string(halvings);
      const Ball within = Ball(2) * expansion.cubic_bound * z * z;
      const AgreesWith halving{.value = -growth, .within = within.upper_double()};
      finding.require("coefficient of z log z" + place, halving, coefficient(value, z));
      finding.control("the same for the integral (25) over R_2" + place, halving, coefficient(smooth, z));
    }
  }
  finding.show(proved(growth));
  return finding;
}

}  // namespace radcert::verification::ac98
