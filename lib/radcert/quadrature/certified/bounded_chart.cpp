// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/certified/bounded_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/scalar/dual.h"
#include "radcert/scalar/functions/divided_difference.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

/// More than the roundings of the few operations by which a bound is made.
constexpr double up = 1 + 0x1p-48;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vector<BoundedDouble> bounded(const Vector<Ball>& v) {
  return {radcert::bounded(v.x), radcert::bounded(v.y), radcert::bounded(v.z)};
}

/// The exact parameter is not negative: s = 0 may be where a root ends.
Ball parameter_around(const BoundedDouble& x) {
  const Ball ball = ball_around(x);
  if (!ball.is_finite() || certainly_at_most(Ball(0), ball)) return ball;
  return hull(Ball(0), max(ball.upper(), Ball(0)));
}

ParameterPoint<Ball> parameters_around(const ParameterPoint<BoundedDouble>& at) {
  return {parameter_around(at.s), parameter_around(at.t)};
}

}  // namespace

BoundedDouble bounded(const Ball& x) {
  if (!x.is_finite()) return {0, infinity};
  const double value = x.to_double();
  // The midpoint to the nearest double, which may be a subnormal one, or 0 where the midpoint is not.
  constexpr double unit = unit_roundoff<double>();
  const double rounding = certainly_zero(x) ? 0 : unit * std::abs(value) + std::numeric_limits<double>::min();
  return {value, (x.radius() + rounding) * up};
}

Ball ball_around(const BoundedDouble& x) {
  if (!std::isfinite(x.value()) || !std::isfinite(x.error())) return Ball::failed("a number without bound");
  return widened(Ball(x.value()), Ball(x.error()));
}

BoundedChart::BoundedChart(const Chart& chart) : chart_(chart), polynomials_(polynomials(chart)) {
  if (!polynomials_) return;
  for (const Polynomial& polynomial : *polynomials_)
    for (const Monomial& monomial : polynomial)
      degree_ = std::max({degree_, monomial.power_of_s, monomial.power_of_t});
}

std::optional<std::array<BoundedChart::Polynomial, 3>> BoundedChart::polynomials(const Chart& chart) {
  const ExactImage* exact = exact_image(chart.in<Ball>());
  if (exact == nullptr) return std::nullopt;
  const Vector<ExactFunction> image = exact->image();
  std::array<Polynomial, 3> result;
  std::size_t place = 0;
  for (const ExactFunction* coordinate : {&image.x, &image.y, &image.z}) {
    const std::optional<PowerQuotient> quotient = coordinate->quotient();
    if (!quotient || quotient->denominator.size() != 1) return std::nullopt;
    const auto& [none, divisor] = *quotient->denominator.begin();
    if (none[0].sign() != 0 || none[1].sign() != 0) return std::nullopt;
    for (const auto& [exponents, coefficient] : quotient->numerator) {
      const std::optional<long> i = exponents[0].to_long();
      const std::optional<long> j = exponents[1].to_long();
      if (!i || !j || *i + *j > static_cast<long>(highest_degree)) return std::nullopt;
      result[place].push_back({.coefficient = from_rational<BoundedDouble>(coefficient / divisor),
                               .power_of_s = static_cast<std::size_t>(*i),
                               .power_of_t = static_cast<std::size_t>(*j)});
    }
    ++place;
  }
  return result;
}

template <Field T>
Vector<T> BoundedChart::image(const T& s, const T& t) const {
  std::array<T, highest_degree + 1> powers_of_s;
  std::array<T, highest_degree + 1> powers_of_t;
  powers_of_s[1] = s;
  powers_of_t[1] = t;
  for (std::size_t k = 2; k <= degree_; ++k) {
    powers_of_s[k] = powers_of_s[k - 1] * s;
    powers_of_t[k] = powers_of_t[k - 1] * t;
  }
  const auto value = [&](const Polynomial& polynomial) {
    T sum(0);
    for (const Monomial& monomial : polynomial) {
      const std::size_t i = monomial.power_of_s;
      const std::size_t j = monomial.power_of_t;
      if (i == 0 && j == 0) {
        sum = monomial.coefficient + sum;
      } else if (i == 0 || j == 0) {
        sum = sum + monomial.coefficient * (i == 0 ? powers_of_t[j] : powers_of_s[i]);
      } else {
        sum = sum + monomial.coefficient * (powers_of_s[i] * powers_of_t[j]);
      }
    }
    return sum;
  };
  const auto& [x, y, z] = *polynomials_;
  return {value(x), value(y), value(z)};
}

Frame<BoundedDouble> BoundedChart::frame(const ParameterPoint<BoundedDouble>& at) const {
  if (!polynomials_) {
    const Frame<Ball> found = chart_.in<Ball>().frame(parameters_around(at));
    return {.point = bounded(found.point),
            .tangent_s = bounded(found.tangent_s),
            .tangent_t = bounded(found.tangent_t),
            .area_normal = bounded(found.area_normal)};
  }
  using D = Dual<BoundedDouble>;
  const Vector<D> f = image(D{at.s, 1, 0}, D{at.t, 0, 1});
  Frame<BoundedDouble> frame;
  frame.point = {f.x.value, f.y.value, f.z.value};
  frame.tangent_s = {f.x.by_s, f.y.by_s, f.z.by_s};
  frame.tangent_t = {f.x.by_t, f.y.by_t, f.z.by_t};
  frame.area_normal = cross(frame.tangent_s, frame.tangent_t);
  if (chart_.facts().orientation == Orientation::against_the_cross_product)
    frame.area_normal = -frame.area_normal;
  return frame;
}

Chord<BoundedDouble> BoundedChart::chord_along(const ParameterPoint<BoundedDouble>& p,
                                               const ParameterPoint<BoundedDouble>& direction,
                                               const BoundedDouble& step) const {
  if (!polynomials_) {
    const Chord<Ball> found = chart_.in<Ball>().chord_along(
        parameters_around(p), {ball_around(direction.s), ball_around(direction.t)}, ball_around(step));
    return {.difference = bounded(found.difference),
            .bend_p = bounded(found.bend_p),
            .bend_q = bounded(found.bend_q)};
  }
  using D = DividedDifference<BoundedDouble>;
  const Vector<D> f = image(D::variable(p.s, direction.s, step), D::variable(p.t, direction.t, step));
  return {.difference = {f.x.first, f.y.first, f.z.first},
          .bend_p = {f.x.second_p, f.y.second_p, f.z.second_p},
          .bend_q = {f.x.second_q, f.y.second_q, f.z.second_q}};
}

}  // namespace radcert
