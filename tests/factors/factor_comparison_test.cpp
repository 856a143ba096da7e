// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/factor_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "radcert/core/errors.h"

namespace radcert {
namespace {

const std::vector<std::string> names{"a", "b", "c"};

/// Three surfaces of areas 2, 1, 4; F_ab = 0.25, F_bc = 0.2, F_ac = 0.3, reciprocal.
FactorMatrix sample_matrix() {
  FactorMatrix matrix;
  matrix.rows = {{.area = {2, 0}, .sum = {0.55, 1e-9}, .to_space = std::nullopt},
                 {.area = {1, 0}, .sum = {0.7, 1e-9}, .to_space = std::nullopt},
                 {.area = {4, 0}, .sum = {0.2, 1e-9}, .to_space = std::nullopt}};
  matrix.entries = {{0, 1, {0.25, 1e-9}}, {0, 2, {0.3, 1e-9}},  {1, 0, {0.5, 1e-9}},
                    {1, 2, {0.2, 1e-9}},  {2, 0, {0.15, 1e-9}}, {2, 1, {0.05, 1e-9}}};
  return matrix;
}

ClaimedFactor claim(double value, double halfwidth) {
  return {Rational::exactly(value), Rational::exactly(halfwidth)};
}

ClaimedFactors claims_of(const FactorMatrix& matrix) {
  ClaimedFactors out;
  for (const ConfigurationFactor& entry : matrix.entries)
    out[{names[entry.from], names[entry.to]}] = claim(entry.factor.value, 1e-6);
  return out;
}

std::string cause(const ClaimedFactors& claims, const std::string& from, const std::string& to) {
  auto pairs = compared(sample_matrix(), names, claims, {});
  explain(pairs, sample_matrix(), names, claims,
          [](std::size_t i, std::size_t j) { return i == 0 && j == 2 ? std::optional(0.4) : std::nullopt; });
  for (const FactorComparison& pair : pairs)
    if (pair.from == from && pair.to == to) {
      EXPECT_EQ(pair.agreement, Agreement::differs);
      return pair.cause;
    }
  return "no such pair";
}

TEST(FactorComparison, AgreesDiffersOrIsUndecidedAgainstTheRadius) {
  const FactorMatrix matrix = sample_matrix();
  ClaimedFactors claims = claims_of(matrix);
  claims[{"b", "a"}] = claim(0.6, 1e-8);
  claims[{"a", "a"}] = claim(0, 1e-8);
  const auto pairs = compared(matrix, names, claims, {});
  ASSERT_EQ(pairs.size(), 7U);
  EXPECT_EQ(pairs[0].agreement, Agreement::differs);
  EXPECT_EQ(pairs[0].from, "b");
  for (std::size_t k = 1; k < pairs.size(); ++k) EXPECT_EQ(pairs[k].agreement, Agreement::agrees);
  const auto finer = compared(matrix, names, {{{"a", "b"}, claim(0.25, 1e-12)}}, {});
  // What the other leaves out is zero.
  EXPECT_EQ(finer.front().agreement, Agreement::differs);
  EXPECT_EQ(finer.back().agreement, Agreement::undecided);
  EXPECT_THROW(static_cast<void>(compared(matrix, names, {{{"d", "a"}, {}}}, {})), InputError);
}

TEST(FactorComparison, IsOfTheDecimalsInTheFile) {
  // 30 digits of 1/3 and what is a rounding of double beside it: all of it lies between two doubles.
  FactorMatrix matrix = sample_matrix();
  matrix.entries = {{0, 1, {1.0 / 3, 2e-17}}};
  const auto verdict = [&](const std::string& digits) {
    return compared(matrix, names, parse_factors("from,to,factor\na,b," + digits + "\n", "f.csv", names), {})
        .front()
        .agreement;
  };
  ASSERT_EQ(Rational::parse("0.333333333333333339829616")->to_double(), 1.0 / 3);
  EXPECT_EQ(verdict("0.333333333333333333333333333333"), Agreement::undecided);
  EXPECT_EQ(verdict("0.333333333333333339829616"), Agreement::differs);
  EXPECT_EQ(verdict("0.3333333333333333"), Agreement::agrees);
  // What radcert wrote means the doubles.
  matrix.entries = {{0, 1, {0.3, 1e-12}}};
  const std::string own = factors_csv(matrix, names);
  EXPECT_EQ(compared(matrix, names, parse_factors(own, "own.csv", names), {}).front().agreement,
            Agreement::agrees);
}

TEST(FactorComparison, GrantsTheLargerOfBothTolerances) {
  const FactorMatrix matrix = sample_matrix();
  ClaimedFactors claims = claims_of(matrix);
  claims[{"a", "b"}].value = Rational::exactly(0.2525);
  claims[{"c", "b"}].value = Rational::exactly(0.0505);
  const auto count = [&](const FactorTolerance& tolerance) {
    const auto pairs = compared(matrix, names, claims, tolerance);
    return std::count_if(pairs.begin(), pairs.end(),
                         [](const FactorComparison& pair) { return pair.agreement == Agreement::differs; });
  };
  EXPECT_EQ(count({}), 2);
  EXPECT_EQ(count({.absolute = 1e-3}), 1);
  EXPECT_EQ(count({.absolute = 3e-3}), 0);
  EXPECT_EQ(count({.relative = 0.0099}), 2);
  EXPECT_EQ(count({.relative = 0.0101}), 0);
  EXPECT_EQ(count({.absolute = 6e-4, .relative = 0.001}), 1);
  // Where the radius straddles the bound it cannot be told.
  const auto pairs = compared(matrix, names, claims, {.absolute = 0.0025});
  EXPECT_EQ(pairs.front().agreement, Agreement::undecided);
}

TEST(FactorComparison, GuessesAtTheCause) {
  const FactorMatrix matrix = sample_matrix();
  ClaimedFactors claims = claims_of(matrix);
  std::swap(claims[{"a", "b"}], claims[{"b", "a"}]);
  EXPECT_EQ(cause(claims, "a", "b"), "transposed");
  claims = claims_of(matrix);
  claims[{"c", "a"}].value *= 4;
  EXPECT_EQ(cause(claims, "c", "a"), "exchange area: not divided by the area");
  claims = claims_of(matrix);
  claims[{"b", "c"}].value *= Rational::exactly(std::numbers::pi);
  EXPECT_EQ(cause(claims, "b", "c"), "without 1/pi");
  claims = claims_of(matrix);
  claims[{"a", "c"}].value = Rational::exactly(0.4);
  EXPECT_EQ(cause(claims, "a", "c"), "occlusion missed");
  claims[{"a", "c"}].value = Rational::exactly(0.41);
  EXPECT_EQ(cause(claims, "a", "c"), "reciprocity broken");
  claims[{"c", "a"}].value = Rational::exactly(0.205);
  EXPECT_EQ(cause(claims, "a", "c"), "");
  // b and c have each other's names.
  claims.clear();
  const auto other = [](const std::string& name) { return name == "b" ? "c" : name == "c" ? "b" : "a"; };
  for (const ConfigurationFactor& entry : matrix.entries)
    claims[{other(names[entry.from]), other(names[entry.to])}] = claim(entry.factor.value, 1e-6);
  EXPECT_EQ(cause(claims, "a", "b"), "b and c swapped");
}

TEST(FactorComparison, GuessesAtCausesOfManyPairsTogether) {
  const FactorMatrix matrix = sample_matrix();
  ClaimedFactors claims = claims_of(matrix);
  // Exchange areas of square metres beside square millimetres.
  for (auto& [pair, claim] : claims) {
    const auto i =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), pair.first) - names.begin());
    claim.value *= Rational::exactly(matrix.rows[i].area.value * 1e-6);
    claim.halfwidth = Rational::exactly(1e-12);
  }
  for (const auto& [pair, claim] : claims)
    EXPECT_EQ(cause(claims, pair.first, pair.second), "exchange area in another unit: A F times 1e-6");
  // The rows of b and c alone.
  claims = claims_of(matrix);
  for (const std::string& to : names) std::swap(claims[{"b", to}], claims[{"c", to}]);
  EXPECT_EQ(cause(claims, "b", "a"), "rows b and c swapped");
  claims = claims_of(matrix);
  claims.erase({"a", "b"});
  EXPECT_EQ(cause(claims, "a", "b"), "not in the file");
  claims[{"a", "b"}] = claim(-0.3, 1e-6);
  EXPECT_EQ(cause(claims, "a", "b"), "below 0");
}

