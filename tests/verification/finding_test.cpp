// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/finding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "tests/verification/fixtures.h"

namespace radcert::verification {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const Equals one{.value = 1, .slack = 0.125, .why = ""};
const Order four = Order::at_least(4);

ObservedOrder exponent(double value, double radius) {
  return {.exponent = {.value = value, .radius = radius}};
}
const AtMost two{.value = 2, .slack = 0, .why = ""};

TEST(Judge, LeavesOpenWhatTheRadiusDoesNotSettle) {
  EXPECT_EQ(judge(one, {1.0625, 0.0625}), Standing::holds);
  EXPECT_EQ(judge(one, {1.0625, 0.125}), Standing::open);
  EXPECT_EQ(judge(one, {1.25, 0.0625}), Standing::violated);
  EXPECT_EQ(judge(one, {1.25, 0.125}), Standing::open);
  EXPECT_EQ(judge(four, exponent(3.875, 0.125)), Standing::holds);
  EXPECT_EQ(judge(four, exponent(3.875, 0.375)), Standing::open);
  EXPECT_EQ(judge(four, exponent(3.25, 0.125)), Standing::violated);
  EXPECT_EQ(judge(four, exponent(9, 0.125)), Standing::holds);
  EXPECT_EQ(judge(two, {2, 0}), Standing::holds);
  EXPECT_EQ(judge(two, {2, 0.5}), Standing::open);
  EXPECT_EQ(judge(two, {3, 0.5}), Standing::violated);
}

TEST(Judge, LeavesOpenWhatIsNotFinite) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const Approximation& observed : {Approximation{none, 0}, Approximation{1, none},
                                        Approximation{1, infinite}, Approximation{infinite, 0}}) {
    EXPECT_EQ(judge(one, observed), Standing::open);
    EXPECT_EQ(judge(four, ObservedOrder{.exponent = observed}), Standing::open);
    EXPECT_EQ(judge(two, observed), Standing::open);
  }
}

TEST(Judge, HoldsBallsAgainstEachOtherAtAllOfTheirPoints) {
  const auto ball = [](double middle, double radius) { return widened(Ball(middle), Ball(radius)); };
  const AgreesWith third{.value = ball(3, 0.125), .within = 0.5};
  EXPECT_EQ(judge(third, ball(3.25, 0.125)), Standing::holds);
  EXPECT_EQ(judge(third, ball(3.25, 0.25)), Standing::open);
  EXPECT_EQ(judge(third, ball(2.75, 0.125)), Standing::holds);
  EXPECT_EQ(judge(third, ball(3.875, 0.125)), Standing::violated);
  EXPECT_EQ(judge(third, ball(2.125, 0.125)), Standing::violated);
  EXPECT_EQ(judge(third, ball(3.875, 0.25)), Standing::open);
  EXPECT_EQ(judge(third, Ball::failed("nothing is known")), Standing::open);
  EXPECT_EQ(judge(AgreesWith{.value = Ball::failed("no value"), .within = 1}, Ball(3)), Standing::open);
  EXPECT_EQ(judge(AgreesWith{.value = Ball(3), .within = 0}, Ball(3)), Standing::holds);
  EXPECT_THROW(static_cast<void>(judge(AgreesWith{.value = Ball(3), .within = -1}, Ball(3))),
               ContractViolation);
}

TEST(Finding, TakesTheAgreementOfBallsForAProof) {
  const AgreesWith one_third{.value = Ball(Rational(1, 3)), .within = 1e-30};
  Finding finding;
  finding.require("a", one_third, Ball(1) / Ball(3));
  finding.control("b", one_third, Ball(1) / Ball(4));
  EXPECT_EQ(finding.verdict(), Verdict::certified);
  EXPECT_EQ(finding.evidence()[0].value.substr(0, 5), "0.333");
  EXPECT_TRUE(finding.evidence()[0].radius.has_value());
  finding.require("c", one_third, Ball::failed("no bound was found"));
  EXPECT_EQ(finding.verdict(), Verdict::undecided);
  EXPECT_NE(finding.evidence()[2].value.find("no bound was found"), std::string::npos);
  EXPECT_FALSE(finding.evidence()[2].radius.has_value());
}

