// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/nodal_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/collocation/nodes.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/study/problems.h"

namespace radcert {
namespace {

using testing::by_piece;
using testing::everywhere;

/// P_n f for a function of the point.
struct Interpolated {
  Surface surface;
  Triangulation triangulation;
  InsetBasis<double> basis;
  std::vector<double> values;

  Interpolated(Surface s, int level, int degree, double inset, double (*f)(const Vector<double>&))
      : surface(std::move(s)), triangulation(triangulate(surface, level)), basis(degree, inset) {
    for (const CollocationPoint<double>& node : collocation_nodes<double>(surface, triangulation, basis))
      values.push_back(f(node.point));
  }
  NodalFunction function() const { return {surface, triangulation, basis, values}; }
};

double one(const Vector<double>&) { return 1; }
double z(const Vector<double>& p) { return p.z; }
double quadratic(const Vector<double>& p) { return p.x * p.x - 2 * p.x * p.y + p.z; }

TEST(NodalFunction, TakesItsValuesAtTheNodes) {
  const Interpolated u(box(1, 2, 5), 1, 2, 0.125, quadratic);
  const std::vector<Barycentric<double>> q = u.basis.nodes();
  for (std::size_t k = 0; k < u.triangulation.triangles.size(); ++k)
    for (std::size_t j = 0; j < q.size(); ++j)
      EXPECT_NEAR(u.function().at(k, q[j]), u.values[k * q.size() + j], 2e-14);
}

TEST(UniformError, VanishesForWhatTheBasisReproduces) {
  const Interpolated u(box(1, 2, 5), 1, 2, 0.125, quadratic);
  const std::optional<Approximation> error =
      uniform_error(u.function().computed(), everywhere("x^2 - 2*x*y + z"));
  ASSERT_TRUE(error);
  EXPECT_LT(error->value, 1e-13);
  EXPECT_FALSE(error->guaranteed);
  EXPECT_FALSE(error->has_radius());
}

TEST(UniformError, IsTheLargestDifferenceCornersIncluded) {
  // A constant on each triangle, the value of z at the centroid: on a wall of the unit cube the farthest
  // corner is 2/3 away.
  const Interpolated u(cube(), 0, 0, 0, z);
  EXPECT_NEAR(uniform_error(u.function().computed(), everywhere("z"))->value, 2.0 / 3, 1e-15);
  // On one piece alone, 5 too much.
  EXPECT_NEAR(uniform_error(u.function().computed(), by_piece({{"*", "z"}, {"floor", "z + 5"}}))->value, 5,
              1e-15);
}

TEST(UniformError, SeesEveryCornerOfTheDomain) {
  // Differences that are 1 at one corner and smaller everywhere else; (1,0) and (0,1) are corners of one
  // triangle each.
  const Interpolated u(two_piece(2), 0, 1, 0.125, one);
  for (const char* bump : {"1 + x*y", "1 + (1-x)*y", "1 + x*(1-y)", "1 + (1-x)*(1-y)"})
    for (const char* piece : {"lower", "upper"})
      EXPECT_NEAR(uniform_error(u.function().computed(), by_piece({{piece, bump}, {"*", "1"}}))->value, 1,
                  1e-14)
          << bump;
}

TEST(UniformError, IsNothingWhereTheSolutionIsNotFinite) {
  // 1/x is finite at every node and not on the side x = 0 that the sample includes.
  const Interpolated u(two_piece(2), 0, 1, 0.125, one);
  EXPECT_EQ(uniform_error(u.function().computed(), everywhere("1/x")), std::nullopt);
  EXPECT_EQ(uniform_error(u.function().computed(), everywhere("sqrt(x - 1/16)")), std::nullopt);
}

TEST(PieceMeans, OfOneAreOneAndNameThePiecesInOrder) {
  for (const Surface& surface : {cube(), sphere(), two_piece(Rational(3, 2))}) {
    const Interpolated u(surface, 1, 2, 0.1, one);
    const auto means = piece_means(u.function().computed(), nodal_mean_order);
    ASSERT_EQ(means.size(), surface.piece_names().size());
    for (std::size_t i = 0; i < means.size(); ++i) {
      EXPECT_EQ(means[i].first, surface.piece_names()[i]);
      EXPECT_NEAR(means[i].second.value, 1, 1e-14);
    }
  }
}

TEST(PieceMeans, AreTheCentroidsOfTheFacesForACoordinate) {
  const Interpolated u(box(1, 2, 5), 1, 1, 0.1, z);
  for (const auto& [piece, mean] : piece_means(u.function().computed(), nodal_mean_order))
    EXPECT_NEAR(mean.value, piece == "floor" ? 0 : piece == "ceiling" ? 5 : 2.5, 1e-14) << piece;
}

TEST(PieceMeans, WeighByAreaAndNotByParameters) {
  // The octant's centroid has z = 1/2; by parameters it would be another mean. Degree 8 follows z closely.
  Surface octant = sphere();
  octant.charts = {Chart(octant.charts.front())};
  octant.diagonals.resize(1);
  const Interpolated u(octant, 2, 8, 0.05, z);
  EXPECT_NEAR(piece_means(u.function().computed(), nodal_mean_order)[0].second.value, 0.5, 1e-9);
}

}  // namespace
}  // namespace radcert
