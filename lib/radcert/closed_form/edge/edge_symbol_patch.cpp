// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/edge_symbol_patch.h"

#include <cmath>
#include <cstddef>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"

namespace radcert {
namespace {

constexpr long degree = 24;
constexpr long reach = 4;  // rho/r: 4^-24 is below what a box of a search is told from zero by

ComplexBall around(const ComplexBall& z, const Ball& by) {
  return {widened(z.real(), by), widened(z.imag(), by)};
}

ComplexBall midpoint_of(const ComplexBall& b) { return {b.real().midpoint(), b.imag().midpoint()}; }

}  // namespace

EdgeSymbolPatch::EdgeSymbolPatch(const EdgeSymbol& symbol, const ComplexBall& set)
    : set_(set), centre_(midpoint_of(set)), x_(symbol.at_zero()), coefficients_(degree) {
  const ComplexBall beta = centre_ * (centre_ + ComplexBall(1));
  const Ball r(((set - centre_) * (set + centre_ + ComplexBall(1))).magnitude_bound());
  expects(certainly_positive(r), "a set of exponents around its midpoint", named("radius", r));
  const Ball rho = Ball(reach) * r;
  const Ball size = Ball(beta.magnitude_bound()) + rho;
  const Ball complement = Ball(1) - x_;
  const long least = static_cast<long>(std::ceil(size.upper_double() / 2)) + 1;
  const Ball small = power(Ball(2), -BallPrecision::current());
  std::vector<ComplexBall> term(degree);  // the Taylor coefficients of a_n x^n
  term[0] = ComplexBall(1);
  Ball bound(1);  // A_n x^n
  Ball sum_of_bounds(0);
  constexpr long often = 1024;
  for (long n = 0; n < symbol.most_terms(); ++n) {
    if (n % often == 0) throw_if_interrupted();
    if (n >= least && certainly_less(bound, small)) {
      const Ball q = Ball(1) / Ball(reach);
      const Ball rest = sum_of_bounds * power(q, degree) / (Ball(1) - q);
      const Ball tail = bound / complement;
      error_ = rest + tail;
      slope_error_ = rest * Ball(degree + 1) / ((Ball(1) - q) * r) + tail / (rho - r);
      return;
    }
    for (std::size_t j = 0; j < term.size(); ++j) coefficients_[j] += term[j];
    sum_of_bounds += bound;
    const Ball step = x_ / Ball((n + 1) * (n + 2));
    const ComplexBall factor = (ComplexBall(n * (n + 1)) - beta) * ComplexBall(step);
    for (std::size_t j = term.size(); j-- > 0;)
      term[j] = j == 0 ? term[j] * factor : term[j] * factor - term[j - 1] * ComplexBall(step);
    bound = (bound * (Ball(n * (n + 1)) + size) * step).upper();
  }
  error_ = slope_error_ = Ball::failed("an angle too small for the series of an edge's symbol");
}

SymbolValue EdgeSymbolPatch::entire(const ComplexBall& b) const {
  if (!error_.is_finite() || !set_.contains(b)) {
    const ComplexBall failed =
        ComplexBall::failed(error_.is_finite() ? "an exponent beside the patch" : error_.failure().data());
    return {failed, failed};
  }
  const ComplexBall d = (b - centre_) * (b + centre_ + ComplexBall(1));
  ComplexBall f(0);
  ComplexBall slope(0);
  for (std::size_t j = coefficients_.size(); j-- > 0;) {
    slope = slope * d + f;
    f = f * d + coefficients_[j];
  }
  f = around(f, error_);
  slope = around(slope, slope_error_);
  const ComplexBall beta = b * (b + ComplexBall(1));
  const ComplexBall x(x_);
  return {.value = x * beta * f, .slope = x * (ComplexBall(2) * b + ComplexBall(1)) * (f + beta * slope)};
}

}  // namespace radcert
