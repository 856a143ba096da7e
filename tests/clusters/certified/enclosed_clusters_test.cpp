// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/collocation/certified/plane_entries.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert {
namespace {

/// A discretisation and its matrix with the reflectivity 1, proved entry by entry without any cluster.
struct Proved {
  Surface surface;
  int level;
  Triangulation triangulation = triangulate(surface, level);
  LagrangeFunctions functions;
  static constexpr double near = 1e-4;  ///< of rows of entries on curved charts

  Proved(Surface s, int levels, int degree, const Rational& inset = Rational(1, 6))
      : surface(std::move(s)),
        level(levels),
        functions(lagrange_functions(inset_nodes(degree, degree == 0 ? Rational(0) : inset)).value()) {}

  [[nodiscard]] CertifiedEntries entries() const {
    if (!std::all_of(surface.charts.begin(), surface.charts.end(),
                     [](const Chart& chart) { return chart.facts().plane.has_value(); }))
      return certified_chart_entries(surface, triangulation, functions, std::vector<double>(size(), 1.0),
                                     near)
          .value();
    std::vector<PlaneChart> elements;
    for (const ParameterTriangle& triangle : triangulation.triangles) {
      std::array<ParameterPoint<Rational>, 3> corners;
      for (std::size_t c = 0; c < 3; ++c)
        corners[c] = {Rational::exactly(triangle.vertices[c].s), Rational::exactly(triangle.vertices[c].t)};
      elements.push_back(plane_chart(surface, triangle.chart)->over(corners));
    }
    return certified_plane_entries(elements, functions).value();
  }
  [[nodiscard]] Outcome<EnclosedClusters> clusters(double tolerance, int refinements = 0) const {
    return enclosed_clusters({.surface = surface,
                              .triangulation = triangulation,
                              .level = level,
                              .functions = functions,
                              .far = ClusterTolerance(tolerance),
                              .near = Tolerance(near),
                              .refinements = refinements});
  }
  [[nodiscard]] std::size_t size() const { return triangulation.triangles.size() * functions.size(); }
};

std::vector<double> random_vector(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> x(size);
  for (double& each : x) each = std::uniform_real_distribution<double>(-1, 1)(random);
  return x;
}

/// Holds products and sizes against the entries, both proved.
void expect_enclosed(const Proved& d, double tolerance, double widest) {
  const CertifiedEntries dense = d.entries();
  const EnclosedClusters k = d.clusters(tolerance).value();
  const std::size_t n = d.size();
  const std::string where = d.surface.name + ", degree " + std::to_string(d.functions.degree());
  ASSERT_GT(k.far_pairs(), 0U) << where;
  for (const unsigned seed : {1U, 2U}) {
    const std::vector<double> x = random_vector(n, seed);
    const std::vector<BoundedDouble> y = k.product(x);
    std::vector<double> sizes_of_x;
    for (const double each : x) sizes_of_x.push_back(std::abs(each));
    const std::vector<double> sizes = k.sizes(sizes_of_x);
    for (std::size_t i = 0; i < n; ++i) {
      BoundedDouble exact = 0;
      BoundedDouble size = 0;
      for (std::size_t j = 0; j < n; ++j) {
        exact = exact + BoundedDouble(dense.entries(i, j), dense.radius(i, j)) * BoundedDouble::exactly(x[j]);
        size = size + BoundedDouble(std::abs(dense.entries(i, j)), dense.radius(i, j)) *
                          BoundedDouble::exactly(sizes_of_x[j]);
      }
      ASSERT_LE(std::abs(y[i].value() - exact.value()), y[i].error() + exact.error())
          << where << " row " << i;
      ASSERT_LE(y[i].error(), widest) << where << " row " << i;
      ASSERT_GE(sizes[i], size.value() - size.error()) << where << " row " << i;
    }
  }
}

TEST(EnclosedClusters, EncloseProductsOnPlaneCharts) {
  for (const int degree : {0, 2}) expect_enclosed(Proved(box(1, 1, 3), 1, degree), 1e-3, 1e-3 + 1e-10);
}

TEST(EnclosedClusters, EncloseProductsOnCurvedCharts) {
  expect_enclosed(Proved(ellipsoid(1, Rational(3, 2), 2), 2, 0), 1e-3, 1e-3 + 2e-4);
  expect_enclosed(Proved(two_piece(2), 2, 0), 1e-3, 1e-3 + 2e-4);
}

TEST(EnclosedClusters, KnowThatRowsOfClosedSurfacesSumToOne) {
  // Int G dS = pi at every point of the boundary of a convex body, and the functions sum to 1.
  const Proved d(ellipsoid(1, 1, 2), 2, 0);
  const EnclosedClusters k = d.clusters(1e-3).value();
  EXPECT_GT(k.far_pairs(), 0U);
  for (const BoundedDouble& sum : k.product(std::vector<double>(d.size(), 1.0))) {
    ASSERT_LE(std::abs(sum.value() - 1), sum.error());
    ASSERT_LE(sum.error(), 1.2e-3);
  }
}

TEST(EnclosedClusters, LeaveNoMoreOutOfARowThanTheySay) {
  const Proved d(box(1, 1, 3), 1, 1);
  const CertifiedEntries dense = d.entries();
  const EnclosedClusters k = d.clusters(1e-3).value();
  const std::size_t n = d.size();
  std::vector<double> left_out(n);
  std::vector<double> unit(n);
  for (std::size_t j = 0; j < n; ++j) {
    unit[j] = 1;
    const std::vector<BoundedDouble> column = k.product(unit);
    unit[j] = 0;
    for (std::size_t i = 0; i < n; ++i) left_out[i] += std::abs(column[i].value() - dense.entries(i, j));
  }
  double nearest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_LE(left_out[i], k.truncation()[i] + 1e-11) << "row " << i;
    nearest = std::max(nearest, left_out[i] / k.truncation()[i]);
  }
  EXPECT_GT(nearest, 0.01);  // a bound that says something
}

}  // namespace
}  // namespace radcert
