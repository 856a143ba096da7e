// SPDX-License-Identifier: GPL-3.0-or-later
// A pack has, lane by lane, the bits of the double.
#include "radcert/scalar/pack.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace radcert {
namespace {

using Lanes = std::array<double, Pack::lanes>;

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// Doubles of every size and sign, zeros and infinities among them.
Lanes random_lanes(std::mt19937_64& stream) {
  constexpr std::array<double, 5> special{0.0, -0.0, 1.0, -std::numeric_limits<double>::infinity(),
                                          0x1p-1074};
  Lanes lanes;
  for (double& x : lanes) {
    const std::uint64_t drawn = stream();
    const int exponent = static_cast<int>(drawn % 200) - 100;
    x = drawn % 17 == 0 ? special[drawn / 17 % special.size()]
                        : std::ldexp(static_cast<double>(static_cast<std::int64_t>(stream())), exponent - 63);
  }
  return lanes;
}

template <class Function>
void expect_lanes(const Pack& pack, const Function& f, const char* what) {
  for (std::size_t i = 0; i < Pack::lanes; ++i) {
    const double expected = f(i);
    if (std::isnan(expected))
      EXPECT_TRUE(std::isnan(pack.lane(i))) << what;
    else
      EXPECT_EQ(bits(pack.lane(i)), bits(expected)) << what << " " << pack.lane(i) << " " << expected;
  }
}

TEST(Pack, HasTheBitsOfTheDouble) {
  std::mt19937_64 stream(7);
  for (int draw = 0; draw < 2000; ++draw) {
    const Lanes x = random_lanes(stream);
    const Lanes y = random_lanes(stream);
    const Lanes z = random_lanes(stream);
    const Pack a = Pack::load(x.data());
    const Pack b = Pack::load(y.data());
    const Pack c = Pack::load(z.data());
    expect_lanes(
        a, [&](std::size_t i) { return x[i]; }, "load");
    expect_lanes(
        -a, [&](std::size_t i) { return -x[i]; }, "-");
    expect_lanes(
        a + b, [&](std::size_t i) { return x[i] + y[i]; }, "+");
    expect_lanes(
        a - b, [&](std::size_t i) { return x[i] - y[i]; }, "-");
    expect_lanes(
        a * b, [&](std::size_t i) { return x[i] * y[i]; }, "*");
    expect_lanes(
        a / b, [&](std::size_t i) { return x[i] / y[i]; }, "/");
    expect_lanes(
        fma(a, b, c), [&](std::size_t i) { return std::fma(x[i], y[i], z[i]); }, "fma");
    expect_lanes(
        abs(a), [&](std::size_t i) { return std::abs(x[i]); }, "abs");
    expect_lanes(
        sqrt(abs(a)), [&](std::size_t i) { return std::sqrt(std::abs(x[i])); }, "sqrt");
    expect_lanes(
        min(a, b), [&](std::size_t i) { return std::min(x[i], y[i]); }, "min");
    expect_lanes(
        max(a, b), [&](std::size_t i) { return std::max(x[i], y[i]); }, "max");
    expect_lanes(
        sin(a), [&](std::size_t i) { return std::sin(x[i]); }, "sin");
    expect_lanes(
        exp(a), [&](std::size_t i) { return std::exp(x[i]); }, "exp");
    expect_lanes(
        pow(abs(a), b), [&](std::size_t i) { return std::pow(std::abs(x[i]), y[i]); }, "pow");
    expect_lanes(
        multiply_add(a, b, c), [&](std::size_t i) { return multiply_add(x[i], y[i], z[i]); }, "");
    expect_lanes(
        power(a, 5), [&](std::size_t i) { return power(x[i], 5); }, "power");
  }
}

TEST(Pack, FoldsItsLanesInAFixedTree) {
  const Lanes x{1, 0x1p-53, 2, 0x1p-54, -1, 3, 0x1p-60, 5};
  const Pack a = Pack::load(x.data());
  const double expected = ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
  EXPECT_EQ(bits(a.sum()), bits(expected));
  EXPECT_EQ(a.largest(), 5);
  EXPECT_EQ(a.smallest(), -1);
}

TEST(Pack, GoesInAndOutOfMemory) {
  Lanes to{};
  Pack a(2.5);
  a.set_lane(3, -7);
  a.store(to.data());
  EXPECT_EQ(to, (Lanes{2.5, 2.5, 2.5, -7, 2.5, 2.5, 2.5, 2.5}));
  EXPECT_TRUE(a == a);
  EXPECT_FALSE(a == Pack(2.5));
  EXPECT_EQ(padded<double>(0), 0U);
  EXPECT_EQ(padded<double>(9), 16U);
  EXPECT_EQ(padded<long double>(9), 9U);
}

static_assert(Real<Pack>);

}  // namespace
}  // namespace radcert
