// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "radcert/core/contract.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Scene, FindsNoFaultsInSoundScenes) {
  EXPECT_THAT(scene_faults(sample::l_room().mesh()), IsEmpty());
  EXPECT_THAT(scene_faults(sample::cube_in_cube(1e-12).mesh()), IsEmpty());
  EXPECT_THAT(scene_faults(sample::boxes_in_box(1, true, 8, 3).mesh()), IsEmpty());
}

TEST(Scene, NamesCrossingTrianglesWithTheirCoordinates) {
  const TriangleMesh mesh =
      sample::fans_of(sample::both(sample::cube(), sample::grid_box({0.5, 0.25, 0.25}, {1.5, 0.75, 0.75})));
  const auto faults = scene_faults(mesh);
  ASSERT_FALSE(faults.empty());
  for (const SceneFault& fault : faults) {
    EXPECT_EQ(fault.kind, SceneFaultKind::crossing);
    EXPECT_THAT(fault.words, HasSubstr("triangle " + std::to_string(fault.first) + " ("));
    EXPECT_THAT(fault.words, HasSubstr("triangle " + std::to_string(fault.second) + " ("));
    EXPECT_THAT(fault.words, HasSubstr("(1.5, 0."));
  }
}

TEST(Scene, NamesBoxesThatStandOnTheFloor) {
  const TriangleMesh mesh = sample::fans_of(
      sample::both(sample::turned(sample::cube()), sample::grid_box({0.25, 0.25, 0}, {0.75, 0.75, 0.5})));
  const auto faults = scene_faults(mesh);
  const auto is = [](SceneFaultKind kind) {
    return [kind](const SceneFault& fault) { return fault.kind == kind; };
  };
  EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), is(SceneFaultKind::crossing)));
  EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), is(SceneFaultKind::overlapping)));
  EXPECT_TRUE(std::is_sorted(faults.begin(), faults.end(),
                             [](const auto& a, const auto& b) { return a.kind < b.kind; }));
}

TEST(Scene, NamesBodiesWithoutThickness) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const auto faults = scene_faults(mesh);
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].kind, SceneFaultKind::doubled);
}

TEST(Scene, NamesDegenerateTrianglesAndWhatIsNotFinite) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 3}, {0, 1, 2}};
  auto faults = scene_faults(mesh);
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].kind, SceneFaultKind::degenerate);
  EXPECT_EQ(faults[0].first, 1U);
  EXPECT_THROW(Scene{mesh}, ContractViolation);
  mesh.vertices[3].x = std::numeric_limits<double>::quiet_NaN();
  faults = scene_faults(mesh);
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].kind, SceneFaultKind::not_finite);
  EXPECT_THROW(Scene{mesh}, ContractViolation);
}

TEST(Scene, KnowsPlanesWhicheverWayTheyLook) {
  const Scene scene(
      sample::fans_of(sample::both(sample::cube(), sample::turned(sample::grid_box({2, 0, 0}, {3, 1, 1})))));
  for (std::size_t i = 0; i < scene.triangle_count(); ++i)
    for (std::size_t j = 0; j < scene.triangle_count(); ++j) {
      const auto axis = [&](std::size_t k) -> std::pair<int, double> {
        const auto [a, b, c] = scene.corners(k);
        if (a.x == b.x && a.x == c.x) return {0, a.x};
        return a.y == b.y && a.y == c.y ? std::pair{1, a.y} : std::pair{2, a.z};
      };
      EXPECT_EQ(scene.plane(i) == scene.plane(j), axis(i) == axis(j));
    }
}

TEST(Scene, JoinsVerticesOfEqualCoordinates) {
  const Scene scene = sample::occluded_squares();
  TriangleMesh apart;
  for (std::size_t k = 0; k < scene.triangle_count(); ++k) {
    for (const Vector<double>& v : scene.corners(k)) apart.vertices.push_back(v);
    apart.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Scene joined(apart);
  for (std::size_t i = 0; i < apart.vertices.size(); ++i)
    for (std::size_t j = 0; j < apart.vertices.size(); ++j)
      EXPECT_EQ(joined.vertices(i / 3)[i % 3] == joined.vertices(j / 3)[j % 3],
                apart.vertices[i] == apart.vertices[j]);
}

TEST(BoxTree, ShowsWhatTouchesABox) {
  const Scene scene = sample::boxes_in_box(7, true, 10, 4);
  sample::Numbers random(51);
  for (int k = 0; k < 50; ++k) {
    const BoundingBox query = box_about(std::array<Vector<double>, 2>{
        Vector<double>{random.on_grid(32), random.on_grid(32), random.on_grid(32)},
        {random.on_grid(32), random.on_grid(32), random.on_grid(32)}});
    const auto touches = [&](const BoundingBox& box) {
      return box.low.x <= query.high.x && query.low.x <= box.high.x && box.low.y <= query.high.y &&
             query.low.y <= box.high.y && box.low.z <= query.high.z && query.low.z <= box.high.z;
    };
    std::vector<std::size_t> found;
    EXPECT_TRUE(scene.tree().visit(touches, [&](std::size_t triangle) {
      found.push_back(triangle);
      return true;
    }));
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> expected;
    for (std::size_t t = 0; t < scene.triangle_count(); ++t)
      if (touches(box_about(scene.corners(t)))) expected.push_back(t);
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace radcert
