// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/plot/convergence_plot.h"

namespace radcert {

/// Convergence plots for LaTeX with pgfplots.
/// Maths     see slope_triangles
/// Source    the package pgfplots
/// Requires  `file` is a table with the columns mesh_size and unknowns, those of the curves, and the keys of the plots
/// Result    a tikzpicture a plot, to be read by \input. The points come from the table, which is looked for where \radcertdata says: a
///           path with its slash, the document's folder if it is not defined. Its text cells are emptied in a copy beside the document, because pgfplots
///           splits at commas within quotes too
/// Limits    a text cell with a backslash or a brace that is not quoted stops LaTeX
[[nodiscard]] std::string latex_plots_text(std::span<const ConvergencePlot> plots, const std::string& file);

}  // namespace radcert
