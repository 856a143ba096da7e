// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/base64.h"

#include <gtest/gtest.h>

namespace radcert {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  for (const auto& [bytes, text] : {std::pair("", ""),
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foobar", "Zm9vYmFy"},
                                    {"\xff\xfe\xfd", "//79"}}) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
}

TEST(Base64, ReadsWhatItWroteOfEveryLength) {
  // Longer than what is handed to the library at a time, and so that each remainder by three occurs.
  std::string bytes;
  for (std::size_t k = 0; k < (3U << 20U) + 5; ++k) bytes.push_back(static_cast<char>(k * k >> 3U));
  for (const std::size_t less : {0U, 1U, 2U, 3U, 4U, 5U, 6U}) {
    const std::string part = bytes.substr(0, bytes.size() - less);
    EXPECT_EQ(from_base64(base64(part)), part) << less;
  }
}

TEST(Base64, ReadsNothingElse) {
  for (const char* text :
       {"Zg=", "Zg", "Z===", "====", "Zm9v ", " Zm9", "Zm=v", "Zm9\n", "Zm9v====", "Zm9-", "Zm9_"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace radcert
