// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_topology.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_quality.h"
#include "radcert/geometry/mesh_repair.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/geometry/smooth_components.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

SmoothComponents components_of(const TriangleMesh& mesh, double degrees = 30) {
  return smooth_components(mesh, mesh_topology(mesh), degrees);
}

TEST(MeshTopology, ClosedSolidsHaveTheCharacteristicOfTheirGenus) {
  for (const auto& [solid, characteristic] :
       std::vector<std::pair<sample::Polyhedron, int>>{{sample::cube(), 2},
                                                       {sample::octahedron(), 2},
                                                       {sample::sphere(2), 2},
                                                       {sample::l_shaped_room(), 2},
                                                       {sample::glued_grid(7, 5, false), 0}}) {
    const MeshTopology topology = mesh_topology(sample::mesh_of(solid));
    EXPECT_TRUE(topology.closed());
    EXPECT_TRUE(topology.orientable());
    EXPECT_EQ(topology.characteristic, characteristic);
    EXPECT_EQ(topology.component_count, 1U);
    EXPECT_THAT(topology.turned, IsEmpty());
    EXPECT_THAT(topology.pinched_vertices, IsEmpty());
  }
}

TEST(MeshTopology, KleinsBottleHasNoSides) {
  const MeshTopology topology = mesh_topology(sample::mesh_of(sample::glued_grid(7, 6, true)));
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.characteristic, 0);
  EXPECT_FALSE(topology.orientable());
}

TEST(MeshTopology, FindsTheTrianglesThatWereTurned) {
  TriangleMesh mesh = sample::mesh_of(sample::sphere(2));
  for (const std::size_t k : {3U, 40U, 41U, 100U}) std::swap(mesh.triangles[k][0], mesh.triangles[k][2]);
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_THAT(topology.turned, ElementsAre(3, 40, 41, 100));
  EXPECT_FALSE(topology.disagreeing_edges.empty());
  const MendedMesh mended = mend(mesh, {.orientation = true});
  EXPECT_TRUE(mesh_topology(mended.mesh).disagreeing_edges.empty());
  EXPECT_EQ(mended.done.size(), 1U);
  EXPECT_EQ(volume_sign(mended.mesh), 1);
}

TEST(MeshTopology, FindsOpenEdgesLineByLine) {
  sample::Polyhedron solid = sample::cube();
  solid.faces.erase(solid.faces.begin());  // the floor, and then the ceiling
  EXPECT_EQ(mesh_topology(sample::mesh_of(solid)).open_loops.size(), 1U);
  solid.faces.erase(solid.faces.begin());
  const MeshTopology topology = mesh_topology(sample::mesh_of(solid));
  ASSERT_EQ(topology.open_loops.size(), 2U);
  EXPECT_EQ(topology.open_edges.size(), 8U);
  EXPECT_THAT(topology.open_loops[0], UnorderedElementsAre(0, 1, 2, 3));
  EXPECT_THAT(topology.open_loops[1], UnorderedElementsAre(4, 5, 6, 7));
  EXPECT_EQ(topology.characteristic, 0);
}

TEST(MeshTopology, FindsWhereSheetsMeet) {
  // Three triangles on an edge; two tetrahedra that touch in a point.
  const sample::Polyhedron book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                                {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  EXPECT_EQ(mesh_topology(sample::mesh_of(book)).crowded_edges.size(), 1U);
  sample::Polyhedron touching = sample::tetrahedron();
  for (const Vector<double>& v : std::vector<Vector<double>>{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}})
    touching.vertices.push_back(v);
  touching.faces.insert(touching.faces.end(), {{0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}});
  const TriangleMesh mesh = sample::mesh_of(touching);
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_THAT(topology.pinched_vertices, ElementsAre(0));
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.component_count, 2U);
  const MendedMesh parted = mend(mesh, {.manifold = true});
  EXPECT_THAT(mesh_topology(parted.mesh).pinched_vertices, IsEmpty());
  EXPECT_EQ(parted.mesh.vertices.size(), mesh.vertices.size() + 1);
  EXPECT_THAT(mesh_topology(mend(sample::mesh_of(book), {.manifold = true}).mesh).crowded_edges, IsEmpty());
}

TEST(VolumeSign, IsExactWhereTheVolumeIsLostInRounding) {
  // A tetrahedron of height 2^-30 far from the origin: its volume is far below the rounding of the sum's
  // terms.
  std::mt19937_64 stream(11);
  const auto away = [&] { return 0x1p20 + std::ldexp(static_cast<double>(stream() >> 12U), -32); };
  for (int k = 0; k < 100; ++k) {
    const double height = k % 2 == 0 ? 0x1p-30 : -0x1p-30;
    const Vector<double> far{away(), away(), away()};
    const sample::Polyhedron solid{{far, far + Vector<double>{1, 0, 0}, far + Vector<double>{0, 1, 0},
                                    far + Vector<double>{0, 0, height}},
                                   sample::tetrahedron().faces};
    EXPECT_EQ(volume_sign(sample::mesh_of(solid)), height > 0 ? 1 : -1) << k;
  }
  sample::Polyhedron flat = sample::tetrahedron();
  flat.vertices[3] = {1, 1, 0};
  EXPECT_EQ(volume_sign(sample::mesh_of(flat)), 0);
}

