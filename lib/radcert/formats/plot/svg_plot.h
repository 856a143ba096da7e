// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/formats/plot/plot.h"

namespace radcert {

/// Plots as SVG, one below the other.
/// Source    SVG 1.1
/// Requires  plots that shown_range takes, else ContractViolation; UTF-8
/// Result    well-formed XML with the title and the description of the first; each marked or thin curve has a
///           colour and, from the ninth on, another marker; a bar from y - radius to y + radius wherever it
///           is taller than the marker; what is outside the axes' ranges is cut off. The slope triangles of
///           the plot; the legend is below the axes and names the curves in their order, with what was
///           fitted; each marker tells its numbers to who points at it. Light or dark as the reader's system,
///           or as the page that holds it. The same bits for the same plot
/// Limits    text is measured by its number of characters
[[nodiscard]] std::string svg_text(std::span<const Plot> plots);
[[nodiscard]] std::string svg_text(const Plot& plot);

}  // namespace radcert
