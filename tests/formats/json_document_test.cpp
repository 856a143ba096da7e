// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/errors.h"
#include "tests/core/refusal.h"

namespace radcert {
namespace {

using testing::HasSubstr;

std::string refusal(std::string_view text) {
  return test::refusal_of([&] { return parse_json(text, "f.json"); });
}

std::string nested(std::size_t depth, std::string_view open, std::string_view close) {
  std::string out;
  for (std::size_t i = 0; i < depth; ++i) out += open;
  out += "0";
  for (std::size_t i = 0; i < depth; ++i) out += close;
  return out;
}

TEST(ParseJson, RefusesWhatIsNoJsonWithLineColumnAndByte) {
  EXPECT_THAT(refusal(""), HasSubstr("f.json: is empty"));
  EXPECT_THAT(refusal("{\"a\": 1,\n \"b\": }"), HasSubstr("line 2, column 7 (byte 16)"));
  EXPECT_THAT(refusal("{\"a\": [1, 2"), HasSubstr("line 1, column 12 (byte 12)"));
  EXPECT_THAT(refusal("{} {}"), HasSubstr("line 1, column 4"));
  EXPECT_THAT(refusal("[1, /* comment */ 2]"), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal("[01]"), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal("[NaN]"), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal("[1, 1e999]"), HasSubstr("/1: \"1e999\" is too large for a double"));
}

TEST(ParseJson, RefusesEveryTruncationOfADocument) {
  const std::string whole = R"({"a": [1, -2.5e3, true, null, "x\u00e9"], "b": {"c": false}})";
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("f.json: is ")) << length;
}

TEST(ParseJson, RefusesBytesThatAreNotUtf8) {
  for (const std::string bytes :
       {"[\"\xff\"]", "[\"\xc0\xaf\"]", "[\"\xed\xa0\x80\"]", "[\"\xf4\x90\x80\x80\"]", "\xff\xfe{\0}\0"})
    EXPECT_THAT(refusal(bytes), HasSubstr("is not JSON")) << bytes;
  EXPECT_THAT(refusal(std::string("\0\0\x7f\x45LF\0", 7)), HasSubstr("is not JSON"));
}

TEST(ParseJson, LimitsTheDepthWithoutRecursion) {
  EXPECT_EQ(refusal(nested(64, "[", "]")), "");
  EXPECT_THAT(refusal(nested(65, "[", "]")), HasSubstr("nested too deeply"));
  EXPECT_THAT(refusal(nested(100000, "[", "]")), HasSubstr("nested too deeply"));
  EXPECT_THAT(refusal(nested(100000, "{\"a\":", "}")), HasSubstr("nested too deeply"));
  EXPECT_THAT(refusal(std::string(100000, '[')), HasSubstr("nested too deeply"));
}

TEST(ParseJson, RefusesAKeyThatOccursTwiceInOneObject) {
  EXPECT_THAT(refusal(R"({"a": [{"b": 1, "b": 2}]})"), HasSubstr("/a/0/b: occurs twice"));
  EXPECT_THAT(refusal(R"({"a": 1, "\u0061": 2})"), HasSubstr("/a: occurs twice"));
  EXPECT_EQ(refusal(R"({"a": {"b": 1}, "b": {"b": 1}})"), "");
}

TEST(ParseJson, ReadsAsManyKeysAsAFileHolds) {
  // Each key is held against those before it: a hundred thousand one by one would be 5e9 comparisons.
  std::string text = "{";
  for (int k = 0; k < 100000; ++k) text += "\"k" + std::to_string(k) + "\": [" + std::to_string(k) + "], ";
  EXPECT_EQ(parse_json(text + "\"last\": {}}", "f.json").members()->size(), 100001U);
  EXPECT_THAT(refusal(text + "\"k7\": 0}"), HasSubstr("/k7: occurs twice"));
}

TEST(AsUtf8, ReplacesWhatIsNone) {
  EXPECT_EQ(as_utf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(as_utf8("\xFFz\xC3(\xE2\x82"), "\xEF\xBF\xBDz\xEF\xBF\xBD(\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(as_utf8(""), "");
}

TEST(PointerBelow, EscapesAsRfc6901Says) {
  EXPECT_EQ(pointer_below("/a", "b/c~d"), "/a/b~1c~0d");
  EXPECT_EQ(pointer_below("", std::size_t{2}), "/2");
}

// The nearest double of a number other than zero is never taken to be zero.
TEST(JsonDocument, RefusesNumbersThatOnlyZeroIsNear) {
  for (const char* text :
       {"1e-400", "-1e-400", "0.0000001e-320", "[1, 2.5e-999]", R"({"a": {"b": 1e-324}})"}) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find("nearer to zero than every double"), std::string::npos) << text << message;
  }
  for (const char* text : {"0e-400", "0.0", "-0.000e5", "5e-324", "1e-323"})
    EXPECT_NO_THROW(static_cast<void>(parse_json(text, "a.json"))) << text;
  for (const char* text : {"1e999", "-1e999", "+1", "0x10", "1_0", "01", ".5", "1.", "nan", "Infinity", "1e"})
    EXPECT_THROW(static_cast<void>(parse_json(text, "a.json")), InputError) << text;
}

}  // namespace
}  // namespace radcert
