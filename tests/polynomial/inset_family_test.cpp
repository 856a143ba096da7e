// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/inset_family.h"

#include <gtest/gtest.h>

#include "radcert/polynomial/real_zeros.h"
#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "tests/laws/basis_laws.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

const RationalPolynomial alpha = RationalPolynomial::variable();

// The family at one inset against the inverse of its matrix there: two routes to the same fractions.
TEST(InsetFamily, IsTheRuleAtEachInset) {
  for (int degree = 0; degree <= 6; ++degree) {
    const InsetFamily family(degree);
    for (const Rational& inset : some_insets()) {
      const LagrangeFunctions functions = functions_of(inset_nodes(degree, inset));
      const TriangleRule<Rational> rule = interpolatory_rule(functions);
      ASSERT_EQ(family.size(), functions.size());
      const Barycentric<Rational> x = at(Rational(2, 7), Rational(3, 11));
      std::vector<Rational> values(functions.size());
      functions.values(x, values);
      for (std::size_t j = 0; j < family.size(); ++j) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(family.node(j)[i](inset), rule.points[j].x[i]);
        EXPECT_EQ(family.weight(j)(inset), rule.weights[j]) << degree << " " << inset.to_text();
        EXPECT_EQ(family.value(j, x)(inset), values[j]) << degree << " " << inset.to_text();
      }
      for (const Region region : {Region::triangle, Region::parallelogram})
        for (const Monomial& monomial :
             {Monomial{degree + 1, 0}, Monomial{1, degree + 1}, Monomial{2, degree}})
          EXPECT_EQ(family.defect(region, monomial)(inset), defect(rule, region, monomial))
              << degree << " " << inset.to_text() << " " << monomial.to_text();
    }
  }
}

TEST(InsetFamily, OfDegreeOneHasConstantWeights) {
  const InsetFamily family(1);
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_EQ(family.weight(j), (InsetFunction{RationalPolynomial(Rational(1, 6)), 0}));
  // 1/6 (2 alpha^2 + (1 - 2 alpha)^2) - 1/12
  const RationalPolynomial s2 = alpha * alpha - Rational(2, 3) * alpha + Rational(1, 12);
  EXPECT_EQ(family.defect(Region::triangle, {2, 0}), (InsetFunction{s2, 0}));
  EXPECT_EQ(family.defect(Region::parallelogram, {2, 0}), (InsetFunction{2 * s2, 0}));
  EXPECT_EQ(s2, (alpha - Rational(1, 6)) * (alpha - Rational(1, 2)));
}

TEST(InsetFamily, MissesNothingUpToItsDegree) {
  for (int degree = 0; degree <= 6; ++degree) {
    const InsetFamily family(degree);
    for (int precision = 0; precision <= degree; ++precision)
      EXPECT_TRUE(family.condition(Region::triangle, precision).is_zero()) << degree << " " << precision;
    const bool gains_one = degree % 2 == 0;
    EXPECT_EQ(family.condition(Region::parallelogram, degree + 1).is_zero(), gains_one) << degree;
    EXPECT_EQ(family.condition(Region::triangle, degree + 1).is_zero(), degree == 0) << degree;
  }
}

TEST(InsetFamily, KnowsTheInsetsThatGainADegree) {
  EXPECT_EQ(InsetFamily(1).condition(Region::triangle, 2),
            (alpha - Rational(1, 6)) * (alpha - Rational(1, 2)));
  // (7 +- sqrt 34)/15
  EXPECT_EQ(InsetFamily(3).condition(Region::triangle, 4),
            alpha * alpha - Rational(14, 15) * alpha + Rational(1, 15));
  for (const int degree : {5, 7, 9})  // none, real or complex
    EXPECT_EQ(InsetFamily(degree).condition(Region::triangle, degree + 1), RationalPolynomial(1)) << degree;
  const std::vector<RealZero> zeros =
      real_zeros(InsetFamily(2).condition(Region::triangle, 3), 0, Rational(1, 3), Rational(1, 1L << 30));
  ASSERT_EQ(zeros.size(), 2U);
  EXPECT_NEAR(zeros[0].upper.to_double(), 0.109039009, 1e-8);
  EXPECT_NEAR(zeros[1].upper.to_double(), 0.231933369, 1e-8);
}

TEST(InsetFamily, IsInLowestTerms) {
  // At a vertex l_1 = (1 - alpha)/(1 - 3 alpha): nothing cancels. At the centroid l_1 = 1/3.
  const InsetFamily family(1);
  EXPECT_EQ(family.value(0, at(0, 0)), (InsetFunction{1 - alpha, 1}));
  EXPECT_EQ(family.value(0, at(Rational(1, 3), Rational(1, 3))), (InsetFunction{Rational(1, 3), 0}));
  EXPECT_EQ(family.value(0, at(0, 0)).to_text(), "(-alpha + 1) / (1 - 3 alpha)");
}

TEST(InsetFamily, RefusesWhatIsOutOfRange) {
  EXPECT_THROW(InsetFamily(-1), ContractViolation);
  EXPECT_THROW(InsetFamily(31), ContractViolation);
  const InsetFamily family(1);
  EXPECT_THROW(static_cast<void>(family.node(3)), ContractViolation);
  EXPECT_THROW(static_cast<void>(family.weight(3)), ContractViolation);
  EXPECT_THROW(static_cast<void>(family.value(0, {{1, 1, 1}})), ContractViolation);
  EXPECT_THROW(static_cast<void>(family.defect(Region::triangle, {-1, 0})), ContractViolation);
  EXPECT_THROW(static_cast<void>(family.condition(Region::triangle, -1)), ContractViolation);
  EXPECT_THROW(static_cast<void>(family.value(0, at(0, 0))(Rational(1, 3))), ContractViolation);
}

}  // namespace
}  // namespace radcert
