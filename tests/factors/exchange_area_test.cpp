// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/exchange_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {
namespace {

PlanePolygon exact(const FacetCorners& corners) {
  std::vector<Vector<Rational>> points;
  for (const Vector<double>& corner : corners) points.push_back(exactly(corner));
  return plane_polygon(points).value();
}

/// A_1 F_12 by the closed form in balls, which shares nothing with quadrature.
double closed_form(const FacetCorners& first, const FacetCorners& second) {
  return (polygon_to_polygon(exact(first), exact(second)) * Ball(norm(vector_area(first)))).to_double();
}

/// The same with the exact area and bits to spare: doubles have no area of slivers.
Ball enclosed_closed_form(const FacetCorners& first, const FacetCorners& second) {
  const BallPrecision precision(400);
  Vector<Rational> twice_area;
  for (std::size_t k = 1; k + 1 < first.size(); ++k)
    twice_area =
        twice_area + cross(exactly(first[k]) - exactly(first[0]), exactly(first[k + 1]) - exactly(first[0]));
  return sqrt(Ball(dot(twice_area, twice_area) / 4)) * polygon_to_polygon(exact(first), exact(second));
}

double error_of(const Approximation& found, const Ball& expected) {
  return abs(Ball(found.value) - expected).upper_double();
}

void expect_closed_form(const FacetCorners& first, const FacetCorners& second, const std::string& what) {
  const double expected = closed_form(first, second);
  const Approximation found = exchange_area(first, second);
  const double scale = std::min(norm(vector_area(first)), norm(vector_area(second)));
  EXPECT_LE(std::abs(found.value - expected), found.radius + 4e-16 * expected) << what;
  EXPECT_LE(std::abs(found.value - expected), 2e-15 * scale) << what;
  EXPECT_LE(found.radius, 1e-13 * std::max(scale, roundness(first).radius * roundness(first).radius)) << what;
  const Approximation back = exchange_area(second, first);
  EXPECT_LE(std::abs(found.value - back.value), found.radius + back.radius) << what;
}

const FacetCorners square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(ExchangeArea, IsTheClosedFormOfOpposedSquaresAtEveryDistance) {
  for (const double d : {1.0, 0.5, 0.1, 1e-3, 1e-6, 1e-9, 1e-12, 4.0, 8.0, 30.0})
    expect_closed_form(square, {{0, 0, d}, {0, 1, d}, {1, 1, d}, {1, 0, d}}, "distance " + std::to_string(d));
}

TEST(ExchangeArea, IsTheClosedFormOfSquaresWithEveryGap) {
  for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    const std::string what = "gap " + std::to_string(-std::log10(gap));
    // One above the other, nested, and next to each other at a right angle.
    expect_closed_form(square, {{0, 0, gap}, {0, 1, gap}, {1, 1, gap}, {1, 0, gap}}, what + " above");
    expect_closed_form(square, {{0.25, 0.25, gap}, {0.25, 0.75, gap}, {0.75, 0.75, gap}, {0.75, 0.25, gap}},
                       what + " nested");
    expect_closed_form(square, {{-gap, 0, 0}, {-gap, 1, 0}, {-gap, 1, 1}, {-gap, 0, 1}}, what + " beside");
  }
}

