// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/ply.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "radcert/core/contract.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

std::vector<std::vector<std::string>> body(const std::string& text) {
  std::istringstream in(text.substr(text.find("end_header\n") + 11));
  std::vector<std::vector<std::string>> out;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    out.emplace_back();
    for (std::string word; words >> word;) out.back().push_back(word);
  }
  return out;
}

using Words = std::vector<std::string>;

TEST(PlyText, HasThreeVerticesOfItsOwnAnElementAndThenTheFaces) {
  const std::string text = ply_text(test::sample_level().elements);
  EXPECT_TRUE(
      text.starts_with("ply\nformat ascii 1.0\ncomment piece 0 is upper\ncomment piece 1 is lower\n"));
  EXPECT_NE(text.find("element vertex 6\n"), std::string::npos);
  EXPECT_NE(text.find("element face 2\n"), std::string::npos);
  EXPECT_EQ(text.find("property double error"), std::string::npos);
  const auto lines = body(text);
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[1], (Words{"1", "0", "0.1", "2"}));
  EXPECT_EQ(lines[5], (Words{"0", "1", "0", "-6"}));
  EXPECT_EQ(lines[6], (Words{"3", "0", "1", "2", "0"}));
  EXPECT_EQ(lines[7], (Words{"3", "3", "4", "5", "1"}));
}

TEST(PlyText, HasTheErrorBehindTheRadiosity) {
  const CornerErrors errors = {{0.5, 0, 1e-300}, {1, 2, 3}};
  const std::string text = ply_text(test::sample_level().elements, errors);
  EXPECT_NE(text.find("property double radiosity\nproperty double error\n"), std::string::npos);
  EXPECT_EQ(body(text)[2], (Words{"0", "1", "0", "3", "1e-300"}));
  EXPECT_EQ(body(text)[3], (Words{"1", "0", "0", "4", "1"}));
}

TEST(PlyText, RefusesNumbersThatAreNotFiniteAndErrorsOfOtherElements) {
  auto elements = test::sample_level().elements;
  EXPECT_THROW((void)ply_text(elements, CornerErrors(3)), ContractViolation);
  elements[0].corner_values[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)ply_text(elements), ContractViolation);
}

TEST(CornerErrors, AreTheDistanceFromTheSolutionOfThePiece) {
  Problem problem = parse_problem(R"json({
    "schema": "radcert/problem/1", "surface": {"name": "two_piece", "p": 2}, "triangulation": {"levels": [0]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"}, "reflectivity": "1/2",
    "solution": {"upper": "x + 2*y + 4*z", "*": "-1"}})json",
                                  "sample");
  const auto elements = test::sample_level().elements;
  const auto errors = corner_errors(problem, elements);
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 2U);
  EXPECT_DOUBLE_EQ((*errors)[0][0], 1.0 / 3);
  EXPECT_DOUBLE_EQ((*errors)[0][1], 2 - 1.4);
  EXPECT_DOUBLE_EQ((*errors)[0][2], 1);
  EXPECT_EQ((*errors)[1], (std::array<double, 3>{5, 6, 5}));
}

TEST(CornerErrors, AreAbsentWithoutASolutionOrWhereItIsInfinite) {
  Problem problem = test::sample_problem();
  const auto elements = test::sample_level().elements;
  EXPECT_TRUE(corner_errors(problem, elements));
  problem = parse_problem(R"json({
    "schema": "radcert/problem/1", "surface": {"name": "two_piece", "p": 2}, "triangulation": {"levels": [0]},
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"}, "reflectivity": "1/2", "solution": "1/x"})json",
                          "sample");
  EXPECT_FALSE(corner_errors(problem, elements));
  problem.emission = problem.solution;
  problem.solution.reset();
  EXPECT_FALSE(corner_errors(problem, elements));
}

}  // namespace
}  // namespace radcert
