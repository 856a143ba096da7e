// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/version.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

TEST(Version, ComesFromTheBuild) {
  const std::string_view version = radcert::version();
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2) << version;
}

TEST(SourceDigest, IsAHexadecimalNumber) {
  const std::string_view digest = radcert::source_digest();
  EXPECT_GE(digest.size(), 16U);
  EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string_view::npos) << digest;
}

}  // namespace
