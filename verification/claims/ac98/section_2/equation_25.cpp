// SPDX-License-Identifier: GPL-3.0-or-later

// In polar coordinates around (x,0), with R(theta) the distance to the sides of the square and 0 < r <=
// min(x, 1-x), the integral over R_2 is
//     S = (z/2) Int_0^pi log[(R^2 + z^2)/(r^2 + z^2)] dtheta.
// Each side is run along at a constant speed: theta = atan(s/a), R^2 = a^2 + s^2 on the sides at the distance
// a = x and a = 1-x, and theta = pi/2 - atan(a s), R^2 = 1 + a^2 s^2 on the parts of the far side, 0 <= s <=
// 1, so that with y = z^2
//     S/z = (1/2) sum_a Int_0^1 {a log(a^2 + s^2 + y)/(a^2 + s^2) + a log(1 + a^2 s^2 + y)/(1 + a^2 s^2)} ds
//           - (pi/2) log(r^2 + y).
// For all 0 < x < 1, all such r and all y > -r^2 the denominators and the arguments of log are positive, s
// from 0 to 1 and beyond: S/z is an analytic function of x and y, hence S one of x and z, continued to z = 0
// and below. As a power series in z
//     S = sum_k (-1)^k z^(2k+1) M_k(x),  M_0 = Int log(R/r) dtheta,
//     M_k = Int (r^(-2k) - R^(-2k)) dtheta/(2k),  0 <= M_k <= pi r^(-2k)/(2k),
// where R cos theta is a over the angle atan(1/a) and 1 over atan(a), so that M_k for k >= 1 is made of Int
// cos^(2k), and M_0' = atan(1/x)/x - atan(1/(1-x))/(1-x).
//
// Checked      For all x, r and y: the antiderivative in the distance, both angles' derivatives, and that
//              denominators and arguments are positive, identities of rational functions; rejected for a
//              half-disk that is wider than the distance to a side, and for the whole square, r = 0. The
//              integrals above, enclosed, against the library's S. S(x,z)/z - S(x,z/2)/(z/2), in which M_0
//              cancels, against the terms k >= 1 with a bound for the rest: with S from (26) and an enclosure
//              of the integral over the whole square that knows no closed form, and with the library's S
//              close to z = 0. The integral over the whole square, which is not smooth, is rejected. M_0'
//              against the difference of S/z over a short step of x.
// Not checked  that the integral over 0 <= s <= 1 of an analytic function of x, y and s is one of x and y.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "radcert/enclosure/interval_integral.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/unit_square_integrals.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// Int_0^phi cos^(2k) dtheta for k = 0, ..., count, from the slope of phi:
// 2k I_k = (2k-1) I_(k-1) + cos^(2k-1) phi sin phi, with cos^2 = 1/(1 + t^2), sin cos = t/(1 + t^2).
std::vector<Ball> cosine_integrals(const Ball& slope, std::size_t count) {
  std::vector<Ball> integrals{atan(slope)};
  const Ball cosine_squared = reciprocal(Ball(1) + slope * slope);
  Ball end = slope * cosine_squared;
  for (std::size_t k = 1; k <= count; ++k) {
    integrals.push_back((Ball(2 * k - 1) * integrals.back() + end) / Ball(2 * k));
    end = end * cosine_squared;
  }
  return integrals;
}

// Int_0^pi R^(-2k) dtheta, k = 0, ..., count.
std::vector<Ball> inverse_powers(const Ball& x, std::size_t count) {
  std::vector<Ball> sum(count + 1);
  for (const Ball& a : {x, Ball(1) - x}) {
    const std::vector<Ball> side = cosine_integrals(reciprocal(a), count);
    const std::vector<Ball> far = cosine_integrals(a, count);
    for (std::size_t k = 0; k <= count; ++k) sum[k] += side[k] / power(a, 2 * static_cast<long>(k)) + far[k];
  }
  return sum;
}

