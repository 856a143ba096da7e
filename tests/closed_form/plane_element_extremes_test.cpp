// SPDX-License-Identifier: GPL-3.0-or-later
// Points for which a single term of PlaneElement's bound decides: without it, a value would be given that is
// off by more than is allowed.
#include <gtest/gtest.h>

#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "tests/closed_form/plane_element_excess.h"

namespace radcert {
namespace {

using Exact = Vector<Rational>;
using Point = Vector<double>;
using Polynomial = PlanePolynomial<Rational>;

constexpr double rough = PlaneElement::largest_accuracy;

std::vector<Polynomial> constant() {
  Polynomial one(0);
  one(0, 0) = 1;
  return {one};
}

/// A point in an oblique frame about P: along its tangent plane, over that plane, and across both.
struct Place {
  Rational along;
  Rational level;  ///< (Q - P) . n_P for the normal below, whose largest part is 2
  Rational across;
};
const Point eye{0.3, -0.7, 0.9};
const Point eye_normal{1, 2, -2};

Exact at(const Place& place) {
  const Exact along{2, 1, 2};
  const Exact across{2, -2, -1};
  return exactly(eye) + Rational(1, 3) * place.along * along +
         Rational(1, 9) * place.level * exactly(eye_normal) + Rational(1, 3) * place.across * across;
}

PlanePolygon polygon_of(const std::vector<Place>& places) {
  std::vector<Exact> corners;
  for (const Place& place : places) corners.push_back(at(place));
  return plane_polygon(corners).value();
}

void expect_within_error(const PlanePolygon& polygon) {
  const PlaneElement element(polygon, constant(), rough);
  EXPECT_LE(excess(polygon, element, rough, eye, eye_normal), 1);
}

/// Of the order of the error of a level.
Rational little() { return power(Rational(1, 2), 94); }

// The levels of all corners are a few of their errors: those that are taken for 0 matter beside the largest.
TEST(PlaneElementExtremes, LevelsWithinTheirErrorCount) {
  for (int k = 0; k < 10; ++k) {
    const Rational unit = power(Rational(1, 2), k) * little();
    expect_within_error(
        polygon_of({{0, Rational(16) * unit, 1}, {-1, Rational(6) * unit, 1}, {1, Rational(6) * unit, 1}}));
  }
}

// A corner is in front of the tangent plane by less than the error of its level, all others are behind.
TEST(PlaneElementExtremes, ACornerWithinItsErrorMayBeTheOnlyOneThatIsSeen) {
  for (int k = 0; k < 32; ++k) {
    const Rational across(k + 13, 33);
    expect_within_error(polygon_of({{Rational(k - 16, 77), power(Rational(1, 2), 17) * little(), across},
                                    {Rational(5, 7), -1, across},
                                    {Rational(9, 7), -1, across}}));
  }
}

// Of two triangles, one is seen from far away. The other has a corner that is in front by less than the error
// of its level, with P close to it, and nothing else in front: the light of that corner is the larger one.
TEST(PlaneElementExtremes, WhatCornersWithinTheirErrorUncoverCounts) {
  const Rational height = power(Rational(1, 2), 72);
  for (int k = 0; k < 4; ++k) {
    const Rational level = power(Rational(1, 2), k) * little();
    expect_within_error(
        polygon_of({{1, -1, height}, {0, level, height}, {-1, -1, height}, {1, -2, height}, {2, 1, height}}));
  }
}

// Of two triangles, one is seen from far away. The other is cut where P is close: by the exact levels, P sees
// what is nearest to it, by levels with their errors, it does not.
TEST(PlaneElementExtremes, WhereTheTangentPlaneCutsCounts) {
  const Rational height = power(Rational(1, 2), 74);
  for (int k = 0; k < 12; ++k) {
    const Rational level = Rational(16) * little();
    const Rational along(97 + k, 97);
    expect_within_error(polygon_of({{along, along * level * Rational(100001, 100000), height},
                                    {-1, -level, height},
                                    {-1, -1, height},
                                    {1, -1, height},
                                    {2, Rational(1, 2), height}}));
  }
}

// P is over an edge to within the error of its distance from it, which is not small against the height.
TEST(PlaneElementExtremes, AnEdgeThatMayGoThroughTheFootCounts) {
  Polynomial first(1);
  first(1, 0) = 1;
  std::vector<Polynomial> functions = constant();
  functions.push_back(first);
  for (int k = 2; k < 6; ++k) {
    const Rational height = power(Rational(2), k) * little();
    const Rational inside = power(Rational(1, 2), 4) * little();
    const PlanePolygon polygon = polygon_of({{-1, height, -inside}, {1, height, -inside}, {0, height, 1}});
    const PlaneElement element(polygon, functions, rough);
    EXPECT_LE(excess(polygon, element, rough, eye, eye_normal), 1) << k;
  }
}

}  // namespace
}  // namespace radcert
