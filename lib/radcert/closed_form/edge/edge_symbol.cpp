// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/edge_symbol.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit terms("closed_form/edge/edge_symbol: terms of the series", 400000, 2,
                      "a failed ball: the angle is too small");

/// At least |z|; unlike the root of a sum of squares also where the parts may be 0.
Ball size_of(const ComplexBall& z) { return (abs(z.real()) + abs(z.imag())).upper(); }

}  // namespace

EdgeSymbol::EdgeSymbol(const Ball& angle) : angle_(angle) {
  expects(certainly_positive(angle) && certainly_less(angle, Ball::pi()), "0 < angle < pi",
          named("angle", angle));
  const Ball cosine = cos(angle / Ball(2));
  const Ball sine = sin(angle / Ball(2));
  x_ = cosine * cosine;
  complement_ = sine * sine;
  expects(certainly_positive(complement_), "an angle that the precision tells from 0", named("angle", angle));
}

long EdgeSymbol::most_terms() { return terms.value(); }

SymbolValue EdgeSymbol::entire(const ComplexBall& b) const {
  const ComplexBall beta = b * (b + ComplexBall(1));
  const double size = beta.magnitude_bound();
  const double limit = static_cast<double>(terms.value());
  if (!(size / 2 < limit)) {
    const ComplexBall failed =
        ComplexBall::failed("an exponent too large for the series of an edge's symbol");
    return {failed, failed};
  }
  // The sum is taken until a term is below the precision, in doubles that decide nothing but where to end.
  const double small = std::ldexp(1.0, -static_cast<int>(std::min(BallPrecision::current() + 8, 1000L)));
  const long enough_by_size = static_cast<long>(std::ceil(size / 2)) + 1;
  const double decay = std::log(x_.upper_double());
  const double length =
      decay < 0 ? static_cast<double>(BallPrecision::current() + 8) * std::log(2.0) / -decay : limit;
  const long count = enough_by_size + static_cast<long>(std::min(std::ceil(length), limit));
  if (count > terms.value()) {
    const ComplexBall failed = ComplexBall::failed("an angle too small for the series of an edge's symbol");
    return {failed, failed};
  }
  const ComplexBall x(x_);
  ComplexBall term(1);  // a_n x^n and its derivative by beta
  ComplexBall term_slope(0);
  ComplexBall sum(0);
  ComplexBall sum_slope(0);
  long n = 0;
  for (; n < count; ++n) {
    sum += term;
    sum_slope += term_slope;
    if (n >= enough_by_size && term.magnitude_bound() < small && term_slope.magnitude_bound() < small) {
      ++n;
      break;
    }
    const ComplexBall step = x / ComplexBall((n + 1) * (n + 2));
    const ComplexBall factor = (ComplexBall(n * (n + 1)) - beta) * step;
    term_slope = term_slope * factor - term * step;
    term = term * factor;
  }
  // Where the loop was left early the last term stands in the sum already and bounds the tail all the same.
  const Ball ends = size_of(term) / complement_;
  const Ball slope_ends = (size_of(term_slope) + size_of(term) / Ball(n)) / complement_;
  const auto around = [](const ComplexBall& z, const Ball& by) {
    return ComplexBall(widened(z.real(), by), widened(z.imag(), by));
  };
  const ComplexBall f = around(sum, ends);
  const ComplexBall f_slope = around(sum_slope, slope_ends);
  const ComplexBall beta_slope = ComplexBall(2) * b + ComplexBall(1);
  return {.value = x * beta * f, .slope = x * beta_slope * (f + beta * f_slope)};
}

ComplexBall EdgeSymbol::operator()(const ComplexBall& b) const {
  const ComplexBall pi(Ball::pi());
  return pi * entire(b).value / sin(pi * b);
}

}  // namespace radcert
