// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/mode_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "radcert/clusters/mode_products.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/pack.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {
namespace {

Barycentric<double> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  double a = uniform(random);
  double b = uniform(random);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return {{a, b, 1 - a - b}};
}

TEST(TriangleModes, AreOrthonormal) {
  constexpr int degree = 20;
  const std::size_t count = mode_count(degree);
  const TriangleRule<long double> rule = [] {
    // The rule in double, whose roundings bound what can be seen.
    const TriangleRule<double> in_double = conical_rule<double>(degree + 1, Grading::none);
    TriangleRule<long double> result;
    for (std::size_t q = 0; q < in_double.points.size(); ++q) {
      const auto& x = in_double.points[q].x;
      result.points.push_back({{x[0], x[1], x[2]}});
      result.weights.push_back(2 * in_double.weights[q]);
    }
    return result;
  }();
  std::vector<long double> products(count * count);
  std::vector<long double> modes(count);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    triangle_modes<long double>(degree, rule.points[q], modes);
    for (std::size_t n = 0; n < count; ++n)
      for (std::size_t m = 0; m <= n; ++m) products[n * count + m] += rule.weights[q] * modes[n] * modes[m];
  }
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t m = 0; m <= n; ++m)
      EXPECT_NEAR(static_cast<double>(products[n * count + m]), n == m ? 1 : 0, 2e-12) << n << " " << m;
}

TEST(TriangleModes, SumTheirSquaresToTheCubeOfTheDegreePlusOneAtTheVertices) {
  std::mt19937 random(7);
  std::vector<double> modes(mode_count(20));
  const auto square_sum = [&modes](const Barycentric<double>& x, std::size_t m) {
    triangle_modes<double>(20, x, modes);
    double sum = 0;
    for (std::size_t i = 0; i <= m; ++i) sum += modes[m * (m + 1) / 2 + i] * modes[m * (m + 1) / 2 + i];
    return sum;
  };
  for (std::size_t m = 0; m <= 20; ++m) {
    const double cube = std::pow(double(m + 1), 3);
    for (const Barycentric<double>& vertex :
         {Barycentric<double>{{1, 0, 0}}, Barycentric<double>{{0, 1, 0}}, Barycentric<double>{{0, 0, 1}}})
      EXPECT_NEAR(square_sum(vertex, m) / cube, 1, 1e-11) << m;
    for (int k = 0; k < 200; ++k) EXPECT_LE(square_sum(random_point(random), m), cube * (1 + 1e-11)) << m;
  }
}

TEST(ModeTables, RebuildPolynomialsFromTheirValuesAtTheNodes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int degree = 0; degree <= largest_mode_degree; ++degree) {
    const ModeInterpolation& interpolation = ModeTables::instance().interpolation(degree);
    const std::size_t k = interpolation.nodes.size();
    std::vector<double> modes(k);
    for (double& mode : modes) mode = uniform(random);
    std::vector<double> at(k);
    std::vector<double> found(interpolation.modes_of_values.rows());
    for (std::size_t a = 0; a < k; ++a) {
      triangle_modes<double>(degree, interpolation.nodes[a], at);
      double value = 0;
      for (std::size_t n = 0; n < k; ++n) value += modes[n] * at[n];
      for (std::size_t n = 0; n < k; ++n) {
        found[n] += interpolation.modes_of_values(n, a) * value;
        EXPECT_EQ(interpolation.modes_of_values(n, a), interpolation.values_of_modes_transposed(a, n));
      }
    }
    for (std::size_t n = 0; n < k; ++n) EXPECT_NEAR(found[n], modes[n], 1e-12) << degree << " " << n;
  }
}

