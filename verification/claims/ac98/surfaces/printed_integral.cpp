// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/printed_integral.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace radcert::verification::ac98 {
namespace {

struct Place {
  Rational x;
  Rational z;
};

void require_points(Finding& finding, const PrintedIntegral& formula) {
  const BallPrecision precision(160);
  constexpr double within = 1e-30;
  // With ceil(1/z) panels rho is 1 + sqrt(2) at least, and rho^-95 times 40 z^-3 is below 1e-32 for z >= 1/7.
  constexpr int points = 48;
  const std::array<Place, 4> places{
      {{{1, 3}, {1, 7}}, {{1, 2}, {1, 2}}, {{1, 10}, {1, 4}}, {{9, 10}, {4, 5}}}};
  for (const Place& place : places) {
    const Ball x(place.x);
    const Ball z(place.z);
    const AgreesWith integral{.value = unit_square_integrals(x, z, points).*formula.integral,
                              .within = within};
    const std::string at = ", x = " + place.x.to_text() + ", z = " + place.z.to_text();
    finding.require(formula.name + " as printed against its integral" + at, integral, formula.printed(x, z));
    finding.require(formula.name + " of the library against its integral" + at, integral,
                    formula.library(x, z));
    finding.control(formula.name + " with " + formula.mistake + at, integral, formula.wrong(x, z));
  }
}

struct BoxCount {
  long disjoint = 0;
  long disjoint_from_wrong = 0;
  double widest = 0;
  double largest = 0;
};

BoxCount count_boxes(const PrintedIntegral& formula, int per_half) {
  const BallPrecision precision(64);
  constexpr int points = 12;  // rho^-23 40 z^-3 < 1e-5 for z >= 1/4
  BoxCount count;
  const Ball half(Rational(1, 4L * per_half));
  const auto side = [&](const Rational& first, int i) {
    return widened(Ball(first + Rational(2L * i + 1, 4L * per_half)), half);
  };
  for (int i = 0; 2 * i < 3 * per_half; ++i)
    for (int j = 0; j < per_half; ++j) {
      const Ball x = side(Rational(1, 8), i);
      const Ball z = side(Rational(1, 4), j);
      const Ball integral = unit_square_integrals(x, z, points).*formula.integral;
      const Ball printed = formula.printed(x, z);
      if (!overlaps(integral, printed)) ++count.disjoint;
      if (!overlaps(integral, formula.wrong(x, z))) ++count.disjoint_from_wrong;
      count.widest = std::max({count.widest, integral.radius(), printed.radius()});
      count.largest = std::max(count.largest, abs(integral).upper_double());
    }
  return count;
}

}  // namespace

void require_values(Finding& finding, const Bench& bench, const PrintedIntegral& formula) {
  require_points(finding, formula);
  // Boxes of width 1/(2 per_half).
  const int per_half = bench.budget == Budget::quick ? 16 : bench.budget == Budget::standard ? 32 : 64;
  const BoxCount count = count_boxes(formula, per_half);
  const std::string boxes = ", boxes of width 1/" + std::to_string(2 * per_half);
  finding.require(formula.name + ": disjoint enclosures of formula and integral" + boxes, IsExactly{0},
                  Rational(count.disjoint));
  finding.control(formula.name + " with " + formula.mistake + ": disjoint enclosures" + boxes, IsExactly{0},
                  Rational(count.disjoint_from_wrong));
  finding.remark(formula.name + ": widest radius over the largest value" + boxes,
                 {.value = count.widest / count.largest, .radius = 0, .guaranteed = false});
}

}  // namespace radcert::verification::ac98
