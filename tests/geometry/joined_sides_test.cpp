// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/joined_sides.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/orientation.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// Twice the area, as a vector, exactly.
Vector<Rational> area_vector(const TriangleMesh& mesh, std::size_t face) {
  Vector<Rational> sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.face[t] != face) continue;
    const auto c = mesh.corners(t);
    sum = sum + cross(exactly(c[1]) - exactly(c[0]), exactly(c[2]) - exactly(c[0]));
  }
  return sum;
}

/// Two triangles of a plane, the second against a part of the first's long side.
TriangleMesh part_of_a_side() {
  return {.vertices = {{0, 0, 0}, {4, 0, 4}, {0, 4, 0}, {1, 0, 1}, {3, 0, 3}, {2, -1, 2}},
          .triangles = {{0, 1, 2}, {4, 3, 5}},
          .group = {0, 1},
          .group_names = {"a", "b"},
          .face = {0, 1}};
}

TEST(JoinedSides, CutATriangleAtTheCornersOnItsSide) {
  const TriangleMesh before = part_of_a_side();
  const JoinedSides joined = joined_sides(before);
  EXPECT_EQ(joined.cut, 1U);
  ASSERT_EQ(joined.mesh.triangles.size(), 4U);
  EXPECT_EQ(joined.mesh.triangles[1], before.triangles[1]);
  EXPECT_TRUE(mesh_defects(joined.mesh).crossing.empty());
  EXPECT_EQ(joined.mesh.group, (std::vector<std::size_t>{0, 1, 0, 0}));
  for (const std::size_t face : {0U, 1U})
    EXPECT_EQ(area_vector(joined.mesh, face), area_vector(before, face));
  // 0, 3, 4, 1 and 2, and what stands on 3, 4: the outline has 6 sides, and 4 triangles meet in 3 edges.
  EXPECT_EQ(mesh_topology(joined.mesh).open_edges.size(), 6U);
}

TEST(JoinedSides, LeaveWhatMeetsInCornersAndSidesAsItIs) {
  const TriangleMesh cube = sample::mesh_of(sample::cube());
  const JoinedSides joined = joined_sides(cube);
  EXPECT_EQ(joined.cut, 0U);
  EXPECT_EQ(joined.mesh.triangles, cube.triangles);
  // A corner inside of a triangle is on no side of it, nor is one that rounding leaves beside it.
  TriangleMesh inside = part_of_a_side();
  inside.vertices[3] = {1, 0.5, 1};
  inside.vertices[4] = {3, 0x1p-52, 3};
  EXPECT_EQ(joined_sides(inside).cut, 0U);
}

TEST(JoinedSides, AreExactForTrianglesThatAreCutOnAllSides) {
  std::mt19937_64 random(7);
  const auto number = [&] { return static_cast<double>(random() % 64) - 32; };
  for (int trial = 0; trial < 200; ++trial) {
    TriangleMesh mesh{.vertices = {{number(), number(), number()},
                                   {number(), number(), number()},
                                   {number(), number(), number()}},
                      .triangles = {{0, 1, 2}},
                      .group = {0},
                      .group_names = {""},
                      .face = {0}};
    if (collinear(mesh.vertices[0], mesh.vertices[1], mesh.vertices[2])) continue;
    // Triangles that stand on the points of the sides at multiples of 1/8, in random order.
    std::size_t on_sides = 0;
    for (int more = 0; more < 5; ++more) {
      const std::size_t side = random() % 3;
      const auto part = 0.125 * static_cast<double>(1 + random() % 7);
      const Vector<double> at =
          mesh.vertices[side] + part * (mesh.vertices[(side + 1) % 3] - mesh.vertices[side]);
      bool is_new = true;
      for (const Vector<double>& v : mesh.vertices) is_new = is_new && v != at;
      on_sides += is_new ? 1 : 0;
      const std::size_t first = mesh.vertices.size();
      mesh.vertices.insert(mesh.vertices.end(), {at, {100, 0, number() + more}, {101, number(), 50}});
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.group.push_back(0);
      mesh.face.push_back(static_cast<std::size_t>(1 + more));
    }
    const JoinedSides joined = joined_sides(mesh);
    std::size_t parts = 0;
    for (const std::size_t face : joined.mesh.face) parts += face == 0 ? 1 : 0;
    EXPECT_EQ(parts, 1 + on_sides) << trial;
    EXPECT_EQ(area_vector(joined.mesh, 0), area_vector(mesh, 0)) << trial;
    EXPECT_EQ(joined_sides(joined.mesh).cut, 0U) << trial;
  }
}

}  // namespace
}  // namespace radcert
