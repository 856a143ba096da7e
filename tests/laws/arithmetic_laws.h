// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "radcert/scalar/ball.h"
#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/pack.h"
#include "radcert/scalar/rational.h"

namespace radcert::laws {

/// How much has been checked.
struct Checks {
  std::size_t containments = 0;
};

namespace detail {

template <class R>
std::vector<R> in_arithmetic(std::span<const Rational> inputs) {
  std::vector<R> values;
  for (const Rational& input : inputs) values.push_back(from_rational<R>(input));
  return values;
}

template <class R, class Formula>
std::vector<R> values_of(const Formula& f, std::span<const Rational> inputs) {
  const std::vector<R> values = in_arithmetic<R>(inputs);
  return f(std::span<const R>(values));
}

template <class Formula>
std::vector<Ball> enclosures_of(const Formula& f, std::span<const Rational> inputs, long bits) {
  const BallPrecision precision(bits);
  return values_of<Ball>(f, inputs);
}

}  // namespace detail

/// One formula in every arithmetic at one set of exact inputs.
/// Maths     f is a class with  template <class R> std::vector<R> operator()(std::span<const R>) const;  with v the values in
///           200 digits and B_b the balls at b bits:  v in B_128;  B_256 is narrow: its radius is below 2^-100 of B_128's, or
///           below 2^-200 |v|;  |f in 50 digits - v| <= 2 radius of B at as many bits, and the same for double at 53 bits;
///           the pack has the bits of the double
/// Source    ball arithmetic bounds the rounding of the same formula at the same precision, so its radius is the stated error
/// Requires  inputs where f has a value
/// Result    a failure names the law and the output
/// Limits    libm rounds its functions to about one unit, not half of one: hence the factor 2
template <class Formula>
::testing::AssertionResult holds_in_every_arithmetic(const Formula& f, std::span<const Rational> inputs,
                                                     Checks& checks) {
  const std::vector<Mpfr<200>> truth = detail::values_of<Mpfr<200>>(f, inputs);
  const std::vector<Ball> balls = detail::enclosures_of(f, inputs, 128);
  const std::vector<Ball> finer = detail::enclosures_of(f, inputs, 256);
  const std::vector<Mpfr<50>> fifty = detail::values_of<Mpfr<50>>(f, inputs);
  const std::vector<Ball> as_fifty = detail::enclosures_of(f, inputs, Mpfr<50>::bits);
  const std::vector<double> doubles = detail::values_of<double>(f, inputs);
  const std::vector<Ball> as_double = detail::enclosures_of(f, inputs, 53);
  const std::vector<Pack> packs = detail::values_of<Pack>(f, inputs);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto fails = [&](const char* law) {
      std::string at;
      for (const Rational& input : inputs) at += " " + input.to_text();
      return ::testing::AssertionFailure() << law << ": output " << k << ", " << truth[k].to_text(40)
                                           << " in " << balls[k].to_text(40) << ", inputs" << at;
    };
    if (!truth[k].is_finite()) return fails("no value");
    ++checks.containments;
    if (!balls[k].contains(truth[k].to_rational())) return fails("the ball contains the value");
    const double narrow =
        std::max(std::ldexp(balls[k].radius(), -100), std::ldexp(std::abs(truth[k].to_double()), -200));
    // radius() is exact from 2^-1000 on.
    const bool measurable = balls[k].is_exact() || narrow > 0x1p-990;
    if (measurable && !(finer[k].radius() <= narrow)) return fails("the ball is narrow");
    const double fifty_error = std::abs((Mpfr<200>(fifty[k].to_rational()) - truth[k]).to_double());
    if (!(fifty_error <= 2 * as_fifty[k].radius())) return fails("fifty digits are right");
    if (!as_double[k].is_finite()) continue;  // 53 bits do not decide whether the formula has a value
    const double double_error = std::abs((Mpfr<200>(doubles[k]) - truth[k]).to_double());
    if (!(double_error <= 2 * as_double[k].radius())) return fails("the double is within its error");
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
      if (std::bit_cast<std::uint64_t>(packs[k].lane(lane)) != std::bit_cast<std::uint64_t>(doubles[k]))
        return fails("the pack has the bits of the double");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
