// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/facet_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "radcert/core/contract.h"
#include "radcert/factors/factor_matrix.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

TEST(FacetScene, JoinsTrianglesToConvexOccludersAndLeavesOutTheHull) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  ASSERT_EQ(scene.occluders().size(), 6U);
  std::set<std::size_t> solids;
  for (const ConvexOccluder& occluder : scene.occluders()) {
    EXPECT_EQ(occluder.corners.size(), 4U);
    EXPECT_TRUE(scene.solid_is_body(occluder.solid));
    solids.insert(occluder.solid);
  }
  EXPECT_EQ(solids.size(), 1U);
  EXPECT_TRUE(FacetScene(sample::mesh_of(sample::box({0, 0, 0}, {1, 1, 1}, true))).occluders().empty());
  const FacetScene squares(sample::obstructed_squares());
  ASSERT_EQ(squares.occluders().size(), 1U);
  EXPECT_FALSE(squares.solid_is_body(squares.occluders().front().solid));
}

TEST(FacetScene, KeepsAnLShapeInConvexParts) {
  // A corridor with a corner: floor and ceiling are L-shaped, two walls stand in the way.
  const auto face = [](Vector<double> a, Vector<double> b, Vector<double> c, Vector<double> d) {
    return sample::Quadrangle{a, b, c, d};
  };
  const FacetScene scene(sample::mesh_of({face({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}),
                                          face({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}),
                                          face({0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}),
                                          face({1, 1, -1}, {2, 1, -1}, {2, 1, 1}, {1, 1, 1})}));
  std::size_t corners = 0;
  for (const ConvexOccluder& occluder : scene.occluders()) corners += occluder.corners.size();
  // The wall, and the floor in two rectangles.
  EXPECT_EQ(scene.occluders().size(), 3U);
  EXPECT_EQ(corners, 12U);
}

TEST(FacetScene, TakesOneSideOfAPlateWhateverItsNeighboursAre) {
  // A plate with two sides above a face that has one, in its plane: the one side of the plate goes on in the
  // face, the other does not, and what hides must not count twice.
  const auto rectangle = [](double low, double high, bool turned) {
    sample::Quadrangle out{Vector<double>{0, 0, low}, {1, 0, low}, {1, 0, high}, {0, 0, high}};
    if (turned) out = {out[0], out[3], out[2], out[1]};
    return out;
  };
  const sample::Quadrangle before{Vector<double>{0, -2, 0}, {1, -2, 0}, {1, -2, 1}, {0, -2, 1}};
  const sample::Quadrangle behind{Vector<double>{0, 2, 0}, {0, 2, 1}, {1, 2, 1}, {1, 2, 0}};
  for (const bool back_first : {false, true})
    for (const bool turned : {false, true}) {
      std::vector<sample::Quadrangle> faces{before, behind, rectangle(0, 1, turned)};
      faces.push_back(rectangle(1, 2, back_first));
      TriangleMesh mesh = sample::mesh_of(faces);
      for (std::size_t t = 6; t < 8; ++t) {  // the plate's other side, of the same triangles
        const VertexTriple front = mesh.triangles[t];
        mesh.triangles.push_back({front[0], front[2], front[1]});
        mesh.group.push_back(0);
        mesh.face.push_back(4);
      }
      const FacetScene scene(mesh);
      double area = 0;
      for (const ConvexOccluder& occluder : scene.occluders()) {
        EXPECT_EQ(occluder.plane, scene.scene().plane(4));
        area += norm(vector_area(occluder.corners));
      }
      EXPECT_EQ(area, 2);
    }
}

