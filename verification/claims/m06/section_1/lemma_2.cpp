// SPDX-License-Identifier: GPL-3.0-or-later

// Lemma 2 is [ac98, Lemma 2.3], and fails with it where a curved piece has a corner: for u = 1 on the roof z
// = 2 - x^2 of two_piece(2) and rho = 1/2 the mixed derivative of K u has no limit at the corner (0,0).
//
// Theorem 3 (b), m = 2, for E = 1 and rho = 1/2 on the same S: the solution u = 1 + K u + ... is at least 1,
// as K is positive. Suppose it were in C^2. Then so were K u = u - 1. With phi(w,x,d) = w^4/[w^2 (1 + (2x +
// w)^2) + d^2]^2 and p(x) = (1 + 4x^2)^(-1/2), the part of 2 pi K u that comes from the roof is p(x) Int Int
// phi(xi - x, x, y - eta) u(xi,eta) d xi d eta; what comes from the square is analytic there. phi depends on
// y - eta alone, so that D_y is an integral of u_eta and values at eta = 0 and 1; on each of these D_x moves
// to xi as well, up to phi_x by x with w fixed, which is bounded. What is left are integrals of bounded
// functions that converge off w = 0, and are continuous at the corner by dominated convergence, and the value
// where xi = 0 and eta = 0 meet: u(0,0) p(x) phi(-x,x,y), phi(-x,x,y) = x^4/[x^2 (1 + x^2) + y^2]^2. It tends
// to u(0,0) >= 1 along y = x^2 and to 0 along x = y^2: K u is not in C^2, and u is not.
//
// Checked      theorem_3_b: what Lemma 2's check has of K u for u = 1; that last term for u(0,0) = 1, a lower
//              bound of its difference, at (t, t^2) and (t^2, t); and for the part of u that vanishes at the
//              corner the mixed derivative of K v, v = x, whose difference tends to 0.
// Not checked  the step in words above: that of all terms only one has no limit, for a u of C^2 that is not
//              known.

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/ac98/surfaces/corner_derivative.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// x^4/[x^2 (1 + x^2) + y^2]^2.
Rational at_the_corner(const Rational& x, const Rational& y) {
  const Rational q = x * x * (1 + x * x) + y * y;
  return power(x, 4) / (q * q);
}

// p(x)/(2 pi) times it: a lower bound of the term that has no limit, as u >= 1; the other one counts with u
// <= 2.
Ball least_difference(const Rational& t) {
  const auto factor = [](const Rational& x) {
    return Ball(1) / (sqrt(Ball(1 + 4 * x * x)) * Ball(2) * Ball::pi());
  };
  return factor(t) * Ball(at_the_corner(t, t * t)) - Ball(2) * factor(t * t) * Ball(at_the_corner(t * t, t));
}

// Int phi(w,x,d) (x + w)^k dw from -x to 1 - x, and of phi_x (x + w), the derivative by x with w fixed.
class OfX {
public:
  OfX(const Rational& x, const Rational& d) : x_(x), d_(d) {}

  [[nodiscard]] Ball moment(int k) const {
    return over([here = *this, k]<class R>(const R& w) -> R {
      const R q = here.denominator(w);
      const R phi = w * w * w * w / (q * q);
      return k == 0 ? phi : phi * (from_rational<R>(here.x_) + w);
    });
  }
  [[nodiscard]] Ball moment_by_x() const {
    return over([here = *this]<class R>(const R& w) -> R {
      const R q = here.denominator(w);
      const R w_2 = w * w;
      return R(-8) * w_2 * w_2 * w_2 * (R(2) * from_rational<R>(here.x_) + w) / (q * q * q) *
             (from_rational<R>(here.x_) + w);
    });
  }
  // phi at w = 1 - x.
  [[nodiscard]] Ball at_the_end() const {
    const Ball w(1 - x_);
    const Ball q = denominator(w);
    return power(w, 4) / (q * q);
  }

private:
  template <class R>
  [[nodiscard]] R denominator(const R& w) const {
    const R bend = R(2) * from_rational<R>(x_) + w;
    return w * w * (R(1) + bend * bend) + from_rational<R>(d_ * d_);
  }
  template <class Formula>
  [[nodiscard]] Ball over(const Formula& formula) const {
    // The integrand changes at |w| = d: two pieces about w = 0.
    const LineFunction f = line_function(formula);
    const Demand demand{.radius = 1e-12};
    return ac98::known(integral_on_interval(f, Ball(-x_), Ball(0), demand)) +
           ac98::known(integral_on_interval(f, Ball(0), Ball(1 - x_), demand));
  }

  Rational x_;
  Rational d_;
};

// D_x {p(x) Int phi (x + w) dw}: at w = -x the factor x + w is 0.
Ball slope(const Rational& x, const Rational& d) {
  const OfX of(x, d);
  const Ball p = Ball(1) / sqrt(Ball(1 + 4 * x * x));
  return p * (of.moment(0) + of.moment_by_x() - of.at_the_end()) -
         Ball(4 * x) * p / Ball(1 + 4 * x * x) * of.moment(1);
}

// The mixed derivative of K v, v = x on the roof, rho = 1/2.
Ball mixed_derivative(const Rational& x, const Rational& y) {
  return (slope(x, y) - slope(x, y - 1)) / (Ball(2) * Ball::pi());
}

}  // namespace

Finding lemma_2(const Bench&) { return ac98::mixed_derivative_at_a_corner(); }

Finding theorem_3_b(const Bench&) {
  const BallPrecision precision(128);
  const AtMost small{
      .value = 0.125, .slack = 0, .why = "two sequences of one limit come nearer than any number"};
  Finding finding = ac98::mixed_derivative_at_a_corner();
  for (const int k : {4, 8, 12}) {
    const Rational t = 1 / power(Rational(2), k);
    const std::string at = ", t = 2^-" + std::to_string(k);
    finding.require(
        "what u(0,0) >= 1 adds to the mixed derivative of u at (t, t^2) less that at (t^2, t)" + at, small,
        ac98::proved(least_difference(t)));
    finding.instead(
        "mixed derivative of K v at (t, t^2) less that at (t^2, t), v = x, which is 0 at the corner" + at,
        small, ac98::proved(abs(mixed_derivative(t, t * t) - mixed_derivative(t * t, t))));
  }
  const Rational third(1, 3);
  const Rational step(1, 4096);
  const auto strip = [](const Rational& x, const Rational& d) {
    return OfX(x, d).moment(1) / sqrt(Ball(1 + 4 * x * x));
  };
  const Rational d(1, 5);
  // The square of the step, times a third derivative.
  finding.instead(
      "derivative of p Int phi (x + w) dw against its difference quotient",
      AgreesWith{.value = (strip(third + step, d) - strip(third - step, d)) / Ball(2 * step), .within = 1e-4},
      slope(third, d));
  return finding;
}

}  // namespace radcert::verification::m06
