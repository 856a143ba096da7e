// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/outcome.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace {

using radcert::because, radcert::ContractViolation, radcert::Outcome;

Outcome<std::string> greeting(bool known) {
  if (!known) return because("nobody is there");
  return std::string("hello");
}

TEST(Outcome, HoldsAValueOrAReason) {
  const auto yes = greeting(true);
  ASSERT_TRUE(yes.has_value());
  EXPECT_EQ(*yes, "hello");
  EXPECT_EQ(yes->size(), 5U);
  const auto no = greeting(false);
  ASSERT_FALSE(no);
  EXPECT_EQ(no.reason(), "nobody is there");
  EXPECT_EQ(no.value_or("silence"), "silence");
}

TEST(Outcome, RefusesTheSideItDoesNotHold) {
  EXPECT_THROW((void)greeting(true).reason(), ContractViolation);
  try {
    (void)greeting(false).value();
    FAIL() << "no exception";
  } catch (const ContractViolation& violation) {
    EXPECT_NE(std::string(violation.what()).find("nobody is there"), std::string::npos) << violation.what();
  }
}

TEST(Outcome, CarriesValuesThatOnlyMove) {
  Outcome<std::unique_ptr<int>> outcome(std::make_unique<int>(5));
  EXPECT_EQ(*std::move(outcome).value(), 5);
}

TEST(Outcome, TellsAValueFromAReasonOfTheSameType) {
  const Outcome<std::string> value(std::string("text"));
  const Outcome<std::string> reason = because(std::string("text"));
  EXPECT_TRUE(value.has_value());
  EXPECT_FALSE(reason.has_value());
}

TEST(Outcome, MayHaveNoValueAtAll) {
  const Outcome<void> done;
  EXPECT_TRUE(done.has_value());
  EXPECT_THROW((void)done.reason(), ContractViolation);
  const Outcome<void> refused = because("no");
  EXPECT_EQ(refused.reason(), "no");
}

}  // namespace
