// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/excluded_ball.h"

#include <cmath>

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/proved_number.h"

namespace radcert::verification::ac98 {
namespace {

// m, k and the rims, over e and over e^2, at an angle.
template <class R>
struct AtAngle {
  AtAngle(const Rational& a, const Rational& b, const Rational& c, const R& angle, const R& square) {
    const R cosine = cos(angle);
    const R sine = sin(angle);
    const auto form = [&](const Rational& x, const Rational& y) {
      return R(x) * cosine * cosine + R(y) * sine * sine;
    };
    m = form(a * a, b * b);
    const R k = form(1 / (a * a), 1 / (b * b));
    const R deep(c * c);
    q_over_square = R(1) / (R(2) * (m + sqrt(m * m + (deep - m) * square)));
    r_over_radius = R(c) * k / (R(1) + sqrt(R(1) + square * k * (deep * k - R(1))));
  }
  R m;
  R q_over_square;
  R r_over_radius;
};

// Four times the integral over a quarter turn.
template <class F>
Ball around(const F& f, double error) {
  return Ball(4) *
         known(integral_on_interval(line_function(f), Ball(0), Ball::pi() / Ball(2), {.radius = error / 4}));
}

// The hull of the same integral for all 0 < e <= radius: f(angle, e^2) on panels of the angle, one part of
// the values e^2 after another.
template <class F>
Ball around_on_panels(const F& f, const Rational& radius, long panels) {
  constexpr long parts = 16;
  const Ball step = Ball::pi() / Ball(2 * panels);
  const Rational part = radius * radius / parts;
  const auto sum_for = [&](const Ball& square) {
    Ball sum;
    for (long i = 0; i < panels; ++i) sum += f(hull(Ball(i) * step, Ball(i + 1) * step), square);
    return Ball(4) * step * sum;
  };
  Ball all = sum_for(hull(Ball(0), Ball(part)));
  for (long k = 1; k < parts; ++k) all = hull(all, sum_for(hull(Ball(k * part), Ball((k + 1) * part))));
  return all;
}

}  // namespace

Ball EllipsoidTip::over_cap(const Rational& radius, double error) const {
  const Rational square = radius * radius;
  const auto f = [&]<class R>(const R& angle) {
    const AtAngle<R> at(a_, b_, c_, angle, R(square));
    return R(2 * a_ * b_ * c_ * c_ * square) * at.q_over_square * at.q_over_square / at.m;
  };
  return around(f, error);
}

Ball EllipsoidTip::over_rest(const Rational& radius, double error) const {
  const Rational square = radius * radius;
  const auto f = [&]<class R>(const R& angle) {
    const AtAngle<R> at(a_, b_, c_, angle, R(square));
    const R q = R(square) * at.q_over_square;
    return R(a_ * b_ / 2) * (R(1) - q) / (at.m + (R(c_ * c_) - at.m) * q);
  };
  return around(f, error);
}

Ball EllipsoidTip::over_sphere(const Rational& radius, double error) const {
  const Rational square = radius * radius;
  const auto f = [&]<class R>(const R& angle) {
    const AtAngle<R> at(a_, b_, c_, angle, R(square));
    return (R(1) - R(square) * at.r_over_radius * at.r_over_radius) / R(2);
  };
  return around(f, error);
}

Ball EllipsoidTip::cap_over_square(const Rational& radius, long panels) const {
  return around_on_panels(
      [&](const Ball& angle, const Ball& square) {
        const AtAngle<Ball> at(a_, b_, c_, angle, square);
        return Ball(2 * a_ * b_ * c_ * c_) * at.q_over_square * at.q_over_square / at.m;
      },
      radius, panels);
}

Ball EllipsoidTip::lack_over_square(const Rational& radius, long panels) const {
  return around_on_panels(
      [&](const Ball& angle, const Ball& square) {
        const AtAngle<Ball> at(a_, b_, c_, angle, square);
        return at.r_over_radius * at.r_over_radius / Ball(2);
      },
      radius, panels);
}

Ball EllipsoidTip::shadow_over_square(const Rational& radius, long panels) const {
  return around_on_panels(
      [&](const Ball& angle, const Ball& square) {
        const AtAngle<Ball> at(a_, b_, c_, angle, square);
        return (Ball(1) - square * at.r_over_radius * at.r_over_radius) / Ball(2);
      },
      radius, panels);
}

}  // namespace radcert::verification::ac98
