// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/plot/error_points.h"
#include "radcert/study/result.h"

namespace radcert {

/// An error of one problem against the mesh size or the unknowns, and where a table of errors has it.
struct ConvergenceCurve {
  std::string name;                ///< for people
  std::string latex = {};          ///< the same with its formulas set; empty: it has none
  std::string column;              ///< of errors.csv: "node_error"
  std::optional<std::size_t> row;  ///< the rows with this number in the key column; absent: all rows
  std::vector<PlotPoint> points;   ///< abscissa, error, radius; the coarsest level first
  std::optional<double> order;     ///< fitted: error ~ h^order, or N^-order
};

/// Errors against the mesh size or the unknowns, both logarithmic.
/// Maths     none
/// Source    -
/// Requires  -
/// Result    plain data
/// Limits    -
struct ConvergencePlot {
  std::string title;
  std::string key;  ///< the column of errors.csv that tells problems apart; empty: there is one problem
  std::vector<ConvergenceCurve> curves;
  PlotAxis axis = PlotAxis::mesh_size;
};

/// The errors of the levels of one problem.
/// Maths     discretisation_error, node_error and uniform_error against h
/// Source    -
/// Requires  levels ascending, orders as collect() fits them
/// Result    a curve for each error that is positive at two levels or more; `row` as given. Without one, no curves
/// Limits    an error of zero has no place on a logarithmic axis and is left out
[[nodiscard]] ConvergencePlot convergence_plot(std::string title, std::span<const LevelResult> levels,
                                               std::span<const OrderFit> orders, std::string key = {},
                                               std::optional<std::size_t> row = std::nullopt);

/// The errors of one kind of all combinations of an experiment, two plots a kind: against h, then against the unknowns.
/// Maths     as above
/// Source    -
/// Requires  a result of collect for each combination, in their order
/// Result    key is "combination"; a curve for each combination with two levels or more; kinds without a curve are left out
/// Limits    as above
[[nodiscard]] std::vector<ConvergencePlot> convergence_plots(const Experiment& experiment,
                                                             std::span<const Result> results);

/// A convergence plot as one for svg_text, the fitted orders in the names of its series.
[[nodiscard]] Plot plot_of(const ConvergencePlot& plot);

/// A right-angled triangle whose longest side has the slope of a curve.
/// Maths     in logarithmic coordinates: from the last but one point of the curve to its last, the middle half of that length, moved by a
///           twentieth of the height of the plot, with the slope `order` in h, -order in the unknowns
/// Source    -
/// Requires  -
/// Result    x[0] < x[1]; y[i] on the slanting side at x[i]; above: the right angle has the larger y and the x of the smaller one, else
///           the smaller y and the x of the larger one
/// Limits    -
struct SlopeTriangle {
  std::array<double, 2> x{};
  std::array<double, 2> y{};
  double order = 0;
  bool above = false;
};

/// The triangles that a plot shows.
/// Maths     one below the curve that ends lowest, one above the curve that ends highest where its order differs by more than a tenth
/// Source    -
/// Requires  -
/// Result    at most two; none where no order is fitted or it is below 1/4
/// Limits    a curve with a single point has none
[[nodiscard]] std::vector<SlopeTriangle> slope_triangles(const ConvergencePlot& plot);

}  // namespace radcert
