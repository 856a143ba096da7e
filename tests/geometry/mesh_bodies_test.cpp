// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/mesh_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

/// Boxes with vertices in common, each a body of its own.
struct Grid {
  TriangleMesh mesh;
  std::vector<std::size_t> box;  ///< of each triangle

  void add(const Vector<double>& from, const Vector<double>& to, bool is_room = false) {
    sample::Polyhedron cube = sample::cube();
    const std::size_t number = box.empty() ? 0 : box.back() + 1;
    for (const std::vector<std::size_t>& face : cube.faces)
      for (const std::size_t k : {1U, 2U}) {
        VertexTriple t{};
        const std::array<std::size_t, 3> corners{face[0], face[k], face[k + 1]};
        for (std::size_t i = 0; i < 3; ++i) {
          const Vector<double>& v = cube.vertices[corners[i]];
          t[i] = vertex({v.x == 0 ? from.x : to.x, v.y == 0 ? from.y : to.y, v.z == 0 ? from.z : to.z});
        }
        if (is_room) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
        box.push_back(number);
      }
  }
  std::size_t vertex(const Vector<double>& at) {
    const auto found = std::find(mesh.vertices.begin(), mesh.vertices.end(), at);
    if (found != mesh.vertices.end()) return static_cast<std::size_t>(found - mesh.vertices.begin());
    mesh.vertices.push_back(at);
    return mesh.vertices.size() - 1;
  }
};

void expect_told_apart(const Grid& grid, const MeshBodies& bodies) {
  std::map<std::size_t, std::size_t> component_of_box;
  std::map<std::size_t, std::size_t> box_of_component;
  for (std::size_t t = 0; t < grid.box.size(); ++t) {
    EXPECT_EQ(component_of_box.emplace(grid.box[t], bodies.component[t]).first->second, bodies.component[t]);
    EXPECT_EQ(box_of_component.emplace(bodies.component[t], grid.box[t]).first->second, grid.box[t]);
  }
}

TEST(MeshBodies, AreToldApartWhereTheyShareFacesAndEdges) {
  // A random order of the triangles, so that each may be the one from which angles are counted.
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    Grid grid;
    std::size_t count = 0;
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        for (int z = 0; z < 2; ++z) {
          if (random() % 3 == 0) continue;
          const Vector<double> low{1.0 + x, 1.0 + y, 1.0 + z};
          grid.add(low, low + Vector<double>{1, 1, 1});
          ++count;
        }
    grid.add({1, 1, 1}, {3, 3, 3}, true);
    if (trial % 2 == 1)  // slanted
      for (Vector<double>& v : grid.mesh.vertices) v = {2 * v.x + v.y, v.y + 3 * v.z, 5 * v.z - v.x};
    std::vector<std::size_t> order(grid.box.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Grid shuffled;
    shuffled.mesh.vertices = grid.mesh.vertices;
    for (const std::size_t t : order) {
      shuffled.mesh.triangles.push_back(grid.mesh.triangles[t]);
      shuffled.box.push_back(grid.box[t]);
    }
    for (const bool right_hand : {true, false}) {
      TriangleMesh mesh = shuffled.mesh;
      if (!right_hand)
        for (VertexTriple& t : mesh.triangles) std::swap(t[1], t[2]);
      const MeshBodies bodies = mesh_bodies(mesh, right_hand);
      ASSERT_EQ(bodies.is_body.size(), count + 1) << trial;
      expect_told_apart(shuffled, bodies);
      EXPECT_EQ(std::count(bodies.is_body.begin(), bodies.is_body.end(), true),
                static_cast<std::ptrdiff_t>(count));
      EXPECT_EQ(std::count(bodies.is_room.begin(), bodies.is_room.end(), true), 1);
    }
  }
}

TEST(MeshBodies, AreNeitherOpenSheetsNorPlates) {
  // A box whose edge a sheet ends at, three triangles there: the box is a body all the same.
  Grid grid;
  grid.add({0, 0, 0}, {1, 1, 1});
  const std::size_t box = grid.mesh.triangles.size();
  grid.mesh.triangles.push_back({grid.vertex({0, 0, 0}), grid.vertex({1, 0, 0}), grid.vertex({0.5, -2, -1})});
  MeshBodies bodies = mesh_bodies(grid.mesh, true);
  EXPECT_TRUE(bodies.is_body[bodies.component[0]]);
  EXPECT_FALSE(bodies.is_body[bodies.component[box]]);
  EXPECT_FALSE(bodies.is_room[bodies.component[box]]);
  // A box without a side is none, nor are two sides of a plate.
  grid.mesh.triangles.pop_back();
  grid.mesh.triangles.erase(grid.mesh.triangles.begin());
  bodies = mesh_bodies(grid.mesh, true);
  EXPECT_FALSE(bodies.is_body[bodies.component[0]]);
  TriangleMesh plate;
  plate.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  plate.triangles = {{0, 1, 2}, {0, 2, 1}};
  bodies = mesh_bodies(plate, true);
  EXPECT_FALSE(bodies.is_body[0] || bodies.is_room[0]);
}

}  // namespace
}  // namespace radcert
