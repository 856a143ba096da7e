// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/chart_shape.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "radcert/hypotheses/chart_pairs.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
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

ExactFunction square_of_t() { return ExactFunction::t() * ExactFunction::t(); }

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

/// z = s^2 - t^2.
template <Field R>
class SaddleOfSquares {
public:
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, s * s - t * t};
  }
};

TEST(ProveShape, RefusesAQuadricWithAnInsideThatIsNotConvex) {
  ChartFacts facts{.name = "saddle", .piece = "saddle", .orientation = along};
  facts.structure.quadric =
      Quadric{.squares = {1, -1, 0}, .linear = {.gradient = {0, 0, -1}, .constant = Rational(0)}};
  const Vector<ExactFunction> image{ExactFunction::s(), ExactFunction::t(), power_of_s(2) - square_of_t()};
  std::size_t boxes = 0;
  const ProvedShape shape = prove_shape(make_chart<SaddleOfSquares>(facts), &image, boxes);
  EXPECT_FALSE(shape.quadric.has_value());
  EXPECT_NE(shape.refusal.find("convex"), std::string::npos) << shape.refusal;
}

/// On x^2 + y^2 = z^2: (2 u t, u^2 - t^2, h (u^2 + t^2)), u = 1 + s, h = 1 or -1.
template <Field R>
class ConePatch {
public:
  explicit ConePatch(int sheet) : sheet_(R(sheet)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const T u = R(1) + s;
    return {R(2) * (u * t), u * u - t * t, sheet_ * (u * u + t * t)};
  }

private:
  R sheet_;
};

bool is_on_upper_nappe(int sheet, Orientation orientation) {
  ChartFacts facts{.name = "cone", .piece = "cone", .orientation = orientation};
  facts.structure.quadric = Quadric{.squares = {1, 1, 0},
                                    .linear = {.gradient = {0, 0, 0}, .constant = Rational(0)},
                                    .nappe = AffineForm{.gradient = {0, 0, 1}, .constant = Rational(0)}};
  const ExactFunction u = ExactFunction(Rational(1)) + ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  const Vector<ExactFunction> image{ExactFunction(Rational(2)) * u * t, u * u - t * t,
                                    ExactFunction(Rational(sheet)) * (u * u + t * t)};
  std::size_t boxes = 0;
  return prove_shape(make_chart<ConePatch>(facts, sheet), &image, boxes).quadric.has_value();
}

TEST(ProveShape, TakesTheUpperNappeOfAConeAlone) {
  EXPECT_NE(is_on_upper_nappe(1, along), is_on_upper_nappe(1, against));
  EXPECT_FALSE(is_on_upper_nappe(-1, along));
  EXPECT_FALSE(is_on_upper_nappe(-1, against));
}

TEST(ProveShape, RefusesAPlaneThatTheFormulaDoesNotKeep) {
  ChartFacts facts{.name = "floor", .piece = "floor", .orientation = along};
  facts.plane = Plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  for (const bool bent : {false, true}) {
    const ExactFunction height = bent ? power_of_s(2) - square_of_t() : ExactFunction(Rational(0));
    const Vector<ExactFunction> image{s, t, height};
    std::size_t boxes = 0;
    const Chart chart =
        bent ? make_chart<SaddleOfSquares>(facts) : make_rectangle(facts, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(prove_shape(chart, &image, boxes).inner.has_value(), !bent);
  }
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

/// z = s^2: its normals turn away from what stands beside it.
template <Field R>
class Trough {
public:
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, s * s};
  }
};

TEST(SearchPairs, LooksAtEveryNormalOfALargePatchBesideASmallOne) {
  // A small patch in front of the tangent plane in the middle of the trough, and behind that at its end.
  const Chart trough = make_chart<Trough>({.name = "trough", .piece = "trough", .orientation = along});
  const Chart small =
      make_rectangle({.name = "small", .piece = "small"}, {Rational(3, 2), Rational(1, 2), Rational(8, 5)},
                     {Rational(1, 1000), 0, 0}, {0, Rational(1, 1000), 0});
  PatchTable of_trough(trough);
  PatchTable of_small(small);
  std::size_t boxes = 0;
  EXPECT_TRUE(search_pairs(of_trough, of_small, 2000, boxes).witness.has_value());
}

}  // namespace
}  // namespace radcert
