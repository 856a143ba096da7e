// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/triangulation/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/surface/default_surface.h"

namespace radcert {
namespace {

using Corner = std::pair<double, double>;
using Corners = std::array<Corner, 3>;

Corner corner(const ParameterPoint<double>& p) { return {p.s, p.t}; }

Corners corners(const ParameterTriangle& triangle) {
  return {corner(triangle.vertices[0]), corner(triangle.vertices[1]), corner(triangle.vertices[2])};
}

/// Twice the signed area; exact for the small dyadic coordinates of a triangulation that is not graded.
double parallelogram(const ParameterTriangle& triangle) {
  const auto& v = triangle.vertices;
  return cross(v[1] - v[0], v[2] - v[0]);
}

std::uint64_t coarse_count(const Surface& surface) {
  std::uint64_t count = 0;
  for (const Chart& chart : surface.charts)
    count += chart.facts().domain == ChartDomain::unit_square ? 2U : 1U;
  return count;
}

TEST(Triangulation, HasFourTimesAsManyTrianglesALevel) {
  for (const Surface& surface : sample::default_surfaces())
    for (int level = 0; level <= 4; ++level) {
      const std::uint64_t expected = coarse_count(surface) << (2U * static_cast<unsigned>(level));
      EXPECT_EQ(triangulate(surface, level).triangles.size(), expected) << surface.name;
      EXPECT_EQ(triangle_count(surface, level), expected) << surface.name;
    }
}

TEST(Triangulation, CutsTwoPieceAlongTheMainDiagonal) {
  const Triangulation coarse = triangulate(two_piece(2), 0);
  ASSERT_EQ(coarse.triangles.size(), 4U);
  for (std::size_t chart = 0; chart < 2; ++chart) {
    const ParameterTriangle& below = coarse.triangles[2 * chart];
    const ParameterTriangle& above = coarse.triangles[2 * chart + 1];
    EXPECT_EQ(below.chart, chart);
    EXPECT_EQ(above.chart, chart);
    EXPECT_EQ(corners(below), (Corners{{{0, 0}, {1, 0}, {1, 1}}}));
    EXPECT_EQ(corners(above), (Corners{{{0, 0}, {1, 1}, {0, 1}}}));
  }
}

TEST(Triangulation, CutsTheCubesNearFacesAlongTheAntiDiagonalAndTheFarOnesAlongTheMain) {
  // In space: on x_a = 0 the diagonal joins e_b to e_c, on x_a = 1 it joins e_a to (1,1,1).
  const Surface surface = cube();
  const Triangulation coarse = triangulate(surface, 0);
  ASSERT_EQ(coarse.triangles.size(), 12U);
  const std::array<Vector<double>, 3> e{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<std::array<const char*, 2>, 3> names{
      {{"west", "east"}, {"south", "north"}, {"floor", "ceiling"}}};
  for (std::size_t a = 0; a < 3; ++a)
    for (const std::size_t end : {0U, 1U}) {
      const Vector<double> first = end == 0 ? e[(a + 1) % 3] : e[a];
      const Vector<double> second = end == 0 ? e[(a + 2) % 3] : Vector<double>{1, 1, 1};
      int with_diagonal = 0;
      int on_face = 0;
      for (const ParameterTriangle& triangle : coarse.triangles) {
        const Chart& chart = surface.charts[triangle.chart];
        if (chart.facts().piece != names[a][end]) continue;
        ++on_face;
        bool has_first = false;
        bool has_second = false;
        for (const ParameterPoint<double>& v : triangle.vertices) {
          const Vector<double> point = chart.in<double>().frame(v).point;
          EXPECT_EQ(dot(point, e[a]), static_cast<double>(end));
          has_first = has_first || point == first;
          has_second = has_second || point == second;
        }
        with_diagonal += has_first && has_second ? 1 : 0;
      }
      EXPECT_EQ(on_face, 2) << names[a][end];
      EXPECT_EQ(with_diagonal, 2) << names[a][end];
    }
}

TEST(Triangulation, TakesAUnitTriangleAsItIs) {
  const Triangulation coarse = triangulate(sphere(), 0);
  ASSERT_EQ(coarse.triangles.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(coarse.triangles[k].chart, k);
    EXPECT_EQ(corners(coarse.triangles[k]), (Corners{{{0, 0}, {1, 0}, {0, 1}}}));
  }
}

TEST(Triangulation, CutsAlongTheDiagonalsThatItIsGiven) {
  const Surface surface = two_piece(2);
  const TriangulationOptions options{.diagonals = std::vector{Diagonal::anti, Diagonal::main}};
  const Triangulation coarse = triangulate(surface, 0, options);
  ASSERT_EQ(coarse.triangles.size(), 4U);
  EXPECT_EQ(corners(coarse.triangles[0]), (Corners{{{0, 0}, {1, 0}, {0, 1}}}));
  EXPECT_EQ(corners(coarse.triangles[1]), (Corners{{{1, 0}, {1, 1}, {0, 1}}}));
  EXPECT_EQ(corners(coarse.triangles[2]), (Corners{{{0, 0}, {1, 0}, {1, 1}}}));
}

using Edge = std::tuple<std::size_t, Corner, Corner>;

/// How many triangles have each side, sides told apart by chart and exact end points.
std::map<Edge, int> edges(const Triangulation& triangulation) {
  std::map<Edge, int> count;
  for (const ParameterTriangle& triangle : triangulation.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner a = corner(triangle.vertices[i]);
      const Corner b = corner(triangle.vertices[(i + 1) % 3]);
      ++count[{triangle.chart, std::min(a, b), std::max(a, b)}];
    }
  return count;
}

/// Whether a segment lies on a side of the domain.
bool on_the_border(ChartDomain domain, const Corner& a, const Corner& b) {
  if ((a.first == 0 && b.first == 0) || (a.second == 0 && b.second == 0)) return true;
  if (domain == ChartDomain::unit_square)
    return (a.first == 1 && b.first == 1) || (a.second == 1 && b.second == 1);
  return a.first + a.second == 1 && b.first + b.second == 1;
}

void expect_conforming(const Surface& surface, const Triangulation& triangulation) {
  for (const auto& [edge, triangles] : edges(triangulation)) {
    const auto& [chart, a, b] = edge;
    EXPECT_EQ(triangles, on_the_border(surface.charts[chart].facts().domain, a, b) ? 1 : 2)
        << surface.name << " chart " << chart << " from (" << a.first << ", " << a.second << ") to ("
        << b.first << ", " << b.second << ")";
  }
}

TEST(Triangulation, HasEveryInnerSideInTwoTrianglesOfItsChart) {
  for (const Surface& surface : sample::default_surfaces())
    for (int level = 0; level <= 4; ++level) expect_conforming(surface, triangulate(surface, level));
}

TEST(Triangulation, HasEverySideInTwoTrianglesOfAClosedSurfaceInSpace) {
  // Across seams too; the end points are the same doubles from both sides.
  using Point = std::array<double, 3>;
  for (const Surface& surface : sample::default_surfaces()) {
    if (!surface.closed) continue;
    const bool of_one_kind =
        std::all_of(surface.charts.begin(), surface.charts.end(), [&surface](const Chart& chart) {
          return chart.facts().domain == surface.charts.front().facts().domain;
        });
    // Only unit squares are graded.
    for (const double grading : of_one_kind ? std::vector{1.0, 2.0} : std::vector{1.0})
      for (int level = 0; level <= 3; ++level) {
        std::map<std::pair<Point, Point>, int> count;
        for (const ParameterTriangle& triangle :
             triangulate(surface, level, {.diagonals = {}, .grading = grading}).triangles)
          for (std::size_t i = 0; i < 3; ++i) {
            const auto in_space = [&](std::size_t vertex) {
              const Vector<double> p =
                  surface.charts[triangle.chart].in<double>().frame(triangle.vertices[vertex]).point;
              return Point{p.x, p.y, p.z};
            };
            const Point a = in_space(i);
            const Point b = in_space((i + 1) % 3);
            ++count[{std::min(a, b), std::max(a, b)}];
          }
        for (const auto& [edge, triangles] : count)
          EXPECT_EQ(triangles, 2) << surface.name << " level " << level;
        EXPECT_EQ(2 * count.size(), 3 * *triangle_count(surface, level)) << surface.name;
      }
  }
}

TEST(Triangulation, CoversEachDomainExactly) {
  for (const Surface& surface : sample::default_surfaces())
    for (int level = 0; level <= 5; ++level) {
      std::vector<double> twice(surface.chart_count());
      for (const ParameterTriangle& triangle : triangulate(surface, level).triangles)
        twice[triangle.chart] += parallelogram(triangle);
      for (std::size_t j = 0; j < twice.size(); ++j)
        EXPECT_EQ(twice[j], surface.charts[j].facts().domain == ChartDomain::unit_square ? 2.0 : 1.0);
    }
}

TEST(Triangulation, IsCounterClockwise) {
  for (const Surface& surface : sample::default_surfaces())
    for (const double grading : {1.0, 1.5, 3.0})
      for (int level = 0; level <= 4; ++level)
        for (const ParameterTriangle& triangle :
             triangulate(surface, level, {.diagonals = {}, .grading = grading}).triangles)
          EXPECT_GT(parallelogram(triangle), 0) << surface.name;
}

TEST(Triangulation, HasChildrenThatDivideTheirParent) {
  for (const Surface& surface : sample::default_surfaces()) {
    const std::vector<ParameterTriangle> parents = triangulate(surface, 2).triangles;
    const std::vector<ParameterTriangle> children = triangulate(surface, 3).triangles;
    ASSERT_EQ(children.size(), 4 * parents.size());
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const ParameterTriangle& parent = parents[k];
      for (std::size_t i = 0; i < 4; ++i) {
        const ParameterTriangle& child = children[4 * k + i];
        EXPECT_EQ(child.chart, parent.chart);
        EXPECT_EQ(4 * parallelogram(child), parallelogram(parent));
        for (std::size_t side = 0; side < 3; ++side) {
          const ParameterPoint<double>& a = parent.vertices[side];
          const ParameterPoint<double> along = parent.vertices[(side + 1) % 3] - a;
          for (const ParameterPoint<double>& v : child.vertices) EXPECT_GE(cross(along, v - a), 0);
        }
        // The first three stand at the parent's vertices and keep their numbers; the last touches none of
        // them.
        for (std::size_t vertex = 0; vertex < 3; ++vertex)
          EXPECT_EQ(child.vertices[vertex] == parent.vertices[vertex], vertex == i);
      }
    }
  }
}

TEST(Triangulation, HasAMeshSizeThatHalvesExactly) {
  for (const Surface& surface : sample::default_surfaces()) {
    EXPECT_EQ(mesh_size(triangulate(surface, 0)), std::numbers::sqrt2) << surface.name;
    for (int level = 1; level <= 5; ++level)
      EXPECT_EQ(mesh_size(triangulate(surface, level)), std::ldexp(std::numbers::sqrt2, -level))
          << surface.name;
  }
}

TEST(Triangulation, HasTheMeshSizeOfItsLongestSide) {
  const Triangulation two{{{0, {{{0, 0}, {1, 0}, {0, 1}}}}, {0, {{{0, 0}, {3, 0}, {3, 4}}}}}};
  EXPECT_EQ(mesh_size(two), 5);
  const Triangulation last_side{{{0, {{{0, 0}, {1, 1}, {3, 4}}}}}};
  EXPECT_EQ(mesh_size(last_side), 5);
  EXPECT_THROW(static_cast<void>(mesh_size({})), ContractViolation);
}

TEST(Triangulation, PutsBarycentricPointsWhereTheyBelong) {
  const ParameterTriangle triangle{0, {{{0, 0}, {4, 0}, {0, 8}}}};
  EXPECT_EQ(triangle.at({1, 0, 0}), (ParameterPoint<double>{0, 0}));
  EXPECT_EQ(triangle.at({0, 1, 0}), (ParameterPoint<double>{4, 0}));
  EXPECT_EQ(triangle.at({0, 0, 1}), (ParameterPoint<double>{0, 8}));
  EXPECT_EQ(triangle.at({0.5, 0.25, 0.25}), (ParameterPoint<double>{1, 2}));
}

TEST(GradedTriangulation, StaysConformingAndCoversEachDomain) {
  for (const Surface& surface : sample::default_surfaces())
    for (const double grading : {1.25, 2.0, 3.0})
      for (int level = 0; level <= 4; ++level) {
        const Triangulation graded = triangulate(surface, level, {.diagonals = {}, .grading = grading});
        EXPECT_EQ(graded.triangles.size(), triangle_count(surface, level));
        expect_conforming(surface, graded);
        std::vector<double> twice(surface.chart_count());
        for (const ParameterTriangle& triangle : graded.triangles)
          twice[triangle.chart] += parallelogram(triangle);
        for (std::size_t j = 0; j < twice.size(); ++j)
          EXPECT_NEAR(twice[j], surface.charts[j].facts().domain == ChartDomain::unit_square ? 2.0 : 1.0,
                      1e-13);
      }
}

TEST(GradedTriangulation, MovesVerticesTowardsBothEndsByThePower) {
  // c -> (2c)^2 / 2: 1/4 -> 1/8, 1/8 -> 1/32, and 1 - c to the mirror image.
  const std::map<double, double> moved{{0, 0},           {0.125, 0.03125}, {0.25, 0.125},
                                       {0.375, 0.28125}, {0.5, 0.5},       {0.625, 0.71875},
                                       {0.75, 0.875},    {0.875, 0.96875}, {1, 1}};
  const Surface surface = cube();
  const std::vector<ParameterTriangle> plain = triangulate(surface, 3).triangles;
  const std::vector<ParameterTriangle> graded =
      triangulate(surface, 3, {.diagonals = {}, .grading = 2}).triangles;
  for (std::size_t k = 0; k < plain.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(graded[k].vertices[i].s, moved.at(plain[k].vertices[i].s));
      EXPECT_EQ(graded[k].vertices[i].t, moved.at(plain[k].vertices[i].t));
    }
}

TEST(GradedTriangulation, LeavesUnitTrianglesAlone) {
  const Triangulation plain = triangulate(sphere(), 2);
  const Triangulation graded = triangulate(sphere(), 2, {.diagonals = {}, .grading = 3});
  for (std::size_t k = 0; k < plain.triangles.size(); ++k)
    EXPECT_EQ(corners(graded.triangles[k]), corners(plain.triangles[k]));
}

TEST(Triangulation, RefusesWhatIsNotALevelAGradingOrADiagonalAChart) {
  const Surface surface = cube();
  EXPECT_THROW(triangulate(surface, -1), ContractViolation);
  EXPECT_THROW(static_cast<void>(triangle_count(surface, -1)), ContractViolation);
  for (const double grading : {0.999, 0.0, -2.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(triangulate(surface, 0, {.diagonals = {}, .grading = grading}), ContractViolation)
        << grading;
  EXPECT_THROW(triangulate(surface, 0, {.diagonals = std::vector<Diagonal>(5), .grading = 1}),
               ContractViolation);
}

TEST(TriangleCount, IsNothingAboveTwoToThe53) {
  EXPECT_EQ(triangle_count(sphere(), 25), std::uint64_t{1} << 53U);
  EXPECT_EQ(triangle_count(sphere(), 26), std::nullopt);
  EXPECT_EQ(triangle_count(two_piece(2), 25), std::uint64_t{1} << 52U);
  EXPECT_EQ(triangle_count(two_piece(2), 26), std::nullopt);
  for (const int level : {31, 32, 40, 64, 1000, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(triangle_count(cube(), level), std::nullopt) << level;
    EXPECT_THROW(triangulate(cube(), level), ContractViolation) << level;
  }
}

}  // namespace
}  // namespace radcert