TEST(Finding, FailsWhereAControlIsNotRejected) {
  Finding finding;
  finding.require("a", one, Approximation{1, 0});
  finding.control("b", one, Approximation{1, 0});
  EXPECT_EQ(finding.verdict(), Verdict::failed);
  Finding open;
  open.require("a", one, Approximation{1, 0});
  open.control("b", one, Approximation{2, 5});
  EXPECT_EQ(open.verdict(), Verdict::failed);
  Finding one_of_two;
  one_of_two.require("a", one, Approximation{1, 0});
  one_of_two.control("b", one, Approximation{2, 0});
  one_of_two.control("c", one, Approximation{1, 0});
  EXPECT_EQ(one_of_two.verdict(), Verdict::failed);
}

TEST(Finding, FailsWhereItRejectsEverything) {
  const auto contradicted = [] {
    Finding finding;
    finding.require("printed", one, Approximation{3, 0});
    finding.control("c", one, Approximation{2, 0});
    return finding;
  };
  EXPECT_EQ(contradicted().verdict(), Verdict::failed);
  EXPECT_NE(contradicted().fault().value().find("what holds instead"), std::string::npos);
  Finding corrected = contradicted();
  corrected.instead("corrected", Equals{.value = 3, .slack = 0, .why = ""}, Approximation{3, 0});
  EXPECT_EQ(corrected.verdict(), Verdict::contradicted);
  Finding of_another_kind = contradicted();
  of_another_kind.instead("corrected", AtMost{.value = 3, .slack = 0, .why = ""}, Approximation{3, 0});
  EXPECT_EQ(of_another_kind.verdict(), Verdict::failed);
  Finding wrong = contradicted();
  wrong.instead("corrected", Equals{.value = 4, .slack = 0, .why = ""}, Approximation{3, 0});
  EXPECT_EQ(wrong.verdict(), Verdict::failed);
  Finding elsewhere = contradicted();
  elsewhere.require("at another place", one, Approximation{1, 0});
  EXPECT_EQ(elsewhere.verdict(), Verdict::contradicted);
  // What is shown to hold instead does not make up for a requirement.
  Finding nothing_required;
  nothing_required.instead("a", one, Approximation{1, 0});
  nothing_required.control("c", one, Approximation{2, 0});
  EXPECT_EQ(nothing_required.verdict(), Verdict::failed);
  Finding of_data = Finding::of_data();
  of_data.require("printed", one, Approximation{3, 0});
  of_data.control("c", one, Approximation{2, 0});
  EXPECT_EQ(of_data.verdict(), Verdict::contradicted);
}

TEST(Finding, FailsWhereAControlIsMadeOfARequirement) {
  const double rate = 15.7321;
  const AtMost small{.value = 20, .slack = 0, .why = ""};
  const auto with_control = [&](double number) {
    Finding finding;
    finding.require("rate", small, Approximation{rate, 0});
    finding.control("c", AtMost{.value = -30, .slack = 0, .why = ""}, Approximation{number, 0});
    return finding.verdict();
  };
  for (const double number : {rate, -rate, 1 / rate, -1 / rate})
    EXPECT_EQ(with_control(number), Verdict::failed);
  EXPECT_EQ(with_control(1.001 * rate), Verdict::supported);
  // Short numbers meet by chance.
  Finding short_number;
  short_number.require("a", one, Approximation{1, 0});
  short_number.control("b", one, Approximation{-1, 0});
  EXPECT_EQ(short_number.verdict(), Verdict::supported);
}

