// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_couplings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "radcert/clusters/certified/interpolation_bounds.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/lagrange_basis.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

ClusterPairs of_leaves(ClusterPairs pairs) {
  for (std::size_t l = 0; l + 1 < pairs.far.size(); ++l) pairs.far[l].clear();
  return pairs;
}

/// The couplings between leaves, single elements, by default of a box.
struct Coupled {
  explicit Coupled(Surface s = box(1, 1, 3), int l = 1) : surface(std::move(s)), level(l) {}
  Surface surface;
  int level;
  Triangulation triangulation = triangulate(surface, level);
  ClusterTree tree = ClusterTree::make(triangulation, level, 0).value();
  LagrangeFunctions functions = lagrange_functions(inset_nodes(1, Rational(1, 6))).value();
  CouplingDemand demand{.share = 1e-4, .functions_size = 1.5, .largest_degree = 9};
  ClusterPairs pairs = of_leaves(
      divide_pairs(surface.charts, tree, ClusterPart(tree), demand, [this](std::size_t a, std::size_t b) {
        return a == b ? surface.charts[a].facts().flat_in().has_value()
                      : in_one_plane(surface.charts[a], surface.charts[b]);
      }));
  EnclosedTables tables{functions, StepFunctions(functions), 0, 9};
  EnclosedCouplings couplings{surface.charts, tree, pairs.far, tables};

  [[nodiscard]] std::vector<double> numbers() const {
    std::mt19937 random(9);
    std::vector<double> x(triangulation.triangles.size() * 3);
    for (double& each : x) each = std::uniform_real_distribution<double>(-1, 1)(random);
    return x;
  }
};

/// sum_n W_na D_n(x) for all a.
std::vector<Ball> functions_at(int degree, const Barycentric<Ball>& x) {
  const Matrix<double>& w = ModeTables::instance().interpolation(degree).modes_of_values;
  std::vector<Ball> modes(mode_count(degree));
  triangle_modes<Ball>(degree, x, modes);
  std::vector<Ball> values(modes.size());
  for (std::size_t a = 0; a < values.size(); ++a)
    for (std::size_t n = 0; n < modes.size(); ++n) values[a] += Ball(w(n, a)) * modes[n];
  return values;
}

ParameterPoint<Ball> parameters(const ParameterTriangle& triangle, const Barycentric<Ball>& x) {
  ParameterPoint<Ball> at;
  for (std::size_t i = 0; i < 3; ++i) {
    at.s += x.x[i] * Ball(triangle.vertices[i].s);
    at.t += x.x[i] * Ball(triangle.vertices[i].t);
  }
  return at;
}

/// Holds the rows of three leaves against their sums written out in balls of 128 bits.
void expect_enclosed(const Coupled& c) {
  const std::vector<ParameterTriangle>& leaves = c.tree.leaves();
  ASSERT_GT(c.pairs.far.back().size(), 100U);
  const std::vector<double> x = c.numbers();
  const std::vector<BoundedDouble> y = c.couplings.product(EnclosedCouplings::Density::functions, x);
  const LagrangeBasis<Ball> basis(c.functions);
  bool rounded = false;
  for (const std::size_t leaf : {std::size_t{0}, std::size_t{5}, leaves.size() - 1}) {
    const Chart& chart = c.surface.charts[leaves[leaf].chart];
    std::array<Ball, 3> exact;
    for (const FarPair& pair : c.pairs.far.back()) {
      if (pair.a != leaf && pair.b != leaf) continue;
      const std::size_t other = pair.a == leaf ? pair.b : pair.a;
      const Chart& from = c.surface.charts[leaves[other].chart];
      const int degree = pair.coupling.degree;
      const auto& nodes = exact_interpolation_nodes(degree);
      // The mean of f times each function over the other cluster.
      std::vector<Ball> weights(nodes.size());
      const TriangleRule<Ball> rule = conical_rule<Ball>(degree + 2, Grading::none);
      std::vector<Ball> at(3);
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        basis.values<Ball>(rule.points[q], at);
        Ball f = 0;
        for (std::size_t j = 0; j < 3; ++j) f += Ball(x[other * 3 + j]) * at[j];
        const std::vector<Ball> values = functions_at(degree, rule.points[q]);
        for (std::size_t b = 0; b < nodes.size(); ++b)
          weights[b] += Ball(2) * rule.weights[q] * f * values[b];
      }
      const Ball area(parameter_area(leaves[other]));
      for (std::size_t i = 0; i < 3; ++i) {
        const Barycentric<Rational>& node = c.functions.nodes()[i];
        const std::vector<Ball> at_row =
            functions_at(degree, {{Ball(node.x[0]), Ball(node.x[1]), Ball(node.x[2])}});
        for (std::size_t a = 0; a < nodes.size(); ++a) {
          const Frame<Ball> p = chart.in<Ball>().frame(
              parameters(leaves[leaf], barycentric_of<Ball>({Ball(nodes[a].s), Ball(nodes[a].t)})));
          for (std::size_t b = 0; b < nodes.size(); ++b) {
            const Frame<Ball> q = from.in<Ball>().frame(
                parameters(leaves[other], barycentric_of<Ball>({Ball(nodes[b].s), Ball(nodes[b].t)})));
            exact[i] += at_row[a] * weights[b] * area * area_element(q) *
                        geometric_kernel<Ball>(p.point, unit_normal(p), q.point, unit_normal(q));
          }
        }
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const BoundedDouble& found = y[leaf * 3 + i];
      const double difference = abs(exact[i] - Ball(found.value())).upper_double();
      EXPECT_LE(difference, found.error()) << leaf << " " << i;
      EXPECT_LE(found.error(), 1e-12);
      // More than the last rounding: what the sums over nodes are off by is in the error too.
      rounded = rounded || difference > 0x1p-52 * std::abs(found.value());
    }
  }
  EXPECT_TRUE(rounded);
}

