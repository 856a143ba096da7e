// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/reference/reference_value.h"

namespace radcert::reference::values {

/// Numbers made of rationals in the arithmetic of an integrand's argument.
template <class R>
R in(const Rational& value) {
  return from_rational<R>(value);
}

/// A factor times Int_from^to f(x) dx; f is a generic lambda of x in balls, real and complex.
/// Maths     |value - factor Int| <= demand.radius
/// Source    integral_on_interval
/// Requires  factor != 0
/// Result    enclosed, or undecided, as where the factor is so large that no double is the integral's radius
template <class Formula>
Enclosure times_integral(const Ball& factor, const Formula& f, const Ball& from, const Ball& to,
                         const Demand& demand) {
  const double radius =
      std::min(demand.radius / (2 * abs(factor).upper_double()), std::numeric_limits<double>::max());
  if (!(radius > 0)) {
    constexpr const char* why = "the factor of an integral leaves no radius that double can hold";
    return because(Undecided{.why = why, .reached = Ball::failed(why)});
  }
  const Enclosure integral =
      integral_on_interval(line_function(f), from, to, {.radius = radius, .work_limit = demand.work_limit});
  if (!integral) return integral;
  return Enclosed{.value = factor * integral->value, .evaluations = integral->evaluations};
}

/// The sum of two enclosures, each made for half the radius.
template <class First, class Second>
Enclosure sum_of(const First& first, const Second& second, const Demand& demand) {
  const Demand half{.radius = demand.radius / 2, .work_limit = demand.work_limit};
  const Enclosure a = first(half);
  if (!a) return a;
  const Enclosure b = second(half);
  if (!b) return b;
  return Enclosed{.value = a->value + b->value, .evaluations = a->evaluations + b->evaluations};
}

}  // namespace radcert::reference::values
