// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/formats/plot/svg_plot.h"
#include "radcert/study/experiment.h"

namespace radcert {

/// What a convergence plot has on its horizontal axis: the largest diameter h, or the number N of unknowns.
enum class PlotAxis { mesh_size, unknowns };

/// "mesh size h", "unknowns".
[[nodiscard]] std::string axis_name(PlotAxis axis);

/// An error in words: "max |u - u_n| over the nodes".
[[nodiscard]] std::string error_words(const std::string& quantity);

/// An error at x with its radius, 0 where it has none; none where a logarithmic axis has no place for it.
[[nodiscard]] std::optional<PlotPoint> error_point(double x, const std::optional<Approximation>& error);

/// The points of one error, level by level; those without a place are left out.
[[nodiscard]] std::vector<PlotPoint> error_points(std::span<const LevelResult> levels, const ErrorKind& kind,
                                                  PlotAxis axis);

/// How an error falls.
/// Maths     error ~ h^order, or N^-order
/// Requires  fits: those of the levels against that axis
/// Result    the fit of that error; of an error that has no radius and is not among the fits, one of all
///           levels, by power_law
[[nodiscard]] OrderFit fitted_order(std::span<const LevelResult> levels, std::span<const OrderFit> fits,
                                    const ErrorKind& kind, PlotAxis axis);

}  // namespace radcert
