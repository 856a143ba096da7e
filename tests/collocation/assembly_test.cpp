// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/assembly.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"

namespace radcert {
namespace {

/// A discretisation with its nodes, ready to be assembled.
struct Setting {
  Surface surface;
  Triangulation triangulation;
  InsetBasis<double> basis;
  std::vector<CollocationPoint<double>> nodes;

  Setting(Surface s, int level, int degree, double inset)
      : surface(std::move(s)),
        triangulation(triangulate(surface, level)),
        basis(degree, inset),
        nodes(collocation_nodes<double>(surface, triangulation, basis)) {}

  CollocationMatrix<double> matrix(double rho) const {
    return assemble<double>(surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), rho));
  }
  CollocationMatrix<double> matrix(const std::vector<double>& rho) const {
    return assemble<double>(surface, triangulation, basis, nodes, rho);
  }
};

double row_sum(const Matrix<double>& a, std::size_t i) {
  double sum = 0;
  for (std::size_t j = 0; j < a.columns(); ++j) sum += a(i, j);
  return sum;
}

TEST(CollocationMatrix, MapsOneToOneOnClosedSurfaces) {
  // The basis functions sum to 1 and Int G = pi.
  for (const Surface& surface : {cube(), box(1, 2, 5), sphere(), ellipsoid(1, 2, 5)})
    for (int degree = 0; degree <= 2; ++degree) {
      const Setting setting(surface, degree == 0 ? 1 : 0, degree, 0.125);
      const CollocationMatrix<double> k = setting.matrix(1);
      ASSERT_EQ(k.entries.rows(), setting.nodes.size());
      ASSERT_EQ(k.entries.columns(), setting.nodes.size());
      for (std::size_t i = 0; i < setting.nodes.size(); ++i) {
        EXPECT_NEAR(row_sum(k.entries, i), 1, 2e-13) << surface.name << " degree " << degree << " row " << i;
        EXPECT_NEAR(k.kernel_integral[i], std::numbers::pi, 5e-13) << surface.name << " row " << i;
        EXPECT_LE(std::abs(row_sum(k.entries, i) - 1), k.row_radius[i] + 1e-15)
            << surface.name << " row " << i;
        EXPECT_LT(k.row_radius[i], 1e-11) << surface.name << " degree " << degree << " row " << i;
      }
    }
}

TEST(CollocationMatrix, HasEqualRowsOnTheSphere) {
  // G = 1/4 there [m06, Lemma 1 (d)]: entry (i, c) = Int l_c dS / (4 pi) for every node i, near or far or
  // inside.
  for (int degree = 0; degree <= 2; ++degree) {
    const Setting setting(sphere(), 1, degree, 0.1);
    const Matrix<double> a = setting.matrix(1).entries;
    for (std::size_t j = 0; j < a.columns(); ++j)
      for (std::size_t i = 1; i < a.rows(); ++i)
        EXPECT_NEAR(a(i, j), a(0, j), 1e-14) << degree << " " << i << " " << j;
  }
}

TEST(CollocationMatrix, HasAnEighthForEachOctantOfTheSphere) {
  const Setting setting(sphere(), 0, 0, 0);
  const Matrix<double> a = setting.matrix(1).entries;
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < 8; ++j) EXPECT_NEAR(a(i, j), 0.125, 2e-14) << i << " " << j;
}

TEST(CollocationMatrix, IsExactlyZeroWithinAPlane) {
  const Setting setting(two_squares(), 1, 1, 0.1);
  const CollocationMatrix<double> k = setting.matrix(1);
  const std::size_t half = setting.nodes.size() / 2;
  for (std::size_t i = 0; i < 2 * half; ++i)
    for (std::size_t j = 0; j < half; ++j)
      EXPECT_EQ(k.entries(i, i < half ? j : j + half), 0) << i << " " << j;
  for (std::size_t i = 0; i < 2 * half; ++i) {
    EXPECT_GT(row_sum(k.entries, i), 0.01);
    EXPECT_LT(row_sum(k.entries, i), 0.5);  // the other square fills less than half of what P sees
  }
}

TEST(CollocationMatrix, SeesTheOtherSquareAsItsMirrorImageDoes) {
  // (x,y,z) -> (x,z,y) exchanges the squares and keeps the nodes' numbers.
  const Setting setting(two_squares(), 1, 1, 0.1);
  const Matrix<double> a = setting.matrix(1).entries;
  const std::size_t half = setting.nodes.size() / 2;
  for (std::size_t i = 0; i < half; ++i)
    for (std::size_t j = half; j < 2 * half; ++j)
      EXPECT_NEAR(a(i, j), a(i + half, j - half), 1e-15) << i << " " << j;
}

