// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/latex_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(LatexEscaped, LeavesNoSpecialCharacterOnItsOwn) {
  EXPECT_EQ(latex_escaped("a b,1/6"), "a b,1/\\allowbreak{}6");
  EXPECT_EQ(latex_escaped("50%"), "50\\%");
  const std::string out = latex_escaped("#$%&{}");
  EXPECT_EQ(out, "\\#\\$\\%\\&\\{\\}");
  for (const char* bare : {"^", "~", "|", "<", ">", "\""})
    EXPECT_EQ(latex_escaped(bare).find(bare), std::string::npos) << bare;
  EXPECT_EQ(latex_escaped("\\"), "\\textbackslash{}");
}

TEST(LatexNumber, HasItsRadiusInUnitsOfTheLastDigit) {
  EXPECT_EQ(latex_number(0.0014834, std::nullopt, 4), "1.483e-3");
  EXPECT_EQ(latex_number(0.0014834, std::numeric_limits<double>::infinity(), 4), "1.483e-3");
  EXPECT_EQ(latex_number(0.0014834, 1e-15, 4), "1.483(1)e-3");
  EXPECT_EQ(latex_number(0.0014834, 1e-5, 4), "1.483(11)e-3");
  EXPECT_EQ(latex_number(0.0014834, 1e-4, 4), "1.48(11)e-3");
  EXPECT_EQ(latex_number(0.0014834, 1, 4), "0(11)e-1");
  EXPECT_EQ(latex_number(-2.5, 0.0, 3), "-2.50");
  EXPECT_EQ(latex_number(1e100, std::nullopt, 2), "1.0e100");
  EXPECT_EQ(latex_number(9.9996e-10, std::nullopt, 4), "1.000e-9");
  EXPECT_EQ(latex_number(0, 1.0, 4), "0(10)e-1");
  EXPECT_EQ(latex_number(0, std::nullopt, 4), "0");
  EXPECT_THROW((void)latex_number(std::numeric_limits<double>::infinity(), std::nullopt, 4),
               ContractViolation);
  EXPECT_THROW((void)latex_number(1, std::nullopt, 0), ContractViolation);
  EXPECT_THROW((void)latex_number(1, -1.0, 4), ContractViolation);
}

TEST(LatexNumber, IsWithinHalfAUnitOfItsLastDigit) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const double mantissa = 1 + static_cast<double>(random() >> 11) * 0x1p-50;
    const double value =
        std::ldexp(random() % 2 == 0 ? mantissa : -mantissa, static_cast<int>(random() % 1800) - 900);
    const int digits = 1 + static_cast<int>(random() % 8);
    const auto back = parse_double(latex_number(value, std::nullopt, digits));
    ASSERT_TRUE(back) << value;
    EXPECT_LE(std::abs(*back - value), 0.5001 * std::pow(10.0, 1 - digits) * std::abs(value))
        << value << " " << digits;
  }
}

TEST(LatexNumber, ShowsAtMostTwoDigitsOfTheRadius) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 500; ++trial) {
    const double value = 1 + static_cast<double>(random() >> 11) * 0x1p-50;
    const double radius = value * std::pow(10.0, -static_cast<double>(random() % 1000) / 100 - 1);
    const std::string text = latex_number(value, radius, 17);
    const std::size_t open = text.find('(');
    ASSERT_NE(open, std::string::npos) << text;
    EXPECT_LE(text.find(')') - open - 1, 2U) << text;
  }
}

TEST(LatexTable, HasAsManyAmpersandsAsColumnsNeedAndTheHeadOnEveryPage) {
  LatexTable table({{"a", "l"}, {"b", "S"}, {"c", "r"}}, true);
  table.add(std::array<std::string, 3>{"x", "1", "y"});
  table.add_rule();
  table.add_line("all");
  const std::string text = table.text();
  EXPECT_NE(text.find("\\begin{longtable}{@{}lSr@{}}"), std::string::npos);
  EXPECT_EQ(count(text, "&"), 4U);
  EXPECT_LT(text.find("\\toprule"), text.find("\\endhead"));
  EXPECT_LT(text.find("\\endhead"), text.find("x & 1 & y"));
  EXPECT_NE(text.find("\\multicolumn{3}{@{}l}{all}"), std::string::npos);
  EXPECT_THROW(table.add(std::array<std::string, 2>{"x", "1"}), ContractViolation);
  EXPECT_THROW(LatexTable({}), ContractViolation);
}

TEST(LevelsLatex, HasARowALevelAndDashesForWhatIsAbsent) {
  const LevelResult level = test::sample_level().result;
  Result result{.problem = test::sample_problem(), .levels = {level, level}, .orders = {}, .timing = {}};
  const std::string text = levels_latex(result);
  EXPECT_EQ(count(text, "3 & 6 & 0.1000 & 3.333(1)e-1 & -- & 1.000 & --"), 2U) << text;
  EXPECT_EQ(count(text, "EOC"), 3U);
  EXPECT_EQ(text.find("Fitted"), std::string::npos);
  result.orders = {
      {.quantity = "node_error", .order = 3.987, .halfwidth = 0.111, .levels = {1, 2, 3}, .left_out = {}}};
  EXPECT_NE(levels_latex(result).find("$3.99 \\pm 0.12$ on levels 1--3"), std::string::npos);
  result.levels[1].node_order = 3.875;
  EXPECT_NE(levels_latex(result).find("1.000 & $3.88$"), std::string::npos);
  result.orders.front().levels = {1, 2};
  EXPECT_NE(levels_latex(result).find("$3.99$"), std::string::npos);
  result.problem.solution.reset();
  EXPECT_NE(levels_latex(result).find("-1.0000000e300"), std::string::npos);
}

TEST(CombinationsLatex, HasTheLevelsOfEachCombinationUnderItsName) {
  const LevelResult level = test::sample_level().result;
  Experiment experiment{.name = "two", .varied = {}, .combinations = {}};
  std::vector<Result> results;
  for (const char* name : {"first", "second_one"}) {
    experiment.combinations.push_back({.name = name, .choice = {}, .problem = test::sample_problem()});
    results.push_back(
        {.problem = test::sample_problem(), .levels = {level, level}, .orders = {}, .timing = {}});
  }
  results.back().orders = {{.quantity = "node_error",
                            .order = {},
                            .halfwidth = {},
                            .levels = {},
                            .left_out = {},
                            .pre_asymptotic = {0, 1, 2}}};
  const std::string text = combinations_latex(experiment, results);
  EXPECT_EQ(count(text, "3 & 6 & 0.1000 & "), 4U) << text;
  EXPECT_LT(text.find("first"), text.find("second\\_"));
  EXPECT_NE(text.find("none, the slopes are not steady"), std::string::npos);
  EXPECT_NE(text.find("\\begin{tabular}"), std::string::npos);
  for (int k = 0; k < 40; ++k) results.front().levels.push_back(level);
  EXPECT_NE(combinations_latex(experiment, results).find("\\begin{longtable}"), std::string::npos);
}

}  // namespace
}  // namespace radcert