// sum_{k>=1} (-1)^k (z^(2k) - (z/2)^(2k)) M_k. What is left out is at most sum_{k>count} pi (z/r)^(2k)/(2k).
Ball difference_of_series(const Ball& x, const Ball& r, const Ball& z) {
  constexpr std::size_t count = 60;
  const std::vector<Ball> powers = inverse_powers(x, count);
  Ball sum;
  for (std::size_t k = 1; k <= count; ++k) {
    const long twice = 2 * static_cast<long>(k);
    const Ball moment = (Ball::pi() / power(r, twice) - powers[k]) / Ball(twice);
    const Ball term = (power(z, twice) - power(z / Ball(2), twice)) * moment;
    sum += k % 2 == 0 ? term : -term;
  }
  const Ball q = (z / r) * (z / r);
  const Ball rest =
      Ball::pi() * power(q, static_cast<long>(count) + 1) / (Ball(2 * count + 2) * (Ball(1) - q));
  return widened(sum, rest);
}

// (26) as printed.
Ball half_disk(const Ball& r, const Ball& z) {
  return Ball::pi() * z / Ball(2) * log(r * r + z * z) - Ball::pi() * z * log(z);
}

using Function = RationalFunction;

Function symbol(const char* name) { return Function::variable(name); }

// The square of the distance along a side at the distance a, and along a part of the far side.
template <class R>
R along_side(const R& a, const R& s) {
  return a * a + s * s;
}
template <class R>
R along_far_side(const R& a, const R& s) {
  return R(1) + a * a * s * s;
}

// Terms in which the derivative of log(rho^2 + z^2)/2 differs from rho/(rho^2 + z^2), and those of the angles
// from a/(a^2 + s^2) and a/(1 + a^2 s^2): that of log q is q'/q, that of atan v is v'/(1 + v^2).
Rational not_in_polar_coordinates(int sign) {
  using D = Dual<Function>;
  const Function z = symbol("z");
  const D rho(symbol("rho"), 1, 0);
  const D q = rho * rho + D(z * z);
  const auto of_angle = [](const D& v) { return v.by_s / (1 + v.value * v.value); };
  const Function a = symbol("a");
  const D s(symbol("s"), 1, 0);
  return differing_terms(q.by_s / (2 * q.value), symbol("rho") / q.value) +
         differing_terms(of_angle(s / D(a)), a / along_side(a, symbol("s"))) +
         differing_terms(of_angle(D(a) * s), Function(sign) * a / along_far_side(a, symbol("s")));
}

// Denominators and arguments that are not positive for all r > 0, sides at a distance a = r + `beyond` < 1
// and y = -r^2 + e, e > 0: a coefficient that is negative, or none at all.
Rational not_positive(const Function& r, const Function& beyond) {
  const auto missing = [](const Function& f) {
    return Rational(negative_terms(f) == Rational(0) && differing_terms(f, 0) != Rational(0) ? 0 : 1);
  };
  const Function a = r + beyond;
  const Function one = a + symbol("1-a");
  const Function s = symbol("s");
  const Function y = symbol("e") - r * r;
  // 1 + a^2 s^2 is of the degree 2 in the unit of length.
  const Function far = one * one + a * a * s * s;
  return missing(along_side(a, s)) + missing(far) + missing(along_side(a, s) + y) + missing(far + y) +
         missing(r * r + y);
}

// S/z by the four integrals along the sides.
Ball by_sides(const Ball& x, const Ball& r, const Ball& z) {
  Ball sum = -Ball::pi() * log(r * r + z * z);
  for (const Ball& a : {x, Ball(1) - x}) {
    const auto integrand = [&]<class R>(const R& s) {
      const R side = along_side(R(a), s);
      const R far = along_far_side(R(a), s);
      const R square = R(z * z);
      return R(a) * (log(side + square) / side + log(far + square) / far);
    };
    sum += known(integral_on_interval(line_function(integrand), Ball(0), Ball(1), {.radius = 1e-30}));
  }
  return sum / Ball(2);
}

Ball whole_by_rules(const Ball& x, const Ball& z) { return unit_square_integrals(x, z, 44).inverse_square; }

}  // namespace

