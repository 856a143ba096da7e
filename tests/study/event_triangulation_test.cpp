// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/events/event_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/surface/mesh_surface.h"
#include "radcert/triangulation/conforming_charts.h"
#include "tests/study/problems.h"
#include "tests/visibility/event_rooms.h"

namespace radcert {
namespace {

using namespace testing;

/// A room as a problem: its lamp emits 1, its floor reflects a half, all else nothing. Turned: its triangles
/// run clockwise as seen from the light.
Problem problem_in(const sample::EventRoom& room, bool closed = true, bool turned = false) {
  TriangleMesh mesh = room.scene.mesh();
  if (turned)
    for (VertexTriple& v : mesh.triangles) std::swap(v[1], v[2]);
  std::vector<std::string> names;
  std::vector<std::size_t> pieces;
  for (const std::string& name : room.names) {
    const auto known = std::find(names.begin(), names.end(), name);
    pieces.push_back(static_cast<std::size_t>(known - names.begin()));
    if (known == names.end()) names.push_back(name);
  }
  const Surface surface = mesh_surface(
      "room", mesh, pieces, names,
      {.orientation = turned ? Orientation::against_the_cross_product : Orientation::along_the_cross_product,
       .closed = closed,
       .unoccluded = false});
  Problem problem = sample_problem("cube");
  problem.surface = {.name = "room",
                     .parameters = {},
                     .mesh = MeshChoice{.file = "room",
                                        .digest = "room",
                                        .angle = 20,
                                        .repair = {},
                                        .mended = {},
                                        .surface = std::make_shared<const Surface>(surface)}};
  problem.triangulation.pattern.clear();
  problem.solution = std::nullopt;
  problem.method = Collocation{{.degree = 1, .alpha = Rational(1, 6)}};
  problem.reflectivity = by_piece({{"floor", "1/2"}, {"*", "0"}});
  problem.emission = by_piece({{"lamp", "1"}, {"*", "0"}});
  return problem;
}

EventCut cut_of(const Problem& problem, const std::optional<Rational>& secondary = std::nullopt) {
  return event_cut(problem, surface_of(problem), secondary);
}

TEST(EventTriangulation, IsConformingOnEveryLevel) {
  for (const sample::EventRoom& room : {sample::room_around_a_corner(0.25, 1), sample::room_with_a_box()}) {
    Problem problem = problem_in(room);
    problem.triangulation.events = cut_of(problem);
    const Surface surface = surface_of(problem);
    EXPECT_GT(problem.triangulation.events->segments, 0U);
    for (int level = 0; level <= 2; ++level) {
      const TriangulationOptions options = triangulation_options(problem, surface);
      const Triangulation found = triangulate(surface, level, options);
      EXPECT_EQ(found.triangles.size(), triangle_count(surface, level, options));
      const Outcome<void> fits = conforming(surface, found);
      EXPECT_TRUE(fits) << fits.reason();
    }
  }
}

// Two charts on both sides of a side have the same vertices on it.
TEST(EventTriangulation, CutsNeighboursAtTheSamePoints) {
  Problem problem = problem_in(sample::room_with_a_box());
  const EventCut cut = cut_of(problem);
  const Surface surface = surface_of(problem);
  std::vector<std::vector<double>> on_diagonal;  // x of vertices on the floor's diagonal, by chart
  for (std::size_t chart = 0; chart < surface.chart_count(); ++chart) {
    if (surface.charts[chart].facts().piece != "floor") continue;
    std::set<double> found;
    for (const ParameterTriangle& element : *cut.coarse)
      if (element.chart == chart)
        for (const auto& v : element.vertices) {
          const Vector<double> p = surface.charts[chart].in<double>().frame(v).point;
          if (p.x == p.y) found.insert(p.x);
        }
    on_diagonal.emplace_back(found.begin(), found.end());
  }
  ASSERT_EQ(on_diagonal.size(), 2U);
  EXPECT_GT(on_diagonal[0].size(), 2U);
  EXPECT_EQ(on_diagonal[0], on_diagonal[1]);
}

// Which way the file's triangles run is exchanged in the scene; the lines on the floor are the same.
TEST(EventTriangulation, DoesNotDependOnTheOrderOfCorners) {
  const auto cuts = [](bool turned) {
    const Problem problem = problem_in(sample::room_with_a_box(), true, turned);
    const Surface surface = surface_of(problem);
    std::set<std::pair<double, double>> places;
    const EventCut cut = cut_of(problem);
    for (const ParameterTriangle& element : *cut.coarse)
      for (const auto& v : element.vertices) {
        const Vector<double> p = surface.charts[element.chart].in<double>().frame(v).point;
        if (p.z == 0) places.emplace(std::round(p.x * 0x1p20), std::round(p.y * 0x1p20));
      }
    return places;
  };
  EXPECT_EQ(cuts(false), cuts(true));
}

TEST(EventTriangulation, TakesReflectingPiecesAboveTheThresholdForSources) {
  Problem problem = problem_in(sample::room_with_a_box());
  EXPECT_EQ(cut_of(problem).source_triangles, 1U);
  EXPECT_EQ(cut_of(problem, Rational(1)).source_triangles, 1U);  // 1/2 / (1 - 1/2) is not above 1
  EXPECT_EQ(cut_of(problem, Rational(99, 100)).source_triangles, 3U);
  problem.reflectivity = by_piece({{"floor", "1/2 + x/100"}, {"*", "0"}});
  EXPECT_EQ(cut_of(problem, Rational(1000)).source_triangles, 3U);  // counts as up to 1
}

TEST(EventTriangulation, CutsNothingThatReflectsNothing) {
  Problem problem = problem_in(sample::room_with_a_box());
  problem.reflectivity = everywhere("0");
  const EventCut cut = cut_of(problem);
  EXPECT_EQ(cut.segments, 0U);
  EXPECT_EQ(cut.coarse->size(), surface_of(problem).chart_count());
}

TEST(EventTriangulation, IsRefusedByName) {
  const auto words = [](const Problem& problem) -> std::string {
    try {
      (void)cut_of(problem);
    } catch (const InputError& error) {
      EXPECT_EQ(error.fault().pointer, "/triangulation/events");
      return error.fault().problem;
    }
    return "";
  };
  const Problem room = problem_in(sample::room_with_a_box());
  const auto with = [&](const std::function<void(Problem&)>& change) {
    Problem changed = room;
    change(changed);
    return words(changed);
  };
  EXPECT_EQ(words(room), "");
  EXPECT_NE(
      with([](Problem& p) { p.solution = p.emission, p.emission = std::nullopt; }).find("given solution"),
      std::string::npos);
  EXPECT_NE(with([](Problem& p) { p.triangulation.grading = 2; }).find("a grading"), std::string::npos);
  EXPECT_NE(with([](Problem& p) { p.geometry = InterpolatedGeometry{}; }).find("interpolated"),
            std::string::npos);
  EXPECT_NE(with([](Problem& p) { p.method = Meshless{}; }).find("without elements"), std::string::npos);
  EXPECT_NE(with([](Problem& p) { p.surface = {.name = "cube", .parameters = {}}; }).find("nothing hides"),
            std::string::npos);
  EXPECT_NE(with([](Problem& p) { p.surface = {.name = "sphere", .parameters = {}}; }).find("curved"),
            std::string::npos);
  EXPECT_NE(words(problem_in(sample::room_with_a_box(), false)).find("open edges"), std::string::npos);
}

}  // namespace
}  // namespace radcert
