// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/convergence_plot.h"

#include <gtest/gtest.h>
#include <limits>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "radcert/core/digest.h"
#include "radcert/formats/plot/experiment_plots.h"
#include "radcert/formats/plot/latex_plot.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/formats/result/provenance.h"

namespace radcert {
namespace {

/// Levels with h = 2^-k and errors c h^p.
std::vector<LevelResult> levels(int count, double node_order, double discretisation_order) {
  std::vector<LevelResult> out;
  for (int k = 0; k < count; ++k) {
    LevelResult level;
    level.level = k;
    level.mesh_size = std::ldexp(1.0, -k);
    level.unknowns = std::uint64_t{12} << static_cast<unsigned>(2 * k);
    level.node_error = Approximation{
        .value = 0.1 * std::pow(level.mesh_size, node_order), .radius = 1e-9, .guaranteed = false};
    level.discretisation_error = Approximation{.value = std::pow(level.mesh_size, discretisation_order),
                                               .radius = std::numeric_limits<double>::infinity(),
                                               .guaranteed = false};
    out.push_back(level);
  }
  return out;
}

Plot plot_of(std::string title, const std::vector<LevelResult>& levels, std::vector<OrderFit> orders = {}) {
  return convergence_plot(std::move(title), {.name = "", .levels = levels, .orders = orders});
}

const PlotCurve& curve(const Plot& plot, const std::string& kind) {
  for (const PlotCurve& one : plot.curves)
    for (const ErrorKind& known : error_kinds())
      if (known.name == kind && one.name == in_words(known)) return one;
  throw std::out_of_range(kind);
}

TEST(ConvergencePlot, HasACurveForEachErrorThatIsThereTwice) {
  auto given = levels(4, 4, 2);
  const Plot plot = plot_of("t", given);
  EXPECT_EQ(plot.curves.size(), 2U);
  EXPECT_EQ(curve(plot, "node_error").points.size(), 4U);
  EXPECT_NEAR(*curve(plot, "node_error").exponent, 4, 1e-12);
  EXPECT_EQ(curve(plot, "node_error").points[2].radius, 1e-9);
  for (LevelResult& level : given) level.node_error->value = 0;
  EXPECT_EQ(plot_of("t", given).curves.size(), 1U);
  EXPECT_TRUE(plot_of("t", levels(1, 4, 2)).curves.empty());
}

TEST(ConvergencePlot, TakesTheFittedOrderWhereThereIsOne) {
  const std::vector<OrderFit> fits = {
      {.quantity = "node_error", .order = 3.5, .halfwidth = {}, .levels = {}, .left_out = {}}};
  const Plot plot = plot_of("t", levels(3, 4, 2), fits);
  EXPECT_EQ(curve(plot, "node_error").exponent, 3.5);
  EXPECT_NEAR(*curve(plot, "discretisation_error").exponent, 2, 1e-12);
}

TEST(ConvergencePlot, FitsNoNoise) {
  // Over the sample, of which no radius is known, the last two levels are what has moved u_n.
  auto given = levels(5, 4, 2);
  for (LevelResult& level : given)
    level.uniform_error = Approximation::without_radius(std::max(level.discretisation_error->value, 0.012));
  for (LevelResult& level : given) level.node_error->radius = 1e-3;
  const Plot plot = plot_of("t", given);
  const PlotCurve& curve = ::radcert::curve(plot, "uniform_error");
  EXPECT_EQ(curve.points.size(), 5U);
  EXPECT_NEAR(*curve.exponent, 2, 1e-12);
  EXPECT_TRUE(curve.fit.ends_with("from 3 levels")) << curve.fit;
}

TEST(SlopeTriangles, HaveTheSlopeOfTheirCurveAndLieOnItsFreeSide) {
  const Plot plot = plot_of("t", levels(4, 4, 2));
  const auto triangles = slope_triangles(plot);
  ASSERT_EQ(triangles.size(), 2U);
  for (const SlopeTriangle& triangle : triangles) {
    const double slope = std::log(triangle.y[1] / triangle.y[0]) / std::log(triangle.x[1] / triangle.x[0]);
    EXPECT_NEAR(slope, triangle.exponent, 1e-12);
    EXPECT_DOUBLE_EQ(triangle.x[0], 0.125 * std::pow(2, 0.25));
    EXPECT_DOUBLE_EQ(triangle.x[1], 0.125 * std::pow(2, 0.75));
    const bool lowest = std::abs(triangle.exponent - 4) < 1e-9;
    EXPECT_EQ(triangle.above, !lowest);
    for (std::size_t i = 0; i < 2; ++i) {
      const double on_curve = lowest ? 0.1 * std::pow(triangle.x[i], 4) : std::pow(triangle.x[i], 2);
      EXPECT_EQ(triangle.y[i] < on_curve, lowest);
    }
  }
}

TEST(SlopeTriangles, AreOneWhereAllOrdersAreAlikeAndNoneWithoutCurves) {
  EXPECT_EQ(slope_triangles(plot_of("t", levels(3, 2.05, 2))).size(), 1U);
  EXPECT_TRUE(slope_triangles(plot_of("t", levels(1, 4, 2))).empty());
}

/// Two methods, of orders 4 and 2 at the nodes in h: half of that in the unknowns.
std::vector<Plot> plots_of_two_methods() {
  Experiment experiment{.name = "two", .varied = {}, .combinations = {}};
  std::vector<Result> results;
  for (const double order : {4.0, 2.0}) {
    experiment.combinations.push_back({.name = "a", .choice = {}, .problem = {}});
    results.push_back({.problem = {}, .levels = levels(4, order, 2), .orders = {}, .timing = {}});
  }
  std::vector<Plot> plots;
  for (NamedPlot& named : experiment_plots(experiment, results)) plots.push_back(std::move(named.plot));
  return plots;
}

TEST(ConvergencePlots, AreAgainstHAndAgainstTheUnknowns) {
  const std::vector<Plot> plots = plots_of_two_methods();
  ASSERT_EQ(plots.size(), 4U);
  for (const Plot& plot : plots) {
    const bool in_h = plot.x.name == "mesh size h";
    ASSERT_EQ(plot.curves.size(), 2U);
    EXPECT_EQ(plot.curves[1].points[2].x, in_h ? 0.25 : 192);
    if (plot.y.name == in_words(error_kinds()[1])) {
      EXPECT_NEAR(*plot.curves[0].exponent, in_h ? 4 : -2, 1e-12);
    }
  }
  EXPECT_EQ(
      std::count_if(plots.begin(), plots.end(), [](const Plot& plot) { return plot.x.name == "unknowns"; }),
      2);
}

TEST(SlopeTriangles, FallWithTheUnknownsOnTheFreeSides) {
  for (const Plot& plot : plots_of_two_methods()) {
    if (plot.x.name != "unknowns" || plot.y.name != in_words(error_kinds()[1])) continue;
    const auto triangles = slope_triangles(plot);
    ASSERT_EQ(triangles.size(), 2U);
    for (const SlopeTriangle& triangle : triangles) {
      EXPECT_LT(triangle.x[0], triangle.x[1]);
      const double slope = std::log(triangle.y[1] / triangle.y[0]) / std::log(triangle.x[1] / triangle.x[0]);
      EXPECT_NEAR(slope, triangle.exponent, 1e-12);
      const double on_curve = 0.1 * std::pow(triangle.x[0] / 12, triangle.exponent);
      EXPECT_EQ(triangle.y[0] > on_curve, triangle.above);
    }
  }
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(LatexPlots, HoldAllOfTheirPointsAndReadNoFile) {
  const std::string text = latex_plot_text(plot_of("a_b", levels(3, 4, 2)));
  EXPECT_NE(text.find("(0.25,0.000390625)"), std::string::npos) << text;
  EXPECT_NE(text.find("a\\_\\allowbreak{}b"), std::string::npos);
  for (const char* reading : {"table[", ".csv", "openin", "jobname"})
    EXPECT_EQ(text.find(reading), std::string::npos) << reading;
}

TEST(LatexPlots, AreOnePictureEachOrAParagraphEach) {
  const std::vector<Plot> plots = plots_of_two_methods();
  EXPECT_EQ(count(latex_plot_text(plots.front()), "\\begin{tikzpicture}"), 1U);
  EXPECT_EQ(count(latex_plot_text(plots.front()), "\\par"), 0U);
  const std::string text = latex_plots_text(plots);
  EXPECT_EQ(count(text, "\\begin{tikzpicture}"), plots.size());
  EXPECT_EQ(count(text, "\\par\\medskip\\noindent"), plots.size());
  EXPECT_LT(text.find("\\par"), text.find("\\begin{tikzpicture}"));
}

TEST(ConvergencePlot, ShowsAProblemAlikeInThePlotsOfAllErrors) {
  auto first = levels(3, 4, 2);
  const auto second = levels(3, 4, 2);
  for (LevelResult& level : first) level.node_error->value = 0;
  const ErrorHistory problems[] = {{.name = "one", .levels = first, .orders = {}},
                                   {.name = "two", .levels = second, .orders = {}}};
  const Plot node = convergence_plot("t", error_kinds()[1], ErrorAgainst::mesh_size, problems);
  ASSERT_EQ(node.curves.size(), 1U);
  EXPECT_EQ(node.number_of(0), 1U);
  EXPECT_NE(svg_text(node).find("class=\"c1\""), std::string::npos);
  EXPECT_EQ(svg_text(node).find("class=\"c0\""), std::string::npos);
  EXPECT_NE(latex_plot_text(node).find("radcert1,mark=square*"), std::string::npos);
}

TEST(ConvergencePlot, SaysWhereNoOrderIsSteady) {
  auto given = levels(3, 4, 2);
  given[1].discretisation_error->value = 1e-6;
  EXPECT_EQ(curve(plot_of("t", given), "discretisation_error").fit, "no steady order");
}

TEST(LatexPlots, HaveThePointsThatNoTableHas) {
  Plot plot{.title = "t",
            .x = {.name = "x", .logarithmic = false, .range = std::pair(0.0, 4.0)},
            .y = {.name = "y", .logarithmic = false},
            .curves = {{.name = "a_b", .points = {{1, 2}, {3, 0.5}}, .style = CurveStyle::thin}},
            .marks = {{.x = 2, .name = "here"}}};
  const auto text = [&] { return latex_plot_text(plot); };
  EXPECT_NE(text().find("\\begin{axis}"), std::string::npos);
  EXPECT_NE(text().find("xmin=0,xmax=4,"), std::string::npos);
  EXPECT_NE(text().find("mark=none] coordinates {\n  (1,2)\n  (3,0.5)};"), std::string::npos);
  EXPECT_NE(text().find("{here}"), std::string::npos);
  plot.y.logarithmic = true;
  EXPECT_NE(text().find("\\begin{semilogyaxis}"), std::string::npos);
}

TEST(ConvergencePlot, NamesTheOrdersInItsLegend) {
  const Plot plot = plot_of("t", levels(3, 4, 2));
  ASSERT_EQ(plot.curves.size(), 2U);
  EXPECT_TRUE(plot.curves[1].fit.starts_with("order 4.00")) << plot.curves[1].fit;
  EXPECT_NE(svg_text(plot).find("max |u - u_n| over the nodes: order 4.00"), std::string::npos);
}

TEST(ConvergencePlot, ComparesProblemsByOneError) {
  const auto one = levels(3, 4, 2);
  const auto single = levels(1, 4, 2);
  const ErrorHistory problems[] = {{.name = "one", .levels = one, .orders = {}},
                                   {.name = "a single level", .levels = single, .orders = {}}};
  const Plot plot = convergence_plot("t", error_kinds()[0], ErrorAgainst::unknowns, problems);
  ASSERT_EQ(plot.curves.size(), 1U);
  EXPECT_EQ(plot.curves[0].name, "one");
  EXPECT_NEAR(*plot.curves[0].exponent, -1, 1e-12);
}

TEST(SvgPlot, DrawsTheSlopeTrianglesOfThePlot) {
  const Plot plot = plot_of("t", levels(4, 4, 2));
  const std::string text = svg_text(plot);
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find("class=\"slope-line\"", at)) != std::string::npos; ++at) ++found;
  EXPECT_EQ(found, slope_triangles(plot).size());
  EXPECT_NE(text.find(">4.00</text>"), std::string::npos);
}

TEST(Provenance, SaysWhatIsUnknownAsNull) {
  const Provenance provenance{.command = "radcert solve \"a\"",
                              .inputs = {{"a", digest_of("a")}},
                              .libraries = {{"mpfr", "4"}},
                              .compiler = "GCC 12",
                              .architecture = "",
                              .system = "Linux",
                              .cpu_features = {"avx"},
                              .threads = 2,
                              .seed = std::nullopt};
  const std::string text = provenance_text(provenance);
  EXPECT_NE(text.find("\"seed\": null"), std::string::npos);
  EXPECT_NE(text.find("\\\"a\\\""), std::string::npos);
}

}  // namespace
}  // namespace radcert
