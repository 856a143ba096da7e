// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/conforming.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "radcert/geometry/polygon_triangulation.h"
#include "radcert/scalar/real.h"
#include "radcert/surface/catalogue.h"
#include "radcert/triangulation/triangulation.h"
#include "tests/surface/default_surface.h"

namespace radcert {
namespace {

using testing::HasSubstr;

std::vector<DomainTriangle> triangles_of(const PlaneTriangulation& t) {
  std::vector<DomainTriangle> out;
  for (const VertexTriple& v : t.triangles)
    out.push_back({t.vertices[v[0]], t.vertices[v[1]], t.vertices[v[2]]});
  return out;
}

PlanePolygon polygon_of(std::vector<PolygonLoop> loops) {
  return plane_polygon({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, std::move(loops)).value();
}

Rational third(long n) { return Rational(n, 3); }

/// Convex; with a notch; with a vertex on a straight side; with two holes; with corners that are no doubles.
std::vector<PlanePolygon> polygons() {
  return {polygon_of({{{0, 0}, {1, 0}, {0, 1}}}), polygon_of({{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}}),
          polygon_of({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}}),
          polygon_of(
              {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{5, 5}, {8, 5}, {6, 8}}}),
          polygon_of(
              {{{0, 0}, {third(1), third(-1)}, {third(7), 0}, {third(4), third(5)}, {third(1), third(2)}}})};
}

TEST(Triangulate, ConformsOnPolygonsWithAndWithoutHoles) {
  for (const PlanePolygon& polygon : polygons()) {
    const PlaneTriangulation t = triangulate(polygon);
    const Outcome<void> found = conforming(polygon.loops(), triangles_of(t));
    EXPECT_TRUE(found) << found.reason();
    std::size_t vertices = 0;
    for (const PolygonLoop& loop : polygon.loops()) vertices += loop.size();
    // Euler: V + 2 (holes - 1) triangles.
    EXPECT_EQ(t.triangles.size() + 4, vertices + 2 * polygon.loops().size());
    EXPECT_EQ(t.vertices.size(), vertices);
  }
}

TEST(GradedToward, ConformsAndIsFineWhereItWasAskedFor) {
  for (const PlanePolygon& polygon : polygons()) {
    const std::vector<PolygonSide> sides{{0, 1}, {polygon.loops().size() - 1, 0}};
    const PlaneTriangulation coarse = triangulate(polygon);
    for (const int times : {0, 1, 2, 5}) {
      const PlaneTriangulation fine = graded_toward(coarse, polygon, sides, times);
      const Outcome<void> found = conforming(polygon.loops(), triangles_of(fine));
      EXPECT_TRUE(found) << found.reason();
      if (times == 0) {
        EXPECT_EQ(fine.triangles, coarse.triangles);
      }
      // Each round at least halves whatever touches a chosen side.
      const PolygonLoop& loop = polygon.loops()[0];
      const auto largest_at = [&](const PlaneTriangulation& t) {
        Rational largest = 0;
        for (const DomainTriangle& v : triangles_of(t))
          if (std::find(v.begin(), v.end(), loop[1]) != v.end())
            largest = std::max(largest, cross(v[1] - v[0], v[2] - v[0]));
        return largest;
      };
      EXPECT_LE(largest_at(fine) * power(Rational(2), times), largest_at(coarse));
    }
  }
}

TEST(GradedToward, RefusesSidesThatAreNotThere) {
  const PlanePolygon polygon = polygons()[0];
  const std::vector<PolygonSide> wrong{{0, 3}};
  EXPECT_THROW((void)graded_toward(triangulate(polygon), polygon, wrong, 1), ContractViolation);
}

TEST(Conforming, HoldsOfEveryTriangulationOfTheCatalogue) {
  const PolygonLoop square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PolygonLoop triangle{{0, 0}, {1, 0}, {0, 1}};
  for (const SurfaceDescription& entry : surface_catalogue()) {
    const Surface surface = default_surface(entry);
    for (const int level : {0, 1, 3})
      for (const double grading : {1.0, 2.0, 3.7}) {
        const Triangulation t = triangulate(surface, level, {.diagonals = std::nullopt, .grading = grading});
        for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
          std::vector<DomainTriangle> triangles;
          for (const ParameterTriangle& element : t.triangles) {
            if (element.chart != chart) continue;
            DomainTriangle exact;
            for (std::size_t i = 0; i < 3; ++i)
              exact[i] = {Rational::exactly(element.vertices[i].s), Rational::exactly(element.vertices[i].t)};
            triangles.push_back(exact);
          }
          const bool is_square = surface.charts[chart].facts().domain == ChartDomain::unit_square;
          const std::vector<PolygonLoop> loops{is_square ? square : triangle};
          const Outcome<void> found = conforming(loops, triangles);
          ASSERT_TRUE(found) << entry.name << " level " << level << ": " << found.reason();
        }
      }
  }
}

TEST(Conforming, SaysWhatIsBroken) {
  const std::vector<PolygonLoop> square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
  const auto said = [&](const std::vector<DomainTriangle>& triangles) {
    const Outcome<void> found = conforming(square, triangles);
    return found ? std::string("conforming") : found.reason();
  };
  using T = DomainTriangle;
  const T low{{{0, 0}, {2, 0}, {2, 2}}};
  const T high{{{0, 0}, {2, 2}, {0, 2}}};
  EXPECT_EQ(said({low, high}), "conforming");
  EXPECT_THAT(said({low, {{{0, 0}, {0, 2}, {2, 2}}}}), HasSubstr("triangle 1 is clockwise or flat"));
  EXPECT_THAT(said({low, {{{0, 0}, {1, 1}, {2, 2}}}}), HasSubstr("triangle 1 is clockwise or flat"));
  EXPECT_THAT(said({low}), HasSubstr("T2"));
  EXPECT_THAT(said({low, high, high}), HasSubstr("T3: triangles 1 and 2"));
  // A vertex in the middle of another's side; a vertex of the polygon left out; a triangle outside.
  EXPECT_THAT(said({low, {{{0, 0}, {1, 1}, {0, 2}}}, {{{1, 1}, {2, 2}, {0, 2}}}}), HasSubstr("T"));
  EXPECT_THAT(said({{{{0, 0}, {2, 0}, {2, 2}}}}), HasSubstr("has no triangle on its other side"));
  EXPECT_THAT(said({low, high, {{{2, 0}, {4, 0}, {2, 2}}}}), HasSubstr("T"));
  EXPECT_THAT(said({low, high, {{{2, 0}, {3, 1}, {2, 2}}}}), HasSubstr("T2: the side from (2, 0) to (3, 1)"));
  EXPECT_THAT(said({low, high, {{{5, 0}, {6, 0}, {5, 1}}}}), HasSubstr("T3: the side from (5, 0)"));
  EXPECT_THAT(said({{{{1, 0}, {2, 0}, {2, 2}}}}), HasSubstr("T1: the vertex (0, 0)"));
  // Twice over: a second layer inside, on vertices of its own.
  EXPECT_THAT(
      said({low, high, {{{Rational(1, 2), Rational(1, 4)}, {1, Rational(1, 4)}, {1, Rational(1, 2)}}}}),
      HasSubstr("T3"));
  EXPECT_THAT(said({}), HasSubstr("T1"));
}

}  // namespace
}  // namespace radcert