TEST(FactorComparison, RefusesFilesByWhatIsWrongInThem) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(parse_factors(text, "f.csv", names));
    } catch (const InputError& error) {
      return error.what();
    }
    return "(none)";
  };
  EXPECT_THAT(refusal("from,a,d\na,0,1\n"), testing::HasSubstr("\"d\" is no surface here"));
  EXPECT_THAT(refusal("0.5,0.5\n0.5,0.5\n"), testing::HasSubstr("is a number, and no name of a surface"));
  EXPECT_THAT(refusal("from;to;factor\na;b;1\n"), testing::HasSubstr("parted by commas"));
  EXPECT_THAT(refusal("from,to,factor\n"), testing::HasSubstr("has no factor"));
  EXPECT_THAT(refusal(",a,b,c\n"), testing::HasSubstr("has no factor"));
  EXPECT_THAT(refusal("from,to,value\na,b,1\n"), testing::HasSubstr("has not the columns"));
  EXPECT_THAT(refusal(""), testing::HasSubstr("is empty"));
}

TEST(FactorComparison, IsWrittenAsATableAndAsAPicture) {
  const FactorMatrix matrix = sample_matrix();
  ClaimedFactors claims = claims_of(matrix);
  claims[{"b", "a"}].value = Rational::exactly(0.6);
  auto pairs = compared(matrix, names, claims, {});
  explain(pairs, matrix, names, claims, [](std::size_t, std::size_t) { return std::nullopt; });
  const std::string table = comparison_csv(pairs);
  EXPECT_TRUE(
      table.starts_with("from,to,ours,radius,guaranteed,theirs,halfwidth,difference,verdict,cause\r\nb,a,"));
  EXPECT_THAT(table, testing::HasSubstr(",differs,reciprocity broken\r\n"));
  const std::string picture = comparison_svg(pairs, names);
  const auto occurrences = [&](const std::string& what) {
    int count = 0;
    for (std::size_t at = picture.find(what); at != std::string::npos; at = picture.find(what, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(occurrences("<rect class=\"differs\"") + occurrences(" class=\"differs\">"), 1);
  EXPECT_EQ(occurrences("<title>"), 7);  // of the picture and of six cells
}

}  // namespace
}  // namespace radcert
