// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/operator_algebra.h"

#include <gtest/gtest.h>

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