TEST(CollocationMatrix, IsLinearInTheReflectivityRowByRow) {
  const Setting setting(two_piece(2), 0, 1, 0.1);
  std::vector<double> rho(setting.nodes.size());
  for (std::size_t i = 0; i < rho.size(); ++i)
    rho[i] = std::ldexp(1.0, -static_cast<int>(i));  // exact scalings
  rho.back() = 0;
  const CollocationMatrix<double> one = setting.matrix(1);
  const CollocationMatrix<double> scaled = setting.matrix(rho);
  for (std::size_t i = 0; i < rho.size(); ++i) {
    for (std::size_t j = 0; j < rho.size(); ++j) EXPECT_EQ(scaled.entries(i, j), rho[i] * one.entries(i, j));
    EXPECT_EQ(scaled.kernel_integral[i], one.kernel_integral[i]);  // without rho
    EXPECT_EQ(scaled.row_radius[i], rho[i] * one.row_radius[i]);
  }
}

TEST(CollocationMatrix, MapsLinearFunctionsAlikeForEveryBasisThatReproducesThem) {
  // On flat pieces K P_n u = K u for linear u, whatever degree, inset and level.
  const auto image_at_first_node = [](const Setting& setting, const CollocationPoint<double>& p) {
    const std::vector<CollocationPoint<double>> nodes(setting.nodes.size(), p);
    const Matrix<double> a = assemble<double>(setting.surface, setting.triangulation, setting.basis, nodes,
                                              std::vector<double>(nodes.size(), 1))
                                 .entries;
    double sum = 0;
    for (std::size_t j = 0; j < a.columns(); ++j) {
      const Vector<double>& q = setting.nodes[j].point;
      sum += a(0, j) * (1 + 2 * q.x - 3 * q.y + 5 * q.z);
    }
    return sum;
  };
  const Surface surface = cube();
  const CollocationPoint<double> p = collocation_point<double>(surface, {4, {0.3, 0.8}});
  const double expected = image_at_first_node(Setting(surface, 0, 1, 0.1), p);
  EXPECT_NEAR(image_at_first_node(Setting(surface, 1, 1, 0.25), p), expected, 1e-12);
  EXPECT_NEAR(image_at_first_node(Setting(surface, 0, 2, 0.05), p), expected, 1e-12);
  EXPECT_NEAR(image_at_first_node(Setting(surface, 0, 3, 0.125), p), expected, 1e-12);
  EXPECT_GT(std::abs(image_at_first_node(Setting(surface, 0, 0, 0), p) - expected), 1e-3);
}

TEST(CollocationMatrix, HasTheSameBitsForEveryNumberOfThreads) {
  // The cube has more elements than chunks.
  for (const Setting& setting : {Setting(two_piece(Rational(3, 2)), 1, 1, 1.0 / 6),
                                 Setting(sphere(), 0, 2, 0.1), Setting(cube(), 2, 0, 0)}) {
    const auto with_threads = [&setting](std::size_t threads) {
      const ThreadLimit limit(threads);
      return setting.matrix(0.7);
    };
    const CollocationMatrix<double> one = with_threads(1);
    const CollocationMatrix<double> two = with_threads(2);
    for (std::size_t j = 0; j < one.entries.columns(); ++j)
      for (std::size_t i = 0; i < one.entries.rows(); ++i)
        ASSERT_EQ(one.entries(i, j), two.entries(i, j)) << i << " " << j;
    EXPECT_EQ(one.kernel_integral, two.kernel_integral);
    EXPECT_EQ(one.row_radius, two.row_radius);
  }
}

TEST(CollocationMatrix, RefusesAnotherNumberOfNodesOrReflectivities) {
  const Setting setting(two_squares(), 0, 1, 0.1);
  const std::vector<double> rho(setting.nodes.size(), 1);
  const std::vector<CollocationPoint<double>> fewer(setting.nodes.begin(), setting.nodes.end() - 1);
  EXPECT_THROW(assemble<double>(setting.surface, setting.triangulation, setting.basis, fewer, rho),
               ContractViolation);
  EXPECT_THROW(setting.matrix(std::vector<double>(rho.size() + 1, 1)), ContractViolation);
}

}  // namespace
}  // namespace radcert
