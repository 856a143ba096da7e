// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
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
#include "running_error.h"

namespace radcert::laws {

/// How much has been checked.
struct Checks {
  std::size_t containments = 0;
  /// Of these, where the running error of a double, or of fifty digits, has no bound.
  std::size_t unbounded_doubles = 0;
  std::size_t unbounded_fifty_digits = 0;
};

namespace detail {

template <class Formula>
std::vector<Ball> enclosures_of(const Formula& f, std::span<const Rational> inputs, long bits) {
  const BallPrecision precision(bits);
  std::vector<Ball> values;
  for (const Rational& input : inputs) values.emplace_back(input);
  return f(std::span<const Ball>(values));
}

inline Mpfr<200> in_two_hundred_digits(double x) { return Mpfr<200>(x); }
/// Exactly: a sum of doubles, each nearest to what is left.
inline Mpfr<200> in_two_hundred_digits(Mpfr<50> x) {
  Mpfr<200> sum;
  for (int bits = 0; bits < Mpfr<50>::bits; bits += std::numeric_limits<double>::digits) {
    const double part = x.to_double();
    sum += Mpfr<200>(part);
    x -= Mpfr<50>(part);
  }
  return sum;
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const Mpfr<50>& a, const Mpfr<50>& b) { return a == b; }

/// The same formula in R, and in R with its running error.
template <class R>
struct Rounded {
  std::vector<R> inputs;
  std::vector<R> values;
  std::vector<RunningError<R>> with_errors;

  template <class Formula>
  Rounded(const Formula& f, std::span<const Rational> exact) {
    std::vector<RunningError<R>> inputs_with_errors;
    for (const Rational& input : exact) {
      inputs.push_back(from_rational<R>(input));
      inputs_with_errors.emplace_back(inputs.back(), input);
    }
    values = f(std::span<const R>(inputs));
    with_errors = f(std::span<const RunningError<R>>(inputs_with_errors));
  }

  bool is_bounded(std::size_t k) const { return std::isfinite(with_errors[k].bound()); }
  bool is_within_its_error(std::size_t k, const Mpfr<200>& truth) const {
    return std::abs((in_two_hundred_digits(values[k]) - truth).to_double()) <= with_errors[k].bound();
  }
};

}  // namespace detail

/// One formula in every arithmetic at one set of exact inputs.
/// Maths     f is a class with  template <class R> std::vector<R> operator()(std::span<const R>) const;  with
///           v the values in 200 digits and B_b the balls at b bits:  v in B_128;  B_256 is narrow: its
///           radius is below 2^-100 of B_128's, or below 2^-200 |v|;  |f in R - v| <= the bound of f in
///           RunningError<R>, whose value has the bits of f in R, for R = double and fifty digits;  the pack
///           has the bits of the double
/// Source    running error analysis, see RunningError. The radius of a ball at as many bits is no bound for
///           the double: an operation that is exact for the ball's midpoint adds nothing to it, and rounds
///           the double, another number
/// Requires  inputs where f has a value
/// Result    a failure names the law and the output
/// Limits    where the running error has no bound the rounded value is not looked at, and counted
template <class Formula>
::testing::AssertionResult holds_in_every_arithmetic(const Formula& f, std::span<const Rational> inputs,
                                                     Checks& checks) {
  std::vector<Mpfr<200>> exact_inputs;
  for (const Rational& input : inputs) exact_inputs.emplace_back(input);
  const std::vector<Mpfr<200>> truth = f(std::span<const Mpfr<200>>(exact_inputs));
  const std::vector<Ball> balls = detail::enclosures_of(f, inputs, 128);
  const std::vector<Ball> finer = detail::enclosures_of(f, inputs, 256);
  const detail::Rounded<Mpfr<50>> fifty(f, inputs);
  const detail::Rounded<double> doubles(f, inputs);
  const std::vector<Pack> packed_inputs(doubles.inputs.begin(), doubles.inputs.end());
  const std::vector<Pack> packs = f(std::span<const Pack>(packed_inputs));
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
    if (!fifty.is_bounded(k)) {
      ++checks.unbounded_fifty_digits;
    } else {
      if (!detail::same_bits(fifty.values[k], fifty.with_errors[k].value()))
        return fails("fifty digits with their error are those without");
      if (!fifty.is_within_its_error(k, truth[k])) return fails("fifty digits are right");
    }
    if (!doubles.is_bounded(k)) {
      ++checks.unbounded_doubles;
      continue;
    }
    if (!detail::same_bits(doubles.values[k], doubles.with_errors[k].value()))
      return fails("the double with its error is that without");
    if (!doubles.is_within_its_error(k, truth[k])) return fails("the double is within its error");
    for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
      if (!detail::same_bits(packs[k].lane(lane), doubles.values[k]))
        return fails("the pack has the bits of the double");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace radcert::laws
