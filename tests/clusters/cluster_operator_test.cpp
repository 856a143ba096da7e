// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_operator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "radcert/clusters/cluster_pairs.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cone.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/octahedron.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/tetrahedron.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert {
namespace {

/// A discretisation, its dense matrix and its operator.
struct Discretisation {
  Surface surface;
  int level;
  double grading;
  Triangulation triangulation;
  TriangleBasis<double> basis;
  std::vector<CollocationPoint<double>> nodes;
  std::vector<double> rho;

  Discretisation(Surface s, int levels, int degree, double inset = 0.1, double graded = 1)
      : surface(std::move(s)),
        level(levels),
        grading(graded),
        triangulation(triangulate(surface, level, {.diagonals = std::nullopt, .grading = grading})),
        basis(InsetBasis<double>(degree, inset)),
        nodes(collocation_nodes<double>(surface, triangulation, basis)) {
    for (std::size_t i = 0; i < nodes.size(); ++i) rho.push_back(0.25 + 0.5 * double(i % 7) / 7);
  }

  /// With leaves of 4^refinements elements: small ones, so that small problems have couplings.
  ClusterOperator clusters(double tolerance, std::optional<int> refinements = std::nullopt) const {
    const int cuts = refinements.value_or(leaf_refinements(basis.size()));
    const ClusterTree tree = (grading == 1 ? ClusterTree::make(triangulation, level, cuts)
                                           : ClusterTree::graded(triangulation, level, cuts))
                                 .value();
    return ClusterOperator({.surface = surface,
                            .tree = tree,
                            .part = ClusterPart(tree),
                            .basis = basis,
                            .nodes = nodes,
                            .reflectivity = rho,
                            .integrals = Tolerance(1e-13),
                            .far = ClusterTolerance(tolerance)});
  }
  CollocationMatrix<double> dense() const {
    return assemble<double>(surface, triangulation, basis, nodes, rho);
  }
  std::size_t size() const { return nodes.size(); }
};

std::vector<double> random_vector(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> x(size);
  for (double& each : x) each = std::uniform_real_distribution<double>(-1, 1)(random);
  return x;
}

std::vector<double> product(const Matrix<double>& a, const std::vector<double>& x) {
  std::vector<double> y(x.size());
  for (std::size_t j = 0; j < x.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i) y[i] += a(i, j) * x[j];
  return y;
}

/// The unknowns of an element with the least distance of its nodes from a corner of a chart's domain, and
/// others across the surface.
std::vector<std::size_t> columns_to_look_at(const Discretisation& d) {
  std::vector<std::size_t> columns;
  const std::size_t p = d.basis.size();
  const std::size_t elements = d.triangulation.triangles.size();
  for (const std::size_t element : {std::size_t{0}, elements / 3, elements - 1})
    for (const std::size_t j : {std::size_t{0}, p - 1}) columns.push_back(element * p + j);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

/// Holds an operator against the dense matrix: entries of some columns in all rows, those at edges and
/// corners among them, and products, within the radii of both.
void expect_agreement(const Discretisation& d, double tolerance, int refinements) {
  const CollocationMatrix<double> dense = d.dense();
  const ClusterOperator k = d.clusters(tolerance, refinements);
  const std::string where = d.surface.name + ", degree " + std::to_string(d.basis.degree()) + ", tolerance " +
                            std::to_string(tolerance);
  const std::size_t n = d.size();
  ASSERT_GT(k.couplings().evaluations(), 0U) << where;
  std::vector<double> y(n);
  for (const std::size_t j : columns_to_look_at(d)) {
    std::vector<double> unit(n);
    unit[j] = 1;
    k.multiply(unit, y);
    for (std::size_t i = 0; i < n; ++i)
      ASSERT_NEAR(y[i], dense.entries(i, j), k.row_radius()[i] + dense.row_radius[i])
          << where << " entry " << i << " " << j;
  }
  for (unsigned seed = 0; seed < 2; ++seed) {
    const std::vector<double> x = random_vector(n, seed);
    const std::vector<double> expected = product(dense.entries, x);
    k.multiply(x, y);
    std::vector<double> accurate(n);
    k.multiply_accurately(x, accurate);
    for (std::size_t i = 0; i < n; ++i) {
      const double radius = k.row_radius()[i] + dense.row_radius[i];
      ASSERT_NEAR(y[i], expected[i], radius) << where << " row " << i;
      // Rows of high degrees have large entries of both signs.
      ASSERT_NEAR(accurate[i], y[i], 1e-13 * std::max(1.0, std::abs(y[i]))) << where << " row " << i;
    }
  }
  double largest_radius = 0;
  for (std::size_t i = 0; i < n; ++i) {
    largest_radius = std::max(largest_radius, k.row_radius()[i]);
    ASSERT_NEAR(k.kernel_integral()[i], dense.kernel_integral[i],
                std::numbers::pi / d.rho[i] * (k.row_radius()[i] + dense.row_radius[i]))
        << where << " row " << i;
  }
  constexpr double near_and_rounding = 1e-11;
  EXPECT_LE(largest_radius, tolerance + near_and_rounding) << where;
}

// A row's radius is at least what its couplings leave out and the rounding of a product: beside them there is
// no more than the radii of near entries, which on the sphere are a part of that rounding.
TEST(ClusterOperator, CountsWhatCouplingsLeaveOutAndRound) {
  const Discretisation d(sphere(), 2, 1);
  constexpr double tolerance = 1e-3;
  const ClusterOperator k = d.clusters(tolerance, 0);
  const ClusterTree tree = ClusterTree::make(d.triangulation, d.level, 0).value();
  const ClusterPart part(tree);
  const CouplingDemand demand{.share = ClusterTolerance(tolerance).share(tree.levels()),
                              .functions_size = size_of_functions(d.basis),
                              .largest_degree = ClusterTolerance(tolerance).largest_degree(),
                              .nodes = d.basis.nodes()};
  const ClusterPairs pairs =
      divide_pairs(d.surface.charts, tree, part, demand, [](std::size_t, std::size_t) { return false; });
  const std::vector<double> left_out = truncation_of_leaves(part, pairs.far);
  // So that the first shares are the last.
  ASSERT_LE(*std::max_element(left_out.begin(), left_out.end()), tolerance);
  const std::size_t unknowns = d.size() / left_out.size();
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double counted = d.rho[i] * (left_out[i / unknowns] + k.rounding());
    // The sum itself is rounded.
    EXPECT_GE(k.row_radius()[i], counted * (1 - 0x1p-52)) << i;
    EXPECT_LE(k.row_radius()[i], counted + d.rho[i] * k.rounding()) << i;
  }
}

TEST(ClusterOperator, AgreesWithTheDenseMatrixForEveryDegree) {
  // Leaves of one element, so that small problems have couplings.
  for (int degree = 0; degree <= 5; ++degree) {
    const int level = degree == 0 ? 3 : 2;
    const double tolerance = degree == 0 ? 1e-8 : degree <= 4 ? 1e-4 : 1e-3;
    const bool is_curved = degree % 2 == 1;
    const Surface surface = is_curved ? ellipsoid(1, Rational(3, 2), 2) : cube();
    expect_agreement(Discretisation(surface, level, degree), tolerance, 0);
  }
  // No small problem of a degree above 6 has couplings on the ellipsoid, and dense matrices of these on the
  // cube have thousands of rows.
  for (int degree = 6; degree <= 10; ++degree)
    expect_agreement(Discretisation(two_squares(), 2, degree), 1e-3, 0);
}

TEST(ClusterOperator, AgreesWithTheDenseMatrixOnEverySurfaceOfAnalyticCharts) {
  for (const Surface& surface : {box(1, 2, 5), sphere(), ellipsoid(1, 2, 5), tetrahedron(), octahedron(),
                                 cylinder(1, 2), cone(1, Rational(1, 2), 2), paraboloid_cap(),
                                 spherical_cap(Rational(1, 2)), two_piece(2), two_squares()}) {
    if (obstacle_to_clusters(surface)) continue;
    const int level = surface.charts.size() < 5 ? 4 : 3;
    expect_agreement(Discretisation(surface, level, 0), 1e-7, 0);
    expect_agreement(Discretisation(surface, level - 1, 2), 1e-3, 0);
  }
}

TEST(ClusterOperator, AgreesWithTheDenseMatrixOnGradedTriangulations) {
  expect_agreement(Discretisation(cube(), 4, 0, 0.1, 2), 1e-4, 1);
  expect_agreement(Discretisation(cube(), 3, 1, 0.1, 1.5), 1e-6, 0);
  expect_agreement(Discretisation(box(1, 2, 3), 3, 2, 0.1, 1.5), 1e-5, 1);
  expect_agreement(Discretisation(two_squares(), 4, 1, 0.1, 3), 1e-8, 1);
  expect_agreement(Discretisation(two_squares(), 3, 4, 0.1, 2), 1e-10, 1);
  // Unit triangles are not graded: clusters are those of a uniform triangulation, by other matrices.
  expect_agreement(Discretisation(octahedron(), 3, 1, 0.1, 2), 1e-6, 0);
}

TEST(ClusterOperator, KeepsToItsRadiusInTheSumOverEachRow) {
  // The sizes of all errors of a row, corners and edges included.
  const std::array<Discretisation, 3> all{Discretisation(ellipsoid(1, Rational(3, 2), 2), 3, 0, 1.0 / 6),
                                          Discretisation(cube(), 2, 1, 1.0 / 6),
                                          Discretisation(cube(), 3, 0, 1.0 / 6, 2)};
  for (const Discretisation& d : all) {
    const Surface& surface = d.surface;
    const CollocationMatrix<double> dense = d.dense();
    const ClusterOperator k = d.clusters(1e-4, 0);
    const std::size_t n = d.size();
    std::vector<double> sum(n);
    std::vector<double> unit(n);
    std::vector<double> y(n);
    for (std::size_t j = 0; j < n; ++j) {
      unit[j] = 1;
      k.multiply(unit, y);
      unit[j] = 0;
      for (std::size_t i = 0; i < n; ++i) sum[i] += std::abs(y[i] - dense.entries(i, j));
    }
    double widest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_LE(sum[i], k.row_radius()[i] + dense.row_radius[i]) << surface.name << " row " << i;
      widest = std::max(widest, sum[i] / k.row_radius()[i]);
    }
    EXPECT_GT(widest, 0.005) << surface.name;  // a radius that says something
  }
}

