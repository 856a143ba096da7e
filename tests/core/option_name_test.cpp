// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/option_name.h"

#include <gtest/gtest.h>

namespace radcert {
namespace {

TEST(OptionName, IsWrittenAsItsUserWritesIt) {
  EXPECT_EQ(option_name(OptionStyle::command_line, "two-sided"), "--two-sided");
  EXPECT_EQ(option_name(OptionStyle::argument, "two-sided"), "two_sided");
  EXPECT_EQ(option_name(OptionStyle::argument, "space"), "space");
}

}  // namespace
}  // namespace radcert
