// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_pairs.h"

#include <gtest/gtest.h>

#include "radcert/core/parallel.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

constexpr CouplingDemand demand{.share = 1e-8, .functions_size = 1, .largest_degree = 12};

ClusterPairs pairs_of(const Surface& surface, const ClusterTree& tree) {
  return divide_pairs(surface.charts, tree, ClusterPart(tree), demand,
                      [&surface](std::size_t a, std::size_t b) {
                        return in_one_plane(surface.charts[a], surface.charts[b]);
                      });
}

TEST(ClusterPairs, HoldEveryPairOfLeavesOnce) {
  for (const Surface& surface : {cube(), ellipsoid(1, Rational(3, 2), 2)}) {
    const ClusterTree tree = ClusterTree::make(triangulate(surface, 3), 3, 0).value();
    const ClusterPairs pairs = pairs_of(surface, tree);
    const std::size_t leaves = tree.leaves().size();
    std::vector<int> seen(leaves * leaves);
    std::size_t far = 0;
    for (std::size_t l = 0; l < tree.levels(); ++l) {
      const std::size_t below = leaves / tree.level(l).size();
      far += pairs.far[l].size();
      for (const FarPair& pair : pairs.far[l]) {
        EXPECT_NE(pair.a, pair.b);
        EXPECT_LE(pair.coupling.error_a, demand.share);
        EXPECT_LE(pair.coupling.error_b, demand.share);
        EXPECT_LE(pair.coupling.degree, demand.largest_degree);
        for (std::size_t i = pair.a * below; i < (pair.a + 1) * below; ++i)
          for (std::size_t j = pair.b * below; j < (pair.b + 1) * below; ++j) {
            ++seen[i * leaves + j];
            ++seen[j * leaves + i];
          }
      }
    }
    for (const NearPair& pair : pairs.near) {
      ++seen[pair.a * leaves + pair.b];
      if (pair.a != pair.b) ++seen[pair.b * leaves + pair.a];
    }
    EXPECT_GT(far, 100U) << surface.name;
    for (std::size_t i = 0; i < leaves; ++i)
      for (std::size_t j = 0; j < leaves; ++j) {
        const bool plane =
            in_one_plane(surface.charts[tree.leaves()[i].chart], surface.charts[tree.leaves()[j].chart]);
        ASSERT_EQ(seen[i * leaves + j], plane ? 0 : 1) << surface.name << " " << i << " " << j;
      }
  }
}

TEST(ClusterPairs, AreTheSameForAnyNumberOfThreads) {
  const Surface surface = ellipsoid(1, Rational(3, 2), 2);
  const ClusterTree tree = ClusterTree::make(triangulate(surface, 3), 3, 0).value();
  const auto pairs_on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return pairs_of(surface, tree);
  };
  const ClusterPairs one = pairs_on(1);
  for (const std::size_t threads : {2, 3}) {
    const ClusterPairs many = pairs_on(threads);
    ASSERT_EQ(one.near.size(), many.near.size());
    for (std::size_t l = 0; l < tree.levels(); ++l) {
      ASSERT_EQ(one.far[l].size(), many.far[l].size());
      for (std::size_t i = 0; i < one.far[l].size(); ++i) {
        EXPECT_EQ(one.far[l][i].a, many.far[l][i].a);
        EXPECT_EQ(one.far[l][i].b, many.far[l][i].b);
        EXPECT_EQ(one.far[l][i].coupling.degree, many.far[l][i].coupling.degree);
        EXPECT_EQ(one.far[l][i].coupling.error_a, many.far[l][i].coupling.error_a);
      }
    }
  }
}

}  // namespace
}  // namespace radcert
