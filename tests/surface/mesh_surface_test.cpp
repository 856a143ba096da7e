// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/mesh_surface.h"

#include <gtest/gtest.h>

#include <numeric>

#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/smooth_components.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

struct Sample {
  TriangleMesh mesh;
  Surface surface;
};

Sample surface_of(const sample::Polyhedron& solid) {
  Sample out{.mesh = sample::mesh_of(solid), .surface = {}};
  const MeshTopology topology = mesh_topology(out.mesh);
  const SmoothComponents components = smooth_components(out.mesh, topology, 30);
  out.surface = mesh_surface("sample", out.mesh, components.of_piece, piece_names(out.mesh, components),
                             {.orientation = Orientation::against_the_cross_product,
                              .closed = topology.closed(),
                              .unoccluded = true});
  return out;
}

TEST(MeshSurface, HasAChartForEachTriangleWithItsCorners) {
  for (const sample::Polyhedron& solid : {sample::cube(), sample::sphere(2), sample::cylinder(13)}) {
    const auto [mesh, surface] = surface_of(solid);
    ASSERT_EQ(surface.chart_count(), mesh.triangles.size());
    for (std::size_t k = 0; k < surface.chart_count(); ++k) {
      const ChartFacts& facts = surface.charts[k].facts();
      EXPECT_EQ(facts.domain, ChartDomain::unit_triangle);
      const auto corners = mesh.corners(k);
      const ChartIn<double>& chart = surface.charts[k].in<double>();
      constexpr std::array<ParameterPoint<double>, 3> ends{{{0, 0}, {1, 0}, {0, 1}}};
      for (std::size_t i = 0; i < 3; ++i) {
        const Frame<double> frame = chart.frame(ends[i]);
        EXPECT_LT(norm(frame.point - corners[i]), 4e-16);
        // The plane is that of the file's own coordinates, exactly.
        EXPECT_EQ(dot(facts.plane->normal(), exactly(corners[i])), facts.plane->offset());
      }
    }
  }
}

TEST(MeshSurface, NormalsPointInwards) {
  // The divergence theorem: a closed surface has Int n = 0 and, with normals inwards, Int x . n = -3 volume.
  for (const auto& [solid, volume] : std::vector<std::pair<sample::Polyhedron, double>>{
           {sample::cube(), 1.0}, {sample::tetrahedron(), 1.0 / 6}, {sample::l_shaped_room(), 3.0}}) {
    const Surface surface = surface_of(solid).surface;
    Vector<double> total;
    double flux = 0;
    for (const Chart& chart : surface.charts) {
      const Frame<double> frame = chart.in<double>().frame({1.0 / 3, 1.0 / 3});
      total = total + 0.5 * frame.area_normal;
      flux += 0.5 * dot(frame.area_normal, frame.point);
    }
    EXPECT_LT(norm(total), 1e-14);
    EXPECT_NEAR(flux, -3 * volume, 1e-13);
  }
}

TEST(MeshSurface, KnowsHowItsPiecesJoin) {
  const Surface cube = surface_of(sample::cube()).surface;
  EXPECT_TRUE(cube.charts_join_smoothly);
  EXPECT_TRUE(cube.pieces_meet_at_angle);
  EXPECT_EQ(cube.piece_names().size(), 6U);
  EXPECT_TRUE(in_one_plane(cube.charts[0], cube.charts[1]));
  EXPECT_FALSE(in_one_plane(cube.charts[0], cube.charts[2]));
  const Surface sphere = surface_of(sample::sphere(2)).surface;
  EXPECT_FALSE(sphere.charts_join_smoothly);
  EXPECT_TRUE(sphere.pieces_meet_at_angle);
  EXPECT_EQ(sphere.piece_names().size(), 1U);
  const Surface sheet = surface_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}}).surface;
  EXPECT_FALSE(sheet.pieces_meet_at_angle);
  EXPECT_TRUE(sheet.charts_join_smoothly);
  EXPECT_FALSE(sheet.closed);
}

}  // namespace
}  // namespace radcert
