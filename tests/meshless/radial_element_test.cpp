// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/radial_element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "radcert/expression/parse.h"
#include "tests/laws/meshless_laws.h"

namespace radcert {
namespace {

Vector<Ball> in_balls(const Vector<Rational>& v) { return {Ball(v.x), Ball(v.y), Ball(v.z)}; }
Site<Ball> in_balls(const Site<Rational>& p) { return {in_balls(p.point), in_balls(p.normal)}; }

std::vector<Site<Ball>> in_balls(const std::vector<Site<Rational>>& sites) {
  std::vector<Site<Ball>> all;
  for (const Site<Rational>& site : sites) all.push_back(in_balls(site));
  return all;
}

TEST(MotherFunction, SplineHasItsExactValues) {
  EXPECT_EQ(spline_bell(Rational(0)), Rational(1));
  EXPECT_EQ(spline_bell(Rational(1, 2)), Rational(1, 2));
  EXPECT_EQ(spline_bell(Rational(1, 3)), Rational(20, 27));
  EXPECT_EQ(spline_bell(Rational(1)), Rational(0));
  EXPECT_EQ(spline_bell(Rational(3, 2)), Rational(0));
  for (int k = 0; k <= 64; ++k) {
    const Rational r(k, 64);
    EXPECT_EQ(spline_bell(r), Rational(2) * r * r * r - Rational(3) * r * r + Rational(1));
  }
}

TEST(MotherFunction, SplineInBallsHoldsBothBranches) {
  for (int k = 0; k < 128; ++k) {
    const Ball r = hull(Ball(Rational(k, 64)), Ball(Rational(k + 3, 64)));
    const Ball value = spline_bell(r);
    if (k <= 56) {
      EXPECT_GT(value.lower_double(), 0) << k;
    }
    for (int j = 0; j <= 3; ++j) EXPECT_TRUE(value.contains(spline_bell(Rational(k + j, 64)))) << k;
  }
}

TEST(MotherFunction, GaussianHasItsExactValues) {
  EXPECT_TRUE(gaussian_bell(Ball(0)).contains(1.0));
  // G(1)^2 = 1/e, G(2) = 1/e^2
  EXPECT_TRUE((power(gaussian_bell(Ball(1)), 2) * exp(Ball(1)) - Ball(1)).contains_zero());
  EXPECT_TRUE((gaussian_bell(Ball(2)) * exp(Ball(2)) - Ball(1)).contains_zero());
  EXPECT_LT(gaussian_bell(Ball(2)).radius(), 1e-15);
  EXPECT_EQ(inverse_square(Rational(2, 3)), Rational(9, 4));
}

TEST(MotherFunction, IsZeroBeyondItsSupportAlone) {
  const double beyond = std::nextafter(4.0, 5.0);
  EXPECT_EQ(gaussian_mother().value(4.0), std::exp(-8.0));
  EXPECT_EQ(gaussian_mother().value(beyond), 0);
  EXPECT_EQ(gaussian_mother(std::nullopt).value(beyond), gaussian_bell(beyond));
  EXPECT_TRUE(gaussian_mother().value(hull(Ball(3), Ball(5))).contains(Rational(0)));
  EXPECT_TRUE(gaussian_mother().value(hull(Ball(3), Ball(5))).contains(gaussian_bell(Ball(4))));
  const MotherFunction ours =
      expression_mother(*parse_expression("1-r", ExpressionVariables::radius), Rational(1, 2));
  EXPECT_EQ(ours.value(0.5), 0.5);
  EXPECT_EQ(ours.value(0.75), 0);
  EXPECT_EQ(ours.to_text(), "1-r");
}

TEST(MotherFunction, RefusesAnExpressionInSpaceAndAnEmptySupport) {
  EXPECT_THROW(static_cast<void>(expression_mother(*parse_expression("x"))), ContractViolation);
  EXPECT_THROW(static_cast<void>(gaussian_mother(Rational(0))), ContractViolation);
}

TEST(RadialElement, HasItsExactValues) {
  const Site<double> q{{0, 0, 0}, {0, 0, 1}};
  const Site<double> tilted{{3, 4, 0}, {0.6, 0, 0.8}};
  // length 5, cosine 4/5, alpha 10
  EXPECT_DOUBLE_EQ(raw_element(gaussian_basis(), tilted, q, 10.0), std::exp(-0.5 * 0.625 * 0.625));
  EXPECT_DOUBLE_EQ(raw_element(lehtinen_basis(), tilted, q, 10.0), 0.5 * 0.8);
  EXPECT_DOUBLE_EQ(raw_element(shepard_basis(), tilted, q, 1.0), 0.64 / 25);
  RadialBasisChoice plain = lehtinen_basis();
  plain.distance = SiteDistance::euclidean;
  EXPECT_DOUBLE_EQ(raw_element(plain, tilted, q, 10.0), 0.5);
  const Site<double> behind{{3, 4, 0}, {0, 0.6, -0.8}};
  for (const RadialBasisChoice& choice : {gaussian_basis(), lehtinen_basis(), shepard_basis()}) {
    EXPECT_EQ(raw_element(choice, behind, q, 10.0), 0);
    EXPECT_EQ(raw_element(choice, Site<double>{{3, 4, 0}, {1, 0, 0}}, q, 10.0), 0);
  }
  EXPECT_DOUBLE_EQ(raw_element(plain, behind, q, 10.0), 0.5);
}

TEST(RadialElement, InBallsEnclosesTheNumberInDouble) {
  const auto sites = laws::random_sites(11, 30, false);
  for (const RadialBasisChoice& choice : {gaussian_basis(), lehtinen_basis(), shepard_basis()})
    for (std::size_t i = 0; i + 1 < sites.size(); ++i) {
      const Ball exact =
          raw_element(choice, in_balls(sites[i]), in_balls(sites[i + 1]), Ball(Rational(1, 2)));
      const double rounded =
          raw_element(choice, laws::in_double(sites[i]), laws::in_double(sites[i + 1]), 0.5);
      ASSERT_TRUE(exact.is_finite()) << exact.failure();
      EXPECT_NEAR(exact.to_double(), rounded, 1e-12 * std::max(1.0, rounded));
      EXPECT_LT(exact.radius(), 1e-12 * std::max(1.0, rounded));
    }
}

TEST(RadialElement, InBallsHoldsBothSidesOfAnOpenRightAngle) {
  const Site<Ball> p{{Ball(0), Ball(0), Ball(0)}, {Ball(0), Ball(0), Ball(1)}};
  const Ball tilt = hull(Ball(Rational(-1, 100)), Ball(Rational(1, 100)));
  const Site<Ball> q{{Ball(1), Ball(0), Ball(0)}, {Ball(1), Ball(0), tilt}};
  for (const RadialBasisChoice& choice : {gaussian_basis(), lehtinen_basis(), shepard_basis()}) {
    const Ball value = raw_element(choice, p, q, Ball(50));
    ASSERT_TRUE(value.is_finite());
    EXPECT_TRUE(value.contains(0.0));
    const Site<Ball> decided{q.point, {Ball(1), Ball(0), Ball(Rational(1, 100))}};
    EXPECT_TRUE(value.contains(raw_element(choice, p, decided, Ball(50))));
  }
}

TEST(RadialElement, NormalisedElementsAreAPartitionOfUnityInBalls) {
  const auto sites = in_balls(laws::random_sites(12, 20, true));
  const std::vector<Ball> radii(sites.size(), Ball(1));
  for (const RadialBasisChoice& choice : {lehtinen_basis(), shepard_basis()})
    for (const Site<Rational>& at : laws::random_sites(13, 20, true)) {
      const std::vector<Ball> values = basis_values<Ball>(choice, sites, radii, in_balls(at));
      Ball sum(0);
      for (const Ball& value : values) {
        EXPECT_GE(value.lower_double(), 0);
        sum += value;
      }
      ASSERT_TRUE(sum.is_finite()) << sum.failure();
      EXPECT_TRUE(sum.contains(1.0));
      EXPECT_LT(sum.radius(), 1e-12);
    }
}

TEST(ShepardValues, InterpolateAndSumToOneExactly) {
  const auto sites = laws::random_sites(14, 12, true);
  const auto squares = [&](const Site<Rational>& p) {
    std::vector<Rational> all;
    for (const Site<Rational>& site : sites) all.push_back(squared_site_distance(p, site));
    return all;
  };
  for (std::size_t j = 0; j < sites.size(); ++j) {
    const std::vector<Rational> values = shepard_values<Rational>(squares(sites[j]));
    for (std::size_t i = 0; i < sites.size(); ++i) EXPECT_EQ(values[i], Rational(i == j ? 1 : 0));
  }
  for (const Site<Rational>& p : laws::random_sites(15, 10, true)) {
    const std::vector<Rational> distances = squares(p);
    const std::vector<Rational> values = shepard_values<Rational>(distances);
    Rational sum(0);
    for (const Rational& value : values) {
      EXPECT_GE(value, Rational(0));
      sum = sum + value;
    }
    EXPECT_EQ(sum, Rational(1));
    // phi_i d_i^2 is the same for all i: the definition.
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(values[i] * distances[i], values[0] * distances[0]);
  }
}

}  // namespace
}  // namespace radcert
