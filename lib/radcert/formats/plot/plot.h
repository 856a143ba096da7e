// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace radcert {

/// A point and how far its y may be off.
struct PlotPoint {
  double x = 0;
  double y = 0;
  double radius = 0;
  friend auto operator<=>(const PlotPoint&, const PlotPoint&) = default;
};

/// How points are shown.
enum class CurveStyle : std::uint8_t {
  marked,  ///< markers and the line through them
  thin,    ///< the line alone
  bold,    ///< a thick line in the colour of the axes
  dots     ///< markers alone, in that colour
};

/// Points that belong together.
struct PlotCurve {
  std::string name;        ///< for people
  std::string latex = {};  ///< the same with its formulas set; empty: it has none
  std::string fit = {};    ///< what was fitted, in words: "order 2.00"
  std::vector<PlotPoint> points = {};
  std::optional<double> exponent = {};     ///< fitted: y ~ x^exponent
  std::optional<std::size_t> number = {};  ///< which colour and marker it has; absent: its place in the plot
  CurveStyle style = CurveStyle::marked;
};

/// The colours that curves take in turns, as six digits in base 16: people with the usual deficiencies tell
/// them apart (after Okabe and Ito), and each is dark enough on white and bright enough on black.
struct CurveColour {
  std::string_view on_white;
  std::string_view on_black;
};
inline constexpr std::array<CurveColour, 8> curve_colours = {{{"0072B2", "4AA8E0"},
                                                              {"D55E00", "F08A4B"},
                                                              {"008A64", "35C297"},
                                                              {"B8588F", "DC8FBB"},
                                                              {"3D9FD6", "86C9EF"},
                                                              {"B98000", "E6B23C"},
                                                              {"6A4FA3", "A58FDC"},
                                                              {"6B6B6B", "A8A8A8"}}};

/// A place on the horizontal axis that a dotted line marks.
struct PlotMark {
  double x = 0;
  std::string name;
};

/// One of the two axes.
struct PlotAxis {
  std::string name;
  std::string latex = {};  ///< the same with its formulas set; empty: it has none
  bool logarithmic = true;
  std::optional<std::pair<double, double>> range = {};  ///< what is shown; absent: the data and a margin
};

/// Curves over two axes: what svg_text and latex_plots_text draw.
/// Result    plain data
/// Limits    one plane
struct Plot {
  std::string title;
  std::string description = {};  ///< for those who do not see it
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotCurve> curves = {};  ///< later ones lie above
  std::vector<PlotMark> marks = {};

  /// The number by which a curve has its colour and marker.
  [[nodiscard]] std::size_t number_of(std::size_t curve) const {
    return curves[curve].number.value_or(curve);
  }
};

/// A plot and the name of its file, without the extension.
struct NamedPlot {
  std::string name;
  Plot plot;
};

/// Where an axis has its ticks.
/// Maths     logarithmic: 10^k; also 2 and 5 times that where the ends are fewer than four decades apart; all
///           whole multiples of a 1, 2 or 5 times 10^k where that leaves fewer than three
/// Requires  least < largest, finite, apart by more than a millionth of the larger, positive if logarithmic,
///           else ContractViolation
/// Result    ascending, between least and largest, at least three
/// Limits    beyond twelve decades every third one
[[nodiscard]] std::vector<double> axis_ticks(double least, double largest, bool logarithmic);

/// A tick's number: "0.05", "2000", "5e-7".
[[nodiscard]] std::string tick_text(double value);

/// The ranges of a plot's two axes.
/// Maths     an axis without a range of its own: from the least to the largest of points, marks and slope
///           triangles, and a twentieth of that on either side; a single value lies in the middle
/// Requires  finite points, y and x not below the smallest normal double where their axis is logarithmic,
///           radii that are not negative, ranges that axis_ticks takes, else ContractViolation
/// Result    least < largest, as axis_ticks takes them; from 1 to 10 without a point
struct PlotRange {
  std::pair<double, double> x;
  std::pair<double, double> y;
};
[[nodiscard]] PlotRange shown_range(const Plot& plot);

/// A right-angled triangle whose longest side has the slope of a curve.
/// Maths     in logarithmic coordinates: from the last but one point of the curve to its last, the middle
///           half of that length, moved by a twentieth of the height of the plot, with the slope `exponent`
/// Result    x[0] < x[1]; y[i] on the slanting side at x[i]; above: the right angle has the larger y and the
///           x of the smaller one, else the smaller y and the x of the larger one
struct SlopeTriangle {
  std::array<double, 2> x{};
  std::array<double, 2> y{};
  double exponent = 0;
  bool above = false;

  /// The corner with the right angle.
  [[nodiscard]] std::array<double, 2> right_angle() const {
    const bool rises = y[0] < y[1];
    return {above == rises ? x[0] : x[1], above == rises ? y[1] : y[0]};
  }
};

/// The triangles that a plot shows.
/// Maths     one below the curve that ends lowest, one above the curve that ends highest where its exponent
///           differs by more than a tenth
/// Result    at most two; none where no exponent is fitted or it is below 1/4, or an axis is not logarithmic,
///           or the errors do not fall
/// Limits    a curve with a single point has none
[[nodiscard]] std::vector<SlopeTriangle> slope_triangles(const Plot& plot);

}  // namespace radcert
