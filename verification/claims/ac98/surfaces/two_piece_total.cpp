// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/two_piece_total.h"

#include <cmath>
#include <span>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/enclosure/maximum.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/roof_pair.h"
#include "verification/claims/proved_number.h"

namespace radcert::verification::ac98 {
namespace {

// 2 Int_0^V dv/(A + v^2)^2, V = 1/2.
template <class T>
T across(const T& a) {
  using std::atan, std::sqrt;
  const T half = T(1) / T(2);
  const T root = sqrt(a);
  return half / (a * (a + half * half)) + atan(half / root) / (a * root);
}

// d^4 across(d^2 chord), d >= 0, without a division by d.
template <class T>
T across_on_the_roof(const T& d, const T& chord) {
  using std::atan, std::sqrt;
  const T half = T(1) / T(2);
  const T root = sqrt(chord);
  const T quarter_turn = T(2) * atan(T(1));
  return d * (d * half / (chord * (d * d * chord + half * half)) +
              (quarter_turn - atan(d * root / half)) / (chord * root));
}

template <class T>
T from_the_square(int p, const T& x, const T& xi) {
  const T z = T(2) - power(xi, p);
  const T d = xi - x;
  return z * (z + T(p) * power(xi, p - 1) * d) * across(d * d + z * z);
}

template <class T>
T from_roof_to_square(int p, const T& x, const T& t) {
  const T z = T(2) - power(x, p);
  const T d = t - x;
  return z * (z - T(p) * power(x, p - 1) * d) / RoofPair<T>::stretch(p, x) * across(d * d + z * z);
}

template <class T>
T from_roof_to_roof(int p, const T& x, const T& t) {
  const auto to_roof = [&](const T& xi, const T& distance) {
    const RoofPair<T> pair(p, x, xi);
    return pair.bend_p * pair.bend_q / pair.stretch_p * across_on_the_roof(distance, pair.chord);
  };
  const T rest = T(1) - x;
  return x * to_roof(x * t, x * (T(1) - t)) + rest * to_roof(x + rest * t, rest * t);
}

template <class T>
T from_the_roof(int p, const T& x, const T& t) {
  return from_roof_to_square(p, x, t) + from_roof_to_roof(p, x, t);
}

// The integral over 0 <= t <= 1 of f(x, t): by Gauss rules at a point x, by the values on panels for a range
// of x.
template <class Integrand>
struct OverUnitInterval {
  Integrand f;
  double radius;
  static constexpr long panels = 64;

  Ball at_point(const Ball& x) const {
    return known(
        integral_on_interval(line_function([this, x]<class R>(const R& t) -> R { return f(R(x), t); }),
                             Ball(0), Ball(1), {.radius = radius}));
  }
  template <class T>
  T on_panels(const T& x) const {
    T sum(0);
    for (long i = 0; i < panels; ++i)
      sum = sum + f(x, T(hull(Ball(Rational(i, panels)), Ball(Rational(i + 1, panels)))));
    return sum / T(static_cast<int>(panels));
  }
  CubeFunction function() const {
    return {
        .dimension = 1,
        .value =
            [*this](std::span<const Ball> x) { return x[0].is_exact() ? at_point(x[0]) : on_panels(x[0]); },
        .gradient =
            [*this](std::span<const Ball> x) {
              return std::vector<Ball>{on_panels(Dual<Ball>(x[0], Ball(1), Ball(0))).by_s};
            }};
  }
};

auto square_integral(int p, double radius) {
  const auto f = [p]<class T>(const T& x, const T& t) -> T { return from_the_square(p, x, t); };
  return OverUnitInterval<decltype(f)>{f, radius};
}

auto roof_integral(int p, double radius) {
  const auto f = [p]<class T>(const T& x, const T& t) -> T { return from_the_roof(p, x, t); };
  return OverUnitInterval<decltype(f)>{f, radius};
}

template <class Integrand>
Ball largest_over_x(const Integrand& f, double radius) {
  return known(maximum(OverUnitInterval<Integrand>{f, radius / 16}.function(), {.radius = radius}));
}

}  // namespace

Ball largest_roof_to_roof(int p, double radius) {
  return largest_over_x([p]<class T>(const T& x, const T& t) -> T { return from_roof_to_roof(p, x, t); },
                        radius);
}

Ball least_total_in_the_middle(int p, double radius) {
  const Ball of_square = -largest_over_x(
      [p]<class T>(const T& x, const T& t) -> T { return -from_the_square(p, x, t); }, radius);
  const Ball of_roof =
      -largest_over_x([p]<class T>(const T& x, const T& t) -> T { return -from_the_roof(p, x, t); }, radius);
  return min(of_square, of_roof);
}

Ball largest_total_of_square(int p, double radius) {
  return known(maximum(square_integral(p, radius / 16).function(), {.radius = radius}));
}

Ball largest_total_of_roof(int p, double radius) {
  return known(maximum(roof_integral(p, radius / 16).function(), {.radius = radius}));
}

Ball total_of_square(int p, const Rational& x, double radius) {
  return square_integral(p, radius).at_point(Ball(x));
}

Ball total_of_roof(int p, const Rational& x, double radius) {
  return roof_integral(p, radius).at_point(Ball(x));
}

Ball largest_total(int p, double radius) {
  return max(largest_total_of_square(p, radius), largest_total_of_roof(p, radius));
}

}  // namespace radcert::verification::ac98
