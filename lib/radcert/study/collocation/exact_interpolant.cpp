// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/exact_interpolant.h"

#include <array>
#include <optional>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

const WorkLimit bits_of_a_point("study/exact_interpolant: bits", 1024, BallPrecision::smallest_bits,
                                "refused: the interpolant is not known exactly");

using Point = ParameterPoint<Rational>;

/// A polynomial with whole exponents at an exact point.
std::optional<Rational> value(const PowerSum& sum, const Point& at) {
  Rational total = 0;
  for (const auto& [exponents, coefficient] : sum) {
    const std::optional<long> i = exponents[0].to_long();
    const std::optional<long> j = exponents[1].to_long();
    if (!i || !j) return std::nullopt;
    total += coefficient * power(at.s, *i) * power(at.t, *j);
  }
  return total;
}

std::optional<Rational> value(const ExactFunction& f, const Point& at) {
  const std::optional<PowerQuotient> quotient = f.quotient();
  if (!quotient) return std::nullopt;
  const std::optional<Rational> numerator = value(quotient->numerator, at);
  const std::optional<Rational> denominator = value(quotient->denominator, at);
  if (!numerator || !denominator || denominator->sign() == 0) return std::nullopt;
  return *numerator / *denominator;
}

bool are_equal(const Ball& ball, const std::optional<Rational>& exact) {
  return exact && ball.is_exact() && ball.contains(*exact);
}

bool interpolates(const ExactImage& exact, const std::array<Point, 3>& corners, const Chart& interpolant,
                  int degree) {
  const Vector<ExactFunction> image = exact.image();
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b) {
      const Point at{Rational(a, degree), Rational(b, degree)};
      const Point in_chart = corners[0] + at.s * (corners[1] - corners[0]) + at.t * (corners[2] - corners[0]);
      const Vector<Ball> found = interpolant.in<Ball>().frame({Ball(at.s), Ball(at.t)}).point;
      if (!are_equal(found.x, value(image.x, in_chart)) || !are_equal(found.y, value(image.y, in_chart)) ||
          !are_equal(found.z, value(image.z, in_chart)))
        return false;
    }
  return true;
}

}  // namespace

Outcome<void> is_exact_interpolant(const NodedSurface& data, const NodedSurface& integrals, int degree) {
  // So that products of a few doubles are not rounded.
  const BallPrecision precision(bits_of_a_point.value());
  const std::vector<ParameterTriangle>& triangles = data.triangulation.triangles;
  expects(triangles.size() == integrals.triangulation.triangles.size(), "the same elements",
          named("elements", triangles.size()));
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Chart& chart = data.surface.charts[triangles[k].chart];
    // Kept as it is.
    if (chart.facts().plane) continue;
    const ExactImage* exact = exact_image(chart.in<Ball>());
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = {Rational::exactly(triangles[k].vertices[i].s),
                    Rational::exactly(triangles[k].vertices[i].t)};
    const Chart& interpolant = integrals.surface.charts[integrals.triangulation.triangles[k].chart];
    if (exact == nullptr || !interpolates(*exact, corners, interpolant, degree))
      return because("the points of chart " + chart.facts().name +
                     " that are interpolated are rounded to double");
  }
  return {};
}

}  // namespace radcert
