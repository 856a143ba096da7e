// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/certified_entries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "radcert/closed_form/plane_element.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/scalar/ball.h"
#include "tests/collocation/certified_samples.h"

namespace radcert {
namespace {

using Triangles = std::vector<ExactTriangle>;

/// The sides of [0, edge]^3, each cut into 2 parts^2 triangles, normals inwards.
Triangles cube(const Rational& edge, int parts) {
  Triangles triangles;
  const Rational step = edge / Rational(parts);
  const auto corner = [&](int axis, bool far, int a, int b) {
    const std::array<Rational, 3> x{far ? edge : Rational(0), Rational(a) * step, Rational(b) * step};
    const auto at = [&](int i) { return x[static_cast<std::size_t>((i - axis + 3) % 3)]; };
    return Vector<Rational>{at(0), at(1), at(2)};
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true})
      for (int a = 0; a < parts; ++a)
        for (int b = 0; b < parts; ++b) {
          ExactTriangle lower{corner(axis, far, a, b), corner(axis, far, a + 1, b),
                              corner(axis, far, a, b + 1)};
          ExactTriangle upper{corner(axis, far, a + 1, b + 1), corner(axis, far, a, b + 1),
                              corner(axis, far, a + 1, b)};
          for (ExactTriangle triangle : {lower, upper}) {
            if (far) std::swap(triangle[1], triangle[2]);
            triangles.push_back(triangle);
          }
        }
  return triangles;
}

/// A tetrahedron whose sides are in no special position, normals inwards.
Triangles oblique_tetrahedron() {
  const Vector<Rational> a{Rational(0), Rational(1, 3), Rational(0)};
  const Vector<Rational> b{Rational(1), Rational(0), Rational(1, 7)};
  const Vector<Rational> c{Rational(1, 5), Rational(1), Rational(0)};
  const Vector<Rational> d{Rational(1, 2), Rational(1, 2), Rational(4, 5)};
  return {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
}

std::vector<double> ones(const Triangles& triangles, const LagrangeFunctions& functions) {
  return std::vector<double>(triangles.size() * functions.size(), 1.0);
}

/// What is left of 1 in every row, and the sum of its radii.
void expect_rows_contain_one(const CertifiedEntries& matrix, double widest) {
  for (std::size_t i = 0; i < matrix.entries.rows(); ++i) {
    Rational sum = 0;
    Rational radius = 0;
    for (std::size_t j = 0; j < matrix.entries.columns(); ++j) {
      sum += Rational::exactly(matrix.entries(i, j));
      radius += Rational::exactly(matrix.radius(i, j));
    }
    EXPECT_LE(abs(sum - Rational(1)), radius) << "row " << i << ": " << (sum - Rational(1)).to_double();
    EXPECT_LE(radius.to_double(), widest) << "row " << i;
  }
}

TEST(CertifiedEntries, RowsOfEnclosuresContainOne) {
  for (const int degree : {0, 1}) {
    const LagrangeFunctions functions = inset_functions(degree, Rational(1, 6));
    for (const Triangles& triangles : {cube(1, 1), cube(Rational(1, 3), 2), oblique_tetrahedron()})
      expect_rows_contain_one(certified_entries(triangles, functions, ones(triangles, functions)).value(),
                              1e-13);
  }
  const LagrangeFunctions functions = inset_functions(2, Rational(1, 6));
  const Triangles triangles = oblique_tetrahedron();
  expect_rows_contain_one(certified_entries(triangles, functions, ones(triangles, functions)).value(), 6e-13);
}

TEST(CertifiedEntries, RadiiAreThoseOfTheIntegrals) {
  // The largest value of a linear function is at a corner; the sum of the entries of an element is its Int
  // |G| rho/pi.
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  std::vector<Rational> at_corner(3);
  functions.values({{1, 0, 0}}, at_corner);
  const double largest = std::max({abs(at_corner[0]), abs(at_corner[1]), abs(at_corner[2])}).to_double();
  const Triangles triangles = oblique_tetrahedron();
  std::vector<double> reflectivity = ones(triangles, functions);
  for (std::size_t i = 0; i < reflectivity.size(); ++i) reflectivity[i] = static_cast<double>(i) - 2;
  const CertifiedEntries matrix = certified_entries(triangles, functions, reflectivity).value();
  for (std::size_t i = 0; i < matrix.entries.rows(); ++i)
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      double sum = 0;
      for (std::size_t j = 3 * k; j < 3 * k + 3; ++j) sum += matrix.entries(i, j);
      const double bound = PlaneElement::usual_accuracy * largest * std::abs(sum);
      for (std::size_t j = 3 * k; j < 3 * k + 3; ++j) {
        EXPECT_GE(matrix.radius(i, j), bound * (1 - 1e-12)) << i << " " << j;
        EXPECT_LE(matrix.radius(i, j), 1.1 * bound + 1e-15 * std::abs(matrix.entries(i, j)) + 1e-300)
            << i << " " << j;
      }
    }
}

TEST(CertifiedEntries, EncloseTheClosedFormInBalls) {
  const BallPrecision scope(128);
  std::mt19937_64 random(51);
  for (const int degree : {0, 1, 2, 3}) {
    const LagrangeFunctions functions = inset_functions(degree, Rational(1, 7));
    const std::size_t p = functions.size();
    for (const Triangles& triangles : {cube(1, 1), oblique_tetrahedron()}) {
      std::vector<double> reflectivity = ones(triangles, functions);
      for (double& rho : reflectivity) rho = static_cast<double>(random() >> 11U) * 0x1p-53;
      const CertifiedEntries matrix = certified_entries(triangles, functions, reflectivity).value();
      for (int trial = 0; trial < 6; ++trial) {
        const std::size_t row = random() % (triangles.size() * p);
        const std::size_t k = random() % triangles.size();
        const ExactTriangle& from = triangles[row / p];
        const Barycentric<Rational>& q = functions.nodes()[row % p];
        const Vector<Rational> node = q.x[0] * from[0] + q.x[1] * from[1] + q.x[2] * from[2];
        const Vector<Rational> normal = cross(from[1] - from[0], from[2] - from[0]);
        const ExactTriangle& to = triangles[k];
        const PlanePolygon polygon =
            plane_polygon(to[0], to[1] - to[0], to[2] - to[0], {{{0, 0}, {1, 0}, {0, 1}}}).value();
        const std::vector<Ball> moments = point_to_polygon_moments<Ball>(node, normal, polygon, degree);
        // The coefficients of l_j by its values, which the entries do not use: the moments of the l_j solve
        // sum_j q_j^m moment(l_j) = moment(m) for every monomial m.
        for (int a = 0; a <= degree; ++a)
          for (int b = 0; a + b <= degree; ++b) {
            Ball sum = 0;
            Ball allowed = 0;
            for (std::size_t j = 0; j < p; ++j) {
              const Barycentric<Rational>& at = functions.nodes()[j];
              const Ball weight(power(at.x[1], a) * power(at.x[2], b));
              sum += weight * Ball(matrix.entries(row, k * p + j));
              allowed += abs(weight) * Ball(matrix.radius(row, k * p + j));
            }
            const Ball truth =
                Ball(reflectivity[row]) / Ball::pi() * moments[PlanePolynomial<Rational>::place(a, b)];
            EXPECT_TRUE(certainly_at_most(abs(sum - truth), allowed + Ball(1e-30)))
                << "degree " << degree << ", row " << row << ", element " << k << ", s^" << a << " t^" << b
                << ": " << (sum - truth).to_text() << " beyond " << allowed.to_text();
            EXPECT_LT(allowed.to_double(), degree < 3 ? 2e-13 : 2e-12);
          }
      }
    }
  }
}

TEST(CertifiedEntries, VanishInTheNodesOwnPlane) {
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  const Triangles triangles = cube(1, 1);
  const CertifiedEntries matrix = certified_entries(triangles, functions, ones(triangles, functions)).value();
  for (std::size_t side = 0; side < 6; ++side)
    for (std::size_t i = 6 * side; i < 6 * side + 6; ++i)
      for (std::size_t j = 6 * side; j < 6 * side + 6; ++j) {
        EXPECT_EQ(matrix.entries(i, j), 0);
        EXPECT_LE(matrix.radius(i, j), 1e-300);
      }
}

TEST(CertifiedEntries, AreTheSameForEveryNumberOfThreads) {
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  const Triangles triangles = cube(1, 1);
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return numbers_of(certified_entries(triangles, functions, ones(triangles, functions)).value());
  };
  EXPECT_EQ(with_threads(1), with_threads(2));
}

