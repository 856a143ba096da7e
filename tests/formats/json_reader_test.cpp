// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_reader.h"

#include <gtest/gtest.h>

#include "radcert/formats/json/json_document.h"

namespace radcert {
namespace {

TEST(NearestWord, FindsASlipOfTheFingerAndNothingFarther) {
  const std::vector<std::string> words = {"two_squares", "two_piece", "cube", "box"};
  EXPECT_EQ(nearest_word("two_peice", words), "two_piece");
  EXPECT_EQ(nearest_word("cubes", words), "cube");
  EXPECT_EQ(nearest_word("icosahedron", words), std::nullopt);
  EXPECT_EQ(nearest_word("", words), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(100000, 'x'), words), std::nullopt);
}

TEST(JsonReader, TakesANumberAsItsNearestDoubleAndAStringExactly) {
  const JsonValue document = parse_json(R"([0.1, "0.1", 2, "1/6", 0e-400])", "");
  const auto cells = JsonReader(document).elements("");
  EXPECT_EQ(cells[0].rational(""), Rational::exactly(0.1));
  EXPECT_EQ(cells[1].rational(""), Rational(1, 10));
  EXPECT_EQ(cells[2].rational(""), Rational(2));
  EXPECT_EQ(cells[3].rational(""), Rational(1, 6));
  EXPECT_EQ(cells[4].rational(""), Rational(0));
}

TEST(JsonReader, NamesThePlaceAndWhatStandsThere) {
  const JsonValue document = parse_json(R"({"a": {"b": [true]}})", "");
  try {
    (void)JsonReader(document).at("a", "").at("b", "").elements("")[0].number("a number");
    FAIL() << "no exception";
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault().pointer, "/a/b/0");
    EXPECT_EQ(error.fault().value, "true");
    EXPECT_EQ(error.fault().allowed, "a number");
  }
}

}  // namespace
}  // namespace radcert
