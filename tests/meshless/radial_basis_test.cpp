// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/radial_basis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/expression/parse.h"
#include "radcert/scalar/ball_precision.h"
#include "tests/laws/meshless_laws.h"

namespace radcert {
namespace {

using ::testing::HasSubstr;

MotherFunction mother(const std::string& text, std::optional<Rational> support = std::nullopt) {
  return expression_mother(*parse_expression(text, ExpressionVariables::radius), std::move(support));
}

// Every combination of the four choices that has values.
std::vector<RadialBasisChoice> all_choices() {
  std::vector<RadialBasisChoice> all;
  for (const MotherFunction& m : {gaussian_mother(), spline_mother(), shepard_mother(), mother("1/(1+r^4)"),
                                  mother("max(0,1-r)", Rational(1)), gaussian_mother(std::nullopt)})
    for (const SiteDistance distance : {SiteDistance::normal_sensitive,
                                        SiteDistance::euclidean_with_normal_factor, SiteDistance::euclidean})
      for (const RadiusRule& radius :
           {RadiusRule{.neighbour = 5, .too_few = TooFewNeighbours::farthest}, RadiusRule{std::nullopt}})
        for (const Normalisation normalise : {Normalisation::none, Normalisation::partition_of_unity})
          if (m.kind != MotherKind::shepard || normalise != Normalisation::none)
            all.push_back({m, distance, radius, normalise});
  return all;
}

SiteSet sites(std::uint64_t seed, std::size_t count, bool towards_z = false) {
  return laws::in_double(laws::random_sites(seed, count, towards_z));
}

std::vector<Site<double>> list(const SiteSet& set) {
  std::vector<Site<double>> all;
  for (std::size_t i = 0; i < set.size(); ++i) all.push_back(set[i]);
  return all;
}

// A flat lattice of k x k sites at whole coordinates.
SiteSet lattice(int k) {
  SiteSet set;
  for (int x = 0; x < k; ++x)
    for (int y = 0; y < k; ++y) set.add({{static_cast<double>(x), static_cast<double>(y), 0}, {0, 0, 1}}, {});
  return set;
}

/// The spline bell once more, as a type of one's own.
struct OwnBell {
  template <Field R>
  R operator()(const R& r) const {
    return select_less(r, R(1), R(R(1) - R(3) * r * r + R(2) * r * r * r), R(0));
  }
};

/// In double alone.
struct OwnHat {
  double operator()(double r) const { return std::max(0.0, 1 - r); }
};

TEST(RadialBasis, TakesAMotherFunctionOfOnesOwnType) {
  RadialBasisChoice named{.mother = spline_mother(), .normalise = Normalisation::partition_of_unity};
  RadialBasisChoice own = named;
  own.mother = own_mother("bell", OwnBell{}, Rational(1));
  const SiteSet centroids = sites(31, 40, true);
  const RadialBasis by_name = RadialBasis::make(centroids, named).value();
  const RadialBasis by_type = RadialBasis::make(centroids, own).value();
  std::vector<double> coefficients(centroids.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = std::sin(static_cast<double>(i));
  for (const Site<double>& p : list(sites(32, 50, true))) {
    const auto expected = by_name.at(p, coefficients);
    const auto found = by_type.at(p, coefficients);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (found) {
      EXPECT_NEAR(*found, *expected, 1e-12);
    }
  }
  EXPECT_EQ(own.mother.to_text(), "bell");
  EXPECT_FALSE(own.mother.is_monotone());
  const BallPrecision scope(100);
  EXPECT_TRUE(own.mother.value(Ball(Rational(1, 2))).contains(Rational(1, 2)));
  EXPECT_EQ(own.mother.value(2.0), 0);
  EXPECT_THROW((void)own_mother("hat", OwnHat{}).value(Ball(1)), ContractViolation);
  EXPECT_THROW((void)own_mother("", OwnHat{}), ContractViolation);
  EXPECT_THROW((void)own_mother("hat", OwnHat{}, Rational(0)), ContractViolation);
}

TEST(RadialBasis, AgreesWithTheFormulaForEveryChoice) {
  const SiteSet centroids = sites(21, 83);
  const std::vector<Site<double>> points = list(sites(22, 60));
  for (const RadialBasisChoice& choice : all_choices()) {
    SCOPED_TRACE(choice.mother.to_text() + ", " + std::string(name(choice.distance)) + ", " +
                 std::string(name(choice.normalise)));
    const auto basis = RadialBasis::make(centroids, choice);
    ASSERT_TRUE(basis) << basis.reason();
    const laws::Elements by_formula = [&](const Site<double>& p) -> std::optional<std::vector<double>> {
      std::vector<double> values = basis_values<double>(choice, list(centroids), basis->radii(), p);
      // Zero everywhere, or 0/0: no value.
      if (std::none_of(values.begin(), values.end(), [](double v) { return v > 0; })) return std::nullopt;
      return values;
    };
    const double tolerance = choice.normalise == Normalisation::none ? 0 : 1e-14;
    EXPECT_TRUE(laws::agree(laws::elements_of(*basis), by_formula, points, tolerance));
  }
}

TEST(RadialBasis, HasTheRadiusOfTheNeighbourThatAPlainSearchFinds) {
  for (const bool towards_z : {false, true})
    for (const SiteDistance distance :
         {SiteDistance::normal_sensitive, SiteDistance::euclidean_with_normal_factor}) {
      const SiteSet set = sites(23, 120, towards_z);
      for (const std::size_t m : {1U, 2U, 10U, 30U}) {
        const auto radii = neighbour_radii(set, distance, m, TooFewNeighbours::farthest);
        ASSERT_TRUE(radii) << radii.reason();
        for (std::size_t i = 0; i < set.size(); ++i) {
          std::vector<double> all;
          for (std::size_t j = 0; j < set.size(); ++j) {
            const double here = laws::site_distance(
                distance == SiteDistance::normal_sensitive ? distance : SiteDistance::euclidean, set[i],
                set[j]);
            if (j != i && here < std::numeric_limits<double>::infinity()) all.push_back(here);
          }
          std::sort(all.begin(), all.end());
          EXPECT_EQ((*radii)[i], all[std::min(m, all.size()) - 1]) << i;
        }
      }
    }
}

TEST(RadialBasis, OfSitesOnALatticeHasTheirRadii) {
  const RadialBasis basis = RadialBasis::make(lattice(9), gaussian_basis()).value();
  // Around an inner site: 4 at 1, 4 at sqrt 2, 4 at 2: the tenth is at 2.
  EXPECT_EQ(basis.radii()[4 * 9 + 4], 2);
  EXPECT_EQ(basis.size(), 81U);
}

TEST(RadialBasis, RefusesByName) {
  const auto reason = [](const SiteSet& set, const RadialBasisChoice& choice) {
    const auto basis = RadialBasis::make(set, choice);
    return basis ? std::string() : basis.reason();
  };
  EXPECT_THAT(reason(sites(24, 10), gaussian_basis()), HasSubstr("at least 11 sites; there are 10"));
  EXPECT_THAT(reason({}, shepard_basis()), HasSubstr("at least one site"));
  RadialBasisChoice choice = gaussian_basis();
  choice.radius.neighbour = 0;
  EXPECT_THAT(reason(sites(24, 30), choice), HasSubstr("neighbour"));

  SiteSet twice = sites(24, 30, true);
  twice.add(twice[17], {});
  for (const RadialBasisChoice& preset : {shepard_basis(), gaussian_basis(), lehtinen_basis()})
    EXPECT_THAT(reason(twice, preset), HasSubstr("sites 17 and 30 coincide"));
  twice.normals.back() = -twice.normals.back();
  EXPECT_EQ(reason(twice, shepard_basis()), "") << "the two sides of a sheet";

  choice = shepard_basis();
  choice.normalise = Normalisation::none;
  EXPECT_THAT(reason(sites(24, 30), choice), HasSubstr("infinite at 0"));
  choice.mother = mother("1/r");
  EXPECT_THAT(reason(sites(24, 30), choice), HasSubstr("infinite at 0"));

  SiteSet alone = sites(24, 30, true);
  alone.normals[4] = {0, 0, -1};
  EXPECT_THAT(reason(alone, gaussian_basis()), HasSubstr("site 4 has fewer than 10 others"));
  choice = gaussian_basis();
  choice.radius.too_few = TooFewNeighbours::farthest;
  EXPECT_THAT(reason(alone, choice), HasSubstr("site 4 has no other"));
  EXPECT_EQ(reason(alone, lehtinen_basis()), "");
  EXPECT_EQ(reason(alone, shepard_basis()), "");
}

TEST(RadialBasis, SaysWhereNoSiteIsInReach) {
  BasisValues room;
  for (const RadialBasisChoice& choice : {gaussian_basis(), lehtinen_basis()}) {
    const RadialBasis basis = RadialBasis::make(lattice(6), choice).value();
    const std::vector<double> ones(basis.size(), 1.0);
    for (const Site<double>& p : {Site<double>{{100, 0, 0}, {0, 0, 1}}, Site<double>{{2, 2, 0}, {0, 0, -1}},
                                  Site<double>{{2, 2, 0}, {1, 0, 0}}}) {
      EXPECT_FALSE(basis.evaluate(p, room));
      EXPECT_EQ(room.size(), 0U);
      EXPECT_FALSE(basis.at(p, ones));
    }
    EXPECT_TRUE(basis.evaluate({{2, 2, 0.1}, {0, 0, 1}}, room));
  }
  const RadialBasis everywhere = RadialBasis::make(lattice(6), shepard_basis()).value();
  EXPECT_TRUE(everywhere.evaluate({{1e6, 0, 0}, {0, 0, 1}}, room));
  EXPECT_FALSE(everywhere.evaluate({{2, 2, 0}, {0, 0, -1}}, room));
}

TEST(RadialBasis, WithoutAPositiveSumHasNoValue) {
  RadialBasisChoice choice = lehtinen_basis();
  BasisValues room;
  for (const char* text : {"-1", "0*r", "log(-1-r)"}) {
    choice.mother = mother(text);
    EXPECT_FALSE(RadialBasis::make(lattice(6), choice)->evaluate({{1, 1, 0}, {0, 0, 1}}, room)) << text;
  }
  choice.normalise = Normalisation::none;
  EXPECT_FALSE(RadialBasis::make(lattice(6), choice)->evaluate({{1, 1, 0}, {0, 0, 1}}, room));
  // Each value is finite, their sum is not.
  choice = lehtinen_basis();
  choice.mother = mother("10^308");
  ASSERT_TRUE(RadialBasis::make(lattice(6), choice)->evaluate({{1, 1, 0}, {0, 0, 1}}, room));
  EXPECT_DOUBLE_EQ(room.values()[0], 1.0 / 36);
}

TEST(RadialBasis, OfShepardHasTheValueOfTheSiteAtAndNextToIt) {
  const SiteSet set = sites(25, 40, true);
  const RadialBasis basis = RadialBasis::make(set, shepard_basis()).value();
  EXPECT_TRUE(basis.interpolates());
  std::vector<double> values(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) values[i] = std::sin(static_cast<double>(i));
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_EQ(basis.at(set[i], values), values[i]);
    for (const double step : {1e-300, 1e-160, 1e-20}) {
      SiteSet shifted;  // with site i at 0, where steps so small are not lost
      for (std::size_t j = 0; j < set.size(); ++j)
        shifted.add({set.points[j] - set.points[i], set.normals[j]}, {});
      const RadialBasis there = RadialBasis::make(shifted, shepard_basis()).value();
      EXPECT_NEAR(there.at({{step, 0, 0}, set.normals[i]}, values).value(), values[i], 1e-30);
    }
  }
}

TEST(RadialBasis, OfShepardTakesEqualSharesOfSitesThatTheirNormalsKeepApart) {
  SiteSet edge = sites(26, 20, true);
  edge.add({{5, 5, 5}, {0.8, 0, 0.6}}, {});
  edge.add({{5, 5, 5}, {-0.8, 0, 0.6}}, {});  // at more than a right angle
  const RadialBasis basis = RadialBasis::make(edge, shepard_basis()).value();
  BasisValues room;
  ASSERT_TRUE(basis.evaluate({{5, 5, 5}, {0, 0, 1}}, room));
  for (std::size_t k = 0; k < room.size(); ++k)
    EXPECT_EQ(room.values()[k], room.sites()[k] >= 20 ? 0.5 : 0) << room.sites()[k];
}

TEST(RadialBasis, CombinesCoefficientsTheSameOnAnyNumberOfThreads) {
  const SiteSet set = sites(27, 300, true);
  std::vector<double> coefficients(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) coefficients[i] = std::cos(static_cast<double>(i));
  const std::vector<Site<double>> points = list(sites(28, 700, true));
  for (const RadialBasisChoice& choice : {shepard_basis(), gaussian_basis(), lehtinen_basis()}) {
    const RadialBasis basis = RadialBasis::make(set, choice).value();
    const auto together = basis.at(points, coefficients);
    const ThreadLimit one(1);
    EXPECT_EQ(together, basis.at(points, coefficients));
    for (std::size_t k = 0; k < points.size(); k += 97)
      EXPECT_EQ(together[k], basis.at(points[k], coefficients));
    const auto values = laws::elements_of(basis)(points[0]);
    ASSERT_TRUE(values);
    double sum = 0;
    for (std::size_t i = 0; i < set.size(); ++i) sum += coefficients[i] * (*values)[i];
    EXPECT_NEAR(*together[0], sum, 1e-13);
  }
  EXPECT_THROW(static_cast<void>(RadialBasis::make(set, shepard_basis())->at(points, std::vector<double>(3))),
               ContractViolation);
}

TEST(RadialBasis, NamesItsChoices) {
  EXPECT_EQ(name(SiteDistance::normal_sensitive), "normal_sensitive");
  EXPECT_EQ(name(SiteDistance::euclidean_with_normal_factor), "euclidean_with_normal_factor");
  EXPECT_EQ(name(SiteDistance::euclidean), "euclidean");
  EXPECT_EQ(name(Normalisation::none), "none");
  EXPECT_EQ(name(Normalisation::partition_of_unity), "partition_of_unity");
  EXPECT_EQ(name(TooFewNeighbours::refuse), "refuse");
  EXPECT_EQ(name(TooFewNeighbours::farthest), "farthest");
}

}  // namespace
}  // namespace radcert