TEST(MeshDefects, CountsNothingOnSolids) {
  for (const sample::Polyhedron& solid : {sample::cube(), sample::sphere(2), sample::l_shaped_room(),
                                          sample::cylinder(17), sample::octahedron(-0.5)}) {
    const MeshDefects defects = mesh_defects(sample::mesh_of(solid));
    EXPECT_THAT(defects.duplicate_vertices, IsEmpty());
    EXPECT_THAT(defects.unreferenced_vertices, IsEmpty());
    EXPECT_THAT(defects.degenerate_triangles, IsEmpty());
    EXPECT_THAT(defects.crossing, IsEmpty());
  }
}

TEST(MeshDefects, FindsEachAndMendsItWhenAsked) {
  TriangleMesh mesh = sample::mesh_of(sample::octahedron());
  const std::size_t triangles = mesh.triangles.size();
  mesh.vertices.push_back(mesh.vertices[2]);  // a duplicate, used below
  mesh.vertices.push_back({7, 7, 7});         // used by nobody
  mesh.triangles[1] = {1, 6, 4};              // instead of 1, 2, 4
  mesh.triangles.push_back({0, 2, 6});        // on one line
  mesh.triangles.push_back({5, 1, 0});        // once more
  for (int i = 0; i < 2; ++i) {
    mesh.group.push_back(0);
    mesh.face.push_back(8);
  }
  const MeshDefects defects = mesh_defects(mesh);
  EXPECT_THAT(defects.duplicate_vertices, ElementsAre(std::pair(6U, 2U)));
  EXPECT_THAT(defects.unreferenced_vertices, ElementsAre(7));
  EXPECT_THAT(defects.degenerate_triangles, ElementsAre(triangles));
  EXPECT_THAT(defects.crossing, ElementsAre(std::pair<std::size_t, std::size_t>(4, triangles + 1)));
  EXPECT_TRUE(mend(mesh, {}).done.empty());
  EXPECT_EQ(mend(mesh, {}).mesh.triangles, mesh.triangles);
  const MendedMesh mended = mend(mesh, {.vertices = true, .faces = true});
  EXPECT_EQ(mended.done.size(), 4U);
  EXPECT_EQ(mended.mesh.vertices.size(), 6U);
  EXPECT_EQ(mended.mesh.triangles.size(), triangles);
  EXPECT_TRUE(mesh_topology(mended.mesh).closed());
}

TEST(MeshDefects, FindsTrianglesThatCross) {
  const auto crossings = [](const sample::Polyhedron& p) {
    return crossing_triangles(sample::mesh_of(p), 10).size();
  };
  // Apart; through each other; in a common plane, overlapping; on a common side, folded onto each other;
  // through a shared vertex.
  EXPECT_EQ(
      crossings({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {3, 4, 5}}}),
      0U);
  EXPECT_EQ(crossings({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 0}},
                       {{0, 1, 2}, {3, 4, 5}}}),
            1U);
  EXPECT_EQ(
      crossings({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {9, 1, 0}, {1, 9, 0}}, {{0, 1, 2}, {3, 4, 5}}}),
      1U);
  EXPECT_EQ(crossings({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}}), 1U);
  EXPECT_EQ(crossings({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}}, {{0, 1, 2}, {0, 3, 4}}}),
            1U);
  EXPECT_EQ(crossings({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2}, {0, 3, 4}}}),
            0U);
}

