// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/hypotheses/chart_pairs.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/exact_chart.h"
#include "tests/hypotheses/dome.h"
#include "tests/surface/default_surface.h"

namespace radcert {
namespace {

using Values = std::vector<Rational>;

Surface named_surface(const std::string& name, const Values& values) {
  return find_surface(name)->make(values);
}

/// The witness, from the two charts and the parameters alone.
::testing::AssertionResult checks(const Surface& surface, const ConvexContainment& found) {
  if (found.verdict != Containment::refuted || !found.chart_witness)
    return ::testing::AssertionFailure() << found.reason;
  const ChartWitness& witness = *found.chart_witness;
  const BallPrecision precision(256);
  const auto frame = [&](std::size_t chart, const ParameterPoint<Rational>& at) {
    return surface.charts.at(chart).in<Ball>().frame({Ball(at.s), Ball(at.t)});
  };
  const Frame<Ball> p = frame(witness.chart_p, witness.at_p);
  const Frame<Ball> q = frame(witness.chart_q, witness.at_q);
  const Ball product = dot(q.point - p.point, p.area_normal);
  const bool in_square = witness.at_p.s >= 0 && witness.at_p.t >= 0 && witness.at_q.s <= 1;
  if (certainly_negative(product) && overlaps(product, witness.product) && in_square &&
      found.relative_depth > 0)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << product.to_text() << " is not " << witness.product.to_text();
}

bool says(const ConvexContainment& found, const std::string& words) {
  return std::any_of(found.steps.begin(), found.steps.end(), [&](const ContainmentStep& step) {
    return step.proof.find(words) != std::string::npos;
  });
}

struct Case {
  std::string name;
  Values values;
};

TEST(CurvedContainment, CertifiesTheConvexSurfacesOfTheCatalogue) {
  const Rational half(1, 2);
  const std::vector<Case> cases{{"two_squares", {}},
                                {"cube", {}},
                                {"box", {1, 2, 5}},
                                {"tetrahedron", {}},
                                {"octahedron", {}},
                                {"sphere", {}},
                                {"paraboloid_cap", {}},
                                {"ellipsoid", {1, 2, 5}},
                                {"ellipsoid", {1, 1, 100}},
                                {"ellipsoid", {100, 1, 1}},
                                {"two_piece", {1}},
                                {"two_piece", {Rational(3, 2)}},
                                {"two_piece", {2}},
                                {"two_piece", {3}},
                                {"two_piece", {Rational(101, 100)}},
                                {"two_piece", {10}},
                                {"spherical_cap", {Rational(1, 1000)}},
                                {"spherical_cap", {Rational(1, 4)}},
                                {"spherical_cap", {half}},
                                {"spherical_cap", {Rational(3, 4)}},
                                {"cylinder", {1, 2}},
                                {"cylinder", {Rational(1, 3), 100}},
                                {"cone", {1, half, 1}},
                                {"cone", {1, 2, 1}},
                                {"cone", {100, 1, 1}}};
  for (const Case& each : cases) {
    const Surface surface = named_surface(each.name, each.values);
    const ConvexContainment found = convex_containment(surface);
    const std::string title = each.name + (each.values.empty() ? "" : " " + each.values.front().to_text());
    EXPECT_EQ(found.verdict, Containment::certified) << title << ": " << found.reason;
    EXPECT_FALSE(found.chart_witness.has_value()) << title;
    EXPECT_TRUE(found.open.empty()) << title;
    EXPECT_FALSE(found.steps.empty()) << title;
    EXPECT_FALSE(says(found, "is stated, but")) << title;
  }
}

TEST(CurvedContainment, CoversTheCatalogue) {
  for (const SurfaceDescription& entry : surface_catalogue()) {
    EXPECT_EQ(convex_containment(default_surface(entry)).verdict,
              entry.unoccluded ? Containment::certified : Containment::refuted)
        << entry.name;
  }
}

TEST(CurvedContainment, RefutesToriByAPairThatChecks) {
  for (const Values& values : {Values{1, Rational(1, 2)}, Values{1, Rational(1, 1000)},
                               Values{1000, Rational(999, 1000)}, Values{Rational(1, 7), Rational(1, 3)}}) {
    const Surface surface = named_surface("torus", values);
    EXPECT_TRUE(checks(surface, convex_containment(surface))) << values[1].to_text();
  }
}

/// The sphere with one chart put in place of its first.
Surface sphere_with(Chart chart) {
  Surface surface = sphere();
  surface.charts.front() = std::move(chart);
  return surface;
}

/// Less work: what is undecided with it is so with more.
constexpr ContainmentBudget little{.boxes_a_pair = 500, .boxes = 4000};

TEST(CurvedContainment, BelievesNoWrongCoefficient) {
  ChartFacts facts = sphere().charts.front().facts();
  facts.structure.quadric->squares.z = Rational(1000001, 1000000);
  const ConvexContainment found =
      convex_containment(sphere_with(make_exact_chart<EllipsoidOctant>(facts, Rational(1), Rational(1),
                                                                       Rational(1), Octant{1, 1, 1})),
                         little);
  EXPECT_EQ(found.verdict, Containment::undecided);
  EXPECT_TRUE(says(found, "a quadric is stated, but it does not hold"));
}

TEST(CurvedContainment, BelievesNoStatementWithoutAnExactFormula) {
  const ConvexContainment found =
      convex_containment(sphere_with(make_chart<EllipsoidOctant>(sphere().charts.front().facts(), Rational(1),
                                                                 Rational(1), Rational(1), Octant{1, 1, 1})),
                         little);
  EXPECT_EQ(found.verdict, Containment::undecided);
  EXPECT_TRUE(says(found, "its formula is not known exactly"));
  for (const OpenPair& open : found.open) EXPECT_TRUE(open.chart_p == 0 || open.chart_q == 0);
}

TEST(CurvedContainment, NoticesAChartWithItsNormalsTurnedOver) {
  for (const Surface& surface : {sphere(), named_surface("cylinder", {1, 2}), named_surface("two_piece", {2}),
                                 named_surface("paraboloid_cap", {}), named_surface("cube", {})}) {
    Surface turned = surface;
    const auto other = [](Orientation given) {
      return given == Orientation::along_the_cross_product ? Orientation::against_the_cross_product
                                                           : Orientation::along_the_cross_product;
    };
    for (Surface* each : {&turned}) {
      ChartFacts facts = each->charts.back().facts();
      facts.orientation = other(facts.orientation);
      const std::string name = surface.name;
      if (name == "sphere")
        each->charts.back() = make_exact_chart<EllipsoidOctant>(facts, Rational(1), Rational(1), Rational(1),
                                                                Octant{-1, -1, -1});
      else
        each->charts.push_back(make_rectangle(
            {.name = "turned", .piece = "turned", .orientation = Orientation::against_the_cross_product},
            {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    }
    EXPECT_TRUE(checks(turned, convex_containment(turned))) << surface.name;
  }
}

/// The octant of the unit sphere, bent outwards by `height` times s t (1 - s - t).
template <Field R>
class BentOctant {
public:
  explicit BentOctant(const Rational& height)
      : octant_(1, 1, 1, Octant{1, 1, 1}), height_(from_rational<R>(height)) {}

  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const Vector<T> f = octant_(s, t);
    const T scale = R(1) + height_ * (s * t * (R(1) - (s + t)));
    return scale * f;
  }

private:
  EllipsoidOctant<R> octant_;
  R height_;
};

TEST(CurvedContainment, NoticesAChartBentByAMillionth) {
  const Rational millionth(1, 1000000);
  const ChartFacts facts = sphere().charts.front().facts();
  const Surface bent = sphere_with(make_exact_chart<BentOctant>(facts, millionth));
  const ConvexContainment found = convex_containment(bent, little);
  EXPECT_TRUE(says(found, "a quadric is stated, but it does not hold"));
  EXPECT_TRUE(checks(bent, found)) << "the chart meets its neighbours at a crease";
  const ConvexContainment straight =
      convex_containment(sphere_with(make_exact_chart<BentOctant>(facts, Rational(0))));
  EXPECT_EQ(straight.verdict, Containment::certified) << "the same formula, not bent";
  // A larger sphere's octant in place of one: it stands out.
  const Rational larger = 1 + millionth;
  const Surface stepped =
      sphere_with(make_exact_chart<EllipsoidOctant>(facts, larger, larger, larger, Octant{1, 1, 1}));
  EXPECT_TRUE(checks(stepped, convex_containment(stepped, little)));
}

TEST(CurvedContainment, CertifiesAStrictlyConvexPatchThatStatesNothing) {
  const ConvexContainment found = convex_containment(sample::dome_over_floor(0));
  EXPECT_EQ(found.verdict, Containment::certified) << found.reason;
  EXPECT_TRUE(says(found, "the second fundamental form"));
  EXPECT_GT(found.boxes, 0U);
  // z'' = -1/2 + 6 dent x: convex as long as dent <= 1/12.
  EXPECT_EQ(convex_containment(sample::dome_over_floor(Rational(8, 100))).verdict, Containment::certified);
  for (const Rational& dent : {Rational(1, 4), Rational(9, 100)})
    EXPECT_TRUE(checks(sample::dome_over_floor(dent), convex_containment(sample::dome_over_floor(dent))))
        << dent.to_text();
}

/// z = 1 - x^2 / 4 + y^2 / 4.
template <Field R>
class Saddle {
public:
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    return {s, t, R(1) + from_rational<R>(Rational(1, 4)) * (t * t - s * s)};
  }
};

bool is_proved(const Chart& of_p, const Chart& of_q, std::size_t limit) {
  PatchTable p(of_p);
  PatchTable q(of_q);
  std::size_t boxes = 0;
  const PairSearch found = search_pairs(p, &of_p == &of_q ? p : q, limit, boxes);
  return found.boxes_left == 0 && !found.witness;
}

TEST(SearchPairs, ProvesWhatIsInFrontAndNothingElse) {
  constexpr std::size_t limit = 5000;
  const ChartFacts downwards{
      .name = "roof", .piece = "roof", .orientation = Orientation::against_the_cross_product};
  const Chart dome = make_chart<sample::Dome>(downwards, Rational(0));
  const Chart saddle = make_chart<Saddle>(downwards);
  EXPECT_TRUE(is_proved(dome, dome, limit));
  EXPECT_FALSE(is_proved(saddle, saddle, limit)) << "convex along s alone";
  const auto wall = [](const Rational& top) {
    return make_rectangle({.name = "wall", .piece = "wall"}, {0, 0, -1}, {1, 0, 0}, {0, 1, top + 1});
  };
  EXPECT_TRUE(is_proved(dome, wall(Rational(1, 8)), limit));
  EXPECT_FALSE(is_proved(dome, wall(Rational(3, 2)), limit))
      << "its centre is in front, its upper side is not";
  // The other way round: the dome before the floor, and not before a plane through its middle.
  const auto floor = [](const Rational& height) {
    return make_rectangle({.name = "floor", .piece = "floor"}, {0, 0, height}, {1, 0, 0}, {0, 1, 0});
  };
  EXPECT_TRUE(is_proved(floor(0), dome, limit));
  EXPECT_FALSE(is_proved(floor(Rational(1, 2)), dome, limit));
}

TEST(CurvedContainment, DoesTheSameWorkEachTime) {
  const Surface dome = sample::dome_over_floor(0);
  EXPECT_EQ(convex_containment(dome).boxes, convex_containment(dome).boxes);
}

TEST(CurvedContainment, NeverRefutesAConvexSurfaceWithoutItsStructure) {
  Surface stripped = ellipsoid(1, 2, 5);
  ChartFacts facts = stripped.charts.front().facts();
  facts.structure = {};
  stripped.charts.front() =
      make_chart<EllipsoidOctant>(facts, Rational(1), Rational(2), Rational(5), Octant{1, 1, 1});
  const ConvexContainment found = convex_containment(stripped, little);
  EXPECT_EQ(found.verdict, Containment::undecided);
  EXPECT_FALSE(found.chart_witness.has_value());
  EXPECT_FALSE(found.open.empty());
}

TEST(CurvedContainment, SaysWhatIsLeft) {
  const Surface dome = sample::dome_over_floor(0);
  const ConvexContainment found = convex_containment(dome, {.boxes_a_pair = 2, .boxes = 3});
  EXPECT_EQ(found.verdict, Containment::undecided);
  ASSERT_FALSE(found.open.empty());
  EXPECT_EQ(found.open.front().chart_p, 1U);
  EXPECT_GT(found.open.front().boxes, 0U);
  EXPECT_NE(found.reason.find("dome"), std::string::npos) << found.reason;
  EXPECT_THROW(static_cast<void>(convex_containment(dome, {.boxes_a_pair = 0})), ContractViolation);
}

TEST(CurvedContainment, LeavesAChartWithoutBallsUndecided) {
  Surface surface = sphere();
  const auto kept = std::make_shared<const Chart>(surface.charts.front());
  surface.charts.front() =
      Chart(kept->facts(), std::shared_ptr<const ChartIn<double>>(kept, &kept->in<double>()));
  const ConvexContainment found = convex_containment(surface);
  EXPECT_EQ(found.verdict, Containment::undecided);
  EXPECT_NE(found.reason.find("octant_ppp has no formula in balls"), std::string::npos) << found.reason;
}

}  // namespace
}  // namespace radcert