TEST(EnclosedCouplings, EncloseTheSumsThatTheyStandForAndLittleElse) { expect_enclosed(Coupled()); }

TEST(EnclosedCouplings, EncloseTheSumsThatTheyStandForOnEllipsoids) {
  expect_enclosed(Coupled(ellipsoid(1, Rational(3, 2), 2), 2));
}

TEST(EnclosedCouplings, AreTheSameAtAnyScaleOrUnknown) {
  // About 2^254 the kernel leaves the range of doubles between some nodes and not between others; what is
  // unknown there, times the density 0, is no number.
  const Coupled one;
  struct Clusters {
    std::uint32_t target;
    std::uint32_t dark;
    std::uint32_t bright;
  };
  std::size_t known = 0;
  std::size_t unknown = 0;
  for (const Clusters& of : {Clusters{31, 2, 20}, Clusters{12, 36, 27}})
    for (const int degree : {1, 2}) {
      std::vector<std::vector<FarPair>> pairs(one.tree.levels());
      for (const std::uint32_t other : {of.dark, of.bright})
        pairs.back().push_back({.a = std::min(of.target, other),
                                .b = std::max(of.target, other),
                                .coupling = {.degree = degree}});
      std::vector<double> x(3 * one.triangulation.triangles.size(), 0.0);
      for (std::size_t j = 0; j < 3; ++j) x[3 * of.bright + j] = 1;
      const auto product_on = [&](const Surface& surface) {
        const ClusterTree tree = ClusterTree::make(triangulate(surface, one.level), one.level, 0).value();
        return EnclosedCouplings(surface.charts, tree, pairs, one.tables)
            .product(EnclosedCouplings::Density::functions, x);
      };
      const std::vector<BoundedDouble> here = product_on(one.surface);
      for (int step = 0; step < 96; ++step) {
        const double scale = std::ldexp(1 + step / 64.0, 254);
        const Rational unit = Rational::exactly(scale);
        const std::vector<BoundedDouble> there = product_on(box(unit, unit, Rational(3) * unit));
        for (std::size_t i = 3 * of.target; i < 3 * of.target + 3; ++i) {
          (std::isfinite(there[i].error()) ? known : unknown) += 1;
          if (!std::isfinite(there[i].error())) continue;
          EXPECT_LE(std::abs(here[i].value() - there[i].value()), here[i].error() + there[i].error())
              << "scale " << scale << ", target " << of.target << ", degree " << degree;
        }
      }
    }
  EXPECT_GT(known, 0U);
  EXPECT_GT(unknown, 0U);
}

TEST(EnclosedCouplings, HaveTheSameBitsForAnyNumberOfThreads) {
  const Coupled c;
  const auto bits_on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    std::vector<double> bits;
    for (const BoundedDouble& each :
         c.couplings.product(EnclosedCouplings::Density::step_functions, c.numbers())) {
      bits.push_back(each.value());
      bits.push_back(each.error());
    }
    return bits;
  };
  const std::vector<double> one = bits_on(1);
  EXPECT_EQ(one, bits_on(2));
  EXPECT_EQ(one, bits_on(3));
}

}  // namespace
}  // namespace radcert
