// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/interpolation_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/meshless/sampling.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue/ellipsoid.h"

namespace radcert {
namespace {

using ::testing::HasSubstr;

double one_norm(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += std::abs(x);
  return sum;
}

std::vector<double> unit(std::size_t n, std::size_t j) {
  std::vector<double> e(n, 0.0);
  e[j] = 1;
  return e;
}

RadialBasisChoice with_mother(const char* text, std::optional<Rational> support = std::nullopt) {
  RadialBasisChoice choice = gaussian_basis();
  choice.mother = expression_mother(*parse_expression(text, ExpressionVariables::radius), std::move(support));
  return choice;
}

// Sparse and dense.
std::vector<RadialBasisChoice> choices() {
  return {gaussian_basis(), lehtinen_basis(), with_mother("exp(-4*r^2)", Rational(1)),
          with_mother("exp(-r)")};
}

TEST(InterpolationSystem, HasTheValuesThatItWasGiven) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.25, 1}).value();
  std::vector<double> f(sites.size());
  std::vector<Site<double>> points;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    f[i] = std::sin(3 * sites.points[i].x) + sites.points[i].z;
    points.push_back(sites[i]);
  }
  for (const RadialBasisChoice& choice : choices()) {
    SCOPED_TRACE(choice.mother.to_text());
    const RadialBasis basis = RadialBasis::make(sites, choice).value();
    const auto system = InterpolationSystem::make(basis);
    ASSERT_TRUE(system) << system.reason();
    const std::vector<double> c = system->solve(f);
    const double tolerance = 1e-15 * system->condition();
    const auto by_basis = basis.at(points, c);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(by_basis[i].value(), f[i], 1e-13 + tolerance);
  }
}

TEST(InterpolationSystem, OfAnInterpolationBasisIsTheUnitMatrix) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  const auto system = InterpolationSystem::make(RadialBasis::make(sites, shepard_basis()).value());
  ASSERT_TRUE(system);
  EXPECT_EQ(system->condition(), 1);
  const std::vector<double> f(sites.size(), 0.25);
  EXPECT_EQ(system->solve(f), f);
}

TEST(InterpolationSystem, EstimatesTheConditionFromBelow) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  const std::size_t n = sites.size();
  for (const RadialBasisChoice& choice : choices()) {
    SCOPED_TRACE(choice.mother.to_text());
    const RadialBasis basis = RadialBasis::make(sites, choice).value();
    const auto system = InterpolationSystem::make(basis);
    ASSERT_TRUE(system) << system.reason();
    double norm = 0;
    double inverse_norm = 0;
    for (std::size_t j = 0; j < n; ++j) {
      double column = 0;
      for (std::size_t i = 0; i < n; ++i) column += std::abs(basis.at(sites[i], unit(n, j)).value());
      norm = std::max(norm, column);
      inverse_norm = std::max(inverse_norm, one_norm(system->solve(unit(n, j))));
    }
    EXPECT_LE(system->condition(), norm * inverse_norm * (1 + 1e-10));
    EXPECT_GE(system->condition(), 0.99 * norm * inverse_norm);
  }
}

TEST(InterpolationSystem, RefusesASingularMatrix) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  RadialBasisChoice constant = with_mother("1");
  constant.distance = SiteDistance::euclidean;
  const auto system = InterpolationSystem::make(RadialBasis::make(sites, constant).value());
  ASSERT_FALSE(system);
  EXPECT_THAT(system.reason(), HasSubstr("singular"));
  const auto undefined = InterpolationSystem::make(RadialBasis::make(sites, with_mother("abs(r)/r")).value());
  ASSERT_FALSE(undefined);
  EXPECT_THAT(undefined.reason(), HasSubstr("no value at its site 0"));
}

TEST(InterpolationSystem, RefusesVectorsOfAnotherSize) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.5, 1}).value();
  const auto system = InterpolationSystem::make(RadialBasis::make(sites, lehtinen_basis()).value());
  ASSERT_TRUE(system) << system.reason();
  EXPECT_THROW(static_cast<void>(system->solve(std::vector<double>(3))), ContractViolation);
}

TEST(InterpolationSystem, KnowsWhatItsCoefficientsLeave) {
  const SiteSet sites = poisson_disk_sites(sphere(), {0.4, 1}).value();
  for (const RadialBasisChoice& choice : choices()) {
    const RadialBasis basis = RadialBasis::make(sites, choice).value();
    const auto system = InterpolationSystem::make(basis);
    ASSERT_TRUE(system);
    std::vector<double> c(sites.size());
    for (std::size_t j = 0; j < c.size(); ++j) c[j] = 1e6 * std::cos(static_cast<double>(j * j));
    std::vector<double> f(sites.size());
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = std::sin(static_cast<double>(i));
    const std::vector<double> residual = system->residual(c, f);
    const std::vector<double> sizes = system->term_sizes(c);
    BasisValues row;
    for (std::size_t i = 0; i < f.size(); ++i) {
      ASSERT_TRUE(basis.evaluate(sites[i], row));
      Rational left = Rational::exactly(f[i]);
      Rational size = 0;
      for (std::size_t k = 0; k < row.size(); ++k) {
        const Rational term = Rational::exactly(row.values()[k]) * Rational::exactly(c[row.sites()[k]]);
        left -= term;
        size += abs(term);
      }
      const double of_sum = static_cast<double>(row.size() + 2) * 0x1p-63 * size.to_double();
      EXPECT_NEAR(residual[i], left.to_double(), of_sum + 0x1p-52 * abs(left).to_double());
      EXPECT_NEAR(sizes[i], size.to_double(), 1e-13 * size.to_double());
    }
  }
}

}  // namespace
}  // namespace radcert