TEST(FacetScene, KeepsBodiesApartThatHaveFacesInOnePlane) {
  const FacetScene scene(sample::room_with_two_boxes());
  ASSERT_EQ(scene.occluders().size(), 12U);
  std::map<std::size_t, std::size_t> faces;
  for (std::size_t k = 0; k < scene.occluders().size(); ++k) {
    const ConvexOccluder& occluder = scene.occluders()[k];
    EXPECT_TRUE(scene.solid_is_body(occluder.solid));
    ++faces[occluder.solid];
    ASSERT_EQ(occluder.corners.size(), 4U);
    for (std::size_t c = 0; c < 4; ++c) {
      // Beyond each side lies another face of the same box, with that side; three meet in each corner.
      ASSERT_TRUE(occluder.beyond_side[c].has_value());
      const ConvexOccluder& other = scene.occluders()[*occluder.beyond_side[c]];
      EXPECT_EQ(other.solid, occluder.solid);
      EXPECT_NE(*occluder.beyond_side[c], k);
      for (const Vector<double>& end : {occluder.corners[c], occluder.corners[(c + 1) % 4]})
        EXPECT_EQ(std::count(other.corners.begin(), other.corners.end(), end), 1);
      ASSERT_EQ(occluder.around_corner[c].size(), 3U);
      for (const std::size_t around : occluder.around_corner[c]) {
        const FacetCorners& corners = scene.occluders()[around].corners;
        EXPECT_EQ(std::count(corners.begin(), corners.end(), occluder.corners[c]), 1);
      }
    }
  }
  EXPECT_EQ(faces.size(), 2U);
  for (const auto& [solid, count] : faces) EXPECT_EQ(count, 6U) << solid;
}

TEST(FacetScene, SightOfPairsIsSymmetricAndRight) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  std::size_t whole = 0;
  for (std::size_t i = 0; i < scene.facet_count(); ++i)
    for (std::size_t j = 0; j < scene.facet_count(); ++j) {
      const FacetPair pair = scene.pair(i, j);
      const FacetPair back = scene.pair(j, i);
      EXPECT_EQ(pair.sight, back.sight) << i << " " << j;
      EXPECT_EQ(pair.occluders, back.occluders) << i << " " << j;
      if (i >= 12 && j >= 12) {
        EXPECT_EQ(pair.sight, PairSight::nothing) << i << " " << j;
      }
      // Nothing stands between the inner cube and what is in front of its faces.
      if ((i < 12) != (j < 12)) {
        EXPECT_NE(pair.sight, PairSight::mixed) << i << " " << j;
      }
      whole += pair.sight == PairSight::whole ? 1 : 0;
    }
  EXPECT_GT(whole, 0U);
}

TEST(FacetScene, SeesThatALargeOccluderHidesAll) {
  const FacetScene scene(sample::mesh_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                          {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}},
                                          {{{-1, -1, 0.5}, {2, -1, 0.5}, {2, 2, 0.5}, {-1, 2, 0.5}}}}));
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {2U, 3U}) EXPECT_EQ(scene.pair(i, j).sight, PairSight::hidden);
}

sample::Quadrangle quadrangle(Vector<double> a, Vector<double> b, Vector<double> c, Vector<double> d) {
  return {a, b, c, d};
}

