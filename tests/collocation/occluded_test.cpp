// SPDX-License-Identifier: GPL-3.0-or-later
// Collocation where parts of the surface hide others.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

Surface surface_of(const TriangleMesh& mesh, bool unoccluded = false) {
  const SmoothComponents components = smooth_components(mesh, mesh_topology(mesh), 30);
  return mesh_surface(
      "mesh", mesh, components.of_piece, piece_names(mesh, components),
      {.orientation = Orientation::against_the_cross_product, .closed = true, .unoccluded = unoccluded});
}

Surface surface_of(const sample::Polyhedron& polyhedron) { return surface_of(sample::mesh_of(polyhedron)); }

struct Assembled {
  Triangulation triangulation;
  std::vector<CollocationPoint<double>> nodes;
  CollocationMatrix<double> matrix;
};

Assembled assembled(const Surface& surface, int level, int degree, double inset) {
  const Triangulation triangulation = triangulate(surface, level);
  const InsetBasis<double> basis(degree, inset);
  const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
  return {triangulation, nodes,
          assemble<double>(surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), 1.0))};
}

double row_sum(const Matrix<double>& a, std::size_t i) {
  double sum = 0;
  for (std::size_t j = 0; j < a.columns(); ++j) sum += a(i, j);
  return sum;
}

TEST(OccludedCollocation, MapsOneToOneInClosedRooms) {
  // Whatever hides what, a point of a closed room sees the whole of its half space: Int G V = pi.
  for (const auto& [room, level] :
       {std::pair{sample::l_shaped_room(), 1}, std::pair{sample::octahedron(-0.5), 1},
        std::pair{sample::cube_in_cube(0.5, {0.25, 0.25, 0.25}), 0},
        std::pair{sample::cube_in_cube(0.25, {0.125, 0.5, 0.0625}), 0}})
    for (int degree = 0; degree <= 2; ++degree) {
      const Assembled a = assembled(surface_of(room), level, degree, 0.125);
      for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        const std::string what = std::to_string(room.faces.size()) + " faces, degree " +
                                 std::to_string(degree) + ", row " + std::to_string(i);
        EXPECT_NEAR(row_sum(a.matrix.entries, i), 1, 1e-12) << what;
        EXPECT_LE(std::abs(row_sum(a.matrix.entries, i) - 1), a.matrix.row_radius[i] + 1e-15) << what;
        EXPECT_LT(a.matrix.row_radius[i], 1e-9) << what;
      }
    }
}

TEST(OccludedCollocation, KnowsWhatANarrowGapCosts) {
  // Corners of the shadow are rounded in the parameters of walls that are a millionth away.
  const Assembled a = assembled(surface_of(sample::cube_in_cube(0.5, {0.25, 0.25, 0x1p-20})), 0, 1, 0.125);
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_LE(std::abs(row_sum(a.matrix.entries, i) - 1), a.matrix.row_radius[i] + 1e-15) << i;
    EXPECT_LT(a.matrix.row_radius[i], 1e-8) << i;
  }
}

TEST(OccludedCollocation, HasTheEntriesOfTheUnoccludedOneWhereNothingHides) {
  const TriangleMesh mesh = sample::mesh_of(sample::cube());
  const Assembled seen = assembled(surface_of(mesh, false), 1, 2, 0.1);
  const Assembled assumed = assembled(surface_of(mesh, true), 1, 2, 0.1);
  for (std::size_t i = 0; i < seen.nodes.size(); ++i)
    for (std::size_t j = 0; j < seen.nodes.size(); ++j)
      EXPECT_EQ(seen.matrix.entries(i, j), assumed.matrix.entries(i, j)) << i << " " << j;
}

TEST(OccludedCollocation, IsIndependentOfHowWallsAreCut) {
  // Degree 0 at the centroid of the L's triangles: the sum over the elements of one wall is that of the
  // coarse wall.
  const Surface room = surface_of(sample::l_shaped_room());
  const InsetBasis<double> basis(0, 0);
  const Triangulation coarse = triangulate(room, 0);
  const auto nodes = collocation_nodes<double>(room, coarse, basis);
  const auto whole = assemble<double>(room, coarse, basis, nodes, std::vector<double>(nodes.size(), 1.0));
  const Triangulation fine = triangulate(room, 2);
  std::vector<CollocationPoint<double>> padded;
  for (std::size_t i = 0; i < fine.triangles.size(); ++i) padded.push_back(nodes[i % nodes.size()]);
  const auto cut = assemble<double>(room, fine, basis, padded, std::vector<double>(padded.size(), 1.0));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t chart = 0; chart < room.chart_count(); ++chart) {
      double sum = 0;
      for (std::size_t k = 0; k < fine.triangles.size(); ++k)
        if (fine.triangles[k].chart == chart) sum += cut.entries(i, k);
      EXPECT_NEAR(sum, whole.entries(i, chart), 1e-13) << i << " " << chart;
    }
}

TEST(OccludedCollocation, HasTheSameBitsForEveryNumberOfThreads) {
  const Surface room = surface_of(sample::cube_in_cube(0.5, {0.25, 0.25, 0.125}));
  const auto by = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return assembled(room, 0, 1, 0.125);
  };
  const Assembled one = by(1);
  const Assembled three = by(3);
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    for (std::size_t j = 0; j < one.nodes.size(); ++j)
      EXPECT_EQ(one.matrix.entries(i, j), three.matrix.entries(i, j));
    EXPECT_EQ(one.matrix.row_radius[i], three.matrix.row_radius[i]);
  }
}

TEST(OccludedCollocation, NeedsAMesh) {
  Surface room = surface_of(sample::l_shaped_room());
  room.mesh = nullptr;
  EXPECT_THROW(static_cast<void>(assembled(room, 0, 0, 0)), ContractViolation);
}

}  // namespace
}  // namespace radcert
