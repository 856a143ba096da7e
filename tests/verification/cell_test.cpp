// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/cell.h"

#include <gtest/gtest.h>

#include <limits>

#include "radcert/core/contract.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

PrintedNumber printed(const char* text) { return parse_printed(text).value(); }

TEST(PrintedNumber, HasHalfAUnitOfItsLastDigit) {
  EXPECT_EQ(printed("1.48E-3").value, Rational(148, 100000));
  EXPECT_EQ(printed("1.48E-3").half_unit, Rational(5, 1000000));
  EXPECT_EQ(printed("12.7").half_unit, Rational(1, 20));
  EXPECT_EQ(printed("12").half_unit, Rational(1, 2));
  EXPECT_EQ(printed("12E+1").half_unit, Rational(5));
  EXPECT_EQ(printed("-0.10").value, Rational(-1, 10));
  EXPECT_EQ(printed("-0.10").half_unit, Rational(1, 200));
}

TEST(PrintedNumber, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"", "-", ".5", "1.", "1.5E", "1.5E-", "1.5 ", "+1", "1,5", "0x1", "nan", "1e9999999999", "1/6"})
    EXPECT_FALSE(parse_printed(text).has_value()) << text;
}

// Printed 1.5, half unit 1/20: everything here is exact in binary but the bound 1.55 itself.
TEST(Cell, IsReproducedUpToHalfAUnitAndContradictedBeyond) {
  EXPECT_EQ(decide(printed("1.5"), 1.5, 0, false), Verdict::reproduced);
  EXPECT_EQ(decide(printed("1.5"), 1.53125, 0.015625, false), Verdict::reproduced);
  EXPECT_EQ(decide(printed("1.5"), 1.53125, 0.03125, false), Verdict::undecided);
  EXPECT_EQ(decide(printed("1.5"), 1.5625, 0.015625, false), Verdict::undecided);
  EXPECT_EQ(decide(printed("1.5"), 1.5625, 0.0078125, false), Verdict::contradicted);
  EXPECT_EQ(decide(printed("1.5"), 1.4375, 0, false), Verdict::contradicted);
}

TEST(Cell, IsCertifiedByAGuaranteedRadiusOnly) {
  EXPECT_EQ(decide(printed("1.5"), 1.5, 0.01, true), Verdict::certified);
  EXPECT_EQ(decide(printed("1.5"), 1.5, 0.01, false), Verdict::reproduced);
  EXPECT_EQ(decide(printed("1.5"), 2, 0.01, true), Verdict::contradicted);
}

TEST(Cell, ComparesExactlyWhereRoundingWouldTip) {
  // 12 +- 1/2: the bound 12.5 is a double; it is reproduced there, and not one unit in the last place beyond.
  EXPECT_EQ(decide(printed("12"), 12.5, 0, false), Verdict::reproduced);
  EXPECT_EQ(decide(printed("12"), 12.500000000000002, 0, false), Verdict::contradicted);
  EXPECT_EQ(decide(printed("12"), 12.5, std::numeric_limits<double>::denorm_min(), false),
            Verdict::undecided);
  // The double nearest to 0.15 lies below it, so that it is still within 0.1 +- 0.05; the one nearest to 0.55
  // lies above.
  EXPECT_EQ(decide(printed("0.1"), 0.15, 0, false), Verdict::reproduced);
  EXPECT_EQ(decide(printed("0.5"), 0.55, 0, false), Verdict::contradicted);
}

TEST(Cell, RefusesNumbersThatAreNone) {
  EXPECT_THROW(static_cast<void>(decide(printed("1.5"), std::numeric_limits<double>::quiet_NaN(), 0, false)),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(decide(printed("1.5"), 1.5, std::numeric_limits<double>::infinity(), false)),
               ContractViolation);
  EXPECT_THROW(static_cast<void>(decide(printed("1.5"), 1.5, -1, false)), ContractViolation);
}

}  // namespace
}  // namespace radcert::verification