TEST(ClusterOperator, HasTheSameBitsForAnyNumberOfThreads) {
  const Discretisation d(ellipsoid(1, Rational(3, 2), 2), 3, 1);
  const std::vector<double> x = random_vector(d.size(), 1);
  struct Bits {
    std::vector<double> product, accurate, sizes, radius, integral;
    bool operator==(const Bits&) const = default;
  };
  const auto bits_on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const ClusterOperator k = d.clusters(1e-5, 0);
    Bits bits{std::vector<double>(d.size()), std::vector<double>(d.size()), std::vector<double>(d.size()),
              k.row_radius(), k.kernel_integral()};
    std::vector<double> positive = x;
    for (double& each : positive) each = std::abs(each);
    k.multiply(x, bits.product);
    k.multiply_accurately(x, bits.accurate);
    k.multiply_sizes(positive, bits.sizes);
    return bits;
  };
  const Bits one = bits_on(1);
  for (const std::size_t threads : {2, 3, 8}) EXPECT_TRUE(one == bits_on(threads)) << threads << " threads";
}

TEST(ClusterOperator, IsLinearWhereADensityVanishesOnMostClusters) {
  const Discretisation d(ellipsoid(1, Rational(3, 2), 2), 3, 1);
  const ClusterOperator k = d.clusters(1e-5, 0);
  std::vector<double> x = random_vector(d.size(), 3);
  for (double& each : x) each = std::abs(each);
  const std::size_t p = d.basis.size();
  using Product = void (ClusterOperator::*)(std::span<const double>, std::span<double>) const;
  for (const Product product : {&ClusterOperator::multiply, &ClusterOperator::multiply_accurately,
                                &ClusterOperator::multiply_sizes}) {
    std::vector<double> whole(d.size());
    (k.*product)(x, whole);
    // One element alone, every seventh of the others, and of the rest the last unknowns and the others:
    // leaves and nodes of clusters at which a density vanishes everywhere, in part, or on one side alone.
    std::vector<double> sum(d.size());
    for (std::size_t part = 0; part < 4; ++part) {
      std::vector<double> of_part(d.size());
      for (std::size_t i = 0; i < d.size(); ++i) {
        const std::size_t which = i / p == 5 ? 3 : i / p % 7 == 0 ? 2 : i % p == p - 1 ? 1 : 0;
        if (which == part) of_part[i] = x[i];
      }
      std::vector<double> y(d.size());
      (k.*product)(of_part, y);
      for (std::size_t i = 0; i < d.size(); ++i) sum[i] += y[i];
    }
    for (std::size_t i = 0; i < d.size(); ++i) EXPECT_NEAR(sum[i], whole[i], 1e-13) << "row " << i;
  }
}

