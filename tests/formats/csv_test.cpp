// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "radcert/core/contract.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

TEST(CsvTable, QuotesAsRfc4180Says) {
  const std::array<std::string_view, 2> columns = {"a", "b"};
  CsvTable table(columns);
  table.add(std::array<JsonValue, 2>{"x,\"y\"\n", JsonValue()});
  table.add(std::array<JsonValue, 2>{0.1, true});
  EXPECT_EQ(table.text(), "a,b\r\n\"x,\"\"y\"\"\n\",\r\n0.1,true\r\n");
}

TEST(CsvTable, RefusesRowsOfAnotherLengthAndCellsThatAreNoScalars) {
  const std::array<std::string_view, 2> columns = {"a", "b"};
  CsvTable table(columns);
  EXPECT_THROW(table.add(std::array<JsonValue, 1>{1}), ContractViolation);
  EXPECT_THROW(table.add(std::array<JsonValue, 2>{1, JsonValue::array()}), ContractViolation);
}

TEST(NodesCsv, HasARowANode) {
  const std::array<LevelOutcome, 2> levels = {test::sample_level(), test::sample_level()};
  const std::string text = nodes_csv(levels);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  EXPECT_TRUE(text.starts_with(
      "level,piece,element,node,x,y,z,normal_x,normal_y,normal_z,u_n,radius,u,emission\r\n3,upper,1,2,0.1,"))
      << text;
  EXPECT_NE(text.find("\"lower, \"\"left\"\"\",0,0,"), std::string::npos);
  EXPECT_NE(text.find(",1e-310,,,-5\r\n"), std::string::npos) << "no proof, no solution: no value";
}

TEST(ErrorsCsv, HasARowALevelWithAsManyCellsAsColumns) {
  Result result{
      .problem = test::sample_problem(), .levels = {test::sample_level().result}, .orders = {}, .timing = {}};
  const std::string text = errors_csv(result);
  const std::size_t line = text.find("\r\n");
  const auto commas = [](std::string_view row) { return std::count(row.begin(), row.end(), ','); };
  EXPECT_EQ(commas(text.substr(0, line)), commas(text.substr(line)));
  EXPECT_NE(text.find(",0.3333333333333333,5e-324,false,"), std::string::npos) << text;
}

TEST(EnclosureCsv, HasARowAPoint) {
  SolutionEnclosure values{.wanted = {.width = 1, .of = EnclosedQuantity::values}};
  values.points.push_back({"east", {1, Rational(1, 2), 0}, Approximation::proved(0.5, 0.001)});
  EXPECT_EQ(enclosure_csv(values), "piece,x,y,z,radiosity,radius\r\neast,1,0.5,0,0.5,0.001\r\n");
  values.emissions.push_back(
      {.emission = "north", .points = {{"east", {1, Rational(1, 2), 0}, Approximation::proved(0.25, 0.5)}}});
  EXPECT_EQ(
      enclosure_csv(values),
      "piece,x,y,z,radiosity,radius,emission\r\neast,1,0.5,0,0.5,0.001,\r\neast,1,0.5,0,0.25,0.5,north\r\n");
  SolutionEnclosure function{.wanted = {.width = 1, .of = EnclosedQuantity::function}};
  function.patches.push_back({.piece = "floor", .corners = {}, .values = {1, 2, 3, 4}, .bound = 0.125});
  EXPECT_NE(enclosure_csv(function).find("floor,0,0,0,4,0.125\r\n"), std::string::npos);
}

}  // namespace
}  // namespace radcert
