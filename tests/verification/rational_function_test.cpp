// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/rational_function.h"

#include <gtest/gtest.h>

#include <array>

#include "radcert/core/contract.h"
#include "verification/claims/induction.h"

namespace radcert::verification {
namespace {

using Function = RationalFunction;

const Function x = Function::variable("x");
const Function y = Function::variable("y");

TEST(RationalFunction, IsAField) {
  EXPECT_EQ(differing_terms((x + y) * (x - y), x * x - y * y), 0);
  EXPECT_EQ(differing_terms(1 / x + 1 / y, (x + y) / (x * y)), 0);
  EXPECT_EQ(differing_terms((x * x - y * y) / (x - y), x + y), 0);
  EXPECT_EQ(differing_terms(-(x - y), y - x), 0);
  EXPECT_EQ(differing_terms(x * y, y * x), 0);
  EXPECT_EQ((x + y) / (x + y), Function(1));
  EXPECT_THROW(static_cast<void>(x / (y - y)), ContractViolation);
}

TEST(RationalFunction, TellsOneFunctionFromAnother) {
  EXPECT_NE(differing_terms(1 / x + 1 / y, 1 / (x + y)), 0);
  EXPECT_EQ(differing_terms(x * x, x), 2);
  EXPECT_EQ(differing_terms(x + Rational(1, 1000000), x), 1);
  EXPECT_FALSE(x == y);
}

TEST(RationalFunction, CountsNegativeCoefficientsOfBothParts) {
  EXPECT_EQ(negative_terms((x + y) / (1 + x)), 0);
  EXPECT_EQ(negative_terms(x - y), 1);
  EXPECT_EQ(negative_terms((x - y) / (1 - x)), 2);
  EXPECT_EQ(negative_terms((x + y) * (x + y) - x * x), 0);
}

TEST(RationalFunction, TakesASquareForWhatItIs) {
  const std::array rules{
      SquareRule{.name = "x", .square = 1 - Polynomial::variable("y") * Polynomial::variable("y")}};
  EXPECT_EQ(differing_terms(x * x + y * y, 1, rules), 0);
  EXPECT_EQ(differing_terms(x * x * x, x * (1 - y * y), rules), 0);
  EXPECT_NE(differing_terms(x * y, 1, rules), 0);
  EXPECT_THROW(static_cast<void>(Polynomial::variable("x").with_square("x", Polynomial::variable("x"))),
               ContractViolation);
}

// The sum of the first n odd numbers.
struct OddNumbers {
  Function count;
  Function sum;
};
// n^2 added to so much is said to be the sum; the next odd number is 2n + 1, or 2n + 2.
Rational said_of_odd_numbers(const Function& added, int next) {
  const Function n = Function::variable("n");
  return left_over_by_induction(
      OddNumbers{0, 0}, OddNumbers{n, n * n + added},
      [&](const OddNumbers& before) {
        return OddNumbers{before.count + 1, before.sum + 2 * before.count + next};
      },
      [&](const OddNumbers& all) { return differing_terms(all.sum, all.count * all.count + added); });
}
TEST(Induction, ProvesWhatHoldsForEveryLengthAndNothingElse) {
  EXPECT_EQ(said_of_odd_numbers(0, 1), 0);
  EXPECT_NE(said_of_odd_numbers(1, 1), 0);  // true of the step alone
  EXPECT_NE(said_of_odd_numbers(0, 2), 0);  // true of the empty list alone
}

// What is said to be any state has to be one of which the statement is true.
TEST(Induction, LooksAtItsHypothesis) {
  const auto same = [](const OddNumbers& all) { return all; };
  const auto leftover = [](const OddNumbers& all) { return differing_terms(all.sum, all.count); };
  EXPECT_EQ(left_over_by_induction(OddNumbers{0, 0}, OddNumbers{x, x}, same, leftover), 0);
  EXPECT_NE(left_over_by_induction(OddNumbers{0, 0}, OddNumbers{x, y}, same, leftover), 0);
}

}  // namespace
}  // namespace radcert::verification
