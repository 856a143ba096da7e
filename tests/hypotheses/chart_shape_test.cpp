// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_shape.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "radcert/hypotheses/chart_pairs.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/chart.h"
#include "tests/hypotheses/dome.h"

namespace radcert {
namespace {

constexpr Orientation along = Orientation::along_the_cross_product;
constexpr Orientation against = Orientation::against_the_cross_product;

/// Whether the profile of a chart that states the ruling (0, 1, 0) is proved to bend to its normal's side.
bool is_convex(const Vector<ExactFunction>& image, Orientation orientation) {
  ChartFacts facts{.name = "ruled", .piece = "ruled", .orientation = orientation};
  facts.structure.ruling = Vector<Rational>{0, 1, 0};
  std::size_t boxes = 0;
  return prove_shape(make_chart<sample::Dome>(facts, Rational(0)), &image, boxes).profile_is_convex;
}

Vector<ExactFunction> profile(const ExactFunction& x, const ExactFunction& z) {
  return {x, ExactFunction::t(), z};
}

ExactFunction power_of_s(const Rational& exponent) {
  return power(ExactFunction::s(), Exponent<ExactFunction>(exponent));
}

TEST(ProveShape, TakesProfilesThatBendToOneSideAlone) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction two(Rational(2));
  for (const Rational& p : {Rational(3, 2), Rational(2), Rational(3), Rational(101, 100)}) {
    // A roof, and a trough: of which the inner normal is the other one.
    EXPECT_TRUE(is_convex(profile(s, two - power_of_s(p)), against)) << p.to_text();
    EXPECT_FALSE(is_convex(profile(s, two - power_of_s(p)), along)) << p.to_text();
    EXPECT_FALSE(is_convex(profile(s, two + power_of_s(p)), against)) << p.to_text();
    EXPECT_TRUE(is_convex(profile(s, two + power_of_s(p)), along)) << p.to_text();
  }
  // Exponents below 1 bend the other way, whichever sign they have.
  for (const Rational& p : {Rational(1, 2), Rational(99, 100), Rational(1, 10)})
    for (const Orientation orientation : {along, against}) {
      EXPECT_FALSE(is_convex(profile(s, two - power_of_s(p)), orientation)) << p.to_text();
      EXPECT_FALSE(is_convex(profile(s, two + power_of_s(p)), orientation)) << p.to_text();
    }
}

TEST(ProveShape, TakesSeveralBendsOfOneDirectionAlone) {
  const ExactFunction s = ExactFunction::s();
  const ExactFunction two(Rational(2));
  const ExactFunction square = power_of_s(2);
  const ExactFunction cube = power_of_s(3);
  EXPECT_TRUE(is_convex(profile(s, two - square - cube), against));
  for (const Orientation orientation : {along, against}) {
    EXPECT_FALSE(is_convex(profile(s, two - square + cube), orientation));
    EXPECT_FALSE(is_convex(profile(s + square, two - cube), orientation));
    EXPECT_FALSE(is_convex(profile(s - square, two - cube), orientation));
  }
}

TEST(ProveShape, TakesAQuadricWithItsNormalsToTheInsideAlone) {
  const Surface sphere = ellipsoid(1, 1, 1);
  for (const Chart& chart : sphere.charts) {
    const ExactImage* exact = exact_image(chart.in<Ball>());
    ASSERT_NE(exact, nullptr);
    const Vector<ExactFunction> image = exact->image();
    std::size_t boxes = 0;
    EXPECT_TRUE(prove_shape(chart, &image, boxes).quadric.has_value()) << chart.facts().name;
    EXPECT_GT(boxes, 0U);
  }
  // The same octant with the other orientation.
  ChartFacts facts = sphere.charts.front().facts();
  facts.orientation = facts.orientation == along ? against : along;
  const Chart turned =
      make_exact_chart<EllipsoidOctant>(facts, Rational(1), Rational(1), Rational(1), Octant{1, 1, 1});
  const Vector<ExactFunction> image = exact_image(turned.in<Ball>())->image();
  std::size_t boxes = 0;
  const ProvedShape shape = prove_shape(turned, &image, boxes);
  EXPECT_FALSE(shape.quadric.has_value());
  EXPECT_FALSE(shape.refusal.empty());
}

TEST(BoxesLeft, AreThoseThatWereNotLookedAt) {
  const Chart chart = sample::dome_over_floor(0).charts.back();
  std::size_t boxes = 0;
  EXPECT_EQ(boxes_left(chart, 100, boxes, [](const Frame<Ball>&) { return true; }), 0U);
  EXPECT_EQ(boxes, 1U);
  EXPECT_GT(boxes_left(chart, 100, boxes, [](const Frame<Ball>&) { return false; }), 0U);
  EXPECT_GT(boxes_left(chart, 1, boxes, [](const Frame<Ball>&) { return false; }), 0U);
}

/// z = 1 - (s^2 + t^2 + 6 s t) / 8: bent inwards along both parameters, and outwards between them.
template <Field R>
class Saddle {
public:
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const R eighth = from_rational<R>(Rational(1, 8));
    return {s, t, R(1) - eighth * (s * s + t * t + R(6) * (s * t))};
  }
};

TEST(SearchPairs, DoesNotTakeASaddleForADome) {
  const Chart saddle = make_chart<Saddle>({.name = "saddle", .piece = "saddle", .orientation = against});
  PatchTable table(saddle);
  std::size_t boxes = 0;
  const PairSearch found = search_pairs(table, table, 2000, boxes);
  EXPECT_TRUE(found.witness.has_value() || found.boxes_left > 0);
}

}  // namespace
}  // namespace radcert
