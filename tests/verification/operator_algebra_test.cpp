// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/operator_algebra.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert::verification {
namespace {

const Operator one(1);

OperatorRelations solved() {
  return OperatorRelations({{.product = "RB", .replacement = one},
                            {.product = "RKBX", .replacement = Operator("X") - one},
                            {.product = "XRKB", .replacement = Operator("X") - one}});
}

TEST(Operator, MultipliesDistributively) {
  const Operator k("K");
  const Operator p("P");
  EXPECT_EQ(((one - k) * (one + p)).terms(), (one + p - k - k * p).terms());
  EXPECT_TRUE((k * p - k * p).terms().empty());
  EXPECT_EQ((k * p - p * k).terms().size(), 2U);
}

TEST(Operator, RefusesSpacesThatDoNotFit) {
  EXPECT_THROW(Operator("RR"), ContractViolation);
  EXPECT_THROW(Operator("B") * Operator("K"), ContractViolation);
  EXPECT_THROW(Operator("R") + Operator("B"), ContractViolation);
  EXPECT_THROW(one + Operator("R"), ContractViolation);
  EXPECT_THROW(Operator("A"), ContractViolation);
}

TEST(OperatorRelations, GiveOneNormalFormWhateverTheBrackets) {
  const OperatorRelations relations = solved();
  const std::vector<Operator> of_values{Operator("X"), one - Operator("RKB"), Operator("RB") + Operator("X")};
  for (const Operator& a : of_values)
    for (const Operator& b : of_values)
      for (const Operator& c : of_values)
        EXPECT_EQ(relations.normal_form(relations.normal_form(a * b) * c).terms(),
                  relations.normal_form(a * relations.normal_form(b * c)).terms());
}

TEST(OperatorRelations, TellAnInverseFromAnythingElse) {
  const Operator matrix = one - Operator("RKB");
  EXPECT_EQ(solved().differing_words(matrix * Operator("X"), one), 0);
  EXPECT_EQ(solved().differing_words(Operator("X") * matrix, one), 0);
  EXPECT_NE(solved().differing_words(matrix, one), 0);
  EXPECT_NE(OperatorRelations({}).differing_words(matrix * Operator("X"), one), 0);
}

// An operator of one space, with matrices for its letters.
using Matrix2 = std::array<std::array<Rational, 2>, 2>;
Matrix2 product(const Matrix2& a, const Matrix2& b) {
  Matrix2 c;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  return c;
}
Matrix2 sum(const Matrix2& a, const Matrix2& b, const Rational& multiple) {
  Matrix2 c = a;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) c[i][j] += multiple * b[i][j];
  return c;
}
const Matrix2 identity{{{1, 0}, {0, 1}}};
Matrix2 at(const Operator& a, const std::map<char, Matrix2>& letters) {
  Matrix2 all{};
  for (const auto& [word, multiple] : a.terms()) {
    Matrix2 factor = identity;
    for (const char letter : word) factor = product(factor, letters.at(letter));
    all = sum(all, factor, multiple);
  }
  return all;
}

// The rules of Neumann's series hold for Z = I + K + ... + K^k and Y = K^(k+1), whatever the matrix K and k,
// and rewriting by them changes no operator.
TEST(OperatorRelations, HoldForMatricesThatMeetTheirRules) {
  const std::vector<OperatorRelations::Rule> rules{
      {.product = "KZ", .replacement = Operator("Z") + Operator("Y") - one},
      {.product = "ZK", .replacement = Operator("Z") + Operator("Y") - one},
      {.product = "YK", .replacement = Operator("KY")},
      {.product = "YZ", .replacement = Operator("ZY")}};
  const OperatorRelations relations(rules);
  std::map<char, Matrix2> letters{{'K', {{{Rational(1, 2), 3}, {-1, Rational(2, 7)}}}}, {'Z', identity}};
  letters['Y'] = letters['K'];
  for (int k = 0; k < 4; ++k) {
    for (const OperatorRelations::Rule& rule : rules)
      EXPECT_EQ(at(Operator(rule.product), letters), at(rule.replacement, letters)) << rule.product;
    for (const char* const word : {"KKZ", "ZKY", "YZK", "KYZKZ", "ZZKK", "YKZYK"})
      EXPECT_EQ(at(Operator(word), letters), at(relations.normal_form(Operator(word)), letters)) << word;
    letters['Z'] = sum(letters['Z'], letters['Y'], 1);
    letters['Y'] = product(letters['K'], letters['Y']);
  }
}

// With K P = I and P K = P the word K P K is K by the one and I by the other, which no rule makes one.
TEST(OperatorRelations, RefuseRulesThatAreNotConfluent) {
  EXPECT_THROW(OperatorRelations({{.product = "KP", .replacement = one},  //
                                  {.product = "PK", .replacement = Operator("P")}}),
               ContractViolation);
  EXPECT_THROW(OperatorRelations({{.product = "KPK", .replacement = one},  //
                                  {.product = "PK", .replacement = one}}),
               ContractViolation);
}

}  // namespace
}  // namespace radcert::verification
