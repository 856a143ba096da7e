// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/experiment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/plot/experiment_plots.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/formats/problem/experiment_file.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/experiment_json.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

const std::string head = R"json({"schema": "radcert/experiment/1", "name": "trial", "base": )json";
const std::string base = R"json({
  "triangulation": {"levels": [0, 1]}, "reflectivity": "1/2", "solution": "1 + x"})json";
const std::string vary = R"json({
  "surface": [{"name": "two_piece"}, {"name": "cube"}],
  "basis": [{"family": "inset", "degree": 0}, {"family": "inset", "degree": 1, "alpha": "0.1"},
            {"family": "inset", "degree": 1, "alpha": "1/6"}]})json";

std::string experiment_text(const std::string& with_base, const std::string& with_vary) {
  return head + with_base + R"(, "vary": )" + with_vary + "}";
}

InputFault refusal(const std::string& with_base, const std::string& with_vary) {
  try {
    static_cast<void>(parse_experiment(experiment_text(with_base, with_vary), "trial.json"));
  } catch (const InputError& error) {
    return error.fault();
  }
  return {.problem = "was not refused"};
}

TEST(Experiment, IsTheProductOfItsListsTheLastRunningFastest) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  ASSERT_EQ(experiment.combinations.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const Combination& combination = experiment.combinations[i];
    EXPECT_EQ(combination.choice[0], std::pair(std::string("surface"), i / 3));
    EXPECT_EQ(combination.choice[1], std::pair(std::string("basis"), i % 3));
    EXPECT_EQ(combination.problem.surface.name, i < 3 ? "two_piece" : "cube");
    EXPECT_EQ(triangle_basis_of(combination.problem.method).degree, i % 3 == 0 ? 0 : 1);
  }
  EXPECT_EQ(questions(experiment), (std::vector<std::vector<std::size_t>>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(Experiment, RanksNothingOnAnInterpolantAgainstWhatIsOnS) {
  const Experiment experiment = parse_experiment(
      experiment_text(
          R"({"surface": {"name": "two_piece"}, "triangulation": {"levels": [0]},
                          "reflectivity": "1/2", "solution": "1"})",
          R"({"geometry": ["exact", {"interpolated": 2}, {"interpolated": 2, "data": "interpolant"},
                                       {"interpolated": 3, "data": "interpolant"}],
                          "basis": [{"family": "inset", "degree": 0},
                                    {"family": "inset", "degree": 1, "alpha": "1/6"}]})"),
      "trial.json");
  EXPECT_EQ(questions(experiment), (std::vector<std::vector<std::size_t>>{{0, 1, 2, 3}, {4, 5}, {6, 7}}));
}

std::string with_labels(const std::string& labels, const std::string& fit_from = "1") {
  return head + base + R"(, "vary": )" + vary + R"(, "labels": )" + labels + R"(, "fit_from": )" + fit_from +
         "}";
}

TEST(Experiment, TakesShortNamesAndALevelToBeginFitsWith) {
  const Experiment experiment =
      parse_experiment(with_labels(R"({"basis": ["P0", "P1 at 0.1", "P1 at 1/6"]})"), "trial.json");
  EXPECT_EQ(experiment.combinations[1].name, "two_piece; p 2; P1 at 0.1");
  EXPECT_EQ(experiment.combinations[5].name, "cube; P1 at 1/6");
  for (const Combination& combination : experiment.combinations)
    EXPECT_EQ(combination.problem.fit_from, std::optional<int>(1));
  const auto pointer = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(parse_experiment(text, "trial.json"));
    } catch (const InputError& error) {
      return error.fault().pointer;
    }
    return "not refused";
  };
  EXPECT_EQ(pointer(with_labels(R"({"basis": ["P0", "P1"]})")), "/labels/basis");
  EXPECT_EQ(pointer(with_labels(R"({"basis": ["a", "b, c", "d"]})")), "/labels/basis/1");
  EXPECT_EQ(pointer(with_labels(R"({"solver": ["a"]})")), "/labels/solver");
  EXPECT_EQ(pointer(with_labels(R"({"basis": ["a", "b", "c"]})", "31")), "/fit_from");
}

