// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/grading_in_double.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// Of doubles in [1/2, 1), which are multiples of 2^-53.
constexpr long last_place = 53;
/// -log2 of the least width that is known to 2^-20 of it.
constexpr long blurred_beyond = 33;

/// Whether the doubles are those of a whole grading whose coordinates are multiples of 2^-53: k^grading, up
/// to 2^52, and what is made of it are then exact.
bool are_exact(long grading, int level) {
  const double half = std::ldexp(1.0, level - 1);
  for (double k = 1; k < half; ++k) {
    double power = 1;
    for (long j = 0; j < grading; ++j) power *= k;
    const double exact = std::ldexp(power, -static_cast<int>(grading * (level - 1) + 1));
    const double c = std::ldexp(k, -level);
    const auto exponent = static_cast<double>(grading);
    if (graded_coordinate(c, exponent) != exact || graded_coordinate(1 - c, exponent) != 1 - exact)
      return false;
  }
  return true;
}

bool has_unit_squares(const Surface& surface) {
  return std::any_of(surface.charts.begin(), surface.charts.end(),
                     [](const Chart& chart) { return chart.facts().domain == ChartDomain::unit_square; });
}

}  // namespace

double graded_coordinate(double c, double grading) {
  return c <= 0.5 ? 0.5 * std::pow(2 * c, grading) : 1 - 0.5 * std::pow(2 * (1 - c), grading);
}

GradingInDouble grading_in_double(const Surface& surface, const Rational& grading, int level) {
  expects(level >= 0 && grading >= Rational(1), "level >= 0 and grading >= 1", named("level", level),
          named("grading", grading.to_text()));
  if (grading == Rational(1) || level < 2 || !has_unit_squares(surface)) return GradingInDouble::exact;
  const Rational places = grading * Rational(level - 1) + Rational(1);
  if (grading.is_integer() && places <= Rational(last_place) && are_exact(*grading.to_long(), level))
    return GradingInDouble::exact;
  return places <= Rational(blurred_beyond) ? GradingInDouble::rounded : GradingInDouble::blurred;
}

double narrowest_layer(const Rational& grading, int level) {
  return level == 0 ? 1 : std::exp2(-(grading * Rational(level - 1) + Rational(1)).to_double());
}

}  // namespace radcert
