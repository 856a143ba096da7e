// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/laws/meshless_laws.h"

#include "radcert/expression/parse.h"

namespace radcert::laws {
namespace {

// Elements with a fault: what the laws must reject.
Elements spoilt(const Elements& elements, const std::function<void(std::vector<double>&)>& fault) {
  return [elements, fault](const Site<double>& p) {
    auto values = elements(p);
    if (values) fault(*values);
    return values;
  };
}

ElementsOf spoilt(
    const ElementsOf& elements_of_sites,
    const std::function<void(std::vector<double>&, const Site<double>&, const SiteSet&)>& fault) {
  return [=](const SiteSet& sites) -> Elements {
    const Elements elements = elements_of_sites(sites);
    return [=](const Site<double>& p) {
      auto values = elements(p);
      if (values) fault(*values, p, sites);
      return values;
    };
  };
}

struct Case {
  std::string name;
  RadialBasisChoice choice;
};

std::vector<Case> cases() {
  RadialBasisChoice ours = lehtinen_basis();
  ours.mother = expression_mother(*parse_expression("exp(-2*r^2)", ExpressionVariables::radius), Rational(2));
  ours.distance = SiteDistance::normal_sensitive;
  return {{"shepard", shepard_basis()},
          {"gaussian", gaussian_basis()},
          {"lehtinen", lehtinen_basis()},
          {"expression", ours}};
}

// Normals within 60 degrees of the z-axis of each other: every site has all others at a finite distance.
SiteSet sites() { return in_double(random_sites(3, 60, true)); }

std::vector<Site<double>> points() {
  std::vector<Site<double>> all;
  for (const Site<Rational>& p : random_sites(4, 40, true)) all.push_back(in_double(p));
  for (const Site<Rational>& p : random_sites(5, 20, false)) all.push_back(in_double(p));
  const SiteSet at_sites = sites();
  for (std::size_t i = 0; i < 5; ++i) all.push_back(at_sites[i]);
  all.push_back({{100, 100, 100}, {0, 0, 1}});
  return all;
}

TEST(MeshlessLaws, HoldForTheBasesOfThePaperAndOneOfOurs) {
  for (const auto& [name, choice] : cases()) {
    SCOPED_TRACE(name);
    const auto basis = RadialBasis::make(sites(), choice);
    ASSERT_TRUE(basis) << basis.reason();
    const Elements elements = elements_of(*basis);
    EXPECT_TRUE(is_nonnegative(elements, points()));
    const bool normalised = choice.normalise == Normalisation::partition_of_unity;
    EXPECT_EQ(normalised, is_partition_of_unity(elements, points(), 1e-14));
    EXPECT_EQ(normalised, stays_between_coefficients(elements, points(), 6, 1e-14));
    EXPECT_EQ(basis->interpolates(), interpolates(elements, sites(), 0));
    if (choice.mother.support) {
      EXPECT_TRUE(is_local(elements, sites(), basis->radii(), choice.distance,
                           choice.mother.support->to_double(), points()));
    }
    EXPECT_TRUE(is_invariant_under_motions(elements_by(choice), sites(), points(), 1e-12));
    EXPECT_TRUE(follows_permutations(elements_by(choice), sites(), points(), 7, 1e-14));
  }
}

TEST(MeshlessLaws, RejectElementsThatAreNegativeOrDoNotSumToOne) {
  const Elements good = elements_by(lehtinen_basis())(sites());
  const auto negative = [](std::vector<double>& v) { v[3] -= 1e-3; };
  EXPECT_FALSE(is_nonnegative(spoilt(good, negative), points()));
  EXPECT_FALSE(is_partition_of_unity(spoilt(good, negative), points(), 1e-6));
  const auto larger = [](std::vector<double>& v) {
    for (double& x : v) x *= 1.001;
  };
  EXPECT_FALSE(is_partition_of_unity(spoilt(good, larger), points(), 1e-6));
  const auto tripled = [](std::vector<double>& v) {
    for (double& x : v) x *= 3;
  };
  EXPECT_FALSE(stays_between_coefficients(spoilt(good, tripled), points(), 6, 1e-6));
  EXPECT_FALSE(is_partition_of_unity([](const Site<double>&) { return std::nullopt; }, points(), 1e-6));
}

TEST(MeshlessLaws, RejectABasisThatMissesItsSites) {
  const Elements good = elements_by(shepard_basis())(sites());
  EXPECT_TRUE(interpolates(good, sites(), 0));
  EXPECT_FALSE(interpolates(spoilt(good, [](std::vector<double>& v) { std::swap(v[0], v[1]); }), sites(), 0));
  EXPECT_FALSE(interpolates([](const Site<double>&) { return std::nullopt; }, sites(), 0));
}

TEST(MeshlessLaws, RejectElementsBeyondTheirSupport) {
  const RadialBasis basis = RadialBasis::make(sites(), lehtinen_basis()).value();
  EXPECT_FALSE(is_local(elements_of(basis), sites(), basis.radii(), basis.choice().distance, 0.5, points()));
}

TEST(MeshlessLaws, RejectABasisThatDependsOnThePlaceOrOnTheOrder) {
  const ElementsOf good = elements_by(gaussian_basis());
  const ElementsOf by_height = spoilt(good, [](std::vector<double>& v, const Site<double>& p,
                                               const SiteSet&) { v[0] *= 1 + 1e-6 * p.point.z; });
  EXPECT_FALSE(is_invariant_under_motions(by_height, sites(), points(), 1e-12));
  const ElementsOf by_order =
      spoilt(good, [](std::vector<double>& v, const Site<double>&, const SiteSet&) { v[0] *= 1.5; });
  EXPECT_FALSE(follows_permutations(by_order, sites(), points(), 7, 1e-12));
}

TEST(MeshlessLaws, TheNormalSensitiveDistanceIsNoMetric) {
  const auto triple = triple_against_the_triangle_inequality();
  for (const Site<Rational>& site : triple) EXPECT_EQ(dot(site.normal, site.normal), Rational(1));
  EXPECT_EQ(squared_site_distance(triple[0], triple[1]), Rational(25, 16));
  EXPECT_EQ(squared_site_distance(triple[1], triple[2]), Rational(25, 16));
  EXPECT_EQ(squared_site_distance(triple[0], triple[2]), Rational(2500, 49));
  EXPECT_TRUE(breaks_the_triangle_inequality(triple));
  auto flat = triple;
  for (Site<Rational>& site : flat) site.normal = triple[0].normal;
  EXPECT_FALSE(breaks_the_triangle_inequality(flat));
}

}  // namespace
}  // namespace radcert::laws
