// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/convex_parts.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "radcert/factors/factor_mesh.h"
#include "radcert/surface/catalogue.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

TEST(ConvexParts, OfAFinelyCutFaceAreOneSquare) {
  const FactorMesh mesh = factor_mesh(find_surface("cube")->make({}), 2);
  const FacetScene scene(mesh.mesh);
  for (std::size_t piece = 0; piece < mesh.piece_names.size(); ++piece) {
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < mesh.piece.size(); ++t)
      if (mesh.piece[t] == piece) triangles.push_back(t);
    const std::vector<ConvexPart> parts = convex_parts(scene.scene(), triangles);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].corners.size(), 4U);
    EXPECT_EQ(mesh.piece[parts[0].triangle], piece);
    EXPECT_EQ(dot(vector_area(parts[0].corners), scene.unit_normal(triangles[0])), 1);
  }
}

TEST(ConvexParts, OfAFrameAreConvexAndPartItsArea) {
  const TriangleMesh mesh = sample::squares_past_a_wall(false);
  const FacetScene scene(mesh);
  std::vector<std::size_t> triangles;
  for (std::size_t t = 4; t < scene.facet_count(); ++t) triangles.push_back(t);
  double area = 0;
  const std::vector<ConvexPart> parts = convex_parts(scene.scene(), triangles);
  EXPECT_LT(parts.size(), triangles.size() / 2);
  for (const ConvexPart& part : parts) {
    area += norm(vector_area(part.corners));
    for (std::size_t k = 0; k < part.corners.size(); ++k) {
      const auto corner = [&](std::size_t l) { return part.corners[(k + l) % part.corners.size()]; };
      EXPECT_GT(cross(corner(1) - corner(0), corner(2) - corner(1)).z, 0);
    }
  }
  // The square less its hole.
  EXPECT_EQ(area, 1 - 0.375 * 0.375);
}

}  // namespace
}  // namespace radcert
