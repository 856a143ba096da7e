// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_tree.h"

#include <gtest/gtest.h>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

void expect_equal(const std::vector<ParameterTriangle>& a, const std::vector<ParameterTriangle>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].chart, b[i].chart);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(a[i].vertices[k].s, b[i].vertices[k].s);
      EXPECT_EQ(a[i].vertices[k].t, b[i].vertices[k].t);
    }
  }
}

TEST(ClusterTree, HasTheTrianglesOfTheCoarserTriangulations) {
  for (const Surface& surface : {cube(), sphere()})
    for (int refinements = 0; refinements <= 3; ++refinements)
      for (int level = 0; level <= 4; ++level) {
        const auto tree = ClusterTree::make(triangulate(surface, level), level, refinements);
        ASSERT_TRUE(tree) << tree.reason();
        const int leaf_level = std::max(0, level - refinements);
        ASSERT_EQ(tree->levels(), static_cast<std::size_t>(leaf_level) + 1);
        EXPECT_EQ(tree->refinements(), level - leaf_level);
        for (int l = 0; l <= leaf_level; ++l)
          expect_equal(tree->level(static_cast<std::size_t>(l)), triangulate(surface, l).triangles);
      }
}

TEST(ClusterTree, RefusesTrianglesThatNoSymmetricRefinementMade) {
  EXPECT_FALSE(ClusterTree::make(triangulate(cube(), 2, {.diagonals = std::nullopt, .grading = 2}), 2, 1));
  Triangulation odd = triangulate(cube(), 2);
  odd.triangles.pop_back();
  EXPECT_FALSE(ClusterTree::make(odd, 2, 1));
  Triangulation exchanged = triangulate(cube(), 2);
  std::swap(exchanged.triangles[4], exchanged.triangles[5]);
  EXPECT_FALSE(ClusterTree::make(exchanged, 2, 1));
  EXPECT_THROW(static_cast<void>(ClusterTree::make(odd, -1, 1)), ContractViolation);
}

TEST(ClusterTree, HasLeavesOfAtMost180Unknowns) {
  EXPECT_EQ(leaf_refinements(1), 3);
  EXPECT_EQ(leaf_refinements(3), 2);
  EXPECT_EQ(leaf_refinements(10), 2);
  EXPECT_EQ(leaf_refinements(15), 1);
  EXPECT_EQ(leaf_refinements(45), 1);
  EXPECT_EQ(leaf_refinements(66), 0);
  EXPECT_THROW(static_cast<void>(leaf_refinements(0)), ContractViolation);
}

}  // namespace
}  // namespace radcert
