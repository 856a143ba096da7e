// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/result_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

Result sample_result() {
  Result result{
      .problem = test::sample_problem(), .levels = {test::sample_level().result}, .orders = {}, .timing = {}};
  result.orders.push_back(
      {.quantity = "node_error", .order = 3.9, .halfwidth = 0.1, .levels = {2, 3}, .left_out = {0}});
  result.timing.push_back(test::sample_level().timing);
  return result;
}

std::vector<std::string> keys(const JsonValue& object) {
  std::vector<std::string> out;
  for (const auto& member : *object.members()) out.push_back(member.key);
  return out;
}

TEST(ResultJson, HasTheKeysOfTheFormatInItsOrder) {
  const JsonValue json = parse_json(result_text(sample_result(), "radcert solve p.json"), "");
  EXPECT_EQ(keys(json), (std::vector<std::string>{"schema", "radcert", "command", "problem", "levels",
                                                  "orders", "timing"}));
  EXPECT_EQ(*json.find("schema")->string(), "radcert/solution/1");
  EXPECT_EQ(*json.find("radcert")->string(), version());
  EXPECT_EQ(*json.find("command")->string(), "radcert solve p.json");
  const JsonValue& level = json.find("levels")->elements()->front();
  EXPECT_EQ(keys(level), (std::vector<std::string>{"level",
                                                   "elements",
                                                   "unknowns",
                                                   "mesh_size",
                                                   "discretisation_error",
                                                   "node_error",
                                                   "uniform_error",
                                                   "l2_error",
                                                   "mean_error",
                                                   "discretisation_ratio",
                                                   "node_ratio",
                                                   "discretisation_order",
                                                   "node_order",
                                                   "piece_means",
                                                   "norm_K",
                                                   "planned_bytes",
                                                   "operator",
                                                   "solver",
                                                   "iteration",
                                                   "verified",
                                                   "solution_radius",
                                                   "means_radius",
                                                   "iterated"}));
  EXPECT_EQ(keys(*level.find("iteration")),
            (std::vector<std::string>{"iterations", "contraction", "error_bound"}));
  EXPECT_EQ(keys(*level.find("verified")), (std::vector<std::string>{"theta", "solution_radius"}));
  EXPECT_EQ(keys(*level.find("node_error")), (std::vector<std::string>{"value", "radius", "guaranteed"}));
  EXPECT_EQ(*json.find("orders")->find("node_error")->find("order")->number(), 3.9);
  EXPECT_EQ(keys(*level.find("norm_K")), (std::vector<std::string>{"value", "radius", "guaranteed"}));
  EXPECT_EQ(*level.find("norm_K")->find("radius")->number(), 0x1p-55);
}

TEST(ResultJson, WritesNullForWhatIsAbsentOrNotFinite) {
  Result result = sample_result();
  result.levels[0].iteration = std::nullopt;
  result.levels[0].verified = std::nullopt;
  result.levels[0].node_ratio = std::numeric_limits<double>::infinity();
  result.levels[0].node_order = std::numeric_limits<double>::quiet_NaN();
  const JsonValue json = parse_json(result_text(result, ""), "");
  const JsonValue& level = json.find("levels")->elements()->front();
  for (const char* key : {"uniform_error", "node_ratio", "node_order", "discretisation_ratio", "iteration",
                          "verified", "l2_error", "iterated"})
    EXPECT_TRUE(level.find(key)->is_null()) << key;
  EXPECT_TRUE(level.find("node_error")->find("radius")->is_null());
}

TEST(ResultJson, HasTheIteratedSolutionWhereItIsAskedFor) {
  Result result = sample_result();
  LevelResult& level = result.levels[0];
  level.iterated_error = Approximation::estimated(0.5, 0.125);
  level.iterated = {.check_points = 24,
                    .u_n_error = Approximation::estimated(2, 0.25),
                    .node_error = {},
                    .difference = Approximation::estimated(3, 0.5),
                    .l2_error = 0.75,
                    .mean_error = {},
                    .piece_means = {{"lower", 1.5}},
                    .ratio = 4,
                    .u_n_ratio = {},
                    .order = 2,
                    .u_n_order = {}};
  const JsonValue json = parse_json(result_text(result, ""), "");
  const JsonValue& iterated = *json.find("levels")->elements()->front().find("iterated");
  EXPECT_EQ(*iterated.find("error")->find("value")->number(), 0.5);
  EXPECT_EQ(*iterated.find("u_n_error")->find("radius")->number(), 0.25);
  EXPECT_EQ(*iterated.find("difference")->find("value")->number(), 3);
  EXPECT_EQ(*iterated.find("piece_means")->find("lower")->number(), 1.5);
  for (const char* key : {"node_error", "mean_error", "u_n_ratio", "u_n_order"})
    EXPECT_TRUE(iterated.find(key)->is_null()) << key;
}

TEST(ResultJson, GivesTheMeansNoRadiusWhereOneHasNone) {
  for (const double none :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const bool first : {true, false}) {
      Result result = sample_result();
      result.levels[0].piece_means = {{"a", {.value = 1, .radius = first ? none : 0.5}},
                                      {"b", {.value = 2, .radius = first ? 0.5 : none}}};
      const JsonValue json = parse_json(result_text(result, ""), "");
      EXPECT_TRUE(json.find("levels")->elements()->front().find("means_radius")->is_null());
    }
}

}  // namespace
}  // namespace radcert
