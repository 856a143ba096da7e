// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/near_entries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "radcert/collocation/nodes.h"
#include "radcert/quadrature/collocation_point_block.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

/// An ellipsoid all of whose pairs of leaves are near.
struct AllNear {
  Surface surface = ellipsoid(1, Rational(3, 2), 2);
  Triangulation triangulation = triangulate(surface, 1);
  TriangleBasis<double> basis = InsetBasis<double>(2, 0.1);
  std::vector<CollocationPoint<double>> nodes = collocation_nodes<double>(surface, triangulation, basis);
  std::shared_ptr<const IntegrationScheme<double>> scheme =
      std::make_shared<const IntegrationScheme<double>>(surface, basis, Tolerance(1e-6));
  ClusterTree tree = ClusterTree::make(triangulation, 1, 1).value();
  std::size_t unknowns = tree.elements_of_leaf() * basis.size();
  std::size_t leaves = tree.leaves().size();
  NearEntries near{ClusterPart(tree), pairs(), unknowns};
  std::vector<double> factors;

  AllNear() {
    for (std::size_t i = 0; i < nodes.size(); ++i) factors.push_back(0.01 + 0.25 * double(i % 7));
  }
  [[nodiscard]] std::vector<NearPair> pairs() const {
    std::vector<NearPair> all;
    for (std::uint32_t a = 0; a < leaves; ++a)
      for (std::uint32_t b = a; b < leaves; ++b) all.push_back({a, b});
    return all;
  }
  NearEntries::RowSums fill() {
    return near.fill({.schemes = {scheme}, .of_leaf = std::vector<std::size_t>(leaves)}, tree, nodes,
                     factors);
  }
};

TEST(NearEntries, HaveTheRadiiOfTheirIntegralsTimesTheirRowsFactor) {
  AllNear all;
  const NearEntries::RowSums sums = all.fill();
  std::vector<double> radius(all.nodes.size());
  std::vector<double> kernel(all.nodes.size());
  BlockIntegral<double> integral;
  for (const ParameterTriangle& triangle : all.triangulation.triangles) {
    ElementIntegrator<double> element(all.scheme, triangle);
    for (std::size_t first = 0; first < all.nodes.size(); first += all.unknowns) {
      const auto of_leaf = std::span(std::as_const(all.nodes)).subspan(first, all.unknowns);
      for (const CollocationPointBlock<double>& block : observer_blocks(of_leaf)) {
        element.integrate(block, of_leaf, integral);
        for (std::size_t lane = 0; lane < block.count; ++lane) {
          const std::size_t i = first + block.first + lane;
          kernel[i] += integral.absolute.lane(lane);
          for (std::size_t j = 0; j < all.basis.size(); ++j)
            radius[i] += all.factors[i] * integral.radius[j].lane(lane);
        }
      }
    }
  }
  for (std::size_t i = 0; i < all.nodes.size(); ++i) {
    EXPECT_GT(radius[i], 0);
    EXPECT_NEAR(sums.radius[i], radius[i], 1e-12 * radius[i]) << i;
    EXPECT_NEAR(sums.kernel_integral[i], kernel[i], 1e-12 * kernel[i]) << i;
  }
}

TEST(NearEntries, HaveSizesThatDoNotCancel) {
  AllNear all;
  static_cast<void>(all.fill());
  const std::size_t n = all.nodes.size();
  std::vector<double> x;
  for (std::size_t j = 0; j < n; ++j) x.push_back(1 + double(j % 5));
  std::vector<double> product(n);
  std::vector<double> accurate(n);
  std::vector<double> sizes(n);
  all.near.add_product(x, product);
  all.near.add_accurately(x, accurate);
  all.near.add_sizes(x, sizes);
  double apart = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    double of_sizes = 0;
    for (std::size_t j = 0; j < n; ++j) {
      sum += all.near.entry(i, j) * x[j];
      of_sizes += std::abs(all.near.entry(i, j)) * x[j];
    }
    EXPECT_NEAR(product[i], sum, 1e-13 * of_sizes) << i;
    EXPECT_NEAR(accurate[i], sum, 1e-13 * of_sizes) << i;
    EXPECT_NEAR(sizes[i], of_sizes, 1e-13 * of_sizes) << i;
    apart = std::max(apart, 1 - sum / of_sizes);
  }
  // Entries of both signs: the two sums are not alike.
  EXPECT_GT(apart, 1e-6);
}

}  // namespace
}  // namespace radcert