TEST(ExchangeArea, IsTheClosedFormWherePolygonsTouch) {
  expect_closed_form(square, {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, "a side in common");
  const FacetCorners triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  expect_closed_form(triangle, {{0, 0, 0}, {0, 1, 0}, {0, 0.5, 1}}, "a side in common, triangles");
  expect_closed_form(triangle, {{0, 0, 0}, {-1, 1, 0.5}, {-0.25, 0.25, 1}}, "a corner in common");
  expect_closed_form(triangle, {{0, 0.25, 0}, {0, 0.75, 0}, {0, 0.5, 1}}, "a part of a side in common");
  expect_closed_form(triangle, {{0, 0, 1e-9}, {0, 1, 1e-9}, {0, 0.5, 1}}, "nearly a side in common");
}

TEST(ExchangeArea, IsTheClosedFormOfStripsHoweverNarrow) {
  // Whichever edges are short: the work does not grow, and rounding is that of the short ones.
  for (int k = 10; k <= 50; k += 5) {
    const std::string what = "width 2^-" + std::to_string(k);
    const double width = std::ldexp(1, -k);
    const FacetCorners strip{{0, 0, 0.5}, {0, 1, 0.5}, {0, 1, 0.5 + width}, {0, 0, 0.5 + width}};
    const FacetCorners opposite{{1, 0, 0.5}, {1, 0, 0.5 + width}, {1, 1, 0.5 + width}, {1, 1, 0.5}};
    for (const FacetCorners& other : {square, opposite})
      for (const auto& [first, second] : {std::pair(strip, other), std::pair(other, strip)}) {
        const double expected = closed_form(first, second);
        const Approximation found = exchange_area(first, second);
        EXPECT_LE(std::abs(found.value - expected), found.radius + 4e-16 * expected) << what;
        EXPECT_LE(found.radius, 0x1p-46) << what;
      }
  }
}

TEST(ExchangeArea, IsTheClosedFormOfRandomTrianglesNearAndFar) {
  constexpr unsigned seed = 7;
  std::mt19937_64 stream(seed);
  const auto uniform = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  for (int k = 0; k < 60; ++k) {
    const double d = std::exp2(8 * uniform() - 2);
    const FacetCorners first{{0, 0, 0}, {1, 0, 0}, {uniform(), 1, 0}};
    FacetCorners second{{uniform(), uniform(), d},
                        {uniform() - 1, uniform(), d + 0.25 * uniform()},
                        {uniform(), 1 + uniform(), d}};
    if (k % 3 == 0)
      second = {{d + 1, uniform(), uniform()}, {d + 1, 2 + uniform(), 0}, {d + 1.5, uniform(), 2}};
    if (orientation(second[0], second[1], second[2], first[0]) < 0) std::swap(second[1], second[2]);
    if (orientation(second[0], second[1], second[2], first[1]) <= 0 ||
        orientation(second[0], second[1], second[2], first[2]) <= 0)
      continue;
    expect_closed_form(first, second,
                       "seed 7, pair " + std::to_string(k) + ", distance " + std::to_string(d));
  }
}

TEST(ExchangeArea, BothWaysAgreeBeyondTheFarRatio) {
  for (const double d : {4.0, 5.0, 7.0, 10.0, 20.0}) {
    const FacetCorners second{{0, 0, d}, {0.5, 1, d + 0.25}, {1, 0, d}};
    const Approximation contours = exchange_area_by_contours(square, second);
    const Approximation rules = exchange_area_by_rules(square, second);
    EXPECT_LE(std::abs(contours.value - rules.value), contours.radius + rules.radius) << d;
    EXPECT_LE(std::abs(contours.value - rules.value), 1e-13) << d;
  }
}

TEST(ExchangeArea, HoldsWhereRulesAgreeByChance) {
  // Gaps over the middle of an edge for which the rule on a half of it agrees with those on its quarters:
  // all of them are off, by 2e-7 to 6e-14.
  for (const double gap :
       {0.015412164823669298, 0.043200481515997771, 0.088902136637365375, 0.16067404551546863}) {
    const FacetCorners second{{-1.5, -2, gap}, {-5.5, 6, gap}, {2.5, 2, gap}};
    const Approximation found = exchange_area_by_contours(square, second);
    EXPECT_LE(error_of(found, enclosed_closed_form(square, second)), found.radius) << gap;
  }
  // A floor that ends a little before a wall. Of random ones these have errors of four and seven radii where
  // rules are believed whenever they agree.
  struct Wall {
    double gap, depth, from, to, height;
  };
  for (const Wall& w : {Wall{1.3423034299000933e-06, 1.1839673077809751, 0.24144549946039784,
                             1.0930347569070484, 0.12391724781925928},
                        {2.5311681434718395e-06, 3.8224710898155312, 0.69465219226026131, 1.3506710916932789,
                         0.79924234079944145}}) {
    const FacetCorners floor{{w.gap, 0, 0}, {w.depth, 0, 0}, {w.depth, 1, 0}, {w.gap, 1, 0}};
    const FacetCorners wall{{0, w.from, 0}, {0, w.to, 0}, {0, w.to, w.height}, {0, w.from, w.height}};
    const Approximation found = exchange_area_by_contours(floor, wall);
    EXPECT_LE(error_of(found, enclosed_closed_form(floor, wall)), found.radius) << w.gap;
  }
}

TEST(ExchangeArea, CutsAnEdgeWhereAnotherCrossesIt) {
  // Below an edge of a triangle, which crosses it at 45 degrees: over the crossing the inner integral has a
  // kink. At these places a rule on the whole edge differs by less than 2^-51 from those on its halves, and
  // all of them are off by 10^-4.
  constexpr double gap = 1e-9;
  for (const double x : {0.029782607626857492, 0.21067376952400649, 0.44415072037475956}) {
    const FacetCorners second{{x - 2, -2, gap}, {x - 6, 6, gap}, {x + 2, 2, gap}};
    const Approximation found = exchange_area_by_contours(square, second);
    EXPECT_LE(error_of(found, enclosed_closed_form(square, second)), found.radius) << x;
  }
}

TEST(ExchangeArea, ByRulesHoldsWhereTheRulesLeaveMuch) {
  // Two triangles that point at each other's corner, in planes at 20 degrees: the discs about them nearly
  // meet, and the kernel is large at both corners. The rules err by 10^-8 to 10^-6 of the value.
  const double along = std::cos(std::numbers::pi / 9);
  const double up = std::sin(std::numbers::pi / 9);
  const FacetCorners first{{0, 0, 0}, {-1, 0.5, 0}, {-1, -0.5, 0}};
  for (const double gap : {0.025, 0.05, 0.09}) {
    const FacetCorners second{{gap, 0, 0}, {gap + along, -0.5, up}, {gap + along, 0.5, up}};
    const Approximation found = exchange_area_by_rules(first, second);
    const double error = error_of(found, enclosed_closed_form(first, second));
    EXPECT_LE(error, found.radius) << gap;
    EXPECT_GE(error, 1e-10) << gap;
  }
}

TEST(ExchangeArea, ByRulesHoldsForSlivers) {
  // The cross product of sides of a sliver has lost all digits that its width has not.
  for (const int k : {8, 16, 24, 32}) {
    const double width = std::ldexp(1, -k);
    const FacetCorners sliver{
        {0.1, 0.2, 0.3}, {1.2, 0.7, 0.6}, {0.1 + 1.1 / 3, (0.2 + 0.5 / 3) - width, 0.4 + width}};
    const FacetCorners other{{4.1, -5.3, -5.6}, {4.7, -5.2, -4.7}, {3.6, -4.9, -5.8}};
    for (const auto& [first, second] : {std::pair(sliver, other), std::pair(other, sliver)}) {
      const Approximation found = exchange_area_by_rules(first, second);
      EXPECT_LE(error_of(found, enclosed_closed_form(first, second)), found.radius) << k;
    }
  }
}

TEST(ExchangeArea, RefusesFewerThanThreeCornersAndNearPolygonsByRules) {
  EXPECT_THROW(static_cast<void>(exchange_area_by_contours({{0, 0, 0}, {1, 0, 0}}, square)),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(exchange_area_by_rules(square, {{0, 0, 0.1}, {0, 1, 0.1}, {1, 1, 0.1}})),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
