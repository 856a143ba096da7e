// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// The precision at which balls are computed while it lives.
/// Maths     midpoints are rounded to that many bits; the radius takes the rounding up
/// Source    Arb's `prec`
/// Requires  2 <= bits <= 10^6, else ContractViolation; precisions of one thread end in the reverse order of
///           their beginning, as scopes do
/// Result    current() is the innermost precision of the calling thread, default_bits where there is none
/// Limits    each thread has its own: whoever starts parallel work reads current() and opens it again inside,
///           as in `const long bits = BallPrecision::current(); parallel_for(n, [&](...) { const
///           BallPrecision inside(bits); ... });`. A ball that exists keeps its digits: constants made at 64
///           bits enclose, and stay wide, at 256
class BallPrecision {
public:
  static constexpr long smallest_bits = 2;
  static constexpr long largest_bits = 1000000;
  static constexpr long default_bits = 128;

  explicit BallPrecision(long bits);
  ~BallPrecision();
  BallPrecision(const BallPrecision&) = delete;
  BallPrecision& operator=(const BallPrecision&) = delete;

  [[nodiscard]] static long current() noexcept;

private:
  long outer_;
};

}  // namespace radcert