TEST(CertifiedEntries, RefusesNodesThatAreDoublesInNoUnit) {
  Triangles triangles = oblique_tetrahedron();
  const Rational far = Rational(1) / Rational(1000003) / Rational(1000033) / Rational(1000037);
  for (ExactTriangle& triangle : triangles)
    for (Vector<Rational>& corner : triangle) corner = {corner.x + far * corner.y, corner.y, corner.z};
  const LagrangeFunctions functions = inset_functions(1, Rational(1, 6));
  EXPECT_FALSE(certified_entries(triangles, functions, ones(triangles, functions)).has_value());
}

// The radius rests on Int G being the sum of the integrals.
TEST(CertifiedEntries, RefusesFunctionsThatDoNotHaveTheSumOne) {
  const PolynomialSpace space{.degree = 1, .functions = {{1, 0, 0}, {0, 1, 0}}};
  const auto node = [](const Rational& s) {
    return Barycentric<Rational>{1 - s - Rational(1, 4), s, Rational(1, 4)};
  };
  const LagrangeFunctions functions =
      lagrange_functions(space, std::vector{node(Rational(1, 4)), node(Rational(1, 2))}).value();
  const Triangles triangles = cube(1, 1);
  EXPECT_FALSE(certified_entries(triangles, functions, ones(triangles, functions)).has_value());
}

