// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <concepts>

#include "radcert/core/contract.h"
#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// The geometric kernel between the two unit squares at a right angle.
/// Maths     G(P,Q) = z eta / [(x - xi)^2 + eta^2 + z^2]^2,  P = (x,0,z), Q = (xi,eta,0)
/// Source    [ac98, (21)]
/// Requires  P != Q
/// Result    as R rounds; symmetric in z and eta, so that it serves P in S_xy, Q in S_xz as well
/// Limits    0 between two points of one square is not said here
template <Field R>
R two_squares_kernel(const R& x, const R& z, const R& xi, const R& eta) {
  const R offset = x - xi;
  const R squared_distance = offset * offset + eta * eta + z * z;
  return (z / squared_distance) * (eta / squared_distance);
}

namespace detail {

/// sqrt(a^2 + b^2), in double without overflow or underflow.
template <Real R>
R hypotenuse(const R& a, const R& b) {
  using std::sqrt;
  if constexpr (std::floating_point<R>) {
    return std::hypot(a, b);
  } else {
    return sqrt(a * a + b * b);
  }
}

/// log(1 + t) for t >= 0; Mpfr and Ball to the precision of 1 + t.
template <Real R>
R log_of_one_plus(const R& t) {
  using std::log;
  if constexpr (std::floating_point<R>) {
    return std::log1p(t);
  } else {
    return log(R(1) + t);
  }
}

}  // namespace detail

/// The integral over a half-disk that carries the singularity of the last integral of (24).
/// Maths     Int Int z / (s^2 + eta^2 + z^2) ds deta over s^2 + eta^2 <= r^2, eta >= 0
///           = (pi z/2) log(r^2 + z^2) - pi z log z = (pi z/2) log(1 + (r/z)^2)
/// Source    [ac98, (26)]; in polar coordinates the integrand is z rho/(rho^2 + z^2) = d/drho (z/2) log(rho^2
///           + z^2)
/// Requires  radius > 0 and distance > 0, certainly so for a Ball, else ContractViolation; distance = z
/// Result    double: relative error at most 2^-50, held against balls; Mpfr: 1 + (r/z)^2 is rounded to its
///           digits; Ball: enclosed
template <Real R>
R inverse_square_over_half_disk(const R& radius, const R& distance) {
  using std::log;
  expects(certainly_positive(radius) && certainly_positive(distance), "radius > 0 and distance > 0",
          named("radius", radius), named("distance", distance));
  // Beyond it z is less than half a unit of the last place of r in all that is compiled, and (r/z)^2 might
  // overflow; before it the difference of logarithms might cancel.
  const R far = power(R(2), 400);
  if (certainly_less(R(1), radius / distance / far))
    return pi<R>() * distance * (log(radius) - log(distance));
  const R ratio = radius / distance;
  return pi<R>() * distance * detail::log_of_one_plus(ratio * ratio) / R(2);
}

/// The first terms of Ku at a small distance z from the common edge, with a bound for the rest.
/// Maths     |Ku - (constant + linear z + linear_logarithm z log z)| <= cubic_bound z^3 for all 0 < z < 1
/// Source    TwoSquares
/// Result    plain data; for R = Ball each is an enclosure, and the bound holds with its upper end
/// Limits    cubic_bound grows like x^-3 or x^-2 towards x = 0, and likewise towards x = 1: the expansion is
///           not uniform there
template <Real R>
struct EdgeExpansion {
  R constant;
  R linear;
  R linear_logarithm;
  R cubic_bound;
};

/// The integrals of G times 1, xi - x and eta over one unit square, from a point of the other one at a right
/// angle to it.
/// Maths     P = (x,0,z), Q = (xi,eta,0), D = (x-xi)^2 + eta^2 + z^2, G = z eta/D^2, integrals over 0 <= xi,
///           eta <= 1; no factor rho/pi. By symmetry also P = (x,z,0), Q = (xi,0,eta). With a = x and a =
///           1-x, w^2 = 1 + z^2: one          Sum_a  1/2 atan(a/z) - z/(2w) atan(a/w),  as d/deta (-1/(2D)) =
///           eta/D^2 offset       (z/4) log{ [(1-x)^2 + z^2][x^2 + w^2] / ([(1-x)^2 + w^2][x^2 + z^2]) }
///           distance     J/2 - Sum_a z/(2w) atan(a/w),  as d/deta (-eta/(2D)) = eta^2/D^2 - 1/(2D);  J = Int
///           Int z/D J            With R(theta) the distance from (x,0) to the sides of the square in the
///           direction theta, in polar
///                        coordinates  J = (z/2) Int_0^pi log(1 + R^2/z^2) dtheta = z (A - pi log z),
///                        A = 1/2 Int_0^pi log(R^2 + z^2) dtheta, an even analytic function of z near 0.
///                        R cos theta = a over the angle alpha = atan(1/a) and R cos theta = 1 over beta =
///                        atan(a), and a^2 + z^2 cos^2 = z^2/(4q) |1 + q e^(2 i theta)|^2 with q(a) = z^2/(a
///                        + sqrt(a^2 + z^2))^2, so that A = Sum_a  alpha log(a + sqrt(a^2 + z^2)) + beta
///                        log(1 + w)
///                                   + [L(q(a), 2 beta) - L(1, 2 beta) + L(q(1), 2 alpha) - L(1, 2 alpha)]/2,
///                        L(r,phi) = Im Li_2(r e^(i phi)), L(1,phi) Clausen's integral
/// Source    [ac98, (22)-(25)]; J ours
/// Requires  0 < along < 1 and 0 < distance < 1, certainly so for a Ball, else ContractViolation; along = x,
///           distance = z
/// Result    double: relative error at most 2^-49 (`one`, `offset`, `inverse_square`), 2^-48
///           (`inverse_square_outside`), 2^-47 (`distance`), measured against balls on random points, close
///           to edges, corners and x = 1/2 too; Mpfr alike, but `offset` loses relative digits near its zero
///           x = 1/2; Ball: enclosed
/// Limits    as (x,z) tends to a corner the limit of `one` depends on the direction: (pi - atan(z/x))/2 at x
///           = 0
template <Real R>
class TwoSquares {
public:
  TwoSquares(const R& along, const R& distance);

