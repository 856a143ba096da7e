// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/gauss.h"

#include <arb.h>
#include <arb_hypgeom.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit newton_steps("polynomial/gauss: steps to a zero", 60, 1, "no rule: AccuracyNotReached");
const WorkLimit doublings("polynomial/gauss: doublings of an enclosed zero's digits", 24, 0,
                          "the zero is not isolated: a failed ball");

template <Real R>
struct ValueAndSlope {
  R value;
  R slope;
};

/// P_n^(0,b)(z) and its derivative by the three-term recurrence.
template <Real R>
ValueAndSlope<R> jacobi(int n, int b, const R& z) {
  ValueAndSlope<R> before{R(1), R(0)};
  ValueAndSlope<R> now{R(1) + R(b + 2) * (z - R(1)) / R(2), R(b + 2) / R(2)};
  for (int k = 2; k <= n; ++k) {
    const int m = 2 * k + b;
    const R scale = R(2 * k) * R(k + b) * R(m - 2);
    const R linear = R(m - 1) * R(m) * R(m - 2);
    const R constant = R(m - 1) * R(-b * b);
    const R old = R(2 * (k - 1)) * R(k + b - 1) * R(m);
    const ValueAndSlope<R> next{
        ((linear * z + constant) * now.value - old * before.value) / scale,
        (linear * now.value + (linear * z + constant) * now.slope - old * before.slope) / scale};
    before = now;
    now = next;
  }
  return now;
}

[[noreturn]] void not_found(int points) {
  throw AccuracyNotReached("Gauss' rule of " + std::to_string(points) + " points",
                           "its zeros were not found by " + std::to_string(newton_steps.value()) + " steps");
}

template <Real R>
IntervalRule<R> compute(int points, int b) {
  using std::abs;
  using std::cos;
  std::vector<R> zeros;
  for (int k = 0; k < points; ++k) {
    R z = -cos(pi<R>() * (R(4 * k + 3) / R(4)) / (R(points) + R(b + 1) / R(2)));
    // Newton with the zeros already found divided out: converges to a new one from every start used here; the
    // last two steps are plain Newton, to the last digit.
    for (long step = 0; step < newton_steps.value(); ++step) {
      const ValueAndSlope<R> p = jacobi(points, b, z);
      R found = R(0);
      for (const R& zero : zeros) found += R(1) / (z - zero);
      const R change = p.value / (p.slope - p.value * found);
      z -= change;
      if (abs(change) < R(4) * unit_roundoff<R>()) break;
    }
    R change = R(1);
    for (int step = 0; step < 2; ++step) {
      const ValueAndSlope<R> p = jacobi(points, b, z);
      change = p.value / p.slope;
      z -= change;
    }
    // What is left is rounding, see Result: Newton's method has squared far larger steps away.
    if (!(abs(change) <= R(16 * points * points) * unit_roundoff<R>())) not_found(points);
    zeros.push_back(z);
  }
  std::sort(zeros.begin(), zeros.end());
  if (!(R(-1) < zeros.front() && zeros.back() < R(1)) ||
      std::adjacent_find(zeros.begin(), zeros.end(), [](const R& a, const R& c) { return !(a < c); }) !=
          zeros.end())
    not_found(points);
  IntervalRule<R> rule;
  for (const R& z : zeros) {
    const R slope = jacobi(points, b, z).slope;
    rule.nodes.push_back((R(1) + z) / R(2));
    rule.weights.push_back(R(1) / ((R(1) - z) * (R(1) + z) * slope * slope));
  }
  return rule;
}

