// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/dilogarithm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <gmp.h>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball_access.h"
#include "radcert/scalar/functions/bernoulli_numbers.h"

namespace radcert {

namespace {

const WorkLimit most_bits("scalar/dilogarithm: bits for a rounded value", 65536, BallPrecision::smallest_bits,
                          "refused: ContractViolation names the angle");

// With |u| <= 1.26 the first term left out is below 2 (1.26 / (2 pi))^26 / 27 < 2^-61 of the sum, in either
// series.
constexpr std::size_t term_count = bernoulli_numbers.size();

/// B_2k / (2k+1)!, or B_2k / (2k (2k+1)!), for k = 1, 2, ...
constexpr std::array<double, term_count> series_coefficients(bool divided) {
  std::array<double, term_count> coefficients{};
  double factorial = 1;
  for (std::size_t k = 1; k <= term_count; ++k) {
    const auto n = static_cast<double>(2 * k);
    factorial *= n * (n + 1);
    coefficients[k - 1] =
        bernoulli_numbers[k - 1][0] / (bernoulli_numbers[k - 1][1] * factorial * (divided ? n : 1.0));
  }
  return coefficients;
}

/// Im(u^3 p(u^2)) for p with real coefficients c_1, c_2, ..., divided by Im u = y.
double odd_series_over_imaginary(const std::array<double, term_count>& c, double x, double y) {
  // With w = u^2, Re w = a and |w|^2 = b: Horner for a real polynomial at a complex point, p(w) = alpha w +
  // beta.
  const double a = (x - y) * (x + y);
  const double size = x * x + y * y;
  const double b = size * size;
  double alpha = c[term_count - 1];
  double beta = c[term_count - 2];
  for (std::size_t k = term_count - 2; k-- > 0;) {
    const double next = std::fma(-alpha, b, c[k]);
    alpha = std::fma(alpha, 2 * a, beta);
    beta = next;
  }
  // Im(u^5) / y = 5 x^4 - 10 x^2 y^2 + y^4, Im(u^3) / y = 3 x^2 - y^2.
  const double x2 = x * x;
  const double y2 = y * y;
  return alpha * (5 * x2 * (x2 - 2 * y2) + y2 * y2) + beta * (3 * x2 - y2);
}

/// An angle as its distance from 0 or from pi, of the smaller size.
struct ReducedAngle {
  double rest;
  bool from_pi;
};

ReducedAngle reduced(double angle) {
  constexpr double pi = std::numbers::pi;
  constexpr double pi_rest = 0x1.1a62633145c07p-53;  // pi minus the double pi
  const double size = std::abs(angle);
  if (size <= pi / 2) return {angle, false};
  if (size <= pi) return {std::copysign((size - pi) - pi_rest, -angle), true};
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return c < 0 ? ReducedAngle{std::atan2(-s, -c), true} : ReducedAngle{std::atan2(s, c), false};
}

/// By Li_2(e^m) = pi^2/6 + m (1 - log(-m)) - m^2/4 - sum_k B_2k m^(2k+1) / (2k (2k+1)!), |m| < 2 pi.
double near_one(double radius, double angle) {
  static constexpr std::array<double, term_count> coefficients = series_coefficients(true);
  const double x = std::log(radius);
  const double size = x * x + angle * angle;
  // size may underflow, and does not matter then: the rim's logarithm is taken of the larger part alone.
  const double logarithm = size < 0x1p-900 ? std::log(std::max(-x, std::abs(angle))) : 0.5 * std::log(size);
  const double even = angle * ((1 - logarithm) - 0.5 * x - odd_series_over_imaginary(coefficients, x, angle));
  return even + x * std::atan2(angle, -x);
}

/// By Li_2(z) = u - u^2/4 + sum_k B_2k u^(2k+1) / (2k+1)!, u = -log(1 - z), |u| < 2 pi.
double away_from_one(double radius, const ReducedAngle& angle) {
  static constexpr std::array<double, term_count> coefficients = series_coefficients(false);
  const double s = angle.from_pi ? -std::sin(angle.rest) : std::sin(angle.rest);
  const double c = angle.from_pi ? -std::cos(angle.rest) : std::cos(angle.rest);
  const double x = -0.5 * std::log1p(radius * (radius - 2 * c));
  const double y = std::atan2(radius * s, 1 - radius * c);
  return y * (1 - 0.5 * x + odd_series_over_imaginary(coefficients, x, y));
}

arb_ptr in(Ball& ball) { return static_cast<arb_ptr>(BallAccess::storage(ball)); }
arb_srcptr in(const Ball& ball) { return static_cast<arb_srcptr>(BallAccess::storage(ball)); }

/// A bound of |f|: Cl_2(pi/3) < 1.02.
constexpr double largest_value = 1.02;

/// A bound of |f(r, x) - f(r, y)| for |x - y| <= d, of the whole disk.
/// The derivative is -log|1 - r e^(ix)|, and |1 - r e^(ix)| lies between |sin x| >= 2 |x| / pi near x = 0 (at
/// least 1 beyond pi/2) and 2: over an interval of length d <= pi the integral of its size is at most d (1 +
/// log(pi/d)).
Ball modulus_of_continuity(const Ball& distance) {
  const Ball d = abs(distance).upper();
  if (certainly_zero(d)) return 0;
  // |f| <= largest_value
  if (!certainly_less(d, Ball(1))) return Ball(3);
  return (d * (1 + log(Ball::pi() / d))).upper();
}

/// Im Li_2(w) of w = x + iy with x <= 1/2, within the unit disk.
Ball imaginary_part(const Ball& x, const Ball& y) {
  CValue<acb_struct, acb_init, acb_clear> z;
  arb_set(acb_realref(z), in(x));
  arb_set(acb_imagref(z), in(y));
  acb_hypgeom_dilog(z, z, BallPrecision::current());
  return Ball::from_arb(acb_imagref(z), "dilogarithm without a bound");
}

/// f at one point: radius and angle are exact.
Ball at_point(const Ball& radius, const Ball& angle) {
  const Ball s = sin(angle);
  const Ball c = cos(angle);
  const Ball half = Ball(1) / 2;
  if (!certainly_less(half, radius) || !certainly_less(half, c))
    return imaginary_part(radius * c, radius * s);
  // Li_2(z) + Li_2(w) = pi^2/6 - log(z) log(w), w = 1 - z.
  const Ball turns = angle / (2 * Ball::pi());
  Ball whole;
  arf_floor(arb_midref(in(whole)), arb_midref(in(turns + half)));
  const Ball rest = angle - 2 * Ball::pi() * whole;
  // The principal argument is within pi/3 of 0, as cos > 1/2. Where the turns are known to less than one of
  // them, `whole` may be any, and `rest` that of another turn.
  if (!certainly_less(abs(rest), Ball::pi())) return widened(Ball(), Ball(largest_value));
  const Ball half_sine = sin(angle / 2);
  const Ball x = (1 - radius) + 2 * radius * power(half_sine, 2);
  const Ball y = -(radius * s);
  if (!certainly_positive(x)) return widened(Ball(), modulus_of_continuity(rest));
  const Ball argument = atan(y / x);
  const Ball logarithm = log(power(x, 2) + power(y, 2)) / 2;
  return -imaginary_part(x, y) - (log(radius) * argument + rest * logarithm);
}

/// Bits that the value loses against 1 where the angle is near a multiple of pi.
long lost_bits(const Ball& angle) {
  const double size = abs(sin(angle)).lower_double();
  return size > 0 ? std::max<long>(-std::ilogb(size), 0) : BallPrecision::current();
}

template <int Digits>
Mpfr<Digits> rounded(const Mpfr<Digits>& radius, const Mpfr<Digits>& angle) {
  expects(radius >= Mpfr<Digits>(0) && radius <= Mpfr<Digits>(1) && angle.is_finite(),
          "0 <= radius <= 1, a finite angle", named("radius", radius), named("angle", angle));
  const Rational exact_radius = radius.to_rational();
  const Rational exact_angle = angle.to_rational();
  // Sixteen bits beyond those of the result make the midpoint good for rounding.
  long bits = Mpfr<Digits>::bits + 32;
  Ball value;
  for (bool enough = false; !enough; bits *= 2) {
    expects(bits <= most_bits.value(), "an angle not so near to a multiple of pi", named("angle", angle));
    const BallPrecision precision(bits);
    value = dilogarithm_imaginary(Ball(exact_radius), Ball(exact_angle));
    enough = value.is_finite() && (value.is_exact() || value.accurate_bits() >= Mpfr<Digits>::bits + 16);
  }
  CValue<fmpq, fmpq_init, fmpq_clear> quotient;
  CValue<__mpq_struct, mpq_init, mpq_clear> copy;
  arf_get_fmpq(quotient, arb_midref(in(value)));
  fmpq_get_mpq(copy, quotient);
  return Mpfr<Digits>(Rational::from_gmp(copy));
}

}  // namespace

double dilogarithm_imaginary(double radius, double angle) {
  expects(radius >= 0 && radius <= 1 && std::isfinite(angle), "0 <= radius <= 1, a finite angle",
          named("radius", radius), named("angle", angle));
  const ReducedAngle near = reduced(angle);
  if (near.rest == 0 || radius == 0) return 0;
  constexpr double third = std::numbers::pi / 3;
  const bool at_one = !near.from_pi && radius > 0.5 && std::abs(near.rest) < third;
  return at_one ? near_one(radius, near.rest) : away_from_one(radius, near);
}

Mpfr<50> dilogarithm_imaginary(const Mpfr<50>& radius, const Mpfr<50>& angle) {
  return rounded(radius, angle);
}

Mpfr<100> dilogarithm_imaginary(const Mpfr<100>& radius, const Mpfr<100>& angle) {
  return rounded(radius, angle);
}

Ball dilogarithm_imaginary(const Ball& radius, const Ball& angle) {
  if (!radius.is_finite()) return radius;
  if (!angle.is_finite()) return angle;
  if (certainly_negative(radius) || certainly_less(Ball(1), radius)) {
    return Ball::failed("dilogarithm_imaginary of a radius outside of [0, 1]");
  }
  const bool is_inside = certainly_at_most(Ball(0), radius) && certainly_at_most(radius, Ball(1));
  const Ball inside = is_inside ? radius : min(max(radius, Ball(0)), Ball(1));
  // The midpoint of a part cut off can lie outside by a rounding.
  const Ball middle = inside.midpoint();
  const Ball middle_radius = is_inside ? middle : min(max(middle, Ball(0)), Ball(1)).midpoint();
  const Ball middle_angle = angle.midpoint();
  if (certainly_zero(middle_angle) && angle.is_exact()) return 0;
  Ball value;
  {
    // Half a turn away from its series Arb loses some 15 bits.
    constexpr long guard = 24;
    const BallPrecision precision(
        std::min(BallPrecision::current() + guard + lost_bits(middle_angle), BallPrecision::largest_bits));
    value = at_point(middle_radius, middle_angle);
  }
  value = value + Ball();  // rounded to the precision asked for
  if (inside.is_exact() && angle.is_exact()) return value;
  // The mean value theorem along the radius, where |df/dr| = |arg(1 - z)| / r <= arcsin(r) / r <= pi/2, and
  // along the angle, where df/dphi = -log|1 - z|; both bounds are valid, the smaller is used.
  const Ball radius_change = abs(inside - middle_radius).upper();
  const Ball angle_change = angle.radius_ball();
  const Ball squared_distance = power(1 - inside, 2) + 4 * inside * power(sin(angle / 2), 2);
  const Ball coarse = modulus_of_continuity(angle_change);
  Ball along_angle = coarse;
  if (certainly_positive(squared_distance)) {
    along_angle = min(coarse, (abs(log(squared_distance)) / 2 * angle_change).upper());
  }
  return widened(widened(value, Ball::pi() / 2 * radius_change), along_angle);
}

}  // namespace radcert
