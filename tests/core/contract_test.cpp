// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/contract.h"

#include <gtest/gtest.h>
#include <string>

namespace {

using radcert::ContractViolation, radcert::expects, radcert::named, radcert::description;

struct Counted {
  mutable int* shown;
  [[nodiscard]] std::string to_text() const {
    ++*shown;
    return "counted";
  }
};
struct Mute {};
enum class Colour { red = 3 };

TEST(Expects, PassesSilentlyWithoutMakingText) {
  int shown = 0;
  EXPECT_NO_THROW(expects(true, "never shown", named("value", Counted{&shown})));
  EXPECT_EQ(shown, 0);
}

TEST(Expects, ShowsRequirementAndValues) {
  const double inset = 0.1;
  try {
    expects(inset > 1, "inset > 1", named("inset", inset), named("name", "a\nb"), named("count", -3L));
    FAIL() << "no exception";
  } catch (const ContractViolation& violation) {
    EXPECT_STREQ(violation.what(), "required: inset > 1; inset = 0.1, name = \"a\\nb\", count = -3");
  }
}

TEST(Expects, HoldsInConstantExpressions) {
  constexpr int checked = [] {
    expects(1 + 1 == 2, "arithmetic");
    return 7;
  }();
  static_assert(checked == 7);
}

TEST(Description, ShowsEveryKindOfValue) {
  int shown = 0;
  EXPECT_EQ(description(true), "true");
  EXPECT_EQ(description(0.1), "0.1");
  EXPECT_EQ(description('\n'), "\"\\n\"");
  EXPECT_EQ(description(UINT64_MAX), "18446744073709551615");
  EXPECT_EQ(description(std::string("text")), "\"text\"");
  EXPECT_EQ(description(Counted{&shown}), "counted");
  EXPECT_EQ(description(Colour::red), "3");
  EXPECT_EQ(description(Mute{}), "(a value without text)");
}

}  // namespace
