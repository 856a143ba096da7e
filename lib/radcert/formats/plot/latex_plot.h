// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/plot/plot.h"

namespace radcert {

/// Plots for LaTeX with pgfplots.
/// Maths     see slope_triangles
/// Source    the package pgfplots
/// Requires  plots that shown_range takes, else ContractViolation; `file` is a table with the columns that
///           the axes and curves name, and the keys of the plots
/// Result    a tikzpicture a plot, to be read by \input. The points of curves with a column come from the
///           table, which is looked for where \radcertdata says: a path with its slash, the document's folder
///           if it is not defined. Its text cells are emptied in a copy beside the document, because pgfplots
///           splits at commas within quotes too. The points of others stand in the text
/// Limits    a text cell with a backslash or a brace that is not quoted stops LaTeX. No bars
[[nodiscard]] std::string latex_plots_text(std::span<const Plot> plots, const std::string& file);

}  // namespace radcert
