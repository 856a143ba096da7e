// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/coupling_degree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "radcert/clusters/mode_tables.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

/// Points of a cluster for a test, in the frame of the surface.
struct TestPoints {
  std::vector<Barycentric<double>> x;
  ClusterPoints points;

  TestPoints(const Chart& chart, const ParameterTriangle& triangle, std::vector<Barycentric<double>> at)
      : x(std::move(at)) {
    points.add(x.size());
    points.place(0, chart, triangle, x);
  }
  double kernel(std::size_t i, const TestPoints& other, std::size_t j) const {
    return geometric_kernel<double>(points.point(i), points.normal(i), other.points.point(j),
                                    other.points.normal(j));
  }
};

/// The Lagrange functions of a degree at points.
std::vector<std::vector<double>> lagrange_values(int degree, const std::vector<Barycentric<double>>& points) {
  const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
  const std::size_t k = interpolation.nodes.size();
  std::vector<std::vector<double>> values;
  std::vector<double> modes(k);
  for (const Barycentric<double>& x : points) {
    triangle_modes<double>(degree, x, modes);
    std::vector<double>& at = values.emplace_back(k);
    for (std::size_t a = 0; a < k; ++a)
      for (std::size_t n = 0; n < k; ++n) at[a] += modes[n] * interpolation.modes_of_values(n, a);
  }
  return values;
}

/// max over points P of a, corners and sides among them, of Int_b |G - I_p G| dS / pi by a rule.
double interpolation_error(const Surface& surface, const ParameterTriangle& a, const ParameterTriangle& b,
                           int degree) {
  std::vector<Barycentric<double>> targets;
  constexpr int lattice = 6;
  for (int i = 0; i <= lattice; ++i)
    for (int j = 0; i + j <= lattice; ++j)
      targets.push_back({{double(i) / lattice, double(j) / lattice, double(lattice - i - j) / lattice}});
  const TriangleRule<double> rule = conical_rule<double>(12, Grading::none);
  const std::vector<Barycentric<double>>& nodes = ModeTables::instance().interpolation(degree).nodes;
  const TestPoints p(surface.charts[a.chart], a, targets);
  const TestPoints q(surface.charts[b.chart], b, rule.points);
  const TestPoints at_a(surface.charts[a.chart], a, nodes);
  const TestPoints at_b(surface.charts[b.chart], b, nodes);
  const auto in_a = lagrange_values(degree, targets);
  const auto in_b = lagrange_values(degree, rule.points);
  double largest = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    // The weights of the nodes of b, seen from P.
    std::vector<double> weights(nodes.size());
    for (std::size_t m = 0; m < nodes.size(); ++m) {
      for (std::size_t n = 0; n < nodes.size(); ++n) weights[m] += in_a[i][n] * at_a.kernel(n, at_b, m);
      weights[m] *= at_b.points.weight(m);
    }
    double error = 0;
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
      double interpolant = 0;
      for (std::size_t m = 0; m < nodes.size(); ++m) interpolant += weights[m] * in_b[j][m];
      error += 2 * rule.weights[j] * std::abs(p.kernel(i, q, j) * q.points.weight(j) - interpolant);
    }
    largest = std::max(largest, error / std::numbers::pi);
  }
  return largest;
}

TEST(CouplingDegree, EstimatesWhatInterpolationLeavesOut) {
  const ModeSizes everywhere;
  for (const Surface& surface :
       {cube(), ellipsoid(1, Rational(3, 2), 2), ellipsoid(1, 2, 5), cylinder(1, 2)}) {
    const std::vector<ParameterTriangle> clusters = triangulate(surface, 2).triangles;
    const ClusterOutlines outlines(surface.charts, clusters);
    for (const double share : {1e-5, 1e-8, 1e-11}) {
      const CouplingDemand demand{.share = share, .functions_size = 1, .largest_degree = 20};
      CouplingLook look(outlines, demand, everywhere);
      std::size_t coupled = 0;
      double errors = 0;
      double estimates = 0;
      for (std::size_t a = 0; a < clusters.size(); a += 9)
        for (std::size_t b = a + 1; b < clusters.size(); b += 11) {
          if (in_one_plane(outlines.chart(a), outlines.chart(b))) continue;
          const auto found = look(a, b);
          if (!found) continue;
          ++coupled;
          EXPECT_LE(std::max(found->error_a, found->error_b), share);
          const double error_a = interpolation_error(surface, clusters[a], clusters[b], found->degree);
          const double error_b = interpolation_error(surface, clusters[b], clusters[a], found->degree);
          constexpr double rounding = 1e-15;
          constexpr double factor_of_one = 4;
          EXPECT_LE(error_a, factor_of_one * found->error_a + rounding)
              << surface.name << " " << a << " " << b << " degree " << found->degree;
          EXPECT_LE(error_b, factor_of_one * found->error_b + rounding)
              << surface.name << " " << a << " " << b << " degree " << found->degree;
          errors += error_a + error_b;
          estimates += found->error_a + found->error_b;
        }
      EXPECT_GT(coupled, 2U) << surface.name << " " << share;
      EXPECT_LE(errors, estimates) << surface.name << " " << share;
      EXPECT_GE(errors, 0.02 * estimates) << surface.name << " " << share;
    }
  }
}

TEST(CouplingDegree, IsNoneForClustersThatTouch) {
  const Surface surface = ellipsoid(1, Rational(3, 2), 2);
  const std::vector<ParameterTriangle> clusters = triangulate(surface, 3).triangles;
  const ClusterOutlines outlines(surface.charts, clusters);
  const CouplingDemand demand{.share = 1e-6, .functions_size = 1, .largest_degree = 20};
  const ModeSizes everywhere;
  CouplingLook look(outlines, demand, everywhere);
  for (std::size_t parent = 0; parent < clusters.size(); parent += 4)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_FALSE(look(parent + c, parent + 3));
}

TEST(CouplingDegree, GrowsWithTheAccuracy) {
  const Surface surface = cube();
  const std::vector<ParameterTriangle> clusters = triangulate(surface, 2).triangles;
  const ClusterOutlines outlines(surface.charts, clusters);
  int before = -1;
  for (const double share : {1e-4, 1e-7, 1e-10}) {
    const CouplingDemand demand{.share = share, .functions_size = 1, .largest_degree = 20};
    const ModeSizes everywhere;
    const auto found = CouplingLook(outlines, demand, everywhere)(0, 33);
    ASSERT_TRUE(found);
    EXPECT_GT(found->degree, before);
    before = found->degree;
  }
}

}  // namespace
}  // namespace radcert
