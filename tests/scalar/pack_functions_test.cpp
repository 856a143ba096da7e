// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/pack_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/mpfr_real.h"
#include "tests/scalar/draw.h"

namespace radcert {
namespace {

using Wide = Mpfr<50>;
constexpr double unit = 0x1p-53;

/// |value - exact| in units of 2^-53 size.
double error_in_units(double value, const Wide& exact, double size) {
  return std::abs((Wide(value) - exact).to_double()) / (unit * size);
}

/// A number that fills all lanes but the first, which holds another.
Pack lanes_of(double x, double first) {
  Pack p(x);
  p.set_lane(0, first);
  return p;
}

/// Of very different sizes, and near 1.
double positive(Draw& draw) {
  switch (draw.below(3)) {
    case 0: return std::ldexp(0.5 + draw.unit(), static_cast<int>(draw.below(600)) - 300);
    case 1: return 0.5 + 1.5 * draw.unit();
    default: return 1 + (draw.unit() - 0.5) * std::ldexp(1.0, -static_cast<int>(draw.below(50)));
  }
}

TEST(PackFunctions, MasksSelectLaneByLane) {
  Pack a(1);
  Pack b(2);
  a.set_lane(5, 3);
  b.set_lane(7, 1);
  EXPECT_EQ(less(a, b).lanes(), 0x5fU);
  EXPECT_EQ(at_most(a, b).lanes(), 0xdfU);
  EXPECT_EQ((!less(a, b)).lanes(), 0xa0U);
  EXPECT_EQ((less(b, a) | at_most(b, a)).lanes(), 0xa0U);
  EXPECT_EQ((at_most(a, b) & at_most(b, a)).lanes(), 0x80U);
  EXPECT_EQ(PackMask().lanes(), 0U);
  const Pack least = select(less(a, b), a, b);
  for (std::size_t i = 0; i < Pack::lanes; ++i) EXPECT_EQ(least.lane(i), std::min(a.lane(i), b.lane(i)));
  EXPECT_EQ(less(Pack(NAN), a).lanes() | at_most(a, Pack(NAN)).lanes(), 0U);
  EXPECT_EQ(fused(a, b, Pack(-1)).lane(5), std::fma(3.0, 2.0, -1.0));
}

TEST(PackFunctions, LogarithmAndAnglesAreWithinTheirUnits) {
  Draw draw(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = positive(draw);
    const double value = fast_log(lanes_of(x, 7)).lane(3);
    const Wide exact = log(Wide(x));
    ASSERT_LE(error_in_units(value, exact, 1), 4.1 * std::abs(exact.to_double())) << x;

    const double p = draw.below(8) == 0 ? 0 : positive(draw);
    const double q = draw.below(2) == 0 ? p * (1 + draw.unit()) + (p == 0 ? 1 : 0) : positive(draw);
    const AcuteAngles angles = acute_angles(lanes_of(p, 2), lanes_of(q, 1));
    const Wide first = atan(Wide(p) / Wide(q));
    const Wide second = p == 0 ? pi<Wide>() / Wide(2) : atan(Wide(q) / Wide(p));
    const double one = error_in_units(angles.of_first.lane(6), first, 1);
    const double other = error_in_units(angles.of_second.lane(6), second, 1);
    ASSERT_LE(one, 6 * first.to_double()) << p << " " << q;
    ASSERT_LE(other, 6 * second.to_double()) << p << " " << q;
    ASSERT_LE(std::max(one, other) * unit, angles.error.lane(6)) << p << " " << q;
    ASSERT_LE(angles.error.lane(6), 6 * unit);

    const double y = draw.below(2) == 0 ? p : -p;
    const Wide turned = y < 0 ? first - pi<Wide>() : pi<Wide>() - first;
    const double left = fast_atan2(lanes_of(y, 2), lanes_of(-q, 1)).lane(4);
    ASSERT_LE(error_in_units(left, turned, std::abs(turned.to_double())), 7) << y << " " << -q;
  }
}

TEST(PackFunctions, ClausensIntegralIsWithinItsUnits) {
  Draw draw(2);
  for (int i = 0; i < 3000; ++i) {
    const double phi = i == 0 ? std::numbers::pi : std::numbers::pi * draw.unit() * (i % 3 == 0 ? 1e-3 : 1.0);
    if (phi == 0) continue;
    const double square = phi * phi;
    const Wide angle = sqrt(Wide(square));
    const Wide exact = dilogarithm_imaginary(Wide(1), angle) / angle + log(Wide(2) * sin(angle / Wide(2)));
    ASSERT_LE(error_in_units(clausen_rest(lanes_of(square, 1)).lane(2), exact, 1), 2) << phi;
  }
}

TEST(PackFunctions, DilogarithmSeriesIsWithinItsUnits) {
  Draw draw(3);
  for (int i = 0; i < 3000; ++i) {
    const double size = 1.06 * (i % 4 == 0 ? 1.0 : draw.unit());
    const double turn = std::numbers::pi * draw.unit();
    const double x = size * std::cos(turn);
    const double y = size * std::sin(turn);
    // z = 1 - exp(-w) in the unit disk.
    const Wide shrink = exp(Wide(-x));
    const Wide re = Wide(1) - shrink * cos(Wide(y));
    const Wide im = shrink * sin(Wide(y));
    const Wide radius = sqrt(re * re + im * im);
    if (!(radius.to_double() < 1) || !(y > 0)) continue;
    const Wide angle = pi<Wide>() / Wide(2) - atan(re / im);
    const Wide exact = dilogarithm_imaginary(radius, angle);
    ASSERT_LE(error_in_units(dilogarithm_series(lanes_of(x, 1), lanes_of(y, 1)).lane(1), exact, y), 6)
        << x << " " << y;
    EXPECT_EQ(dilogarithm_series(Pack(x), Pack(-y)).lane(7), -dilogarithm_series(Pack(x), Pack(y)).lane(7));
  }
}

}  // namespace
}  // namespace radcert
