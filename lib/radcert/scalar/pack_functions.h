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
/// Result    copied by memory of a whole register at a time, which the compiler leaves out
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
/// Result    no lane touches another; comparisons with what is no number do not hold
class PackMask {
public:
  using Bits = PackHalves::Bits;

  /// In no lane.
  PackMask() : low_(Bits{}), high_(Bits{}) {}
  RADCERT_PACK_INLINE PackMask(const Bits& low, const Bits& high) : low_(low), high_(high) {}

  RADCERT_PACK_INLINE friend Pack select(const PackMask& mask, const Pack& yes, const Pack& no) {
    const PackHalves x(yes);
    const PackHalves y(no);
    return PackHalves(mask.low_ < 0 ? x.low : y.low, mask.high_ < 0 ? x.high : y.high).pack();
  }

private:
  Bits low_;
  Bits high_;
};

/// In which lanes a < b; not where either is no number.
RADCERT_PACK_INLINE inline PackMask less(const Pack& a, const Pack& b) {
  const PackHalves x(a);
  const PackHalves y(b);
  return {x.low < y.low, x.high < y.high};
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

/// An acute angle of a right triangle.
/// Maths     arctan(p / q)
/// Source    arctan r = pi/4 + arctan((r - 1) / (r + 1)) above tan(pi/8)
/// Requires  p, q >= 0, not both zero, their sum a normal number
/// Result    within 6 2^-53 of itself: the smaller angle suffers its own rounding, that of the sum r + ...,
///           and those of r, three if r is such a quotient, else one; the larger angle two more
RADCERT_PACK_INLINE inline Pack acute_angle(const Pack& p, const Pack& q) {
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
  const Pack other = Pack(2 * quarter) - (angle - Pack(2 * quarter_rest));
  return select(less(q, p), other, angle);
}

/// The angle of the point (x, y) in [-pi, pi].
/// Maths     arctan(y / x) in its quadrant
/// Source    acute_angle
/// Requires  not both zero
/// Result    within 7 2^-53 of the value
/// Limits    y = 0 counts as positive
RADCERT_PACK_INLINE inline Pack fast_atan2(const Pack& y, const Pack& x) {
  constexpr double pi = std::numbers::pi;
  constexpr double pi_rest = 0x1.1a62633145c07p-53;
  const Pack acute = acute_angle(abs(y), abs(x));
  const Pack size = select(less(x, Pack(0)), Pack(pi) - (acute - Pack(pi_rest)), acute);
  return select(less(y, Pack(0)), -size, size);
}

}  // namespace radcert
