// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_value.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"

namespace radcert {
namespace {

TEST(JsonValue, KeepsTheOrderOfKeys) {
  JsonValue value = JsonValue::object();
  for (const char* key : {"z", "a", "m"}) value.set(key, 1);
  EXPECT_EQ(value.compact(), R"({"z": 1, "a": 1, "m": 1})");
}

TEST(JsonValue, RefusesAKeyThatIsThereAndNumbersThatAreNotFinite) {
  JsonValue value = JsonValue::object();
  value.set("a", 1);
  EXPECT_THROW(value.set("a", 2), ContractViolation);
  EXPECT_THROW(JsonValue(std::numeric_limits<double>::quiet_NaN()), ContractViolation);
  EXPECT_THROW(JsonValue(std::numeric_limits<double>::infinity()), ContractViolation);
  EXPECT_THROW(JsonValue(1).push(2), ContractViolation);
}

TEST(JsonValue, ReadsBackEveryDoubleToTheBit) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const auto back = parse_json(JsonValue(value).compact(), "").number();
    ASSERT_TRUE(back);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << value;
  }
}

TEST(JsonValue, ReadsBackEveryWholeNumberOf64Bits) {
  for (const std::uint64_t n : {std::uint64_t{0}, (std::uint64_t{1} << 53) + 1, UINT64_MAX})
    EXPECT_EQ(parse_json(JsonValue(n).compact(), "").unsigned_whole(), n);
  for (const std::int64_t n : {INT64_MIN, std::int64_t{-1}, INT64_MAX})
    EXPECT_EQ(parse_json(JsonValue(n).compact(), "").signed_whole(), n);
}

TEST(JsonValue, KnowsWholeNumbersHoweverTheyAreWritten) {
  EXPECT_EQ(JsonValue(3.0).signed_whole(), 3);
  EXPECT_EQ(JsonValue(3.5).signed_whole(), std::nullopt);
  EXPECT_EQ(JsonValue(1e300).signed_whole(), std::nullopt);
  EXPECT_EQ(JsonValue(-1).unsigned_whole(), std::nullopt);
  EXPECT_EQ(JsonValue("3").signed_whole(), std::nullopt);
}

TEST(JsonValue, ReadsBackEveryString) {
  const std::string nasty = std::string("\"\\/\n\t\0\x1f", 7) + "\u00e9\U0001F4A1";
  EXPECT_EQ(*parse_json(JsonValue(nasty).compact(), "").string(), nasty);
  EXPECT_NO_THROW((void)parse_json(JsonValue("\xff\xfe").compact(), ""))
      << "bytes that are no UTF-8 are replaced";
}

TEST(JsonValue, SaysTheSamePrettyAndCompact) {
  JsonValue inner = JsonValue::array();
  for (int i = 0; i < 60; ++i) inner.push(i * 1000);
  JsonValue value = JsonValue::object();
  value.set("long", inner);
  value.set("empty", JsonValue::array());
  value.set("nothing", JsonValue());
  value.set("yes", true);
  EXPECT_NE(value.pretty(), value.compact());
  EXPECT_EQ(parse_json(value.pretty(), "").compact(), value.compact());
}

}  // namespace
}  // namespace radcert
