// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>

#include "radcert/scalar/pack.h"

namespace radcert::reference {

/// Both hyperbolic functions of one argument.
struct SinhCosh {
  Pack sinh;
  Pack cosh;
};

namespace detail {

constexpr double inverse_factorial(int n) {
  double factorial = 1;  // exact up to 18!
  for (int k = 2; k <= n; ++k) factorial *= k;
  return 1 / factorial;
}

/// e^x, for |x| <= 700, to two units in the last place: x = k log 2 + r and Taylor's series of e^r.
inline Pack exponential(const Pack& x) {
  constexpr double shift = 0x1.8p52;  // adding it rounds to a whole number
  const Pack k = fma(x, 1.4426950408889634, shift) - shift;
  // log 2 in two parts, the first with so few bits that k times it is exact.
  const Pack r = fma(k, -0x1.3de6af278ece6p-42, fma(k, -0x1.62e42fefa3p-1, x));
  Pack sum = inverse_factorial(13);
  for (int n = 12; n >= 0; --n) sum = fma(sum, r, inverse_factorial(n));
  const auto power_of_two = [](double exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(exponent) + 1023)
                                 << 52U);
  };
  return sum * by_lane(power_of_two, k);
}

}  // namespace detail

/// sinh and cosh of eight numbers.
/// Maths     (e^x - e^-x) / 2, (e^x + e^-x) / 2
/// Requires  |x| <= 700
/// Result    sinh with an absolute error of a few units in the last place of cosh, cosh with a relative one
/// Limits    digits of sinh are lost near 0: a map that sends x to delta sinh(x) moves its points by an ulp
///           of delta there
inline SinhCosh sinh_cosh(const Pack& x) {
  const Pack e = detail::exponential(x);
  const Pack f = Pack(1.0) / e;
  return {Pack(0.5) * (e - f), Pack(0.5) * (e + f)};
}

}  // namespace radcert::reference