TEST(Experiment, HasNoCommaInANameOfItsTable) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  for (const Combination& combination : experiment.combinations) {
    EXPECT_EQ(combination.name.find(','), std::string::npos) << combination.name;
    EXPECT_EQ(combination.name.find('"'), std::string::npos) << combination.name;
  }
}

TEST(Experiment, StatesTheProblemsThatFilesOfTheirOwnWould) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  const Problem alone = parse_problem(R"json({"schema": "radcert/problem/1", "surface": {"name": "cube"},
    "triangulation": {"levels": [0, 1]}, "reflectivity": "1/2", "solution": "1 + x",
    "basis": {"family": "inset", "degree": 1, "alpha": "1/6"}})json",
                                      "alone");
  EXPECT_EQ(problem_text(experiment.combinations.back().problem), problem_text(alone));
}

TEST(Experiment, NamesCombinationsByWhatTellsThemApart) {
  const Experiment alphas = parse_experiment(
      experiment_text(
          R"({"surface": {"name": "cube"}, "triangulation": {"levels": [0]}, "reflectivity": "1/2",
                          "solution": "1"})",
          R"({"basis": [{"family": "inset", "degree": 1, "alpha": "0.1"},
                                    {"family": "inset", "degree": 1, "alpha": "superconvergent"}]})"),
      "trial.json");
  EXPECT_EQ(alphas.combinations[0].name, "alpha 1/10");
  EXPECT_EQ(alphas.combinations[1].name, "alpha 1/6");
}

TEST(Experiment, IsRefusedWithThePlaceInItsFile) {
  struct Case {
    std::string base, vary, pointer, says;
  };
  const std::string basis = R"({"family": "inset", "degree": 0})";
  const std::string whole = R"({"surface": {"name": "cube"}, "triangulation": {"levels": [0]},
                               "reflectivity": "1/2", "solution": "1"})";
  for (const Case& c :
       std::vector<Case>{{base, "{}", "/vary", "is empty"},
                         {base, R"({"basis": []})", "/vary/basis", "is empty"},
                         {base, R"({"basis": 1})", "/vary/basis", "is a number"},
                         {base, R"({"bases": [1]})", "/vary/bases", "did you mean basis?"},
                         {base, R"({"solution": ["1"]})", "/vary/solution", "stated in base too"},
                         {R"({"emission": "1"})", vary, "/base/emission", "no error to compare"},
                         {base, R"({"emission": ["1"]})", "/vary/emission", "no error to compare"},
                         {R"({"schema": "radcert/problem/1"})", vary, "/base/schema", "unknown key"},
                         {"{}", vary, "/base/triangulation", "is missing"},
                         {whole, R"({"basis": [)" + basis + R"(, {"family": "inset", "degree": 11}]})",
                          "/vary/basis/1/degree", "outside the range"},
                         {R"({"surface": {"name": "cub"}})", R"({"basis": [)" + basis + "]}",
                          "/base/surface/name", "did you mean cube?"},
                         {whole, R"({"basis": [)" + basis + ", " + basis + "]}", "/vary/basis/1",
                          "makes the same problem as /vary/basis/0"},
                         {whole,
                          R"({"basis": [{"family": "inset", "degree": 1, "alpha": "1/6"},
                          {"family": "inset", "degree": 1, "alpha": "superconvergent"}]})",
                          "/vary/basis/1", "makes the same problem as /vary/basis/0"}}) {
    const InputFault fault = refusal(c.base, c.vary);
    EXPECT_EQ(fault.source, "trial.json");
    EXPECT_EQ(fault.pointer, c.pointer) << fault.problem;
    EXPECT_NE(fault.problem.find(c.says), std::string::npos) << c.pointer << ": " << fault.problem;
    EXPECT_FALSE(fault.allowed.empty()) << c.pointer;
  }
}

TEST(Experiment, RefusesMoreCombinationsThanALegendCanName) {
  std::string list;
  for (int i = 1; i <= 40; ++i) list += (i == 1 ? "\"" : ", \"") + std::to_string(i) + "\"";
  const InputFault fault =
      refusal("{}", R"({"solution": [)" + list + R"(], "reflectivity": [)" + list + "]}");
  EXPECT_EQ(fault.pointer, "/vary/reflectivity");
  EXPECT_EQ(fault.problem, "makes 1600 combinations");
}

