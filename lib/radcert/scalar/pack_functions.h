// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "radcert/scalar/pack.h"

/// A call would send packs through memory.
#if defined(__GNUC__)
#define RADCERT_PACK_INLINE __attribute__((always_inline))
#else
#define RADCERT_PACK_INLINE
#endif

namespace radcert {

/// The registers that a pack fills, for operations that Pack itself does not have.
/// Maths     lanes 0-3 and 4-7
/// Source    -
/// Requires  -
/// Result    copied by memory of a whole register at a time, which the compiler leaves out
/// Limits    -
struct PackHalves {
  // NOLINTBEGIN(modernize-use-using)
  typedef double Numbers __attribute__((vector_size(Pack::lanes / 2 * sizeof(double))));
  typedef std::int64_t Bits __attribute__((vector_size(Pack::lanes / 2 * sizeof(double))));
  typedef std::uint64_t Words __attribute__((vector_size(Pack::lanes / 2 * sizeof(double))));
  // NOLINTEND(modernize-use-using)
  static constexpr std::size_t lanes = Pack::lanes / 2;

  RADCERT_PACK_INLINE explicit PackHalves(const Pack& a) {
    alignas(Numbers) std::array<double, Pack::lanes> memory;
    a.store(memory.data());
    std::memcpy(&low, memory.data(), sizeof(Numbers));
    std::memcpy(&high, memory.data() + lanes, sizeof(Numbers));
  }
  RADCERT_PACK_INLINE PackHalves(const Numbers& first, const Numbers& second) : low(first), high(second) {}
  [[nodiscard]] RADCERT_PACK_INLINE Pack pack() const {
    alignas(Numbers) std::array<double, Pack::lanes> memory;
    std::memcpy(memory.data(), &low, sizeof(Numbers));
    std::memcpy(memory.data() + lanes, &high, sizeof(Numbers));
    return Pack::load(memory.data());
  }

  Numbers low;
  Numbers high;
};

/// A truth for every lane of a pack.
/// Maths     less(a, b) holds in the lanes where a < b; select(m, a, b) is a where m holds and b elsewhere
/// Source    -
/// Requires  -
/// Result    no lane touches another; comparisons with what is no number do not hold
/// Limits    -
class PackMask {
public:
  using Bits = PackHalves::Bits;

  /// In no lane.
  PackMask() : low_(Bits{}), high_(Bits{}) {}
  RADCERT_PACK_INLINE PackMask(const Bits& low, const Bits& high) : low_(low), high_(high) {}

