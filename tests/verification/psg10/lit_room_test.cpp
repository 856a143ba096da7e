// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/scenes/lit_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/visibility/scene.h"

namespace radcert::verification::psg10 {
namespace {

TEST(LitRoom, IsAClosedMeshWithoutFaults) {
  const LitRoom room = lit_room();
  const Surface& surface = room.scene.surface();
  ASSERT_TRUE(surface.mesh);
  EXPECT_THAT(scene_faults(*surface.mesh), testing::IsEmpty());
  // Every side belongs to two triangles, which run along it in opposite directions.
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const VertexTriple& t : surface.mesh->triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);
  }
  for (const Vector<double>& v : surface.mesh->vertices)
    for (const double x : {v.x, v.y, v.z}) EXPECT_EQ(x, std::round(16 * x) / 16);
  EXPECT_THAT(surface.piece_names(),
              testing::UnorderedElementsAre("floor", "ceiling", "back", "front", "left", "right", "tall",
                                            "low", "column", "shade"));
}

TEST(LitRoom, HasTheVolumeAndTheAreaOfItsParts) {
  const LitRoom room = lit_room();
  const Surface& surface = room.scene.surface();
  double volume = 0;
  double area = 0;
  for (std::size_t k = 0; k < surface.chart_count(); ++k) {
    const auto [a, b, c] = surface.mesh->corners(k);
    const LitPoint at = lit_point(surface, {.chart = k, .at = {0.25, 0.25}});
    const Vector<double> twice = cross(b - a, c - a);
    // Light is inside: the inner normal, against the one that the divergence theorem takes.
    volume -= dot(a, at.site.normal) * norm(twice) / 6;
    area += norm(twice) / 2;
  }
  const auto square = [](double u, double v) { return 4 * (u * u + v * v) / 256; };
  const double octagon = (10.0 * 10 - 2 * 3 * 3) / 256;
  const double bodies = square(9, 3) * 29 / 16 + square(8, 3) * 13 / 16 + octagon * 3 + 1.0 * 1 / 16;
  EXPECT_NEAR(volume, 4 * 4 * 3 - bodies, 1e-12);
  // The floor lacks what the lids have; sides by their lengths.
  const double sides =
      8 * std::sqrt(90) / 16 * 29 / 16 + 8 * std::sqrt(73) / 16 * 13 / 16 + (16 + 12 * std::sqrt(2)) / 16 * 3;
  EXPECT_NEAR(area, 2 * 16 + 4 * 12 - 2 * octagon + sides + 2 + 4.0 / 16, 1e-12);
}

TEST(LitRoom, IsLitByItsLampBelowTheShade) {
  const LitRoom room = lit_room();
  const Surface& surface = room.scene.surface();
  std::map<std::string, double> most;
  for (std::size_t k = 0; k < surface.chart_count(); ++k)
    for (const auto& at : {ParameterPoint<double>{0.3, 0.3}, {0.1, 0.8}, {0.8, 0.1}, {0.1, 0.1}}) {
      double& here = most[surface.charts[k].facts().piece];
      here =
          std::max(here, direct_radiance(room.scene, room.lamp, lit_point(surface, {.chart = k, .at = at})));
    }
  for (const char* piece : {"floor", "back", "left", "right", "tall", "low", "column", "shade"})
    EXPECT_GT(most[piece], 0.02) << piece;
  // Above the middle of the shade it is dark.
  const LitPoint above{.site = {.point = {2, 1.75, 3}, .normal = {0, 0, -1}}, .chart = [&] {
                         std::size_t k = 0;
                         while (surface.charts[k].facts().piece != "ceiling") ++k;
                         return k;
                       }()};
  EXPECT_EQ(direct_radiance(room.scene, room.lamp, above), 0);
}

}  // namespace
}  // namespace radcert::verification::psg10
