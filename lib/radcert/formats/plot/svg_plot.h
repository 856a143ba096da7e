// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <string>
#include <vector>

namespace radcert {

/// A point and how far its y may be off.
struct PlotPoint {
  double x = 0;
  double y = 0;
  double radius = 0;
  friend auto operator<=>(const PlotPoint&, const PlotPoint&) = default;
};

/// Points that belong together, and what the legend says of them.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
};

/// A place on the horizontal axis that a dotted line marks.
struct PlotMark {
  double x = 0;
  std::string name;
};

/// A plot with a logarithmic vertical axis.
/// Maths     y always by its logarithm, x too unless linear_x
/// Source    -
/// Requires  -
/// Result    plain data
/// Limits    one plane
struct Plot {
  std::string title;
  std::string description;  ///< for those who do not see it
  std::string x_name;
  std::string y_name;
  bool linear_x = false;
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks = {};
};

/// A plot as SVG.
/// Maths     none
/// Source    SVG 1.1
/// Requires  UTF-8; finite x and y, y not below the smallest normal double and neither is x unless linear_x; radii not negative,
///           else ContractViolation
/// Result    well-formed XML with title and desc; each series has a colour and, from the ninth on, another marker; a bar
///           from y - radius to y + radius wherever it is taller than the marker, cut off at the frame; the legend is below the
///           axes and names the series in their order; light or dark as the reader's system. The same bits for the same plot
/// Limits    text is measured by its number of characters; axes without a point run from 1 to 10
[[nodiscard]] std::string svg_text(const Plot& plot);

/// Where an axis has its ticks.
/// Maths     logarithmic: 10^k; also 2 and 5 times that where the ends are fewer than four decades apart; all whole multiples
///           of a 1, 2 or 5 times 10^k where that leaves fewer than three
/// Source    -
/// Requires  least < largest, finite, apart by more than a millionth of the larger, positive unless linear, else
///           ContractViolation
/// Result    ascending, between least and largest, at least three
/// Limits    beyond twelve decades every third one
[[nodiscard]] std::vector<double> axis_ticks(double least, double largest, bool linear);

}  // namespace radcert