Finding equation_25(const Bench&) {
  const BallPrecision precision(192);
  constexpr double within = 1e-25;
  Finding finding;
  finding.require("terms of the antiderivative and of the angles' derivatives", IsExactly{0},
                  not_in_polar_coordinates(1));
  finding.control("the same with a turning back along the far side", IsExactly{0},
                  not_in_polar_coordinates(-1));
  finding.require("denominators and arguments that are not positive, all r <= a < 1, y > -r^2", IsExactly{0},
                  not_positive(symbol("r"), symbol("d")));
  finding.control("the same for a half-disk that reaches over a side", IsExactly{0},
                  not_positive(symbol("a") + symbol("d"), -symbol("d")));
  for (const Rational& at : {Rational(1, 3), Rational(19, 20)}) {
    const Ball x(at);
    const Ball r(Rational(99, 100) * std::min(at, 1 - at));
    const Ball z(Rational(1, 5));
    const TwoSquares<Ball> there(x, z);
    const AgreesWith sides{.value = by_sides(x, r, z), .within = within};
    const std::string place = ", x = " + at.to_text() + ", r = (99/100) min(x, 1-x), z = 1/5";
    finding.require("S/z of the library against the integrals along the sides" + place, sides,
                    there.inverse_square_outside(r) / z);
    finding.control("the same over the whole square" + place, sides, there.inverse_square() / z);
  }
  for (const Rational& at : {Rational(1, 2), Rational(9, 20)}) {
    const Ball x(at);
    const Ball r(Rational(2, 5));
    const Ball z(Rational(1, 5));
    const Ball half = z / Ball(2);
    const Ball whole = whole_by_rules(x, z) / z - whole_by_rules(x, half) / half;
    const Ball disk = half_disk(r, z) / z - half_disk(r, half) / half;
    const AgreesWith series{.value = difference_of_series(x, r, z), .within = within};
    const std::string place = ", by Gauss rules, x = " + at.to_text() + ", r = 2/5, z = 1/5";
    finding.require("S(z)/z - S(z/2)/(z/2) against its power series" + place, series, whole - disk);
    finding.control("the same over the whole square" + place, series, whole);
  }
  for (const Rational& at : {Rational(1, 3), Rational(1, 10), Rational(99, 100)})
    for (const int halvings : {1, 20}) {
      const Ball x(at);
      const Ball r = min(x, Ball(1) - x) / Ball(2);
      const Ball z = r * power(Ball(2), -halvings);
      const Ball half = z / Ball(2);
      const TwoSquares<Ball> there(x, z);
      const TwoSquares<Ball> closer(x, half);
      const AgreesWith series{.value = difference_of_series(x, r, z), .within = within};
      const std::string place = ", x = " + at.to_text() + ", z = r 2^-" + std::to_string(halvings);
      finding.require("S(z)/z - S(z/2)/(z/2) of the library against its power series" + place, series,
                      there.inverse_square_outside(r) / z - closer.inverse_square_outside(r) / half);
      finding.control("the same over the whole square" + place, series,
                      there.inverse_square() / z - closer.inverse_square() / half);
    }
  // d(S/z)/dx at z = 0 is M_0'; d(S/z)/dx is analytic in x, and a symmetric difference over 2^-40 is off by
  // 2^-80 times its second derivative, which is below 10^4 here.
  for (const Rational& at : {Rational(1, 3), Rational(4, 5)}) {
    const Ball x(at);
    const Ball step = power(Ball(2), -40);
    const Ball z = power(Ball(2), -40);
    const Ball r(Rational(1, 10));
    const auto smooth = [&](const Ball& where) {
      return TwoSquares<Ball>(where, z).inverse_square_outside(r) / z;
    };
    const auto slope = [&](const Ball& where) {
      return (smooth(where + step) - smooth(where - step)) / (Ball(2) * step);
    };
    const auto side = [](const Ball& a) { return atan(reciprocal(a)) / a; };
    const AgreesWith moment{.value = side(x) - side(Ball(1) - x), .within = 1e-20};
    finding.require("slope of S/z by x close to z = 0 against M_0', x = " + at.to_text(), moment, slope(x));
    finding.control("the same at a distance of 1/20 from that x = " + at.to_text(), moment,
                    slope(x + Ball(Rational(1, 20))));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