TEST(MeshRepair, ClosesHoles) {
  sample::Polyhedron solid = sample::cube();
  solid.faces.erase(solid.faces.begin() + 1,
                    solid.faces.begin() + 3);  // two sides that meet: one hole of six edges
  const MendedMesh mended = mend(sample::mesh_of(solid), {.holes = true});
  const MeshTopology topology = mesh_topology(mended.mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_TRUE(topology.disagreeing_edges.empty());
  EXPECT_EQ(topology.characteristic, 2);
  EXPECT_EQ(mended.mesh.group_names.back(), "closed_hole");
}

TEST(MeshRepair, LeavesOutWhatCrossesAndClosesWhatThatOpens) {
  // A vertex of the sphere pulled through its other side.
  sample::Polyhedron solid = sample::sphere(2);
  solid.vertices[4] = {0.1, 0.2, -1.5};
  const TriangleMesh mesh = sample::mesh_of(solid);
  ASSERT_FALSE(mesh_defects(mesh).crossing.empty());
  const MendedMesh parted = mend(mesh, {.crossings = true});
  EXPECT_TRUE(mesh_defects(parted.mesh).crossing.empty());
  EXPECT_EQ(mesh_topology(parted.mesh).open_loops.size(), 2U);
  ASSERT_EQ(parted.done.size(), 1U);
  const MendedMesh closed = mend(mesh, {.crossings = true, .holes = true});
  EXPECT_TRUE(mesh_defects(closed.mesh).crossing.empty());
  EXPECT_TRUE(mesh_topology(closed.mesh).closed());
  EXPECT_TRUE(mesh_topology(closed.mesh).disagreeing_edges.empty());
  EXPECT_EQ(mesh_topology(closed.mesh).characteristic, 2);
  EXPECT_EQ(closed.done.size(), 2U);
  EXPECT_TRUE(mend(sample::mesh_of(sample::cube()), {.crossings = true}).done.empty());
}

TEST(SmoothComponents, AreThoseOfTheSolid) {
  struct Case {
    sample::Polyhedron solid;
    std::size_t components;
    std::size_t lines;
    std::size_t closed_lines;
    std::size_t corners;
  };
  for (const Case& c : std::vector<Case>{{sample::cylinder(48), 3, 2, 2, 0},
                                         {sample::cube(), 6, 12, 0, 8},
                                         {sample::l_shaped_room(), 8, 18, 0, 12},
                                         {sample::sphere(3), 1, 0, 0, 0},
                                         {sample::tetrahedron(), 4, 6, 0, 4}}) {
    const TriangleMesh mesh = sample::mesh_of(c.solid);
    const SmoothComponents found = components_of(mesh);
    EXPECT_EQ(found.count, c.components);
    EXPECT_EQ(found.lines.size(), c.lines);
    EXPECT_EQ(
        std::count_if(found.lines.begin(), found.lines.end(), [](const SharpLine& l) { return l.closed; }),
        static_cast<std::ptrdiff_t>(c.closed_lines));
    EXPECT_EQ(found.corners.size(), c.corners);
    EXPECT_EQ(found.piece_count, c.components);
  }
}

TEST(SmoothComponents, CompareAnglesExactly) {
  // The sides of this column turn by exactly 90 degrees, those of the octagon by 45.
  const TriangleMesh cube = sample::mesh_of(sample::cube());
  EXPECT_EQ(components_of(cube, 90).count, 1U);
  EXPECT_EQ(components_of(cube, 89.999999999).count, 6U);
  const TriangleMesh prism =
      sample::mesh_of(sample::column({{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}, 1));
  EXPECT_EQ(components_of(prism, 44.999999).count, 10U);
  EXPECT_EQ(components_of(prism, 45.000001).count, 3U);
  EXPECT_EQ(components_of(sample::mesh_of(sample::sphere(2)), 0).count, 128U);
  EXPECT_EQ(components_of(cube, 180).count, 1U);
}

/// Two triangles on a common edge from the origin.
std::size_t components_of_wedge(const Vector<double>& edge, const Vector<double>& p, const Vector<double>& q,
                                double degrees) {
  const TriangleMesh mesh = sample::mesh_of({{{0, 0, 0}, edge, p, q}, {{0, 1, 2}, {1, 0, 3}}});
  return components_of(mesh, degrees).count;
}

TEST(SmoothComponents, CompareAnglesExactlyWhereDoublesDoNot) {
  // Rows of the orthogonal matrix of a quaternion with whole components, times odd numbers near 2^24: right
  // angles whose cosine in doubles is a rounding.
  std::mt19937_64 stream(5);
  const auto whole = [&] { return static_cast<double>(stream() % 199) - 99; };
  const auto odd = [&] { return static_cast<double>(0x1000001 + 2 * (stream() % 1000)); };
  for (int k = 0; k < 200; ++k) {
    const double a = 1 + static_cast<double>(stream() % 99);
    const double b = whole();
    const double c = whole();
    const double d = whole();
    const Vector<double> x =
        odd() * Vector<double>{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)};
    const Vector<double> y =
        odd() * Vector<double>{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)};
    const Vector<double> z =
        odd() * Vector<double>{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d};
    EXPECT_EQ(components_of_wedge(x, y, z, 90), 1U) << a << " " << b << " " << c << " " << d;
  }
  // 120 degrees exactly, and the doubles beside it.
  const Vector<double> edge{1, 1, 1};
  EXPECT_EQ(components_of_wedge(edge, {0, 0, 1}, {-1, 0, 0}, 119.99999999999999), 2U);
  EXPECT_EQ(components_of_wedge(edge, {0, 0, 1}, {-1, 0, 0}, 120.00000000000003), 1U);
}

