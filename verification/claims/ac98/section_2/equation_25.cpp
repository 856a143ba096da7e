// SPDX-License-Identifier: GPL-3.0-or-later

// In polar coordinates around (x,0), with R(theta) the distance to the sides of the square and 0 < r < min(x,
// 1-x), the integral over R_2 is
//     S = (z/2) Int_0^pi log[(R^2 + z^2)/(r^2 + z^2)] dtheta = sum_k (-1)^k z^(2k+1) M_k(x)  for 0 <= z < r,
//     M_0 = Int log(R/r) dtheta,  M_k = Int (r^(-2k) - R^(-2k)) dtheta/(2k),  0 <= M_k <= pi r^(-2k)/(2k),
// a power series: S is an analytic function of z for |z| < r, continued to z = 0 and below. R cos theta is a
// over the angle atan(1/a) and 1 over atan(a), a = x and a = 1 - x, so that M_k for k >= 1 is made of Int
// cos^(2k), and M_0' = atan(1/x)/x - atan(1/(1-x))/(1-x): each M_k is analytic in 0 < x < 1, and the series
// converges uniformly for x in a compact part.
//
// Checked      S(x,z)/z - S(x,z/2)/(z/2), in which M_0 cancels, against the terms k >= 1 with a bound for the
//              rest: with S from (26) and an enclosure of the integral over the whole square that knows no
//              closed form, and with the library's S close to z = 0. The integral over the whole square,
//              which is not smooth, is rejected. M_0' against the difference of S/z over a short step of x.
// Not checked  the existence of the power series by itself: the argument above speaks for it.

#include <cstddef>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "verification/claims/ac98/surfaces/unit_square_integrals.h"
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

Ball whole_by_rules(const Ball& x, const Ball& z) { return unit_square_integrals(x, z, 44).inverse_square; }

}  // namespace

Finding equation_25(const Bench&) {
  const BallPrecision precision(192);
  constexpr double within = 1e-25;
  Finding finding;
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
