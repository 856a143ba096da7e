// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/expression/parse.h"
#include "radcert/meshless/sampling.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert {
namespace {

using ::testing::HasSubstr;

Surface square(int side) {
  Surface surface;
  surface.name = "square";
  surface.charts.push_back(make_rectangle({.name = "square", .piece = "square"}, {0, 0, 0},
                                          {Rational(side), 0, 0}, {0, Rational(side), 0}));
  surface.diagonals.assign(1, Diagonal::main);
  return surface;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// 2 pi int Phi(r) r dr by Simpson's rule.
double simpson(const MotherFunction& mother, double end) {
  constexpr int panels = 4000;
  const double h = end / (2 * panels);
  double total = 0;
  for (int k = 0; k <= 2 * panels; ++k) {
    const double weight = k == 0 || k == 2 * panels ? 1 : (k % 2 == 1 ? 4 : 2);
    total += weight * mother.value(h * k) * h * k;
  }
  return 2 * std::numbers::pi * total * h / 3;
}

TEST(PlaneIntegral, AgreesWithAQuadratureOfTheMotherFunction) {
  EXPECT_TRUE((plane_integral(spline_mother()).value() - Ball::pi() * Ball(Rational(3, 10))).contains_zero());
  EXPECT_NEAR(plane_integral(spline_mother())->to_double(), simpson(spline_mother(), 1), 1e-10);
  EXPECT_NEAR(plane_integral(gaussian_mother())->to_double(), simpson(gaussian_mother(), 4), 1e-10);
  EXPECT_NEAR(plane_integral(gaussian_mother(Rational(1)))->to_double(), simpson(gaussian_mother(), 1),
              1e-10);
  EXPECT_NEAR(plane_integral(gaussian_mother(std::nullopt))->to_double(),
              simpson(gaussian_mother(std::nullopt), 12), 1e-10);
  MotherFunction half = spline_mother();
  half.support = Rational(1, 2);
  EXPECT_NEAR(plane_integral(half)->to_double(), simpson(half, 0.5), 1e-10);
}

TEST(PlaneIntegral, IsRefusedWhereItDivergesOrHasNoClosedForm) {
  EXPECT_THAT(plane_integral(shepard_mother()).reason(), HasSubstr("diverges"));
  EXPECT_THAT(
      plane_integral(expression_mother(*parse_expression("exp(-r)", ExpressionVariables::radius))).reason(),
      HasSubstr("closed form"));
}

TEST(Weights, OfElementsInsideASquareAreThoseOfThePlane) {
  const Surface surface = square(8);
  const SiteSet sites = poisson_disk_sites(surface, {0.5, 1}).value();
  RadialBasisChoice choice = lehtinen_basis();
  choice.normalise = Normalisation::none;
  const RadialBasis basis = RadialBasis::make(sites, choice).value();
  const std::vector<double> plane = plane_weights(basis).value();
  const BasisIntegrals exact = integrate_basis(basis, surface, {.relative_error = 1e-2});
  EXPECT_TRUE(exact.reached);
  EXPECT_NEAR(exact.area, 64, 1e-10);
  std::size_t inside = 0;
  for (std::size_t j = 0; j < sites.size(); ++j) {
    EXPECT_GT(exact.errors[j], 0);
    EXPECT_LE(exact.weights[j], plane[j] + 2 * exact.errors[j]);  // what falls outside is missing
    const Vector<double>& p = sites.points[j];
    const double reach = basis.radii()[j];
    if (p.x < reach || p.y < reach || p.x > 8 - reach || p.y > 8 - reach) continue;
    ++inside;
    EXPECT_NEAR(exact.weights[j], plane[j], 2 * exact.errors[j] + 1e-12) << j;
    EXPECT_NEAR(exact.weights[j], plane[j], 0.01 * plane[j]) << j;
  }
  EXPECT_GT(inside, 50U);
}

TEST(Weights, OfAPartitionOfUnitySumToTheArea) {
  const Surface surface = sphere();
  const SiteSet sites = poisson_disk_sites(surface, {0.3, 1}).value();
  for (const RadialBasisChoice& choice : {shepard_basis(), lehtinen_basis()}) {
    const RadialBasis basis = RadialBasis::make(sites, choice).value();
    const BasisIntegrals exact = integrate_basis(basis, surface, {.relative_error = 0.05});
    EXPECT_TRUE(exact.reached);
    EXPECT_EQ(exact.uncovered_area, 0);
    EXPECT_NEAR(sum(exact.weights), exact.area, 1e-10);
    EXPECT_NEAR(exact.area, 4 * std::numbers::pi, 1e-3);
    EXPECT_NEAR(sum(mean_density_weights(basis, 4 * std::numbers::pi)), 4 * std::numbers::pi, 1e-10);
    const std::vector<double> near = neighbour_weights(basis).value();
    const std::vector<double> radii = neighbour_radii(sites, choice.distance, 10).value();
    for (std::size_t j = 0; j < near.size(); ++j)
      EXPECT_DOUBLE_EQ(near[j], std::numbers::pi * radii[j] * radii[j] / 10);
  }
}

TEST(Weights, SayWhatIsNotCoveredAndWhatWasNotReached) {
  const Surface surface = square(8);
  SiteSet corner;  // sites in a corner of the square alone
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) corner.add({{x / 4.0, y / 4.0, 0}, {0, 0, 1}}, {});
  const RadialBasis basis = RadialBasis::make(corner, lehtinen_basis()).value();
  const BasisIntegrals integrals = integrate_basis(basis, surface, {.relative_error = 0.05});
  EXPECT_GT(integrals.uncovered_area, 50);
  EXPECT_NEAR(integrals.uncovered_area + sum(integrals.weights), 64, 1e-9);
  const BasisIntegrals few = integrate_basis(basis, surface, {.relative_error = 1e-9, .most_points = 10000});
  EXPECT_FALSE(few.reached);
  EXPECT_LE(few.points, 10000U);
  EXPECT_THROW(static_cast<void>(integrate_basis(basis, surface, {.relative_error = 0})), ContractViolation);
}

TEST(Weights, AreTheSameOnAnyNumberOfThreads) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  const RadialBasis basis = RadialBasis::make(sites, lehtinen_basis()).value();
  const BasisIntegrals together = integrate_basis(basis, sphere(), {.relative_error = 0.1});
  const ThreadLimit one(1);
  EXPECT_EQ(together.weights, integrate_basis(basis, sphere(), {.relative_error = 0.1}).weights);
}

TEST(Weights, ThatHaveNoEstimateAreRefused) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  EXPECT_FALSE(plane_weights(RadialBasis::make(sites, shepard_basis()).value()));
  EXPECT_FALSE(neighbour_weights(RadialBasis::make(sites, shepard_basis()).value(), sites.size()));
  EXPECT_THROW(static_cast<void>(mean_density_weights(RadialBasis::make(sites, shepard_basis()).value(), 0)),
               ContractViolation);
}

}  // namespace
}  // namespace radcert