TEST(SmoothComponents, AnOpenSquareHasItsFourSidesAndCorners) {
  const TriangleMesh mesh = sample::mesh_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}});
  const SmoothComponents found = components_of(mesh);
  EXPECT_EQ(found.count, 1U);
  EXPECT_EQ(found.lines.size(), 4U);
  EXPECT_EQ(found.corners.size(), 4U);
  for (const SharpLine& line : found.lines) EXPECT_TRUE(line.open_border);
}

TEST(PieceNames, TakeThoseOfTheGroups) {
  TriangleMesh mesh = sample::mesh_of(sample::cube());
  EXPECT_THAT(piece_names(mesh, components_of(mesh)),
              ElementsAre("piece_1", "piece_2", "piece_3", "piece_4", "piece_5", "piece_6"));
  mesh.group_names = {"floor", "wall", "*"};
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) mesh.group[k] = k < 2 ? 0 : k == 3 ? 2 : 1;
  // The ceiling is one smooth component of two groups.
  const SmoothComponents found = components_of(mesh);
  EXPECT_EQ(found.count, 6U);
  EXPECT_EQ(found.piece_count, 7U);
  EXPECT_THAT(piece_names(mesh, found),
              ElementsAre("floor", "wall_1", "*_", "wall_2", "wall_3", "wall_4", "wall_5"));
}

TEST(PlaneClasses, AreThePlanesAndTheirSides) {
  EXPECT_EQ(plane_classes(sample::mesh_of(sample::cube())).count(), 6U);
  EXPECT_EQ(plane_classes(sample::mesh_of(sample::l_shaped_room())).count(), 8U);
  const TriangleMesh sphere = sample::mesh_of(sample::sphere(2));
  EXPECT_EQ(plane_classes(sphere).count(), sphere.triangles.size());
  // One plane, two sides; and a parallel plane; and one that differs by one bit.
  const TriangleMesh mesh = sample::mesh_of({{{0, 0, 0},
                                              {1, 0, 0},
                                              {0, 1, 0},
                                              {0, 0, 1},
                                              {3, 0, 1},
                                              {0, 7, 1},
                                              {0.1, 0.3, 0},
                                              {9, 2, 0},
                                              {4, 5, 0},
                                              {4, 5, 1e-300}},
                                             {{0, 1, 2}, {2, 1, 0}, {3, 4, 5}, {6, 7, 8}, {6, 7, 9}}});
  EXPECT_THAT(plane_classes(mesh).of_triangle, ElementsAre(0, 1, 2, 0, 3));
}

TEST(PlaneClasses, AgreeWithExactOrientationsOnRandomTriangles) {
  std::mt19937_64 stream(7);
  TriangleMesh mesh;
  const auto small = [&] { return static_cast<double>(stream() % 3) / 7; };
  for (int k = 0; k < 120; ++k) {
    const std::size_t n = mesh.vertices.size();
    for (int i = 0; i < 3; ++i) mesh.vertices.push_back({small(), small(), small()});
    if (collinear(mesh.vertices[n], mesh.vertices[n + 1], mesh.vertices[n + 2])) {
      mesh.vertices.resize(n);
      continue;
    }
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  const PlaneClasses classes = plane_classes(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto [a, b, c] = mesh.corners(i);
      const auto other = mesh.corners(j);
      const bool coplanar = std::all_of(
          other.begin(), other.end(),
          [&, p = a, q = b, r = c](const Vector<double>& v) { return orientation(p, q, r, v) == 0; });
      const bool same_way = dot(cross(b - a, c - a), cross(other[1] - other[0], other[2] - other[0])) > 0;
      EXPECT_EQ(classes.of_triangle[i] == classes.of_triangle[j], coplanar && same_way) << i << " " << j;
    }
}

TEST(MeshQuality, IsThatOfKnownTriangles) {
  const MeshQuality equal = mesh_quality(sample::mesh_of(sample::octahedron()));
  EXPECT_NEAR(equal.smallest_angle, 60, 1e-12);
  EXPECT_NEAR(equal.largest_angle, 60, 1e-12);
  EXPECT_NEAR(equal.largest_aspect, 1, 1e-14);
  EXPECT_NEAR(equal.area, 4 * std::sqrt(3.0), 1e-14);
  EXPECT_DOUBLE_EQ(equal.diagonal, std::sqrt(12.0));
  const MeshQuality half_squares = mesh_quality(sample::mesh_of(sample::cube()));
  EXPECT_NEAR(half_squares.smallest_angle, 45, 1e-12);
  EXPECT_NEAR(half_squares.largest_angle, 90, 1e-12);
  EXPECT_DOUBLE_EQ(half_squares.longest_side, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(half_squares.shortest_side, 1);
}

}  // namespace
}  // namespace radcert
