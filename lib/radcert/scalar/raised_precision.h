// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/outcome.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// Where the search for a precision ends unless told otherwise. Bits are lost in proportion to the logarithm
/// of the ratio of lengths; for 10^800, the most that decimals from 1e-400 to 1e400 allow,
/// opposed_rectangles, which loses the fourth power, is narrow at 18688 bits and not at 9344.
extern const WorkLimit most_raised_bits;

/// One value at growing precision, until its ball is good enough.
/// Maths     evaluate() at bits, 2 bits, 4 bits, ... <= most_bits; the first ball that accept() takes
/// Requires  smallest_bits <= bits <= most_bits <= largest_bits of BallPrecision, else ContractViolation;
///           evaluate() makes its constants from exact numbers, at the precision current when it is called;
///           accept() takes a finite ball
/// Result    the ball, or the precision tried last and what came of it
/// Limits    the cost of the last evaluation counts: the others together cost about as much again
template <class Evaluate, class Accept>
Outcome<Ball> at_raised_precision(long bits, long most_bits, const Evaluate& evaluate, const Accept& accept) {
  expects(
      BallPrecision::smallest_bits <= bits && bits <= most_bits && most_bits <= BallPrecision::largest_bits,
      "a range of precisions", named("bits", bits), named("most_bits", most_bits));
  for (;;) {
    const BallPrecision scope(bits);
    const Ball value = evaluate();
    if (value.is_finite() && accept(value)) return value;
    if (bits == most_bits)
      return because("at " + std::to_string(bits) + " bits the value is " + value.to_text());
    bits = std::min(2 * bits, most_bits);
  }
}

}  // namespace radcert
