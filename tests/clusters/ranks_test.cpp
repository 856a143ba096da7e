// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <mutex>
#include <random>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/solve/gmres.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "tests/thread_ranks.h"

namespace radcert {
namespace {

/// What ranks make of a level, all parts after each other.
struct Made {
  std::vector<double> product;
  std::vector<double> sizes;
  std::vector<double> accurate;
  std::vector<double> radius;
  std::vector<double> kernel_integral;
  std::vector<double> solution;
  double error_bound = 0;
  std::size_t largest_part = 0;  ///< of the near entries
  std::size_t evaluations = 0;
};

Made made_by(std::size_t count, const Surface& surface, int level, int refinements, double tolerance) {
  const TriangleBasis<double> basis(InsetBasis<double>(1, 0.1));
  Made made;
  std::mutex mutex;
  ThreadRanks::run(count, [&](const Ranks& ranks) {
    const ClusterTree tree =
        ClusterTree::above(triangulate(surface, level - refinements), level - refinements, refinements)
            .value();
    const ClusterPart part(tree, ranks);
    const std::size_t elements = tree.elements_of_leaf();
    const Triangulation own =
        triangulate_part(surface, level, {}, {part.leaves().begin * elements, part.leaves().end * elements});
    const auto nodes = collocation_nodes<double>(surface, own, basis);
    std::vector<double> rho;
    std::vector<double> x;
    for (const CollocationPoint<double>& node : nodes) {
      rho.push_back(0.5 + 0.25 * node.normal.x);
      x.push_back(node.point.x + node.point.y * node.point.z);
    }
    const ClusterOperator k({.surface = surface,
                             .tree = tree,
                             .part = part,
                             .basis = basis,
                             .nodes = nodes,
                             .reflectivity = rho,
                             .far = ClusterTolerance(tolerance)});
    std::vector<double> y(x.size());
    const auto all = [&](std::span<const double> numbers) { return ranks.gather_numbers(numbers); };
    Made now;
    k.multiply(x, y);
    now.product = all(y);
    k.multiply_sizes(std::vector<double>(x.size(), 1.0), y);
    now.sizes = all(y);
    k.multiply_accurately(x, y);
    now.accurate = all(y);
    now.radius = all(k.row_radius());
    now.kernel_integral = all(k.kernel_integral());
    const Contraction contraction = find_contraction(k, k.row_radius()).value();
    const IterativeSolution solved = solve_by_gmres(k, contraction, x).value();
    now.solution = all(solved.values);
    now.error_bound = solved.error_bound;
    now.largest_part = static_cast<std::size_t>(ranks.largest(static_cast<double>(k.near_entries().size())));
    now.evaluations = k.couplings().evaluations();
    if (ranks.is_first()) made = now;
  });
  return made;
}

TEST(Ranks, MakeTheSameBitsAsOne) {
  for (const Surface& surface : {ellipsoid(1, 2, 5), box(1, 2, 5)}) {
    const Made one = made_by(1, surface, 2, 0, 1e-4);
    ASSERT_GT(one.evaluations, 0U);
    const std::vector<std::size_t> counts = surface.charts.front().facts().plane
                                                ? std::vector<std::size_t>{5}
                                                : std::vector<std::size_t>{2, 3, 8};
    for (const std::size_t count : counts) {
      const Made many = made_by(count, surface, 2, 0, 1e-4);
      ASSERT_EQ(many.product, one.product) << surface.name << " " << count;
      EXPECT_EQ(many.sizes, one.sizes) << surface.name << " " << count;
      EXPECT_EQ(many.accurate, one.accurate) << surface.name << " " << count;
      EXPECT_EQ(many.radius, one.radius) << surface.name << " " << count;
      EXPECT_EQ(many.kernel_integral, one.kernel_integral) << surface.name << " " << count;
      EXPECT_EQ(many.solution, one.solution) << surface.name << " " << count;
      EXPECT_EQ(many.error_bound, one.error_bound) << surface.name << " " << count;
      EXPECT_LT(many.largest_part, 2 * one.largest_part / count) << surface.name << " " << count;
    }
  }
}

// On the mantle, which is the second of two ranks', rows leave out a quarter more at first than they may, and
// on the disks they do not: the shares of both ranks are reduced.
TEST(Ranks, ReduceTheirSharesTogether) {
  const Surface surface = cylinder(1, 2);
  const Made one = made_by(1, surface, 2, 0, 1e-3);
  const Made two = made_by(2, surface, 2, 0, 1e-3);
  EXPECT_EQ(two.radius, one.radius);
  EXPECT_EQ(two.product, one.product);
}

TEST(Ranks, HaveEachClusterBelowTheCutOnce) {
  const ClusterTree tree = ClusterTree::make(triangulate(cube(), 4), 4, 1).value();
  for (const std::size_t count : {1, 2, 3, 5, 8, 48})
    ThreadRanks::run(count, [&](const Ranks& ranks) {
      const ClusterPart part(tree, ranks);
      for (std::size_t l = 0; l < tree.levels(); ++l) {
        std::size_t end = 0;
        for (std::size_t rank = 0; rank < count; ++rank) {
          const ClusterRange range = part.range(l, rank);
          EXPECT_LT(range.begin, range.end);
          if (l < part.cut()) continue;
          EXPECT_EQ(range.begin, end);
          end = range.end;
          for (const std::size_t cluster : {range.begin, range.end - 1})
            EXPECT_EQ(part.owner(l, cluster), rank) << l << " " << cluster;
        }
        if (l >= part.cut()) {
          EXPECT_EQ(end, tree.level(l).size());
        }
        const ClusterRange here = part.range(l);
        EXPECT_EQ(here.begin, part.leaves().begin >> 2 * (part.leaf_level() - l));
        EXPECT_EQ(here.end, ((part.leaves().end - 1) >> 2 * (part.leaf_level() - l)) + 1);
      }
    });
  EXPECT_EQ(ClusterPart::most_ranks(tree), 48U);
  EXPECT_THROW(ThreadRanks::run(49, [&](const Ranks& ranks) { static_cast<void>(ClusterPart(tree, ranks)); }),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
