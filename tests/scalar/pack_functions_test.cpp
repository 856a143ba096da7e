// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/pack_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  const Pack least = select(less(a, b), a, b);
  for (std::size_t i = 0; i < Pack::lanes; ++i) EXPECT_EQ(least.lane(i), std::min(a.lane(i), b.lane(i)));
  const Pack unordered = select(less(Pack(NAN), a), a, b);
  for (std::size_t i = 0; i < Pack::lanes; ++i) EXPECT_EQ(unordered.lane(i), b.lane(i));
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
    const Wide first = atan(Wide(p) / Wide(q));
    const double angle = acute_angle(lanes_of(p, 2), lanes_of(q, 1)).lane(6);
    ASSERT_LE(error_in_units(angle, first, 1), 6 * first.to_double()) << p << " " << q;

    const double y = draw.below(2) == 0 ? p : -p;
    const Wide turned = y < 0 ? first - pi<Wide>() : pi<Wide>() - first;
    const double left = fast_atan2(lanes_of(y, 2), lanes_of(-q, 1)).lane(4);
    ASSERT_LE(error_in_units(left, turned, std::abs(turned.to_double())), 7) << y << " " << -q;
  }
}

}  // namespace
}  // namespace radcert
