// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/ball_precision.h"
#include "tests/closed_form/polar_kernel_integral.h"

namespace radcert {

inline Vector<Rational> exactly(const Vector<double>& a) {
  return {Rational::exactly(a.x), Rational::exactly(a.y), Rational::exactly(a.z)};
}

inline judge::Triple triple(const Vector<Rational>& a) { return {a.x, a.y, a.z}; }

/// How far the integral of the first function, the constant 1, is off, over what is allowed, by Lambert's
/// formula in space: it shares nothing with the element and with the balls that it falls back to.
inline double excess(const PlanePolygon& polygon, const PlaneElement& element, double accuracy,
                     const Vector<double>& p, const Vector<double>& normal) {
  std::vector<double> values(element.function_count());
  (void)element.integrals(p, normal, values);
  judge::Polygon judged{triple(polygon.origin()), triple(polygon.first()), triple(polygon.second()), {}};
  for (const PolygonLoop& loop : polygon.loops()) {
    judged.loops.emplace_back();
    for (const auto& at : loop) judged.loops.back().push_back({at.s, at.t});
  }
  const BallPrecision precision(512);
  const Ball exact = judge::lambert_integral(judged, triple(exactly(p)), triple(exactly(normal)));
  if (certainly_zero(exact)) return values[0] == 0 ? 0 : HUGE_VAL;
  EXPECT_LE(exact.radius(), 1e-20 * abs(exact).lower_double());
  return abs((Ball(values[0]) - exact) / (Ball(accuracy) * exact)).upper_double();
}

}  // namespace radcert
