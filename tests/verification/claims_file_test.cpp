// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/errors.h"
#include "tests/core/refusal.h"
#include "verification/framework/reading/claim.h"

namespace radcert::verification {
namespace {

using testing::HasSubstr;

// The message of the InputError that reading gives.
std::string refusal(const std::string& text) {
  return test::refusal_of([&] { return read_claims(text, "claims.toml"); });
}

constexpr const char* good = R"([theorem_1]
says = "one is one"
verdict = "supported"
scope = "all"
)";

TEST(ClaimsFile, KeepsTheOrderOfTheFile) {
  const auto claims =
      read_claims(std::string("[zeta]\nsays = \"a\"\nverdict = \"supported\"\nscope = \"all\"\n\n") + good,
                  "claims.toml");
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_EQ(claims[0].label, "zeta");
  EXPECT_EQ(claims[1].label, "theorem_1");
  EXPECT_EQ(claims[1].line, 6);
}

TEST(ClaimsFile, TakesAVerdictForEachBudget) {
  const auto claims = read_claims(
      "[a]\nsays = \"a\"\nverdict = {quick = \"supported\", standard = \"certified\", full = "
      "\"certified\"}\nscope = \"all\"\n",
      "claims.toml");
  EXPECT_EQ(claims[0].verdict->at(Budget::quick), Verdict::supported);
  EXPECT_EQ(claims[0].verdict->at(Budget::full), Verdict::certified);
}

TEST(ClaimsFile, RefusesWithLineAndPlace) {
  EXPECT_THAT(refusal(std::string(good) + "colour = \"red\"\n"),
              HasSubstr("claims.toml, line 5: /theorem_1/colour"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"true\"\n"),
              HasSubstr("claims.toml, line 3: /a/verdict: \"true\""));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"failed\"\n"), HasSubstr("cannot be recorded"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\n"), HasSubstr("/a/verdict: is missing"));
  EXPECT_THAT(refusal("[a]\nverdict = \"supported\"\n"), HasSubstr("/a/says: is missing"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = {quick = \"supported\"}\n"),
              HasSubstr("/a/verdict/standard: is missing"));
  EXPECT_THAT(refusal("[a]\nsays = 3\nverdict = \"supported\"\n"), HasSubstr("/a/says: \"3\""));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"supported\"\ncovers = [0]\n"),
              HasSubstr("/a/covers/0"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"supported\"\nneeds = [\"x\", \"y\"]\nmet = [\"z\"]\n"),
              HasSubstr("does not fit the hypotheses"));
  EXPECT_THAT(refusal("[A]\nsays = \"a\"\nverdict = \"supported\"\n"), HasSubstr("is no label"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"definition\"\n"), HasSubstr("/a/symbol: is missing"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\ncheck = \"magic\"\nverdict = \"supported\"\n"),
              HasSubstr("function, table, order or enclosure"));
  EXPECT_THAT(refusal("a = 1\n"), HasSubstr("line 1: /a: \"1\" is a number"));
  EXPECT_THAT(refusal("[a]\n\nsays = 1979-05-27\n"), HasSubstr("line 3: /a/says: is a date or time"));
  EXPECT_THAT(refusal("[a]\nslack = [1,\n inf]\n"), HasSubstr("line 3: /a/slack/1: is not finite"));
}

TEST(ClaimsFile, RefusesOneWithoutAClaim) { EXPECT_THAT(refusal("# none\n"), HasSubstr("has no claim")); }

TEST(ClaimsFile, RefusesADefinitionThatAsserts) {
  const auto definition = [](const std::string& rest) {
    return "[a]\nverdict = \"definition\"\nsymbol = \"s\"\n" + rest + "\n";
  };
  const std::string plain = definition("says = \"the union of the pieces\"");
  EXPECT_EQ(read_claims(plain, "claims.toml").size(), 1U);
  EXPECT_EQ(read_claims(plain + "formula = 'S=\\bigcup S_j'\n", "claims.toml").size(), 1U);
  for (const char* const says :
       {"u = 1", "an error of O(h)", "m is one-to-one", "F maps R onto S", "every piece"})
    EXPECT_THAT(refusal(definition("says = \"" + std::string(says) + "\"")), HasSubstr("asserts something"))
        << says;
  for (const char* const formula : {R"(e=O(h^2))", R"(F:R\xrightarrow[\text{onto}]{1-1}S)", R"(h\to 0)"})
    EXPECT_THAT(refusal(plain + "formula = '" + formula + "'\n"), HasSubstr("/a/formula")) << formula;
  EXPECT_THAT(refusal(plain + "needs = [\"x\"]\nmet = [\"y\"]\n"), HasSubstr("hypotheses of a definition"));
}