/// Accuracy times max |l_j|: what integrals are off by, over Int |G|.
double relative_error(const IntegralErrors& errors) {
  return PlaneElement::usual_accuracy * errors.largest_value();
}

TEST(IntegralErrors, CountWhatTheSumOfTheIntegralsIsOffBy) {
  // Nodes so near to each other that functions are as large as is allowed. Int G = 1 is the sum of the exact
  // integrals, of which each is found too small by as much as its error may be.
  const Rational apart(1, 2000000000000);
  const Rational third(1, 3);
  std::vector<Barycentric<Rational>> nodes;
  for (std::size_t i = 0; i < 3; ++i) {
    Barycentric<Rational> node{third - apart, third - apart, third - apart};
    node.x[i] = third + Rational(2) * apart;
    nodes.push_back(node);
  }
  const IntegralErrors errors = IntegralErrors::of(lagrange_functions(nodes).value()).value();
  const double error = relative_error(errors);
  ASSERT_GT(error, 1e-3);
  const std::array<double, 3> found{0.5 - error, 0.375 - error, 0.125 - error};
  EXPECT_GE(errors.bound(found), error * (1 - 1e-12));
  EXPECT_LE(errors.bound(found), error * (1 + 1e-9));
}

TEST(IntegralErrors, CountTheRoundingsOfTheSumOfTheIntegrals) {
  // 1 and -1 cancel, and what is between them is lost in the sum.
  const IntegralErrors errors = IntegralErrors::of(inset_functions(1, Rational(1, 6))).value();
  const double between = 0.99 * 0x1p-53;
  EXPECT_GE(errors.bound(std::array{1.0, between, -1.0}), relative_error(errors) * between);
}

TEST(IntegralErrors, CountWhatUnderflows) {
  // An integral that was rounded to zero.
  const IntegralErrors errors = IntegralErrors::of(inset_functions(1, Rational(1, 6))).value();
  EXPECT_GE(errors.bound(std::array{0.0, 0.0, 0.0}), std::numeric_limits<double>::denorm_min());
}

TEST(CertifiedEntries, RefusesOtherNumbersOfReflectivitiesAndDegenerateElements) {
  const LagrangeFunctions functions = inset_functions(0, Rational(0));
  Triangles triangles = cube(1, 1);
  EXPECT_THROW(static_cast<void>(certified_entries(triangles, functions, std::vector<double>(3, 1.0))),
               ContractViolation);
  std::vector<double> reflectivity = ones(triangles, functions);
  reflectivity[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(certified_entries(triangles, functions, reflectivity)), ContractViolation);
  triangles[0][1] = triangles[0][0];
  EXPECT_THROW(static_cast<void>(certified_entries(triangles, functions, ones(triangles, functions))),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