TEST(Finding, FailsWithoutAControlAndWithoutARequirement) {
  Finding no_control;
  no_control.require("a", one, Approximation{1, 0});
  EXPECT_EQ(no_control.verdict(), Verdict::failed);
  Finding no_requirement;
  no_requirement.control("b", one, Approximation{2, 0});
  EXPECT_EQ(no_requirement.verdict(), Verdict::failed);
  EXPECT_EQ(Finding().verdict(), Verdict::failed);
}

TEST(Finding, IsTheWorstOfItsRequirements) {
  const auto with = [](const Approximation& observed) {
    Finding finding;
    finding.require("a", one, Approximation{1, 0});
    finding.require("b", one, observed);
    finding.control("c", one, Approximation{2, 0});
    return finding.verdict();
  };
  EXPECT_EQ(with({1, 0}), Verdict::supported);
  EXPECT_EQ(with({1, 0.5}), Verdict::undecided);
  EXPECT_EQ(with({3, 0.5}), Verdict::contradicted);
  EXPECT_EQ(with({infinite, 0}), Verdict::undecided);
}

TEST(Finding, IsCertifiedOnlyIfEveryRequirementIsProved) {
  Finding exact;
  exact.require("a", IsExactly{Rational(1, 3)}, Rational(2, 6));
  exact.control("b", IsExactly{Rational(1, 3)}, Rational(1, 4));
  EXPECT_EQ(exact.verdict(), Verdict::certified);
  exact.require("c", two, Approximation{.value = 1, .radius = 0.5, .guaranteed = true});
  EXPECT_EQ(exact.verdict(), Verdict::certified);
  exact.require("d", two, Approximation{.value = 1, .radius = 0.5, .guaranteed = false});
  EXPECT_EQ(exact.verdict(), Verdict::supported);
}

// In doubles 1 + 2^-60 is 1, and 2^60 + 1 - 2^60 is 0.
TEST(Judge, ComparesBothSidesWithoutRounding) {
  const auto number = [](double value, double radius) {
    return Approximation{.value = value, .radius = radius, .guaranteed = true};
  };
  EXPECT_EQ(judge(AtMost{.value = 1, .slack = 0, .why = ""}, number(1, 0x1p-60)), Standing::open);
  EXPECT_EQ(judge(AtMost{.value = 1, .slack = 0x1p-60, .why = ""}, number(1, 0x1p-60)), Standing::holds);
  EXPECT_EQ(judge(AtMost{.value = 1, .slack = 0x1p-60, .why = ""}, number(1 + 0x1p-52, 0)),
            Standing::violated);
  EXPECT_EQ(judge(Order::at_least(1), exponent(0.5, 0x1p-60)), Standing::open);
  EXPECT_EQ(judge(Order::at_most(1, 2), exponent(1.5 + 0x1p-52, 0x1p-60)), Standing::violated);
  EXPECT_EQ(judge(Equals{.value = 0x1p60, .slack = 0.5, .why = ""}, number(0x1p60, 1)), Standing::open);
  EXPECT_EQ(judge(Equals{.value = 1, .slack = 0x1p-53, .why = ""}, number(1 + 0x1p-52, 0x1p-60)),
            Standing::violated);
  EXPECT_EQ(judge(AtMost{.value = HUGE_VAL, .slack = 0, .why = ""}, number(1, 0)), Standing::open);
}