TEST(Experiment, NamesTheOtherPartsOfACombinationThatIsRefused) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  const InputError error({.pointer = "/basis/alpha", .problem = "is too large", .allowed = "less"});
  const InputFault there = in_experiment(error, experiment.combinations[4]).fault();
  EXPECT_EQ(there.pointer, "/vary/basis/1/alpha");
  EXPECT_EQ(there.problem, "is too large (with /vary/surface/1)");
  const InputError of_base({.pointer = "/triangulation/levels/1", .problem = "is large"});
  EXPECT_EQ(in_experiment(of_base, experiment.combinations[0]).fault().pointer,
            "/base/triangulation/levels/1");
}

TEST(PowerLaw, FindsTheExponentOfOne) {
  std::mt19937_64 random(20);
  for (int trial = 0; trial < 50; ++trial) {
    const double exponent = static_cast<double>(random() % 1601) / 100 - 8;
    const double factor = std::pow(2.0, static_cast<double>(random() % 60) - 30);
    std::vector<CostPoint> points;
    for (const double cost : {3.0, 12.0, 48.0, 50.0})
      points.push_back({cost, factor * std::pow(cost, exponent)});
    const auto law = power_law(points);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, exponent, 1e-12) << factor;
    EXPECT_NEAR(*law->halfwidth, 0, 1e-10) << exponent << " " << factor;
    EXPECT_NEAR(*error_at(points, 24), factor * std::pow(24, exponent),
                1e-12 * factor * std::pow(24, exponent));
  }
}

TEST(PowerLaw, SaysHowUnsteadyTheSlopesAre) {
  // The slopes are 1 and 2; by symmetry the exponent is 3/2.
  const auto law = power_law(std::vector<CostPoint>{{1, 1}, {2, 2}, {4, 8}});
  EXPECT_NEAR(law->exponent, 1.5, 1e-14);
  EXPECT_NEAR(*law->halfwidth, 0.5, 1e-14);
}

TEST(PowerLaw, HasNoHalfwidthFromTwoPointsAndIsNoneFromOneCost) {
  EXPECT_FALSE(power_law(std::vector<CostPoint>{{1, 1}, {2, 8}})->halfwidth);
  EXPECT_NEAR(power_law(std::vector<CostPoint>{{1, 1}, {2, 8}})->exponent, 3, 1e-14);
  EXPECT_FALSE(power_law(std::vector<CostPoint>{{2, 1}, {2, 8}}));
  EXPECT_FALSE(power_law({}));
  EXPECT_THROW(static_cast<void>(power_law(std::vector<CostPoint>{{1, 0}, {2, 1}})), ContractViolation);
}

TEST(EqualCost, IsTheLeastOfTheDearestLevelsAndExtrapolatesNothing) {
  const std::vector<std::vector<CostPoint>> methods = {
      {{10, 1e-1}, {100, 1e-2}}, {{5, 1}, {50, 1e-3}}, {{60, 1e-9}}, {}, {{20, 1e-4}, {80, 1e-4}}};
  const auto equal = at_equal_cost(methods);
  ASSERT_TRUE(equal);
  EXPECT_EQ(equal->cost, 50);
  EXPECT_NEAR(*equal->errors[0], 0.02, 1e-15);
  EXPECT_EQ(equal->errors[1], 1e-3);
  EXPECT_FALSE(equal->errors[2]);
  EXPECT_FALSE(equal->errors[3]);
  EXPECT_NEAR(*equal->errors[4], 1e-4, 1e-18);
  EXPECT_EQ(equal->order, (std::vector<std::size_t>{4, 1, 0, 2, 3}));
  EXPECT_FALSE(at_equal_cost(std::vector<std::vector<CostPoint>>{{}, {}}));
}

TEST(EqualCost, PassesOverALevelThatCostsLessThanOneBefore) {
  EXPECT_NEAR(*error_at(std::vector<CostPoint>{{4, 1}, {2, 100}, {16, 0.25}}, 8), 0.5, 1e-15);
}