// A cube, a triangle within and one outside that look at each other; the inner one apart, with a corner, a
// side or all corners on the cube's own.
TEST(FacetScene, HidesWhatABodyContainsFromWhatIsOutside) {
  const std::vector<sample::Quadrangle> cube = sample::box({0, 0, 0}, {4, 4, 4}, false);
  const std::vector<std::array<Vector<double>, 3>> inner{{{{2, 1, 1}, {2, 3, 1}, {2, 2, 3}}},
                                                         {{{4, 4, 0}, {2, 3, 1}, {2, 2, 3}}},
                                                         {{{4, 4, 0}, {2, 3, 3}, {4, 4, 4}}},
                                                         {{{0, 0, 0}, {4, 4, 4}, {3, 1, 2}}}};
  for (const bool reversed : {false, true})
    for (const auto& corners : inner) {
      TriangleMesh mesh = sample::mesh_of(cube);
      if (reversed)
        for (VertexTriple& t : mesh.triangles) std::swap(t[1], t[2]);
      const auto add = [&](const std::array<Vector<double>, 3>& c) {
        const std::size_t n = mesh.vertices.size();
        mesh.vertices.insert(mesh.vertices.end(), c.begin(), c.end());
        mesh.triangles.push_back({n, n + 1, n + 2});
        mesh.group.push_back(0);
        mesh.face.push_back(mesh.face.size());
      };
      add(corners);
      add({{{9, 1, 1}, {9, 1, 3}, {9, 3, 1}}});
      add({{{9, 8, 1}, {9, 1, 4}, {9, 9, 9}}});
      ASSERT_TRUE(scene_faults(mesh).empty());
      const FacetScene scene(mesh);
      for (const std::size_t outside : {13U, 14U}) {
        for (const bool certified : {false, true}) {
          if (certified && reversed && outside == 14U) continue;  // as the other, and slow
          const PairExchange found =
              pair_exchange(scene, 12, outside, {.certified = certified, .accuracy = 1e-2});
          EXPECT_LE(found.area.value, found.area.radius);
          // A cube with a triangle along its side is no body for us, but a wall of six plates.
          if (!reversed &&
              !(corners[0] == Vector<double>{4, 4, 0} && corners[2] == Vector<double>{4, 4, 4})) {
            EXPECT_EQ(found.area.value, 0);
            EXPECT_EQ(found.area.radius, 0);
          }
        }
      }
      EXPECT_EQ(scene.pair(13, 14).sight, PairSight::nothing);
    }
}

TEST(FacetScene, LetsWhatABodyContainsSeeItself) {
  // Two triangles within a cube, and a plate between them: the cube's faces are no occluders of theirs.
  for (const bool plate : {false, true}) {
    std::vector<sample::Quadrangle> faces = sample::box({-4, -4, -4}, {4, 4, 4}, false);
    faces.push_back(quadrangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}));
    faces.push_back(quadrangle({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}));
    if (plate) faces.push_back(quadrangle({-2, -2, 0.5}, {2, -2, 0.5}, {2, 2, 0.5}, {-2, 2, 0.5}));
    // And something outside, so that the cube has occluders.
    faces.push_back(quadrangle({9, -9, -9}, {9, 9, -9}, {9, 9, 9}, {9, -9, 9}));
    faces.push_back(quadrangle({-9, -9, -9}, {-9, 9, -9}, {-9, 9, 9}, {-9, -9, 9}));
    const FacetScene scene(sample::mesh_of(faces));
    EXPECT_EQ(scene.bodies_of(12).size(), 1U);
    EXPECT_EQ(scene.pair(12, 14).sight, plate ? PairSight::hidden : PairSight::whole);
  }
}

TEST(FacetScene, KnowsBodiesInBodies) {
  std::vector<sample::Quadrangle> faces = sample::box({-4, -4, -4}, {4, 4, 4}, false);
  for (const auto& face : sample::box({-1, -1, -1}, {1, 1, 1}, false)) faces.push_back(face);
  faces.push_back(quadrangle({-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}));
  faces.push_back(quadrangle({-0.5, -0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, -0.5, 0.5}));
  faces.push_back(quadrangle({-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}));
  faces.push_back(quadrangle({-0.5, -0.5, 9}, {-0.5, 0.5, 9}, {0.5, 0.5, 9}, {0.5, -0.5, 9}));
  faces.push_back(quadrangle({9, -9, -9}, {9, 9, -9}, {9, 9, 9}, {9, -9, 9}));
  faces.push_back(quadrangle({-9, -9, -9}, {-9, 9, -9}, {-9, 9, 9}, {-9, -9, 9}));
  const FacetScene scene(sample::mesh_of(faces));
  EXPECT_EQ(scene.pair(24, 26).sight, PairSight::whole);
  EXPECT_EQ(scene.pair(24, 28).sight, PairSight::hidden);
  EXPECT_EQ(scene.pair(24, 30).sight, PairSight::hidden);
  // The inner body's upper face sees what is in the outer one, not what is outside.
  std::size_t upper = 12;
  while (!(scene.unit_normal(upper) == Vector<double>{0, 0, 1})) ++upper;
  EXPECT_EQ(scene.pair(upper, 28).sight, PairSight::whole);
  EXPECT_EQ(scene.pair(upper, 30).sight, PairSight::hidden);
}