TEST(Order, IsToldFromItsNeighboursAtTheMiddle) {
  const Order is_two = Order::is(2);
  EXPECT_EQ(judge(is_two, exponent(2.25, 0.125)), Standing::holds);
  EXPECT_EQ(judge(is_two, exponent(2.25, 0.25)), Standing::open);
  EXPECT_EQ(judge(is_two, exponent(2.75, 0.125)), Standing::violated);
  EXPECT_EQ(judge(is_two, exponent(1.25, 0.125)), Standing::violated);
  EXPECT_EQ(judge(is_two, exponent(2, 8)), Standing::open);
  EXPECT_EQ(judge(Order::at_least(1, 0.5), exponent(0.7, 0.01)), Standing::violated);
  EXPECT_EQ(judge(Order::at_least(1, 0.5), exponent(0.8, 0.01)), Standing::holds);
  EXPECT_EQ(judge(Order::at_most(0, 2), exponent(-3, 0.5)), Standing::holds);
  EXPECT_EQ(judge(Order::at_most(0, 2), exponent(1.5, 0.25)), Standing::violated);
  EXPECT_THROW(static_cast<void>(judge(Order::at_least(1, 1), exponent(1, 0))), ContractViolation);
  EXPECT_THROW(static_cast<void>(judge(Order::at_most(1, 0), exponent(1, 0))), ContractViolation);
}

// h^3 is taken for 3 + lambda in a model with |log h|: the middle moves with it.
TEST(Order, OfALogarithmIsToldFromTheSlowerOneWithout) {
  const ObservedOrder between{.exponent = {.value = 3.6, .radius = 0.01}, .logarithm = 0.5};
  EXPECT_EQ(judge(four, between), Standing::violated);
  EXPECT_EQ(judge(four, ObservedOrder{.exponent = between.exponent}), Standing::holds);
}

TEST(Order, NamesItsNeighboursAndIsNoProof) {
  Finding finding;
  finding.require("a", Order::is(2), exponent(2, 0.125));
  finding.require("b", four, ObservedOrder{.exponent = {.value = 4, .radius = 0}, .logarithm = 0.5});
  finding.control("c", four, exponent(3, 0));
  EXPECT_EQ(finding.evidence()[0].allowed, "order = 2: between 1.5 and 2.5, the middle to 1 and to 3");
  EXPECT_NE(
      finding.evidence()[1].allowed.find("above 3.75, the middle to 3 without |log h|, which gives 3.5"),
      std::string::npos);
  EXPECT_EQ(finding.evidence()[0].kind, "order");
  EXPECT_EQ(finding.verdict(), Verdict::supported);
}

TEST(LiesIn, ComparesTheWholeEnclosureExactly) {
  const LiesIn third{.least = Rational(1, 4), .largest = Rational(1, 3)};
  const auto number = [](double value, double radius) {
    return Approximation{.value = value, .radius = radius, .guaranteed = true};
  };
  EXPECT_EQ(judge(third, number(0.28125, 0.03125)), Standing::holds);  // touches 1/4
  EXPECT_EQ(judge(third, number(0.28125, 0.0625)), Standing::open);    // sticks out on both sides
  EXPECT_EQ(judge(third, number(0.21875, 0.03125)), Standing::open);   // touches 1/4 from outside
  EXPECT_EQ(judge(third, number(0.21875, 0.015625)), Standing::violated);
  EXPECT_EQ(judge(third, number(0.5, 0.125)), Standing::violated);
  EXPECT_EQ(judge(third, number(0.3, std::numeric_limits<double>::infinity())), Standing::open);
  EXPECT_EQ(judge(third, Ball(Rational(3, 10))), Standing::holds);
  EXPECT_EQ(judge(third, Ball(Rational(1, 5))), Standing::violated);
  EXPECT_EQ(judge(third, Ball(Rational(2, 5))), Standing::violated);
  EXPECT_EQ(judge(third, Ball(Rational(1, 3))), Standing::open);  // a ball of 1/3 reaches to both sides of it
}

TEST(LiesIn, ShowsItsEndsAsTheyWereWritten) {
  Finding finding;
  finding.require("a", LiesIn{.least = Rational(-203, 10000), .largest = Rational(1, 3)}, Ball(0));
  EXPECT_EQ(finding.evidence()[0].allowed, "in [-0.0203, 1/3]");
  EXPECT_TRUE(finding.evidence()[0].proved);
}

}  // namespace
}  // namespace radcert::verification
