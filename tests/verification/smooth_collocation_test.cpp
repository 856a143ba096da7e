// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/claims/ac98/collocation/interpolation_bounds.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/ac98/surfaces/exact_plane.h"

namespace radcert::verification::ac98 {
namespace {

const PlanarTriangle& some_triangle() {
  static const PlanarTriangle triangle{PlanarPoint{Rational(1, 2), 3}, PlanarPoint{-1, Rational(2, 7)},
                                       PlanarPoint{4, 1}};
  return triangle;
}

ExactPolynomial linear(const Rational& a, const Rational& b, const Rational& c) {
  return ExactPolynomial(a) * ExactPolynomial::monomial(1, 0) +
         ExactPolynomial(b) * ExactPolynomial::monomial(0, 1) + c;
}

TEST(ExactPolynomial, IsARingWhoseTermsCancel) {
  const ExactPolynomial sum = linear(1, 1, 0);
  const ExactPolynomial difference = linear(1, -1, 0);
  const ExactPolynomial squares = ExactPolynomial::monomial(2, 0) - ExactPolynomial::monomial(0, 2);
  EXPECT_EQ((sum * difference - squares).size(), 0U);
  EXPECT_EQ((sum * difference).size(), 2U);
  EXPECT_EQ((squares.by_x() - ExactPolynomial(2) * ExactPolynomial::monomial(1, 0)).size(), 0U);
  EXPECT_EQ((squares.by_y() + ExactPolynomial(2) * ExactPolynomial::monomial(0, 1)).size(), 0U);
}

TEST(ExactPolynomial, HasDerivativesFromAllXToAllY) {
  const std::vector<ExactPolynomial> all = derivatives(ExactPolynomial::monomial(2, 3), 2);
  ASSERT_EQ(all.size(), 3U);
  const PlanarPoint p{2, 3};
  EXPECT_EQ(all[0](p), Rational(2 * 27));
  EXPECT_EQ(all[1](p), Rational(2 * 2 * 3 * 9));
  EXPECT_EQ(all[2](p), Rational(4 * 6 * 3));
}

TEST(Taylor, OfHighDegreeIsThePolynomialAndOfLowDegreeAgreesAtThePoint) {
  const ExactPolynomial f = ExactPolynomial::monomial(3, 1) + linear(2, -5, 1);
  const PlanarPoint about{Rational(1, 3), Rational(-2, 5)};
  EXPECT_EQ((taylor(f, about, 4) - f).size(), 0U);
  const ExactPolynomial rest = f - taylor(f, about, 2);
  for (int order = 0; order <= 2; ++order)
    for (const ExactPolynomial& d : derivatives(rest, order)) EXPECT_EQ(d(about), 0);
  EXPECT_NE(rest(PlanarPoint{1, 1}), 0);
}

TEST(Interpolant, ReproducesLinearFunctionsAndMeetsOthersAtTheNodes) {
  for (const Rational& alpha : {Rational(0), Rational(1, 6), Rational(3, 10)}) {
    const ExactPolynomial f = linear(Rational(2, 3), -7, 5);
    EXPECT_EQ((interpolant(some_triangle(), alpha, f) - f).size(), 0U);
    const ExactPolynomial g = ExactPolynomial::monomial(2, 3);
    for (const PlanarPoint& node : printed_rule(some_triangle(), alpha).points)
      EXPECT_EQ(interpolant(some_triangle(), alpha, g)(node), g(node));
  }
}

TEST(InterpolationError, IsTheRulesDefectForConstantPhi) {
  for (int a = 0; a <= 3; ++a) {
    const std::vector<PlanarPoint> points(some_triangle().begin(), some_triangle().end());
    EXPECT_EQ(interpolation_error(1, ExactPolynomial::monomial(a, 1), {some_triangle()}, Rational(1, 10)),
              -missed(printed_rule(some_triangle(), Rational(1, 10)), points, a, 1))
        << a;
  }
}

TEST(BoundedErrors, ScaleWithTheTriangle) {
  const std::vector<PlanarPoint> points{{0, 0}, {1, 0}, {0, 1}};
  const auto errors = [&](const Rational& h) {
    const std::vector<PlanarPoint> p = placed(points, h, {0, 0});
    return bounded_errors({{p[0], p[1], p[2]}}, p, 1);
  };
  const std::vector<BoundedError> unit = errors(1);
  const std::vector<BoundedError> half = errors(Rational(1, 2));
  // phi = 1, f = x^3, the seventh of the monomials: h^5 in the error, h^2 in the integral.
  constexpr std::size_t place = 6 * 10;
  EXPECT_EQ(half.at(place).error * 32, unit.at(place).error);
  EXPECT_EQ(half.at(place).bound * 4, unit.at(place).bound);
  EXPECT_EQ(unit.at(place).bound, Rational(1, 2) * 6);
  EXPECT_EQ(exceeding(unit, 0),
            Rational(std::count_if(unit.begin(), unit.end(),
                                   [](const BoundedError& each) { return each.error.sign() > 0; })));
}

TEST(CoordinateIntegrals, SumToTheOctantAndAgreeWithARule) {
  const BallPrecision precision(192);
  for (const int level : {0, 1, 3}) {
    Ball sum(0);
    for (const OctantTriangle& t : symmetric_octant(level))
      for (const Ball& each : coordinate_integrals(t)) sum += each;
    EXPECT_TRUE(overlaps(sum, Ball::pi() / Ball(2))) << sum.to_text();
    EXPECT_LT(sum.radius(), 1e-40);
  }
  // The midpoint of each of 4^6 equal parts, by barycentric coordinates (c/3, ...) / parts.
  const OctantTriangle t = symmetric_octant(1).at(2);
  std::array<double, 3> sums{};
  constexpr int parts = 64;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (const int turned : {0, 1}) {
        if (i + j + turned >= parts) continue;
        const double s = (i + (1 + turned) / 3.0) / parts;
        const double w = (j + (1 + turned) / 3.0) / parts;
        const std::array<double, 3> x{1 - s - w, s, w};
        Vector<double> e{0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k)
          e = e + x.at(k) * Vector<double>{t.corners.at(k).x.to_double(), t.corners.at(k).y.to_double(),
                                           t.corners.at(k).z.to_double()};
        const double density = std::pow(norm(e), -3) / 4 / (2.0 * parts * parts);
        for (std::size_t k = 0; k < 3; ++k) sums.at(k) += density * x.at(k);
      }
  const std::array<Ball, 3> exact = coordinate_integrals(t);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(sums.at(k), exact.at(k).to_double(), 2e-5) << k;
}

TEST(CoordinateIntegrals, FollowTheCornersHoweverTheyRun) {
  const BallPrecision precision(128);
  const OctantTriangle t = symmetric_octant(2).at(5);
  const OctantTriangle turned{{t.corners[1], t.corners[0], t.corners[2]}, t.upright};
  const std::array<Ball, 3> a = coordinate_integrals(t);
  const std::array<Ball, 3> b = coordinate_integrals(turned);
  EXPECT_TRUE(overlaps(a[0], b[1]) && overlaps(a[1], b[0]) && overlaps(a[2], b[2]));
}

TEST(OctantTriangulations, CoverTheOctantAndHaveAsManyUprightTriangles) {
  const BallPrecision precision(128);
  for (int level = 0; level <= 3; ++level) {
    const std::vector<OctantTriangle> symmetric = symmetric_octant(level);
    const long side = 1L << level;
    EXPECT_EQ(static_cast<long>(symmetric.size()), side * side);
    EXPECT_EQ(std::count_if(symmetric.begin(), symmetric.end(), [](const auto& t) { return t.upright; }),
              side * (side + 1) / 2);
    Ball sum(0);
    for (const OctantTriangle& t : upright_divided_octant(level))
      for (const Ball& each : coordinate_integrals(t)) sum += each;
    EXPECT_TRUE(overlaps(sum, Ball::pi() / Ball(2)));
  }
}

TEST(SphereCollocation, IsExactForConstantsAndForTheSumOfSquares) {
  const BallPrecision precision(192);
  for (const Rational& alpha : {Rational(0), Rational(1, 6), Rational(3, 10)}) {
    const SphereCollocation method(symmetric_octant(2), alpha);
    EXPECT_TRUE(method.mean([](const Vector<Ball>&) { return Ball(1); }).contains(1));
    const Ball third = method.mean([](const Vector<Ball>& q) { return q.x * q.x; });
    EXPECT_TRUE(third.contains(Rational(1, 3)));
    EXPECT_TRUE(method.mean([](const Vector<Ball>& q) { return q.y; }).contains(0));
    EXPECT_FALSE(method.mean([](const Vector<Ball>& q) { return power(q.x, 4); }).contains(Rational(1, 5)));
  }
}

}  // namespace
}  // namespace radcert::verification::ac98
