// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/plot/plot.h"

namespace radcert {

/// A plot for LaTeX with pgfplots, one picture.
/// Maths     see slope_triangles
/// Source    the package pgfplots
/// Requires  a plot that shown_range takes, else ContractViolation
/// Result    a tikzpicture as wide as a line, to be read by \input; all of its points stand in the text, so
///           that the file may lie anywhere
/// Limits    no bars
[[nodiscard]] std::string latex_plot_text(const Plot& plot);

/// Several such plots, a paragraph each: pages may end between them.
[[nodiscard]] std::string latex_plots_text(std::span<const Plot> plots);

}  // namespace radcert