TEST(ClusterOperator, MapsOneToTheReflectivityOnClosedSurfaces) {
  for (const Surface& surface : {cube(), ellipsoid(1, Rational(3, 2), 2), cylinder(1, 2)}) {
    const Discretisation d(surface, 3, 1);
    const ClusterOperator k = d.clusters(1e-9, 1);
    std::vector<double> y(d.size());
    k.multiply(std::vector<double>(d.size(), 1.0), y);
    for (std::size_t i = 0; i < d.size(); ++i) {
      EXPECT_NEAR(y[i], d.rho[i], k.row_radius()[i]) << surface.name << " row " << i;
      EXPECT_NEAR(k.kernel_integral()[i], std::numbers::pi, 1e-8) << surface.name << " row " << i;
    }
  }
}

TEST(ClusterOperator, BoundsTheSizesOfItsEntries) {
  const Surface curved = ellipsoid(1, Rational(3, 2), 2);
  const std::array<Discretisation, 5> all{Discretisation(curved, 3, 0), Discretisation(curved, 2, 1),
                                          Discretisation(curved, 2, 2), Discretisation(curved, 2, 4),
                                          Discretisation(two_squares(), 3, 2, 0.1, 2)};
  for (const Discretisation& d : all) {
    const int degree = d.basis.degree();
    const ClusterOperator k = d.clusters(1e-3, 0);
    const Matrix<double> dense = d.dense().entries;
    std::vector<double> w = random_vector(d.size(), 5);
    for (double& each : w) each = std::abs(each);
    std::vector<double> y(d.size());
    k.multiply_sizes(w, y);
    for (std::size_t i = 0; i < d.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < d.size(); ++j) sum += std::abs(dense(i, j)) * w[j];
      EXPECT_GE(y[i] + k.row_radius()[i], sum) << degree << " row " << i;
    }
  }
}