/// Results whose node errors are h^order with h = 2^-level and four times the unknowns from level to level.
std::vector<Result> power_results(const Experiment& experiment, double order) {
  std::vector<Result> results;
  for (const Combination& combination : experiment.combinations) {
    std::vector<LevelResult> levels;
    for (int k = 0; k < 3; ++k) {
      LevelResult level = test::sample_level().result;
      level.level = k;
      level.mesh_size = std::pow(2.0, -k);
      level.unknowns = std::uint64_t{12} << (2 * k);
      const Approximation figure{
          .value = std::pow(level.mesh_size, order), .radius = 1e-12, .guaranteed = false};
      level.node_error = level.discretisation_error = level.uniform_error = figure;
      levels.push_back(level);
    }
    results.push_back(collect(combination.problem, levels, std::vector<LevelTiming>(3, {1, 2, 3})));
  }
  return results;
}

TEST(Experiment, HasHalfTheOrderInTheUnknowns) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  for (const OrderFit& fit : orders_in_unknowns(power_results(experiment, 3).front())) {
    EXPECT_NEAR(*fit.order, 1.5, 1e-13) << fit.quantity;
    EXPECT_EQ(fit.levels, (std::vector<int>{0, 1, 2}));
  }
}

TEST(Experiment, CountsAssemblyAndSolutionAsSecondsOfALevel) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  for (const ErrorKind& kind : error_kinds())
    for (const CostPoint& point : error_against_seconds(power_results(experiment, 3).front(), kind))
      EXPECT_EQ(point.cost, 4);
}

TEST(ExperimentPlots, HaveASeriesACombinationWithItsOrder) {
  const Experiment experiment = parse_experiment(experiment_text(base, vary), "trial.json");
  const std::vector<NamedPlot> plots = experiment_plots(experiment, power_results(experiment, 3));
  ASSERT_EQ(plots.size(), 6U);
  for (const auto& [name, plot] : plots) {
    ASSERT_EQ(plot.curves.size(), 6U) << name;
    const std::string order = name.ends_with("_h") ? ": order 3.00 \u00b1 0.01" : ": order 1.50 \u00b1 0.01";
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(plot.curves[i].name + ": " + plot.curves[i].fit, experiment.combinations[i].name + order)
          << name;
      EXPECT_EQ(plot.curves[i].points.size(), 3U);
    }
  }
}

TEST(ExperimentPlots, SweepAlphaWhereThreeProblemsDifferInNothingElse) {
  std::string alphas;
  for (const char* alpha : {"0.2", "0.1", "1/6"})
    alphas += std::string(alphas.empty() ? "" : ", ") + R"({"family": "inset", "degree": 1, "alpha": ")" +
              alpha + "\"}";
  const Experiment experiment = parse_experiment(
      experiment_text(base, R"({"surface": [{"name": "cube"}], "basis": [)" + alphas + "]}"), "trial.json");
  const std::vector<NamedPlot> plots = experiment_plots(experiment, power_results(experiment, 2));
  ASSERT_EQ(plots.size(), 9U);
  EXPECT_EQ(plots[2].name, "discretisation_error_against_alpha");
  const Plot& plot = plots[2].plot;
  ASSERT_EQ(plot.curves.size(), 3U);
  for (const PlotCurve& curve : plot.curves) {
    ASSERT_EQ(curve.points.size(), 3U);
    EXPECT_EQ(curve.points[0].x, 0.1);
    EXPECT_EQ(curve.points[1].x, 1.0 / 6);
    EXPECT_EQ(curve.points[2].x, 0.2);
  }
  ASSERT_EQ(plot.marks.size(), 1U);
  EXPECT_EQ(plot.marks[0].x, 1.0 / 6);
}

TEST(AxisTicks, AreThreeAtLeastAscendingAndWithin) {
  std::mt19937_64 random(21);
  for (int trial = 0; trial < 400; ++trial) {
    const bool linear = trial % 2 == 0;
    const double least = std::pow(10.0, static_cast<double>(random() % 600) / 10 - 30);
    const double length = std::pow(10.0, static_cast<double>(random() % 200) / 10 - 5);
    const double largest = least * (1 + length);
    const std::vector<double> ticks = axis_ticks(linear ? -least : least, largest, !linear);
    EXPECT_GE(ticks.size(), 3U) << least << " " << largest;
    EXPECT_LE(ticks.size(), 16U) << least << " " << largest;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_LE(linear ? -least : least, ticks[i]);
      EXPECT_LE(ticks[i], largest);
      EXPECT_TRUE(i == 0 || ticks[i - 1] < ticks[i]) << least << " " << largest;
    }
  }
  EXPECT_THROW(static_cast<void>(axis_ticks(0, 1, true)), ContractViolation);
  EXPECT_THROW(static_cast<void>(axis_ticks(1, 1, false)), ContractViolation);
}