// Corners so close to one line that the rounded normal is zero, or has lost its direction.
TEST(FacetScene, TakesSliversWhoseRoundedNormalIsZero) {
  const std::array<Vector<double>, 3> sliver{{{-1.1695644156503835, -0.7950591661281423, 0},
                                              {-0.9823117908892629, 0.18725262476112056, 0},
                                              {-0.7950591661281423, 1.1695644156503835, 0}}};
  ASSERT_EQ(cross(sliver[1] - sliver[0], sliver[2] - sliver[0]), (Vector<double>{0, 0, 0}));
  for (const double scale : {1.0, 0x1p-60, 0x1p60})
    for (int turn = 0; turn < 3; ++turn) {
      const auto placed = [&](const Vector<double>& p) {
        const Vector<double> q = turn == 0   ? p
                                 : turn == 1 ? Vector<double>{p.z, p.x, p.y}
                                             : Vector<double>{p.y, p.z, p.x};
        return scale * q;
      };
      TriangleMesh mesh;
      mesh.group_names = {""};
      for (const auto& c : {sliver, std::array<Vector<double>, 3>{{{2, 1, 3}, {0, 2, 3}, {-1, -2, 4}}},
                            std::array<Vector<double>, 3>{{{2, 1, -3}, {0, 2, -3}, {-1, -2, -4}}}}) {
        const std::size_t n = mesh.vertices.size();
        for (const Vector<double>& p : c) mesh.vertices.push_back(placed(p));
        mesh.triangles.push_back({n, n + 1, n + 2});
        mesh.group.push_back(0);
        mesh.face.push_back(mesh.face.size());
      }
      const FacetScene scene(mesh);
      EXPECT_GT(scene.area(0), 0);
      EXPECT_NEAR(norm(scene.unit_normal(0)), 1, 1e-15);
      EXPECT_EQ(std::abs(dot(scene.unit_normal(0), placed({0, 0, 1}))), scale);
      for (const ConvexOccluder& occluder : scene.occluders()) EXPECT_GE(occluder.corners.size(), 3U);
      for (std::size_t j : {1U, 2U})
        for (const bool certified : {false, true}) {
          const PairExchange found = pair_exchange(scene, 0, j, {.certified = certified});
          EXPECT_TRUE(std::isfinite(found.area.value) && std::isfinite(found.area.radius));
        }
    }
}

TEST(FacetScene, RefusesWhatDoublesDoNotCarry) {
  TriangleMesh mesh = sample::cube_in_cube(0.25);
  EXPECT_FALSE(beyond_doubles(mesh).has_value());
  for (const double scale : {1e-40, 1e-200, 1e-300, 1e31}) {
    TriangleMesh other = mesh;
    for (Vector<double>& v : other.vertices) v = scale * v;
    EXPECT_TRUE(beyond_doubles(other).has_value()) << scale;
    EXPECT_THROW(FacetScene{other}, ContractViolation) << scale;
  }
  // A triangle with hardly any area.
  const std::size_t n = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), {{0.5, 0.5, 0.1}, {0.5, 0.6, 0.1}, {0.5, 0.7, 0.1 + 0x1p-50}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  EXPECT_FALSE(beyond_doubles(mesh).has_value());
  mesh.vertices[n] = {0, 0, 0};
  mesh.vertices[n + 1] = {1e-320, 0, 0};
  mesh.vertices[n + 2] = {0, 1e-300, 0};
  EXPECT_TRUE(beyond_doubles(mesh).has_value());
}

}  // namespace
}  // namespace radcert
