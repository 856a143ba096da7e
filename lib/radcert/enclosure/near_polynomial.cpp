// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/near_polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit boxes_of_a_bound("enclosure/near_polynomial: boxes of a bound on two ellipses", 5000, 1,
                                 "no bound there: smaller ellipses, or refused");

constexpr int largest_degree = 16;
/// Chebyshev points in each variable, N.
constexpr int points = 32;
/// Up to which coefficients are looked at, D.
constexpr int degree_seen = 24;
/// Sums of the half axes that are tried.
constexpr std::array<double, 10> sums_of_axes{1.25, 1.5, 2, 2.5, 3, 4, 6, 8, 12, 20};

struct Interval {
  double low;
  double high;
  [[nodiscard]] double middle() const { return low + (high - low) / 2; }
  [[nodiscard]] double least_size() const { return low > 0 ? low : (high < 0 ? -high : 0); }
  [[nodiscard]] Ball ball() const { return hull(Ball(low), Ball(high)); }
};

/// A rectangle of the complex plane.
struct ComplexBox {
  Interval real;
  Interval imag;
  [[nodiscard]] ComplexBall ball() const { return {real.ball(), imag.ball()}; }
};

/// A Bernstein ellipse about [-1,1].
struct Ellipse {
  double long_axis;
  double short_axis;

  /// Half axes that are not too short after rounding.
  explicit Ellipse(double sum)
      : long_axis((sum + 1 / sum) / 2 * (1 + 1e-15)), short_axis((sum - 1 / sum) / 2 * (1 + 1e-15)) {}
  /// Slightly more than the ellipse, so that rounding drops no box that touches it.
  [[nodiscard]] bool meets(const ComplexBox& box) const {
    constexpr double margin = 1e-9;
    const double x = box.real.least_size() / long_axis;
    const double y = box.imag.least_size() / short_axis;
    return x * x + y * y <= 1 + margin;
  }
  /// Boxes that cover it, or its upper half.
  [[nodiscard]] std::vector<ComplexBox> cover(bool upper_half) const {
    std::vector<ComplexBox> boxes;
    constexpr int cuts = 4;
    const auto cut = [](double low, double high, int k) { return low + (high - low) * k / cuts; };
    const double bottom = upper_half ? 0 : -short_axis;
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; j < cuts; ++j) {
        const ComplexBox box{.real = {cut(-long_axis, long_axis, i), cut(-long_axis, long_axis, i + 1)},
                             .imag = {cut(bottom, short_axis, j), cut(bottom, short_axis, j + 1)}};
        if (meets(box)) boxes.push_back(box);
      }
    return boxes;
  }
};

/// The four quarters of a box.
std::array<ComplexBox, 4> quarters(const ComplexBox& box) {
  const double x = box.real.middle();
  const double y = box.imag.middle();
  return {ComplexBox{.real = {box.real.low, x}, .imag = {box.imag.low, y}},
          ComplexBox{.real = {x, box.real.high}, .imag = {box.imag.low, y}},
          ComplexBox{.real = {box.real.low, x}, .imag = {y, box.imag.high}},
          ComplexBox{.real = {x, box.real.high}, .imag = {y, box.imag.high}}};
}

/// A variable from [-1,1] to its side of the rectangle.
struct Side {
  Rational middle;
  Rational half;
  Side(const Rational& low, const Rational& high)
      : middle((low + high) / Rational(2)), half((high - low) / Rational(2)) {}
  template <class R>
  [[nodiscard]] R at(const R& x) const {
    return from_rational<R>(middle) + from_rational<R>(half) * x;
  }
};

/// sup |f| on the product of two filled ellipses, rounded up; a failure where f is not shown to be analytic.
/// Maths     f is real for real arguments: f(conj x, conj y) = conj f(x, y), so that the upper half of the
///           first ellipse will do
struct Bound {
  double value = 0;
  std::string failure = {};
};
Bound bound_on_ellipses(const PlaneFunction& f, const Side& s, const Side& t, double sum) {
  struct Pair {
    ComplexBox x;
    ComplexBox y;
  };
  const Ellipse ellipse(sum);
  std::vector<Pair> open;
  for (const ComplexBox& x : ellipse.cover(true))
    for (const ComplexBox& y : ellipse.cover(false)) open.push_back({x, y});
  Bound bound;
  long left = boxes_of_a_bound.value();
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    const ComplexBall value = f.in_complex_balls(s.at(pair.x.ball()), t.at(pair.y.ball()));
    --left;
    if (value.is_finite()) {
      bound.value = std::max(bound.value, value.magnitude_bound());
      continue;
    }
    bound.failure = value.failure();
    if (left <= 0) return bound;
    for (const ComplexBox& x : quarters(pair.x))
      for (const ComplexBox& y : quarters(pair.y))
        if (ellipse.meets(x) && ellipse.meets(y)) open.push_back({x, y});
  }
  bound.failure.clear();
  return bound;
}

/// cos(k (2m+1) pi/(2N)), by k, m: the Chebyshev polynomials at the points.
std::vector<std::vector<Ball>> chebyshev_values() {
  std::vector<std::vector<Ball>> values;
  for (int k = 0; k <= degree_seen; ++k) {
    values.emplace_back();
    for (int m = 0; m < points; ++m)
      values.back().push_back(cos(Ball::pi() * Ball(Rational(k * (2 * m + 1), 2 * points))));
  }
  return values;
}