TEST(ModeTables, TakeModesOfATriangleToThoseOfItsChildren) {
  std::mt19937 random(2);
  const Triangulation coarse = triangulate(sphere(), 0);
  const Triangulation fine = triangulate(sphere(), 1);
  const ParameterTriangle& parent = coarse.triangles[0];
  const std::size_t modes = mode_count(largest_mode_degree);
  std::vector<double> in_parent(modes);
  std::vector<double> in_child(modes);
  for (std::size_t c = 0; c < 4; ++c)
    for (int k = 0; k < 20; ++k) {
      const Barycentric<double> y = random_point(random);
      const ParameterPoint<double> at = fine.triangles[c].at(y.x);
      // Octants have the corners (0,0), (1,0), (0,1).
      const Barycentric<double> x{{1 - at.s - at.t, at.s, at.t}};
      ASSERT_EQ(parent.vertices[1].s, 1);
      triangle_modes<double>(largest_mode_degree, x, in_parent);
      triangle_modes<double>(largest_mode_degree, y, in_child);
      for (std::size_t n = 0; n < modes; ++n) {
        double down = 0;
        double up = 0;
        for (std::size_t m = 0; m < modes; ++m) {
          down += ModeTables::instance().to_child(c)(m, n) * in_child[m];
          up += ModeTables::instance().to_parent(c)(n, m) * in_child[m];
        }
        EXPECT_NEAR(down, in_parent[n], 2e-11) << c << " " << n;
        EXPECT_NEAR(up, in_parent[n], 2e-11) << c << " " << n;
      }
    }
}

TEST(LeafTables, IntegrateBasisFunctionsAgainstModesAndTakeModesToNodes) {
  for (const int degree : {0, 1, 2, 5, 8}) {
    const InsetBasis<double> inset(degree, 0.1);
    const TriangleBasis<double> basis(inset);
    constexpr int most = 7;
    for (const int refinements : {0, 1, 2}) {
      const LeafTables leaf(basis, refinements, most);
      const std::size_t elements = leaf.unknowns / basis.size();
      // A polynomial that the basis reproduces has the moments of itself: its modes.
      std::vector<double> modes(mode_count(most));
      for (int reproduced = 0; reproduced <= std::min(degree, most); ++reproduced) {
        const std::size_t n = mode_count(reproduced) - 1;
        for (std::size_t m = 0; m < mode_count(most); ++m) {
          double moment = 0;
          for (std::size_t i = 0; i < leaf.unknowns; ++i) moment += leaf.moments(m, i) * leaf.values(i, n);
          EXPECT_NEAR(moment, m == n ? 1 : 0, 1e-12) << degree << " " << refinements << " " << n << " " << m;
        }
      }
      double sizes = 0;
      for (std::size_t i = 0; i < leaf.unknowns; ++i) {
        EXPECT_GE(leaf.absolute_moments(0, i) * (1 + 1e-3), std::abs(leaf.moments(0, i)));
        sizes += leaf.absolute_moments(0, i);
      }
      EXPECT_GE(sizes, 1 - 1e-3);
      EXPECT_LE(sizes, size_of_functions(basis) * (1 + 1e-12));
      EXPECT_EQ(elements, std::size_t{1} << (2U * static_cast<unsigned>(refinements)));
    }
  }
}

TEST(ModeProduct, HasTheSameBitsForOneVectorAsForMany) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix<double> a(24, 21);
  for (std::size_t j = 0; j < 21; ++j)
    for (double& entry : a.column(j)) entry = uniform(random);
  constexpr std::size_t count = 7;
  std::vector<std::vector<double>> x(count, std::vector<double>(21));
  std::vector<std::vector<double>> together(count, std::vector<double>(24, 0.5));
  std::vector<const double*> from;
  std::vector<double*> to;
  for (std::size_t c = 0; c < count; ++c) {
    for (double& entry : x[c]) entry = uniform(random);
    from.push_back(x[c].data());
    to.push_back(together[c].data());
  }
  add_mode_product(a, 16, 20, from, to);
  for (std::size_t c = 0; c < count; ++c) {
    std::vector<double> alone(24, 0.5);
    double* place = alone.data();
    add_mode_product(a, 16, 20, std::span(&from[c], 1), std::span(&place, 1));
    EXPECT_EQ(alone, together[c]);
    for (std::size_t i = 0; i < 24; ++i) {
      double expected = 0.5;
      for (std::size_t j = 0; j < 20 && i < 16; ++j) expected = std::fma(a(i, j), x[c][j], expected);
      EXPECT_EQ(alone[i], expected);
    }
  }
}

}  // namespace
}  // namespace radcert
