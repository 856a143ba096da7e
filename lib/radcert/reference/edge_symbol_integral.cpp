// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/edge_symbol_integral.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/enclosure/interval_integral.h"
#include "radcert/reference/reference_value.h"

namespace radcert::reference {
namespace {

constexpr int shrinkings = 10;  // of the disk in which one zero is proved, by 16 each time

const WorkLimit steps("reference/edge_symbol_integral: steps of Newton's method", 40, 1,
                      "refused, with the exponent reached");

/// The terms from p_n (1/2)^e/e, e = n+2+b and n+1-b, on: what they are summed up with.
template <class Add>
void over_terms(const Ball& cosine, const ComplexBall& b, long count, const Add& add) {
  Ball before(0);
  Ball p(1);
  for (long n = 0; n < count; ++n) {
    add(p, ComplexBall(n + 2) + b, 1);
    add(p, ComplexBall(n + 1) - b, -1);
    const Ball next = (Ball(2 * n + 3) * cosine * p - Ball(n + 2) * before) / Ball(n + 1);
    before = p;
    p = next;
  }
}

ComplexBall half_to(const ComplexBall& e) { return exp(-(e * ComplexBall(log(Ball(2))))); }

/// 8 (N+1)(N+2) 2^(s - N).
Ball tail_from(long n, const Ball& size) {
  return Ball(8 * (n + 1) * (n + 2)) * exp((size - Ball(n)) * log(Ball(2)));
}

double real_size(const ComplexBall& b) { return abs(b.real()).upper_double(); }

}  // namespace

EdgeSymbolIntegral::EdgeSymbolIntegral(const Ball& angle) : cosine_(cos(angle)), sine_(sin(angle)) {
  expects(certainly_positive(angle) && certainly_less(angle, Ball::pi()) && certainly_positive(sine_),
          "0 < angle < pi", named("angle", angle));
}

Outcome<ComplexBall> EdgeSymbolIntegral::at(const ComplexBall& b, int derivative, double radius) const {
  expects((derivative == 0 || derivative == 1) && radius > 0, "derivative 0 or 1, radius > 0",
          named("derivative", derivative), named("radius", radius));
  const double size = real_size(b);
  const long count = 4 + static_cast<long>(std::ceil(size)) +
                     static_cast<long>(std::ceil(1.25 * (size + std::log2(1 / std::min(radius, 1.0)) + 16)));
  const ComplexBall minus_log_two(-log(Ball(2)));
  ComplexBall sum(0);
  {
    // The recurrence multiplies errors by at most 1 + sqrt(2) a term.
    const BallPrecision precision(BallPrecision::current() + 2 * count);
    over_terms(cosine_, b, count, [&](const Ball& p, const ComplexBall& e, int by_b) {
      const ComplexBall one = ComplexBall(1) / e;
      const ComplexBall inner = derivative == 0 ? one : ComplexBall(by_b) * one * (minus_log_two - one);
      sum += ComplexBall(p) * half_to(e) * inner;
    });
  }
  const Ball tail = tail_from(count, Ball(size));
  const auto integral = [&](bool imaginary) -> Enclosure {
    const Ball re = b.real();
    const Ball im = b.imag();
    return integral_on_interval(line_function([&, imaginary, derivative]<class R>(const R& t) {
                                  const R square = R(1) - R(2) * R(cosine_) * t + t * t;
                                  const R l = log(t);
                                  R up = exp((R(1) + R(re)) * l);
                                  R down = exp(-(R(re) * l));
                                  if (derivative == 1) {
                                    up = up * l;
                                    down = -(down * l);
                                  }
                                  const R turned =
                                      imaginary ? (up - down) * sin(R(im) * l) : (up + down) * cos(R(im) * l);
                                  return turned / (square * sqrt(square));
                                }),
                                Ball(Rational(1, 2)), Ball(1), {.radius = radius});
  };
  const Enclosure real = integral(false);
  if (!real) return because(real.reason().to_text());
  Ball imaginary(0);
  if (!b.is_real()) {
    const Enclosure part = integral(true);
    if (!part) return because(part.reason().to_text());
    imaginary = part->value;
  }
  const Ball factor = sine_ * sine_ / Ball(2);
  return ComplexBall(factor * widened(sum.real() + real->value, tail),
                     b.is_real() ? Ball(0) : factor * widened(sum.imag() + imaginary, tail));
}

Ball EdgeSymbolIntegral::second_derivative_bound(const ComplexBall& b, const Ball& by) const {
  const Ball l = log(Ball(2));
  const Ball size = Ball(real_size(b)) + by;
  const long count = 64 + static_cast<long>(std::ceil(2 * size.upper_double()));
  Ball sum(0);
  Ball most(1);  // (n+1)(n+2)/2 >= |p_n|
  long n = 0;
  over_terms(cosine_, b, count, [&](const Ball&, const ComplexBall& e, int by_b) {
    const Ball least = max(abs(e.real()), abs(e.imag())).lower() - by;
    // A disk that may reach a pole has no bound.
    const Ball one = reciprocal(certainly_positive(least) ? least : Ball(0));
    const Ball power_of_half = exp((by - e.real()) * l);
    sum += most * power_of_half * one * (l * l + Ball(2) * l * one + Ball(2) * one * one);
    if (by_b < 0) most = Ball((n + 2) * (n + 3)) / Ball(2), ++n;
  });
  const Ball integral = l * l / Ball(2) * exp((Ball(1) + size) * l) / power(sine_, 3);
  return sine_ * sine_ / Ball(2) * (sum + Ball(4) * tail_from(count, size) + integral);
}

Outcome<ComplexBall> edge_zero_near(const Rational& degrees, const Rational& scale_squared, int sign,
                                    const ComplexBall& start, const Rational& radius) {
  expects(scale_squared.sign() > 0 && radius.sign() > 0 && (sign == 1 || sign == -1),
          "R > 0, radius > 0, sign 1 or -1", named("scale_squared", scale_squared));
  // The series loses a third of the bits at worst: its errors grow by (1 + sqrt(2))/2 a term.
  const BallPrecision precision(3 * bits_for(radius) / 2 + 96);
  const EdgeSymbolIntegral symbol(Ball::pi() * Ball(degrees / Rational(180)));
  const Ball scale = sqrt(Ball(scale_squared));
  const auto f = [&](const ComplexBall& b, int derivative, double accuracy) -> Outcome<ComplexBall> {
    const Outcome<ComplexBall> value = symbol.at(b, derivative, accuracy);
    if (!value) return because(value.reason());
    return ComplexBall(scale) * *value - ComplexBall(derivative == 0 ? sign : 0);
  };
  const double smallest = radius.to_double();
  ComplexBall b(start.real().midpoint(), start.imag().midpoint());
  double width = 1e-2;
  for (long step = 0; step < steps.value(); ++step) {
    const Outcome<ComplexBall> value = f(b, 0, std::max(smallest, width * width) * 1e-3);
    if (!value) return because(value.reason());
    const Outcome<ComplexBall> slope = f(b, 1, std::max(smallest, width) * 1e-3);
    if (!slope) return because(slope.reason());
    if (slope->contains_zero())
      return because("the slope near " + b.to_text() + " was not bounded away from 0");
    const Ball least(max(abs(slope->real()), abs(slope->imag())).lower());
    // Beside a pole or another zero only a smaller disk has one zero.
    Ball r(radius);
    for (int shrunk = 0; shrunk < shrinkings; ++shrunk, r = r / Ball(16)) {
      const Ball rest = r * r / Ball(2) * scale * symbol.second_derivative_bound(b, r);
      if (certainly_less(abs(value->real()) + abs(value->imag()) + rest, least * r))
        return ComplexBall(widened(b.real(), r), b.is_real() ? Ball(0) : widened(b.imag(), r));
    }
    const ComplexBall next = b - *value / *slope;
    if (!((next - start).magnitude_bound() < 0.25))
      return because("Newton's method leaves the neighbourhood of " + start.to_text());
    width = std::min(width / 2, 4 * (next - b).magnitude_bound());
    b = ComplexBall(next.real().midpoint(), b.is_real() ? Ball(0) : next.imag().midpoint());
  }
  return because("Newton's method stands at " + b.to_text());
}

}  // namespace radcert::reference