/// T_k((s - middle)/half) by powers of s.
std::vector<std::vector<Rational>> chebyshev_monomials(const Side& side, int degree) {
  std::vector<std::vector<Rational>> out(static_cast<std::size_t>(degree) + 1,
                                         std::vector<Rational>(static_cast<std::size_t>(degree) + 1));
  const Rational slope = Rational(1) / side.half;
  const Rational start = -side.middle / side.half;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (k == 0) {
      out[0][0] = 1;
    } else {
      const Rational twice = k == 1 ? 1 : 2;
      for (std::size_t i = 0; i < k; ++i) {
        out[k][i] += twice * start * out[k - 1][i];
        out[k][i + 1] += twice * slope * out[k - 1][i];
      }
      if (k > 1)
        for (std::size_t i = 0; i + 1 < k; ++i) out[k][i] -= out[k - 2][i];
    }
  }
  return out;
}

/// What the coefficients up to degree_seen are off by, and what lies beyond, for |f| <= 1; rounded up.
double beyond_coefficients(double rho) {
  const Ball inverse = Ball(1) / Ball(rho);
  const Ball turned = power(inverse, 2 * points);
  const auto with_aliases = [&](int k) {
    return power(inverse, k) + (power(Ball(rho), k) + power(inverse, k)) * turned / (Ball(1) - turned);
  };
  Ball sum;
  for (int k = 0; k <= degree_seen; ++k)
    for (int l = 0; k + l <= degree_seen; ++l)
      sum += with_aliases(k) * with_aliases(l) - power(inverse, k + l);
  // sum_(n>D) (n+1) q^n = q^(D+1) ((D+2) - (D+1) q)/(1-q)^2
  sum += power(inverse, degree_seen + 1) * (Ball(degree_seen + 2) - Ball(degree_seen + 1) * inverse) /
         power(Ball(1) - inverse, 2);
  return (Ball(4) * sum).upper_double();
}

}  // namespace

Outcome<NearPolynomial> near_polynomial(const PlaneFunction& f, const ParameterRectangle& on, int degree) {
  expects(0 <= degree && degree <= largest_degree, "0 <= degree <= 16", named("degree", degree));
  expects(on.s_low < on.s_high && on.t_low < on.t_high, "a rectangle with an inside",
          named("s_low", on.s_low), named("s_high", on.s_high), named("t_low", on.t_low),
          named("t_high", on.t_high));
  const Side s(on.s_low, on.s_high);
  const Side t(on.t_low, on.t_high);

  double truncation = std::numeric_limits<double>::infinity();
  std::string failure;
  for (const double rho : sums_of_axes) {
    const Bound bound = bound_on_ellipses(f, s, t, rho);
    if (!bound.failure.empty()) {
      failure = bound.failure;
      break;
    }
    truncation = std::min(truncation, (Ball(bound.value) * Ball(beyond_coefficients(rho))).upper_double());
  }
  if (!std::isfinite(truncation))
    return because("it is not shown to be analytic about the whole of it: " +
                   (failure.empty() ? std::string("its values are beyond double") : failure));

  // c_kl by sums over the points of y, then of x.
  const std::vector<std::vector<Ball>> chebyshev = chebyshev_values();
  std::vector<std::vector<Ball>> along_t(points, std::vector<Ball>(chebyshev.size()));
  for (std::size_t m = 0; m < points; ++m)
    for (std::size_t n = 0; n < points; ++n) {
      const Ball value = f.in_balls(s.at(chebyshev[1][m]), t.at(chebyshev[1][n]));
      if (!value.is_finite()) return because("it has no value at a point: " + std::string(value.failure()));
      for (std::size_t l = 0; l < chebyshev.size(); ++l) along_t[m][l] += value * chebyshev[l][n];
    }
  const std::vector<std::vector<Rational>> in_s = chebyshev_monomials(s, degree);
  const std::vector<std::vector<Rational>> in_t = chebyshev_monomials(t, degree);
  NearPolynomial out{.polynomial = PlanePolynomial<Rational>(degree)};
  Ball left;
  Ball size;
  for (std::size_t k = 0; k < chebyshev.size(); ++k)
    for (std::size_t l = 0; k + l < chebyshev.size(); ++l) {
      Ball sum;
      for (std::size_t m = 0; m < points; ++m) sum += along_t[m][l] * chebyshev[k][m];
      const Ball coefficient = sum * Ball((k > 0 ? 2 : 1) * (l > 0 ? 2 : 1)) / Ball(points * points);
      if (k + l >= in_s.size()) {
        left += abs(coefficient).upper();
        continue;
      }
      const double rounded = coefficient.to_double();
      left += abs(coefficient - Ball(rounded)).upper();
      size += Ball(std::abs(rounded));
      const Rational exact = Rational::exactly(rounded);
      for (std::size_t i = 0; i <= k; ++i)
        for (std::size_t j = 0; j <= l; ++j)
          out.polynomial(static_cast<int>(i), static_cast<int>(j)) += exact * in_s[k][i] * in_t[l][j];
    }
  out.size = size.upper_double();
  out.distance = (left + Ball(truncation)).upper_double();
  return out;
}

}  // namespace radcert
