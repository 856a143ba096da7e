// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/plot/plot.h"
#include "radcert/study/experiment.h"
#include "radcert/study/result.h"

namespace radcert {

/// The horizontal axis of a convergence plot: the largest diameter h, or the number N of unknowns.
enum class ErrorAgainst : std::uint8_t { mesh_size, unknowns };

/// An error in words: "max |u - u_n| over the nodes".
[[nodiscard]] std::string in_words(const ErrorKind& kind);
/// The same with its formulas for LaTeX.
[[nodiscard]] std::string in_latex(const ErrorKind& kind);

/// An error as a point; none where a logarithmic axis has no place for it.
[[nodiscard]] std::optional<PlotPoint> plot_point(double x, const std::optional<Approximation>& error);

/// The levels of one problem, as far as a plot asks.
struct ErrorHistory {
  std::string name;
  std::span<const LevelResult> levels;
  std::span<const OrderFit> orders;  ///< in h or in N, whichever the plot is against
};

/// An error of several problems against the mesh size or the unknowns, both logarithmic.
/// Maths     errors of `kind`; the order is the exponent of h, or minus that of N, by `orders`; by
///           asymptotic_law where the kind is not among them, over the levels that stand above their radius,
///           or above that of u_n at the nodes where they have none
/// Requires  levels ascending, orders as collect() fits them
/// Result    a curve for each problem with a positive error at two levels or more, its order in words, its
///           number that of the problem: the plots of several errors show it alike
/// Limits    an error of zero has no place on a logarithmic axis and is left out. An order +- the spread of
///           its slopes is no guarantee
[[nodiscard]] Plot convergence_plot(std::string title, const ErrorKind& kind, ErrorAgainst against,
                                    std::span<const ErrorHistory> problems);

/// The errors of the levels of one problem against h: a curve for each error that is positive at two levels
/// or more; no curves without one.
[[nodiscard]] Plot convergence_plot(std::string title, const ErrorHistory& problem);

}  // namespace radcert
