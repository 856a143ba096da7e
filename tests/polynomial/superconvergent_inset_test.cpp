// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/superconvergent_inset.h"

#include <gtest/gtest.h>

#include <map>

#include "radcert/polynomial/rules/interpolatory_rule.h"
#include "radcert/scalar/ball.h"
#include "tests/polynomial/node_sets.h"

namespace radcert {
namespace {

constexpr std::array both = {Region::triangle, Region::parallelogram};

std::string title(int degree, Region region) {
  return "degree " + std::to_string(degree) + (region == Region::triangle ? ", triangle" : ", parallelogram");
}

struct Expected {
  std::vector<double> insets;
  int precision;  ///< at each of them
};

// The answers to degree 12; the zeros as mpmath finds them from the condition in 30 digits.
const std::map<std::pair<int, Region>, Expected> gains = {
    {{1, Region::triangle}, {{0.1666666666666667}, 2}},
    {{1, Region::parallelogram}, {{0.1666666666666667}, 3}},
    {{2, Region::triangle}, {{0.1090390090728772, 0.2319333685530306}, 3}},
    {{3, Region::triangle}, {{0.07793654034364664}, 4}},
    {{3, Region::parallelogram}, {{0.07793654034364664}, 5}},
    {{4, Region::triangle}, {{0.06097282700790822, 0.176887607008452}, 5}},
    {{6, Region::triangle}, {{0.04114156083292955, 0.1425836386289845}, 7}},
};

TEST(SuperconvergentInsets, AreTheKnownOnesWithTheirCertificate) {
  for (int degree = 0; degree <= 12; ++degree)
    for (const Region region : both) {
      const SuperconvergentInsets answer = superconvergent_insets(degree, region);
      const Outcome<void> proof = recheck(answer);
      EXPECT_TRUE(proof) << title(degree, region) << (proof ? "" : ": " + proof.reason());
      const bool parity = degree % 2 == 0 && (region == Region::parallelogram || degree == 0);
      EXPECT_EQ(answer.precision, degree + (parity ? 1 : 0)) << title(degree, region);
      const auto known = gains.find({degree, region});
      if (known == gains.end()) {
        EXPECT_EQ(answer.condition, RationalPolynomial(1)) << title(degree, region);
        EXPECT_TRUE(answer.insets.empty()) << title(degree, region);
        continue;
      }
      ASSERT_EQ(answer.insets.size(), known->second.insets.size()) << title(degree, region);
      for (std::size_t i = 0; i < answer.insets.size(); ++i) {
        EXPECT_NEAR(answer.insets[i].enclosure.upper.to_double(), known->second.insets[i], 1e-12)
            << title(degree, region);
        EXPECT_EQ(answer.insets[i].precision, known->second.precision) << title(degree, region);
      }
    }
}

// A numerator of degree n is determined by n + 1 values; here they come from the inverse of the nodes'
// matrix.
TEST(SuperconvergentInsets, RestOnDefectsThatAnotherRouteConfirms) {
  for (int degree = 1; degree <= 5; ++degree)
    for (const Region region : both) {
      const SuperconvergentInsets answer = superconvergent_insets(degree, region);
      int largest = 0;
      for (const InsetDefect& d : answer.defects) largest = std::max(largest, d.defect.numerator.degree());
      for (int k = 0; k <= largest + degree; ++k) {
        const Rational inset(k, 3L * (largest + degree + 1));
        const TriangleRule<Rational> rule = interpolatory_rule(functions_of(inset_nodes(degree, inset)));
        for (const InsetDefect& d : answer.defects)
          EXPECT_EQ(d.defect(inset), defect(rule, region, d.monomial)) << title(degree, region);
      }
    }
}

TEST(SuperconvergentInsets, HaveClosedForms) {
  EXPECT_EQ(superconvergent_insets(1, Region::triangle).insets[0].closed_form, "1/6");
  EXPECT_EQ(superconvergent_insets(3, Region::triangle).insets[0].closed_form, "7/15 - 1/15 sqrt(34)");
  // (1 + cos((arccos(4/5) + 2 pi k)/3))/3 with arccos(4/5) = arctan(3/4).
  const SuperconvergentInsets cubic = superconvergent_insets(2, Region::triangle);
  for (int k = 1; k <= 2; ++k) {
    const Ball angle = (atan(Ball(Rational(3, 4))) + Ball(2 * k) * Ball::pi()) / Ball(3);
    const Ball inset = (Ball(1) + cos(angle)) / Ball(3);
    const RealZero& zero = cubic.insets[static_cast<std::size_t>(k) - 1].enclosure;
    EXPECT_TRUE(certainly_less(Ball(zero.lower), inset) && certainly_less(inset, Ball(zero.upper))) << k;
    EXPECT_FALSE(cubic.insets[static_cast<std::size_t>(k) - 1].closed_form);
  }
}

bool has_zero_modulo(const RationalPolynomial& p, long prime) {
  for (long x = 0; x < prime; ++x)
    if ((p(Rational(x)) / Rational(prime)).is_integer()) return true;
  return false;
}

RationalPolynomial whole(const RationalPolynomial& p) {
  Rational common = 1;
  for (int k = 0; k <= p.degree(); ++k)
    common *= (common * p.coefficient(static_cast<std::size_t>(k))).denominator();
  return common * p;
}

TEST(SuperconvergentInsets, OfDegreeTwoAreNotRational) {
  const RationalPolynomial p = whole(superconvergent_insets(2, Region::triangle).condition);
  EXPECT_EQ(p.leading(), Rational(60));
  EXPECT_FALSE(has_zero_modulo(p, 7) && has_zero_modulo(p, 11) && has_zero_modulo(p, 13));
}

TEST(SuperconvergentInsets, RejectCertificatesThatProveNothing) {
  for (const int degree : {2, 5}) {
    const SuperconvergentInsets right = superconvergent_insets(degree, Region::triangle);
    ASSERT_TRUE(recheck(right));
    SuperconvergentInsets wrong = right;
    wrong.cofactors.back() += 1;
    wrong.cofactors.front() += 1;
    EXPECT_FALSE(recheck(wrong));
    wrong = right;
    wrong.condition *= RationalPolynomial::variable() - RationalPolynomial(Rational(1, 5));
    EXPECT_FALSE(recheck(wrong));
    wrong = right;
    wrong.insets.emplace_back().enclosure = {Rational(1, 5), Rational(1, 5)};
    EXPECT_FALSE(recheck(wrong));
    wrong = right;
    wrong.cofactors.pop_back();
    EXPECT_FALSE(recheck(wrong));
    wrong = right;
    wrong.condition = RationalPolynomial();
    EXPECT_FALSE(recheck(wrong));
  }
  SuperconvergentInsets moved = superconvergent_insets(2, Region::triangle);
  moved.insets[1].enclosure.upper = moved.insets[1].enclosure.lower;
  EXPECT_FALSE(recheck(moved));
  // The third zero lies at 0.659.
  moved = superconvergent_insets(2, Region::triangle);
  moved.insets[1].enclosure = {Rational(3, 5), Rational(7, 10)};
  EXPECT_FALSE(recheck(moved));
  moved = superconvergent_insets(2, Region::triangle);
  std::swap(moved.insets[0], moved.insets[1]);
  EXPECT_FALSE(recheck(moved));
}

TEST(SuperconvergentInset, IsAsCloseAsAsked) {
  const Rational width = 1 / power(Rational(10), 80);
  const NearInset one = superconvergent_inset(1, width).value();
  EXPECT_TRUE(one.is_exact);
  EXPECT_EQ(one.value, Rational(1, 6));
  const NearInset three = superconvergent_inset(3, width).value();
  EXPECT_FALSE(three.is_exact);
  // 15 alpha_0 - 7 = -sqrt 34, to 2 15 sqrt 34 width.
  const Rational root = 7 - 15 * three.value;
  EXPECT_LE(abs(root * root - 34), 175 * width);
  EXPECT_GT(root.sign(), 0);
}

TEST(SuperconvergentInset, IsProvedToBeMissing) {
  for (const int degree : {2, 4, 5, 6}) {
    const Outcome<NearInset> none = superconvergent_inset(degree, Rational(1, 1000));
    ASSERT_FALSE(none) << degree;
    EXPECT_NE(none.reason().find("proven"), std::string::npos) << none.reason();
    EXPECT_EQ(none.reason().find("every alpha") != std::string::npos, degree % 2 == 0) << none.reason();
  }
  EXPECT_THROW(static_cast<void>(superconvergent_inset(0, 1)), ContractViolation);
}

TEST(SuperconvergentInsets, SayWhatTheyAre) {
  EXPECT_EQ(superconvergent_insets(1, Region::triangle).to_text(), "1/6");
  const std::string none = superconvergent_insets(5, Region::triangle).to_text();
  EXPECT_EQ(none.find("none: the defects of s^6"), 0U) << none;
}

}  // namespace
}  // namespace radcert
