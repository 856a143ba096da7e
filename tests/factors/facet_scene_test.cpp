// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/facet_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <set>

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

}  // namespace
}  // namespace radcert