TEST(ClaimsFile, SaysHowFarAVerdictReaches) {
  const std::string claim = "[a]\nsays = \"a\"\nverdict = \"supported\"\n";
  const auto read = [](const std::string& text) { return read_claims(text, "claims.toml").front(); };
  EXPECT_THAT(refusal(claim), HasSubstr("/a/scope: is missing"));
  EXPECT_THAT(refusal(claim + "scope = \"some\"\n"), HasSubstr("all, family or instances"));
  EXPECT_THAT(refusal(claim + "scope = \"instances\"\n"), HasSubstr("/a/tried: is missing"));
  EXPECT_THAT(refusal(claim + "scope = \"family\"\ntried = []\n"), HasSubstr("/a/tried"));
  EXPECT_THAT(refusal(claim + "scope = \"all\"\ntried = [\"cube\"]\n"), HasSubstr("/a/tried"));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nverdict = \"definition\"\nsymbol = \"s\"\nscope = \"all\"\n"),
              HasSubstr("/a/scope: "));
  const Claim at_two = read(claim + "scope = \"instances\"\ntried = [\"cube\", \"sphere\"]\n");
  EXPECT_EQ(at_two.scope, Scope::instances);
  EXPECT_EQ(reach_text(*at_two.scope, at_two.tried.size()), "at 2 instances");
  EXPECT_EQ(reach_text(Scope::instances, 1), "at 1 instance");
  EXPECT_EQ(reach_text(Scope::all, 0), "for all");
}

TEST(ClaimsFile, RefusesWhatIsNoToml) {
  EXPECT_THAT(refusal("[a\n"), HasSubstr("claims.toml, line "));
  EXPECT_THAT(refusal("[a]\nsays = \"a\"\nsays = \"b\"\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusal("\xff\xfe"), HasSubstr("claims.toml"));
  EXPECT_THAT(refusal("[a]\nneeds = " + std::string(100000, '[')), HasSubstr("claims.toml"));
  EXPECT_THAT(refusal("[a]\nneeds\xEF\xBB\xBD = 1\n"), HasSubstr("line 2: has U+FEFD"));
}

constexpr const char* order = R"([a]
says = "a"
check = "order"
problem = "p.json"
control = "c.json"
quantity = "node_error"
order = 4
verdict = "supported"
)";

TEST(ClaimsFile, RefusesKeysThatAreTablesWithinTables) {
  std::string deep = "a";
  for (int k = 0; k < 50000; ++k) deep += k % 3 == 0 ? ".1" : (k % 3 == 1 ? " . 2" : ".\"b\"");
  for (const std::string& text : {deep + " = 1\n", "[" + deep + "]\n", "a = {" + deep + " = 1}\n"})
    EXPECT_THAT(refusal(text), HasSubstr("line 1: has ")) << text.size();
  std::string lines = "a = [\n";
  for (int k = 0; k < 200; ++k) lines += "{b.c.d = [\n";
  EXPECT_NE(refusal(lines), "");
  // Decimals are no keys.
  std::string numbers = "a = [0.5";
  for (int k = 0; k < 500; ++k) numbers += ", 1.25e-3, -1_0.0_1";
  EXPECT_THAT(refusal(numbers + "]\n"), HasSubstr("/a"));
}

TEST(ClaimsFile, ReadsAnOrder) {
  const auto read = [](const std::string& text) {
    return read_claims(text, "claims.toml").front().order.value();
  };
  EXPECT_EQ(read(order).order, 4);
  EXPECT_FALSE(read(order).logarithm);
  EXPECT_TRUE(read(std::string(order) + "logarithm = true\n").logarithm);
}

TEST(ClaimsFile, RefusesAnOrderWithASlackOrWithoutAControl) {
  const auto without = [](std::string line) {
    std::string text = order;
    text.erase(text.find(line), line.size() + 1);
    return refusal(text);
  };
  EXPECT_THAT(refusal(std::string(order) + "slack = 0.25\n"), HasSubstr("is no key of an order any more"));
  EXPECT_THAT(without("control = \"c.json\""), HasSubstr("/a/control: is missing"));
}

}  // namespace
}  // namespace radcert::verification