  /// Int Int G, [ac98, (22)].
  [[nodiscard]] R one() const;
  /// Int Int G (xi - x), [ac98, (23)].
  [[nodiscard]] R offset() const;
  /// Int Int G eta, [ac98, (24)]; eta is the distance of Q from the common edge.
  [[nodiscard]] R distance() const;
  /// Int Int z/D, the last integral of [ac98, (24)]; it carries the factor 1/2 there.
  [[nodiscard]] R inverse_square() const { return z_ * (smooth_part() - pi<R>() * log_of_distance()); }
  /// The same integral without the half-disk of this radius around (x,0), [ac98, (25)]: z (A - (pi/2) log(r^2
  /// + z^2)). ContractViolation unless 0 < radius <= x, 1-x, certainly so for a Ball.
  [[nodiscard]] R inverse_square_outside(const R& radius) const;

  /// one() = pi/2 - (z/2) Sum_a (1/a + atan a) + ...
  [[nodiscard]] static EdgeExpansion<R> expansion_of_one(const R& along);
  /// offset() = (z/4) log{ (1-x)^2 (x^2 + 1) / ([(1-x)^2 + 1] x^2) } + ...
  [[nodiscard]] static EdgeExpansion<R> expansion_of_offset(const R& along);
  /// distance() = -(pi/2) z log z + (z/2) [A(z = 0) - Sum_a atan a] + ...
  [[nodiscard]] static EdgeExpansion<R> expansion_of_distance(const R& along);

private:
  static void require(const R& along);
  /// The sides x and 1 - x.
  static std::array<R, 2> sides(const R& along) { return {along, R(1) - along}; }
  /// A, at any z >= 0.
  static R smooth_part(const R& along, const R& z);
  /// Sum_a Int_0^a ds/(1 + s^2)^2 = Sum_a [atan a + a/(1 + a^2)]/2.
  static R decrease(const R& along);
  [[nodiscard]] R smooth_part() const { return smooth_part(x_, z_); }
  [[nodiscard]] R log_of_distance() const {
    using std::log;
    return log(z_);
  }
  /// Sum_a atan(a/w)/w.
  [[nodiscard]] R far_side() const;

  R x_;
  R z_;
};

template <Real R>
void TwoSquares<R>::require(const R& along) {
  expects(certainly_positive(along) && certainly_less(along, R(1)), "0 < along < 1", named("along", along));
}

template <Real R>
TwoSquares<R>::TwoSquares(const R& along, const R& distance) : x_(along), z_(distance) {
  require(along);
  expects(certainly_positive(distance) && certainly_less(distance, R(1)), "0 < distance < 1",
          named("distance", distance));
}

template <Real R>
R TwoSquares<R>::far_side() const {
  using std::atan;
  const R w = detail::hypotenuse(R(1), z_);
  const std::array<R, 2> a = sides(x_);
  return (atan(a[0] / w) + atan(a[1] / w)) / w;
}

template <Real R>
R TwoSquares<R>::one() const {
  using std::atan;
  // Not pi - atan(z/x), which loses digits where x is small. The second part is at most 2/3 of the first.
  const std::array<R, 2> a = sides(x_);
  return (atan(a[0] / z_) + atan(a[1] / z_) - z_ * far_side()) / R(2);
}

