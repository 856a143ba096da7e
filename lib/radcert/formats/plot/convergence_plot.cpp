// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/convergence_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

std::string in_latex(const std::string& kind) {
  if (kind == "uniform_error") return "$\\max|u-u_n|$ over a sample of $S$";
  return kind == "node_error" ? "$\\max|u-u_n|$ over the nodes" : "$\\max|K(I-P_n)u|$ over the nodes";
}

std::optional<ConvergenceCurve> curve(std::string name, const ErrorKind& kind,
                                      std::span<const LevelResult> levels, std::span<const OrderFit> orders,
                                      std::optional<std::size_t> row, PlotAxis axis) {
  ConvergenceCurve out{.name = std::move(name),
                       .column = kind.name,
                       .row = row,
                       .points = error_points(levels, kind, axis),
                       .order = std::nullopt};
  if (out.points.size() < 2) return std::nullopt;
  out.order = fitted_order(levels, orders, kind, axis).order;
  return out;
}

/// How far a triangle stands off its curve, as part of the plot's height.
constexpr double distance = 0.05;

/// Below this order a triangle is a line.
constexpr double least_order = 0.25;

std::optional<SlopeTriangle> triangle(const ConvergenceCurve& curve, PlotAxis axis, double height,
                                      bool above) {
  if (!curve.order || *curve.order < least_order || curve.points.size() < 2) return std::nullopt;
  const PlotPoint& fine = curve.points.back();
  const PlotPoint& coarse = curve.points[curve.points.size() - 2];
  const double ratio = coarse.x / fine.x;
  if (!(axis == PlotAxis::mesh_size ? ratio > 1 : ratio < 1)) return std::nullopt;
  const double shift = std::pow(height, above ? distance : -distance);
  const double slope = axis == PlotAxis::mesh_size ? *curve.order : -*curve.order;
  const auto [low, high] = std::minmax({std::pow(ratio, 0.25), std::pow(ratio, 0.75)});
  return SlopeTriangle{.x = {fine.x * low, fine.x * high},
                       .y = {fine.y * shift * std::pow(low, slope), fine.y * shift * std::pow(high, slope)},
                       .order = *curve.order,
                       .above = above};
}

}  // namespace

ConvergencePlot convergence_plot(std::string title, std::span<const LevelResult> levels,
                                 std::span<const OrderFit> orders, std::string key,
                                 std::optional<std::size_t> row) {
  ConvergencePlot plot{
      .title = std::move(title), .key = std::move(key), .curves = {}, .axis = PlotAxis::mesh_size};
  for (const ErrorKind& kind : error_kinds())
    if (auto one = curve(error_words(kind.name), kind, levels, orders, row, PlotAxis::mesh_size)) {
      one->latex = in_latex(kind.name);
      plot.curves.push_back(std::move(*one));
    }
  return plot;
}

std::vector<ConvergencePlot> convergence_plots(const Experiment& experiment,
                                               std::span<const Result> results) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  std::vector<ConvergencePlot> plots;
  for (const ErrorKind& kind : error_kinds())
    for (const PlotAxis axis : {PlotAxis::mesh_size, PlotAxis::unknowns}) {
      ConvergencePlot plot{.title = experiment.name + ": " + error_words(kind.name),
                           .key = "combination",
                           .curves = {},
                           .axis = axis};
      for (std::size_t i = 0; i < results.size(); ++i) {
        const std::vector<OrderFit> orders =
            axis == PlotAxis::mesh_size ? results[i].orders : orders_in_unknowns(results[i]);
        if (auto one = curve(experiment.combinations[i].name, kind, results[i].levels, orders, i, axis))
          plot.curves.push_back(std::move(*one));
      }
      if (!plot.curves.empty()) plots.push_back(std::move(plot));
    }
  return plots;
}

Plot plot_of(const ConvergencePlot& plot) {
  Plot out{
      .title = plot.title,
      .description =
          std::string(plot.axis == PlotAxis::mesh_size
                          ? "Errors against the mesh size, both axes logarithmic. The order is the exponent "
                            "of the mesh size "
                          : "Errors against the unknowns, both axes logarithmic. The order is minus the "
                            "exponent of the unknowns ") +
          "that is fitted to the levels, no guarantee. Bars: what quadrature and rounding may have "
          "changed, where more than a marker.",
      .x_name = axis_name(plot.axis),
      .y_name = "error",
      .series = {}};
  for (const ConvergenceCurve& curve : plot.curves)
    out.series.push_back(
        {curve.name + (curve.order ? ": order " + nearest_text(*curve.order, DecimalForm::fixed(2)) : ""),
         curve.points});
  return out;
}

std::vector<SlopeTriangle> slope_triangles(const ConvergencePlot& plot) {
  double least = 0;
  double largest = 0;
  const ConvergenceCurve* lowest = nullptr;
  const ConvergenceCurve* highest = nullptr;
  for (const ConvergenceCurve& curve : plot.curves) {
    for (const PlotPoint& at : curve.points) {
      least = least == 0 ? at.y : std::min(least, at.y);
      largest = std::max(largest, at.y);
    }
    if (!curve.order || curve.points.size() < 2) continue;
    if (lowest == nullptr || curve.points.back().y < lowest->points.back().y) lowest = &curve;
    if (highest == nullptr || curve.points.back().y > highest->points.back().y) highest = &curve;
  }
  std::vector<SlopeTriangle> out;
  if (lowest == nullptr) return out;
  const double height = largest / least;
  if (const auto one = triangle(*lowest, plot.axis, height, false)) out.push_back(*one);
  constexpr double alike = 0.1;
  if (std::abs(*highest->order - *lowest->order) > alike)
    if (const auto one = triangle(*highest, plot.axis, height, true)) out.push_back(*one);
  return out;
}

}  // namespace radcert
