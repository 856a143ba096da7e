// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

double largest_coordinate_outside(const ParameterTriangle& cluster, const ParameterPoint<double>& p) {
  const auto& [a, b, c] = cluster.vertices;
  const double whole = cross(b - a, c - a);
  return -std::min({cross(c - b, p - b), cross(a - c, p - c), cross(b - a, p - a)}) / whole;
}

TEST(ClusterTree, HoldsTheElementsOfAGradedTriangulation) {
  for (const double grading : {1.25, 2.0, 5.0})
    for (int refinements = 0; refinements <= 2; ++refinements) {
      const int level = 4;
      const Triangulation triangulation =
          triangulate(cube(), level, {.diagonals = std::nullopt, .grading = grading});
      const auto tree = ClusterTree::graded(triangulation, level, refinements);
      ASSERT_TRUE(tree) << tree.reason();
      ASSERT_EQ(tree->levels(), static_cast<std::size_t>(level - refinements) + 1);
      const std::size_t elements = triangulation.triangles.size();
      for (std::size_t k = 0; k < elements; ++k)
        expect_equal({tree->element(k)}, {triangulation.triangles[k]});
      for (std::size_t l = 0; l < tree->levels(); ++l) {
        const std::vector<ParameterTriangle>& clusters = tree->level(l);
        double touched = 1;
        for (std::size_t k = 0; k < elements; ++k) {
          const ParameterTriangle& cluster = clusters[k * clusters.size() / elements];
          EXPECT_EQ(cluster.chart, triangulation.triangles[k].chart);
          for (const ParameterPoint<double>& vertex : triangulation.triangles[k].vertices) {
            const double outside = largest_coordinate_outside(cluster, vertex);
            EXPECT_LT(outside, 1e-12);
            touched = std::min(touched, std::abs(outside));
          }
        }
        EXPECT_LT(touched, 1e-12);
        // No larger than twice the triangle of the coarser triangulation, whose right angle it has.
        const Triangulation coarse =
            triangulate(cube(), static_cast<int>(l), {.diagonals = std::nullopt, .grading = grading});
        for (std::size_t i = 0; i < clusters.size(); ++i) {
          const auto& [a, b, c] = clusters[i].vertices;
          const auto& [p, q, r] = coarse.triangles[i].vertices;
          const double scale = std::sqrt(cross(b - a, c - a) / cross(q - p, r - p));
          EXPECT_GE(scale, 1 - 1e-12);
          EXPECT_LT(scale, 2);
        }
      }
    }
}

TEST(ClusterTree, RefusesTrianglesThatNoGradedRefinementMade) {
  Triangulation odd = triangulate(cube(), 2, {.diagonals = std::nullopt, .grading = 2});
  std::swap(odd.triangles[0], odd.triangles[1]);
  EXPECT_FALSE(ClusterTree::graded(odd, 2, 1));
  odd.triangles.pop_back();
  EXPECT_FALSE(ClusterTree::graded(odd, 2, 1));
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