TEST(AxisTicks, AreRoundNumbers) {
  EXPECT_EQ(axis_ticks(0.9, 101, true), (std::vector<double>{1, 2, 5, 10, 20, 50, 100}));
  EXPECT_EQ(axis_ticks(1e-5, 0.5, true), (std::vector<double>{1e-5, 1e-4, 1e-3, 1e-2, 1e-1}));
  EXPECT_EQ(axis_ticks(0.03, 0.31, false), (std::vector<double>{0.05, 0.1, 0.15, 0.2, 0.25, 0.3}));
}

TEST(SvgPlot, EscapesWhatXmlWouldTakeForItsOwn) {
  const std::string text =
      svg_text(Plot{.title = "a < b & \"c\"",
                    .description = "d > e",
                    .x = {.name = "x"},
                    .y = {.name = "y"},
                    .curves = {{.name = "<s>", .points = {{1, 1}, {2, 0.5}}}, {.name = "none"}}});
  EXPECT_NE(text.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos);
  EXPECT_NE(text.find(">&lt;s&gt;</text>"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(SvgPlot, PutsLargerValuesHigherAndFurtherRight) {
  const std::string text =
      svg_text(Plot{.title = "t",
                    .description = "d",
                    .x = {.name = "x"},
                    .y = {.name = "y"},
                    .curves = {{.name = "s", .points = {{1, 1}, {10, 100}, {100, 10000}}}}});
  // The ends lie a twentieth of 560 by 380 units within the frame at (84, 48), by the rule for ranges: 1/22
  // of each.
  EXPECT_NE(text.find("d=\"M109.45 410.73L364 238L618.55 65.27\""), std::string::npos) << text;
}

TEST(SvgPlot, HasBarsWhereRadiiAreTallerThanMarkers) {
  const auto text = [](double radius) {
    return svg_text(
        Plot{.title = "t",
             .description = "d",
             .x = {.name = "x"},
             .y = {.name = "y"},
             .curves = {{.name = "s", .points = {{1, 1, 0}, {10, 100, radius}, {100, 10000, 0}}}}});
  };
  // Four decades over 380/1.1 units: half a percent is less than a unit.
  EXPECT_EQ(text(0.5).find("M364 238V"), std::string::npos);
  EXPECT_EQ(text(0.5).find("h10M"), std::string::npos);
  EXPECT_NE(text(0.5).find("<title>x 10: 100 \u00b1 0.5</title>"), std::string::npos);
  // From 10 to 190 about (364, 238): a decade is 345.45/4 units, and log10 1.9 = 0.27875.
  EXPECT_NE(text(90).find("d=\"M364 213.93V324.36M359 213.93h10M359 324.36h10\""), std::string::npos)
      << text(90);
  // Down to the frame at 428, where zero is not.
  EXPECT_NE(text(100).find("V428M359 212"), std::string::npos) << text(100);
}

TEST(SvgPlot, ServesEmptySingleAndExtremeData) {
  for (const auto& points : std::vector<std::vector<PlotPoint>>{{},
                                                                {{1, 1}},
                                                                {{3, 1e-300}, {3, 1e300}},
                                                                {{1, 1}, {1 + 1e-15, 1 + 1e-15}},
                                                                {{1e-307, 2.3e-308}, {1e308, 1.7e308}}})
    for (const bool linear : {false, true}) {
      const std::string text = svg_text(Plot{.title = "t",
                                             .description = "d",
                                             .x = {.name = "x", .logarithmic = !linear},
                                             .y = {.name = "y"},
                                             .curves = {{.name = "s", .points = points}}});
      EXPECT_EQ(text.find("nan"), std::string::npos);
      EXPECT_EQ(text.find("inf\""), std::string::npos);
    }
  EXPECT_THROW(
      static_cast<void>(svg_text(Plot{
          .title = "", .x = {.name = ""}, .y = {.name = ""}, .curves = {{.name = "s", .points = {{1, 0}}}}})),
      ContractViolation);
}

}  // namespace
}  // namespace radcert