  RADCERT_PACK_INLINE friend PackMask operator&(const PackMask& a, const PackMask& b) {
    return {a.low_ & b.low_, a.high_ & b.high_};
  }
  RADCERT_PACK_INLINE friend PackMask operator|(const PackMask& a, const PackMask& b) {
    return {a.low_ | b.low_, a.high_ | b.high_};
  }
  RADCERT_PACK_INLINE PackMask operator!() const { return {~low_, ~high_}; }
  RADCERT_PACK_INLINE friend Pack select(const PackMask& mask, const Pack& yes, const Pack& no) {
    const PackHalves x(yes);
    const PackHalves y(no);
    return PackHalves(mask.low_ < 0 ? x.low : y.low, mask.high_ < 0 ? x.high : y.high).pack();
  }
  /// The lanes where it holds, lane k as the bit 2^k.
  [[nodiscard]] unsigned lanes() const {
    constexpr unsigned half = PackHalves::lanes;
    unsigned found = 0;
    for (unsigned k = 0; k < half; ++k) {
      found |= static_cast<unsigned>(low_[k] & 1) << k | static_cast<unsigned>(high_[k] & 1) << (k + half);
    }
    return found;
  }

private:
  Bits low_;
  Bits high_;
};

RADCERT_PACK_INLINE inline PackMask less(const Pack& a, const Pack& b) {
  const PackHalves x(a);
  const PackHalves y(b);
  return {x.low < y.low, x.high < y.high};
}
RADCERT_PACK_INLINE inline PackMask at_most(const Pack& a, const Pack& b) {
  const PackHalves x(a);
  const PackHalves y(b);
  return {x.low <= y.low, x.high <= y.high};
}

/// a b + c with one rounding, as fma, in one instruction a register also inside of loops.
RADCERT_PACK_INLINE inline Pack fused(const Pack& a, const Pack& b, const Pack& c) {
#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
  const PackHalves x(a);
  const PackHalves y(b);
  const PackHalves z(c);
  return PackHalves(__builtin_ia32_vfmaddpd256(x.low, y.low, z.low),
                    __builtin_ia32_vfmaddpd256(x.high, y.high, z.high))
      .pack();
#else
  return fma(a, b, c);
#endif
}

/// A number as mantissa 2^exponent.
struct BinaryPack {
  Pack mantissa;  ///< from sqrt(1/2) to sqrt(2)
  Pack exponent;
};

/// Of positive normal numbers.
RADCERT_PACK_INLINE inline BinaryPack binary_parts(const Pack& a) {
  using Words = PackHalves::Words;
  using Numbers = PackHalves::Numbers;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t root = 0x3fe6a09e667f3bcd;      // sqrt(1/2)
  constexpr std::uint64_t integers = 0x4330000000000000;  // 2^52: its last bits count ones
  constexpr std::uint64_t fraction = 0x000fffffffffffff;
  constexpr unsigned fraction_bits = 52;
  constexpr double bias = 0x1p52 + 1023;
  const auto shifted = [](const Numbers& x) { return std::bit_cast<Words>(x) + (one - root); };
  const auto mantissa = [](const Words& x) { return std::bit_cast<Numbers>((x & fraction) + root); };
  const auto exponent = [](const Words& x) {
    return std::bit_cast<Numbers>((x >> fraction_bits) | integers) - bias;
  };
  const PackHalves halves(a);
  const Words low = shifted(halves.low);
  const Words high = shifted(halves.high);
  return {PackHalves(mantissa(low), mantissa(high)).pack(), PackHalves(exponent(low), exponent(high)).pack()};
}

/// sum of c_k x^k by Horner's rule.
template <std::size_t count>
RADCERT_PACK_INLINE inline Pack polynomial(const std::array<double, count>& c, const Pack& x) {
  Pack sum(c[count - 1]);
  for (std::size_t k = count - 1; k-- > 0;) sum = fused(sum, x, Pack(c[k]));
  return sum;
}

/// The natural logarithm, all lanes at once.
/// Maths     log(2^k m) = k log 2 + 2 s + s^3 r(s^2), s = (m - 1) / (m + 1), sqrt(1/2) <= m < sqrt(2)
/// Source    -
/// Requires  positive normal numbers
/// Result    within 4.1 2^-53 of the value: m - 1 is exact, log m suffers two roundings in s and one more,
///           the sum one
/// Limits    other numbers give no meaningful result
RADCERT_PACK_INLINE inline Pack fast_log(const Pack& a) {
  // Interpolates (log((1 + s) / (1 - s)) / s - 2) / s^2 in s^2 at 7 Chebyshev nodes of [0, 0.02944]: within
  // 3.2e-16.
  static constexpr std::array<double, 7> coefficients{
      0x1.5555555555558p-1, 0x1.99999999952e2p-2, 0x1.2492492df148dp-2, 0x1.c71c62e5800a1p-3,
      0x1.7462b4ab2ef6bp-3, 0x1.39fe606542ddep-3, 0x1.2b584aae78a57p-3};
  constexpr double high = 0x1.62e42fee00000p-1;  // log 2, to 32 bits: exact times an exponent
  constexpr double low = 0x1.a39ef35793c76p-33;
  const BinaryPack parts = binary_parts(a);
  const Pack f = parts.mantissa - Pack(1);
  const Pack s = f / (Pack(2) + f);
  const Pack square = s * s;
  const Pack rest = fused(s * square, polynomial(coefficients, square), parts.exponent * Pack(low));
  return fused(parts.exponent, Pack(high), (s + s) + rest);
}

/// The two acute angles of a right triangle.
/// Maths     of_first = arctan(p / q), of_second = arctan(q / p)
/// Source    arctan r = pi/4 + arctan((r - 1) / (r + 1)) above tan(pi/8)
/// Requires  p, q >= 0, not both zero, their sum a normal number
/// Result    either within 6 2^-53 of itself, both within `error`: the smaller angle suffers its own
///           rounding, that of the sum r + ..., and those of r, three if r is such a quotient, else one; the
///           larger angle two more
/// Limits    -
struct AcuteAngles {
  Pack of_first;
  Pack of_second;
  Pack error;
};
RADCERT_PACK_INLINE inline AcuteAngles acute_angles(const Pack& p, const Pack& q) {
  // Interpolates (arctan(r) / r - 1) / r^2 in r^2 at 11 Chebyshev nodes of [0, tan(pi/8)^2]: within 3.2e-17.
  static constexpr std::array<double, 11> coefficients{
      -0x1.5555555555555p-2, 0x1.999999999934cp-3, -0x1.2492492436201p-3, 0x1.c71c71853d7fap-4,
      -0x1.745d0b28a7e37p-4, 0x1.3b1263064f6b9p-4, -0x1.10fa77b1a6d57p-4, 0x1.dfe6497e96323p-5,
      -0x1.a0999c632b6edp-5, 0x1.4162c02b1dda3p-5, -0x1.3a31b1c0fd3b7p-6};
  constexpr double quarter = std::numbers::pi / 4;
  constexpr double quarter_rest = 0x1.1a62633145c07p-55;  // pi/4 minus that
  constexpr double tangent = 0.41421356237309503;         // of pi/8
  const Pack small = min(p, q);
  const Pack large = max(p, q);
  const PackMask upper = less(Pack(tangent) * large, small);
  const Pack r = select(upper, small - large, small) / select(upper, small + large, large);
  const Pack square = r * r;
  const Pack cubic = r * square * polynomial(coefficients, square);
  const Pack angle =
      select(upper, Pack(quarter), Pack(0)) + (r + (cubic + select(upper, Pack(quarter_rest), Pack(0))));
  constexpr double unit = 0x1p-53;
  constexpr double quarters_roundings = 1.1 * 2 * quarter;  // of the larger angle
  const Pack of_quotient = select(upper, Pack(4.4 * unit), Pack(1.4 * unit)) * abs(r);
  const Pack error = fused(Pack(1.1 * unit), angle, of_quotient) + Pack(quarters_roundings * unit);
  const Pack other = Pack(2 * quarter) - (angle - Pack(2 * quarter_rest));
  const PackMask first = less(q, p);
  return {select(first, other, angle), select(first, angle, other), error};
}

/// The angle of the point (x, y) in [-pi, pi].
/// Maths     arctan(y / x) in its quadrant
/// Source    acute_angles
/// Requires  not both zero
/// Result    within 7 2^-53 of the value
/// Limits    y = 0 counts as positive
RADCERT_PACK_INLINE inline Pack fast_atan2(const Pack& y, const Pack& x) {
  constexpr double pi = std::numbers::pi;
  constexpr double pi_rest = 0x1.1a62633145c07p-53;
  const Pack acute = acute_angles(abs(y), abs(x)).of_first;
  const Pack size = select(less(x, Pack(0)), Pack(pi) - (acute - Pack(pi_rest)), acute);
  return select(less(y, Pack(0)), -size, size);
}

/// Clausen's integral without its logarithm.
/// Maths     E(phi) = Cl_2(phi) / phi + log(2 sin(phi/2)), as a function of phi^2; E(0) = 1
/// Source    Cl_2(phi) = -Int_0^phi log(2 sin(x/2)) dx
/// Requires  0 <= phi^2 <= pi^2, but for roundings
/// Result    within 2 2^-53 for the number given: the later terms are at most 0.03 of the first
/// Limits    -
RADCERT_PACK_INLINE inline Pack clausen_rest(const Pack& squared_angle) {
  // Interpolates E at 14 Chebyshev nodes of [0, pi^2]: within 1.6e-17.
  static constexpr std::array<double, 14> coefficients{
      0x1.0000000000000p+0,   -0x1.c71c71c71c7a2p-6,  -0x1.234567899e0ebp-12, -0x1.3d079fbfcc991p-18,
      -0x1.8a86a1a60215fp-24, -0x1.04d8429b245e1p-29, -0x1.658071c3a9067p-35, -0x1.f71b11ec199bdp-41,
      -0x1.608f04c900970p-46, -0x1.283a959a9b1c5p-51, -0x1.d1aee983a2307p-59, -0x1.d7772520d90f3p-61,
      0x1.92f52899acd98p-66,  -0x1.e01e7b854f7f5p-71};
  return polynomial(coefficients, squared_angle);
}

/// The imaginary part of the dilogarithm of 1 - exp(-w), w = x + i y.
/// Maths     Im [w - w^2/4 + sum_k B_2k w^(2k+1) / (2k+1)!]
/// Source    Lewin, Polylogarithms and Associated Functions, 1981, 1.3; Bernoulli's numbers
/// Requires  |w| <= 1.06
/// Result    within 6 |y| 2^-53: the sum over y is at most 1.65 and rounded twice, its terms are at most 0.6
///           and 0.1; what is left out is below 1e-18 |y|
/// Limits    odd in y
RADCERT_PACK_INLINE inline Pack dilogarithm_series(const Pack& x, const Pack& y) {
  static constexpr std::array<double, 10> coefficients{1.0 / 36,
                                                       -1.0 / 3600,
                                                       1.0 / 211680,
                                                       -1.0 / 10886400,
                                                       5.0 / (66 * 39916800.0),
                                                       -691.0 / (2730 * 6227020800.0),
                                                       7.0 / (6 * 1307674368000.0),
                                                       -3617.0 / (510 * 355687428096000.0),
                                                       43867.0 / (798 * 121645100408832000.0),
                                                       -174611.0 / (330 * 51090942171709440000.0)};
  // With v = w^2, a = Re v and b = |v|^2: Horner for a real polynomial at a complex point, p(v) = alpha v +
  // beta.
  const Pack x2 = x * x;
  const Pack y2 = y * y;
  const Pack a = x2 - y2;
  const Pack size = x2 + y2;
  const Pack b = -(size * size);
  const Pack twice = a + a;
  Pack alpha(coefficients[9]);
  Pack beta(coefficients[8]);
  for (std::size_t k = 8; k-- > 0;) {
    const Pack next = fused(alpha, b, Pack(coefficients[k]));
    alpha = fused(alpha, twice, beta);
    beta = next;
  }
  // Im(w^5) / y = 5 x^4 - 10 x^2 y^2 + y^4, Im(w^3) / y = 3 x^2 - y^2.
  const Pack fifth = fused(Pack(5) * x2, x2 - (y2 + y2), y2 * y2);
  const Pack third = fused(Pack(3), x2, -y2);
  return y * (Pack(1) - (Pack(0.5) * x - fused(alpha, fifth, beta * third)));
}

}  // namespace radcert