/// A ball around the zero of P^(0,1) near z and nowhere else: Newton's method on exact midpoints, then
/// Newton's operator.
Ball enclosed_zero(int points, double z) {
  Ball middle(z);
  Ball step(1);
  // Each step doubles the digits: from those of a double to those of the largest precision there is.
  for (long k = 0;
       k < doublings.value() && !certainly_less(abs(step), power(Ball(2), -BallPrecision::current())); ++k) {
    const ValueAndSlope<Ball> p = jacobi(points, 1, middle);
    step = (p.value / p.slope).midpoint();
    middle = (middle - step).midpoint();
  }
  const ValueAndSlope<Ball> p = jacobi(points, 1, middle);
  const Ball around = widened(middle, Ball(2) * (p.value / p.slope));
  const Ball zero = middle - p.value / jacobi(points, 1, around).slope;
  // N(X) in X: P has exactly one zero in X, and it lies in N(X).
  return around.contains(zero) ? zero : Ball::failed("a Gauss rule's zero was not isolated");
}

/// The rule for the weight x.
IntervalRule<Ball> enclosed_variable(int points) {
  IntervalRule<Ball> rule;
  // Newer and older term of the recurrence have factors below 2 and 1: a radius grows by less than two bits a
  // step.
  const BallPrecision guarded(BallPrecision::current() + 2 * points + 40);
  std::vector<Ball> zeros;
  for (const double node : gauss_rule<double>(points, IntervalWeight::variable).nodes) {
    zeros.push_back(enclosed_zero(points, 2 * node - 1));
    if (zeros.size() > 1 && !certainly_less(zeros[zeros.size() - 2], zeros.back()))
      zeros.back() = Ball::failed("two zeros of a Gauss rule were not told apart");
  }
  for (const Ball& z : zeros) {
    const Ball slope = jacobi(points, 1, z).slope;
    rule.nodes.push_back((Ball(1) + z) / Ball(2));
    rule.weights.push_back(Ball(1) / ((Ball(1) - z) * (Ball(1) + z) * slope * slope));
  }
  return rule;
}

/// The rule for the weight 1.
IntervalRule<Ball> enclosed_one(int points) {
  // The least node is about 1/points^2, and 1 + z loses as many digits of z.
  constexpr long guard_bits = 32;
  const BallPrecision guarded(BallPrecision::current() + guard_bits);
  IntervalRule<Ball> rule = legendre_rule(points);
  for (Ball& node : rule.nodes) node = (1 + node) / 2;
  for (Ball& weight : rule.weights) weight = weight / 2;
  return rule;
}

}  // namespace

IntervalRule<Ball> legendre_rule(int points) {
  expects(points >= 1, "points >= 1", named("points", points));
  IntervalRule<Ball> rule;
  CValue<arb_struct, arb_init, arb_clear> node;
  CValue<arb_struct, arb_init, arb_clear> weight;
  // Arb's zeros descend.
  for (int k = points - 1; k >= 0; --k) {
    arb_hypgeom_legendre_p_ui_root(node, weight, static_cast<ulong>(points), static_cast<ulong>(k),
                                   BallPrecision::current());
    rule.nodes.push_back(Ball::from_arb(node, "a Gauss node without a bound"));
    rule.weights.push_back(Ball::from_arb(weight, "a Gauss weight without a bound"));
  }
  return rule;
}

template <Real R>
IntervalRule<R> gauss_rule(int points, IntervalWeight weight) {
  expects(1 <= points && points <= 192, "1 <= points <= 192", named("points", points));
  const int b = weight == IntervalWeight::variable ? 1 : 0;
  if constexpr (std::is_same_v<R, double>) {
    const IntervalRule<long double> exact = compute<long double>(points, b);
    IntervalRule<double> rule;
    for (const long double node : exact.nodes) rule.nodes.push_back(static_cast<double>(node));
    for (const long double w : exact.weights) rule.weights.push_back(static_cast<double>(w));
    return rule;
  } else if constexpr (std::is_same_v<R, Ball>) {
    return weight == IntervalWeight::one ? enclosed_one(points) : enclosed_variable(points);
  } else {
    return compute<R>(points, b);
  }
}

template IntervalRule<double> gauss_rule<double>(int, IntervalWeight);
template IntervalRule<long double> gauss_rule<long double>(int, IntervalWeight);
template IntervalRule<Mpfr<50>> gauss_rule<Mpfr<50>>(int, IntervalWeight);
template IntervalRule<Ball> gauss_rule<Ball>(int, IntervalWeight);

}  // namespace radcert
