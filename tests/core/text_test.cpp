// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace {

using radcert::is_utf8, radcert::parse_double, radcert::quotation, radcert::shortest;

TEST(Shortest, ReadsBackTheSameDouble) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 20000; ++trial) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const auto back = parse_double(shortest(value));
    ASSERT_TRUE(back.has_value()) << shortest(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << shortest(value);
  }
  for (const double value :
       {0.0, -0.0, 5e-324, std::numeric_limits<double>::max(), 2.2250738585072014e-308}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(parse_double(shortest(value)).value()),
              std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Shortest, IsShort) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e300), "1e+300");
  EXPECT_EQ(shortest(-INFINITY), "-inf");
  EXPECT_EQ(shortest(-NAN), "nan");
}

TEST(ParseDouble, RefusesWhatIsNotOneDecimalNumber) {
  for (const char* text : {"", " 1", "1 ", "+1", "1,5", "0x10", "1e", "inf", "nan", "1e999", "-1e999",
                           "1e-999", "1.5.2", "one", "--1"}) {
    EXPECT_FALSE(parse_double(text).has_value()) << text;
  }
  EXPECT_FALSE(parse_double(std::string_view("1\0", 2)).has_value());
  EXPECT_EQ(parse_double("-1.5e-3"), -1.5e-3);
}

TEST(Quotation, EscapesWhatDoesNotPrint) {
  EXPECT_EQ(quotation("plain"), "\"plain\"");
  EXPECT_EQ(quotation("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(quotation("\x1b[31m\r\n\t\x7f"), "\"\\x1b[31m\\x0d\\n\\t\\x7f\"");
  EXPECT_EQ(quotation(std::string_view("\0", 1)), "\"\\x00\"");
  EXPECT_EQ(quotation("\xff\xc3"), "\"\\xff\\xc3\"");
  EXPECT_EQ(quotation("\xc3\xa4"), "\"\xc3\xa4\"");             // a with diaeresis prints
  EXPECT_EQ(quotation("\xe2\x80\xae"), "\"\\xe2\\x80\\xae\"");  // right-to-left override does not
  EXPECT_EQ(quotation("\xc2\x9b"), "\"\\xc2\\x9b\"");           // nor does a C1 control
}

TEST(Quotation, CutsLongTextBetweenCharacters) {
  EXPECT_EQ(quotation(std::string(80, 'a')), "\"" + std::string(80, 'a') + "\"");
  EXPECT_EQ(quotation(std::string(1000000, 'a')), "\"" + std::string(80, 'a') + "\"... (1000000 bytes)");
  EXPECT_EQ(quotation("a\xc3\xa4", 2), "\"a\"... (3 bytes)");
}

TEST(IsUtf8, FollowsTheStandard) {
  for (const char* good : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xef\xbf\xbf",
                           "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_TRUE(is_utf8(good)) << quotation(good);
  }
  for (const char* bad : {"\x80", "\xc0\x80", "\xc1\xbf", "\xc3", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xe2\x82",
                          "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"}) {
    EXPECT_FALSE(is_utf8(bad)) << quotation(bad);
  }
}

}  // namespace