TEST(ClusterOperator, NamesWhatItDoesNotServe) {
  EXPECT_FALSE(obstacle_to_clusters(cube()));
  EXPECT_FALSE(obstacle_to_clusters(two_piece(2)));
  EXPECT_TRUE(obstacle_to_clusters(two_piece(Rational(5, 2))));
  Surface occluded = cube();
  occluded.unoccluded = false;
  EXPECT_EQ(obstacle_to_clusters(occluded), "parts of the surface hide others");
  const Discretisation d(cube(), 1, 1);
  EXPECT_THROW(ClusterTolerance(0.9e-13), ContractViolation);
  EXPECT_THROW(ClusterTolerance(0.1), ContractViolation);
  const ClusterTree tree = ClusterTree::make(d.triangulation, 1, 1).value();
  EXPECT_THROW(ClusterOperator({.surface = occluded,
                                .tree = tree,
                                .part = ClusterPart(tree),
                                .basis = d.basis,
                                .nodes = d.nodes,
                                .reflectivity = d.rho}),
               ContractViolation);
}

TEST(ClusterOperator, RefusesMoreMemoryThanItMayTake) {
  const Discretisation d(cube(), 2, 1);
  const ClusterTree tree = ClusterTree::make(d.triangulation, 2, 2).value();
  EXPECT_THROW(ClusterOperator({.surface = d.surface,
                                .tree = tree,
                                .part = ClusterPart(tree),
                                .basis = d.basis,
                                .nodes = d.nodes,
                                .reflectivity = d.rho,
                                .memory_limit = 100000}),
               InputError);
}

}  // namespace
}  // namespace radcert