template <Real R>
R TwoSquares<R>::offset() const {
  using std::log;
  // Odd about x = 1/2. With b the shorter side, a the longer and A = a^2 + z^2, B = b^2 + z^2 the quotient is
  // A (B + 1) / ((A + 1) B) = 1 + (a - b) / ((A + 1) B), as a + b = 1. For a ball around x = 1/2 either order
  // is right.
  const bool mirrored = certainly_less(R(1), x_ + x_);
  const R b = mirrored ? R(1) - x_ : x_;
  const R a = R(1) - b;
  const R larger = a * a + z_ * z_;
  const R difference = mirrored ? x_ + x_ - R(1) : R(1) - (x_ + x_);
  const R near = detail::hypotenuse(b, z_);
  R logarithm;
  if (certainly_less(R(8) * near,
                     R(1))) {  // B may underflow; -2 log(near) > 4 and the rest > -1: nothing cancels
    logarithm = log(larger * (near * near + R(1)) / (larger + R(1))) - R(2) * log(near);
  } else {
    logarithm = detail::log_of_one_plus(difference / ((larger + R(1)) * (near * near)));
  }
  const R value = z_ * logarithm / R(4);
  return mirrored ? -value : value;
}

template <Real R>
R TwoSquares<R>::smooth_part(const R& along, const R& z) {
  using std::atan, std::log;
  const auto ratio = [&](const R& a) {
    const R root = z / (a + detail::hypotenuse(a, z));
    return root * root;
  };
  const R w = detail::hypotenuse(R(1), z);
  const R of_one = ratio(R(1));
  R sum(0);
  for (const R& a : sides(along)) {
    const R beta = atan(a);
    const R alpha = atan(R(1) / a);
    const R dilogarithms =
        dilogarithm_imaginary(ratio(a), beta + beta) - dilogarithm_imaginary(R(1), beta + beta) +
        dilogarithm_imaginary(of_one, alpha + alpha) - dilogarithm_imaginary(R(1), alpha + alpha);
    sum = sum + alpha * log(a + detail::hypotenuse(a, z)) + beta * log(R(1) + w) + dilogarithms / R(2);
  }
  return sum;
}

template <Real R>
R TwoSquares<R>::distance() const {
  return z_ * (smooth_part() - pi<R>() * log_of_distance() - far_side()) / R(2);
}

template <Real R>
R TwoSquares<R>::inverse_square_outside(const R& radius) const {
  using std::log;
  expects(certainly_positive(radius) && certainly_at_most(radius, x_) && certainly_at_most(radius, R(1) - x_),
          "0 < radius <= along, 1 - along", named("radius", radius), named("along", x_));
  return z_ * (smooth_part() - pi<R>() * log(detail::hypotenuse(radius, z_)));
}

template <Real R>
R TwoSquares<R>::decrease(const R& along) {
  using std::atan;
  R sum(0);
  for (const R& a : sides(along)) sum = sum + (atan(a) + a / (R(1) + a * a)) / R(2);
  return sum;
}

// atan(z/a) = z/a up to z^3/(3 a^3), and Sum_a atan(a/w)/w = Int ds/(s^2 + 1 + z^2) falls from its value at z
// = 0 by no more than z^2 decrease().
template <Real R>
EdgeExpansion<R> TwoSquares<R>::expansion_of_one(const R& along) {
  using std::atan;
  require(along);
  R linear(0);
  R cubic = decrease(along) / R(2);
  for (const R& a : sides(along)) {
    linear = linear - (R(1) / a + atan(a)) / R(2);
    cubic = cubic + R(1) / (R(6) * (a * a) * a);
  }
  return {.constant = pi<R>() / R(2), .linear = linear, .linear_logarithm = R(0), .cubic_bound = cubic};
}

// The derivative of the logarithm by z^2 is 1/(A (A + 1)) - 1/(B (B + 1)), A = (1-x)^2 + z^2, B = x^2 + z^2.
template <Real R>
EdgeExpansion<R> TwoSquares<R>::expansion_of_offset(const R& along) {
  using std::log;
  require(along);
  const std::array<R, 2> a = sides(along);
  const R quotient = a[1] / a[0];
  const R linear = (R(2) * log(quotient) + log((a[0] * a[0] + R(1)) / (a[1] * a[1] + R(1)))) / R(4);
  R cubic(0);
  for (const R& side : a) cubic = cubic + R(1) / (R(4) * (side * side) * (side * side + R(1)));
  return {.constant = R(0), .linear = linear, .linear_logarithm = R(0), .cubic_bound = cubic};
}

// A grows from its value at z = 0 by no more than (z^2/2) Int_0^pi R^-2 dtheta, where R cos theta is a over
// alpha and 1 over beta and Int_0^phi cos^2 = phi/2 + sin(2 phi)/4 with sin(2 alpha) = sin(2 beta) = 2a/(1 +
// a^2); far_side() falls by no more than z^2 decrease().
template <Real R>
EdgeExpansion<R> TwoSquares<R>::expansion_of_distance(const R& along) {
  using std::atan;
  require(along);
  R linear = smooth_part(along, R(0));
  R inverse_squares(0);
  for (const R& a : sides(along)) {
    linear = linear - atan(a);
    const R sine = a / (R(1) + a * a);
    inverse_squares = inverse_squares + (atan(R(1) / a) + sine) / (R(2) * (a * a)) + (atan(a) + sine) / R(2);
  }
  return {.constant = R(0),
          .linear = linear / R(2),
          .linear_logarithm = -pi<R>() / R(2),
          .cubic_bound = inverse_squares / R(4) + decrease(along) / R(2)};
}

}  // namespace radcert
