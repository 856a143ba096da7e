// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/latex_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <variant>

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

/// Levels with errors 2^-p of all kinds, as `collect` makes of them what tables show.
Result result_of(const Method& method, bool iterated) {
  Problem problem = test::sample_problem();
  problem.method = method;
  problem.iterated = iterated;
  std::vector<LevelResult> levels;
  for (int k = 0; k < 4; ++k) {
    LevelResult level;
    level.level = k;
    level.mesh_size = std::ldexp(1.0, -k);
    double p = 1;
    for (const ErrorKind& kind : error_kinds()) {
      const double error = std::exp2(-p * k);
      level.*kind.figure = Approximation::estimated(error, error / 1000);
      ++p;
    }
    if (std::holds_alternative<Galerkin>(method)) level.discretisation_error.reset();
    if (iterated) {
      level.iterated_error = level.node_error;
      level.iterated.emplace().u_n_error = level.uniform_error;
    }
    levels.push_back(level);
  }
  return collect(problem, levels, {});
}

TEST(LevelsLatex, NamesEveryErrorOfWhichAnOrderIsFitted) {
  const Method collocation = test::sample_problem().method;
  for (const Method& method : {collocation, Method(Galerkin{.degree = 1}), Method(Meshless{})})
    for (const bool iterated : {false, true}) {
      const Result result = result_of(method, iterated);
      const std::string text = levels_latex(result);
      std::set<std::string> said;
      for (std::size_t at = text.find("Fitted order of "); at != std::string::npos;
           at = text.find("Fitted order of ", at + 1))
        said.insert(text.substr(at, text.find(": ", at) - at));
      // None of a collocation's discretisation error where there is none.
      std::size_t fitted = 0;
      for (const OrderFit& fit : result.orders) fitted += fit.order ? 1 : 0;
      EXPECT_EQ(said.size(), fitted) << text;
      EXPECT_GE(fitted, 2U);
    }
}

TEST(LevelsLatex, ShowsGalerkinsErrorsInMeans) {
  const Result result = result_of(Galerkin{.degree = 1}, false);
  const std::string text = levels_latex(result);
  EXPECT_EQ(text.find("K(I-P_n)u"), std::string::npos) << text;
  EXPECT_EQ(count(text, "{$\\|u-u_n\\|_{L^2}$} & EOC"), 1U) << text;
  EXPECT_EQ(count(text, "{means of $u-u_n$} & EOC"), 1U) << text;
  // Node, L2 and mean errors of the level 1 with their orders 2, 4 and 5.
  EXPECT_NE(text.find("2.500(3)e-1 & $2.00$ & 6.250(7)e-2 & $4.00$ & 3.125(4)e-2 & $5.00$"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("Fitted order of $\\|u-u_n\\|_{L^2}$: $4.00"), std::string::npos) << text;
  EXPECT_NE(text.find("Fitted order of means of $u-u_n$: $5.00"), std::string::npos) << text;
  // Beside collocation each has the columns of both.
  Experiment experiment{.name = "two", .varied = {}, .combinations = {}};
  const std::vector<Result> results = {result_of(test::sample_problem().method, false), result};
  for (const Result& one : results)
    experiment.combinations.push_back({.name = "a", .choice = {}, .problem = one.problem});
  EXPECT_EQ(count(combinations_latex(experiment, results), "& EOC"), 4U);
}

TEST(LevelsLatex, RefusesAnErrorWithoutAName) {
  Result result = result_of(test::sample_problem().method, false);
  result.orders.front().quantity = "u_error";
  EXPECT_THROW((void)levels_latex(result), ContractViolation);
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
