// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/formats/plot/svg_elements.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

using svg::attribute;
using svg::coordinate;

// Lengths are in units of the view box, about a pixel each.
constexpr double left = 84;
constexpr double top = 48;
constexpr double plot_width = 560;
constexpr double plot_height = 380;
constexpr double bottom = top + plot_height;
constexpr double right_margin = 26;
constexpr double below_axis = 62;  // tick labels and the axis' name
constexpr double legend_line = 20;
constexpr double legend_sample = 26;
constexpr double text_size = 13;
constexpr double title_size = 16;
constexpr double marker_radius = 4;

/// A property with two colours: a reader that does not know light-dark() takes the first.
std::string coloured(const std::string& property, const std::string& on_white, const std::string& on_black) {
  return property + ": #" + on_white + "; " + property + ": light-dark(#" + on_white + ", #" + on_black +
         ");";
}

std::string style() {
  const std::string ink = "1b1b1b";
  const std::string pale_ink = "e8e8e8";
  std::string out =
      "\n.radcert:root { color-scheme: light dark; }\n"
      ".radcert text { font: 13px system-ui, \"DejaVu Sans\", sans-serif; " +
      coloured("fill", ink, pale_ink) +
      " }\n.radcert .title { font-size: 16px; font-weight: 600; }\n.radcert .slope { font-size: 11px; }\n"
      ".radcert .paper { " +
      coloured("fill", "ffffff", "15171a") + " }\n.radcert .axis { fill: none; " +
      coloured("stroke", ink, pale_ink) + " }\n.radcert .grid { " + coloured("stroke", "d9d9d9", "3a3d42") +
      " }\n.radcert .mark { stroke: #777777; stroke-dasharray: 2 4; }\n"
      ".radcert .slope-line { stroke: #777777; fill: none; }\n.radcert .ink { " +
      coloured("color", ink, pale_ink) + " }\n";
  for (std::size_t i = 0; i < curve_colours.size(); ++i)
    out += ".radcert .c" + std::to_string(i) + " { " +
           coloured("color", std::string(curve_colours[i].on_white), std::string(curve_colours[i].on_black)) +
           " }\n";
  return out;
}

/// From data to units of the view box.
class Scale {
public:
  Scale(const PlotAxis& axis, const std::pair<double, double>& range, double from, double to)
      : least_(range.first), largest_(range.second), logarithmic_(axis.logarithmic), from_(from), to_(to) {}
  [[nodiscard]] double at(double value) const {
    return from_ + (to_ - from_) * ((scaled(value) - scaled(least_)) / (scaled(largest_) - scaled(least_)));
  }
  [[nodiscard]] std::vector<double> ticks() const { return axis_ticks(least_, largest_, logarithmic_); }

private:
  [[nodiscard]] double scaled(double value) const { return logarithmic_ ? std::log(value) : value; }
  double least_, largest_;
  bool logarithmic_;
  double from_, to_;
};

struct Scales {
  Scale x;
  Scale y;
};

/// The marker of a curve: a disk, a square, a triangle, a cross, by turns of the colours. `title` is an
/// element within it.
std::string marker(std::size_t number, double x, double y, const std::string& title) {
  constexpr double r = marker_radius;
  const auto closed = [&](const std::string& name) {
    return title.empty() ? "/>\n" : ">" + title + "</" + name + ">\n";
  };
  const std::string filled = " fill=\"currentColor\"";
  switch ((number / curve_colours.size()) % 4) {
    case 0:
      return "    <circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", r) + filled +
             closed("circle");
    case 1:
      return "    <rect" + attribute("x", x - r) + attribute("y", y - r) + attribute("width", 2 * r) +
             attribute("height", 2 * r) + filled + closed("rect");
    case 2:
      return "    <path d=\"M" + coordinate(x) + " " + coordinate(y - r) + "l" + coordinate(r) + " " +
             coordinate(2 * r) + "h" + coordinate(-2 * r) + "z\"" + filled + closed("path");
    default:
      return "    <path d=\"M" + coordinate(x - r) + " " + coordinate(y - r) + "l" + coordinate(2 * r) + " " +
             coordinate(2 * r) + "m0 " + coordinate(-2 * r) + "l" + coordinate(-2 * r) + " " +
             coordinate(2 * r) + "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"" +
             closed("path");
  }
}

bool in_ink(const PlotCurve& curve) {
  return curve.style == CurveStyle::bold || curve.style == CurveStyle::dots;
}
bool has_line(const PlotCurve& curve) { return curve.style != CurveStyle::dots; }
bool has_markers(const PlotCurve& curve) {
  return curve.style == CurveStyle::marked || curve.style == CurveStyle::dots;
}

std::string group(const PlotCurve& curve, std::size_t number) {
  return "  <g class=\"" + (in_ink(curve) ? "ink" : "c" + std::to_string(number % curve_colours.size())) +
         "\">\n";
}

std::string stroke(const PlotCurve& curve) {
  return std::string("\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"") +
         (curve.style == CurveStyle::bold ? "2.4" : "1.6") + "\"/>\n";
}

/// From y - radius to y + radius, with a short line across each end inside the frame; nothing where the
/// marker hides it.
std::string error_bar(const PlotPoint& point, const Plot& plot, const Scales& to) {
  constexpr double half_width = 5;
  const double middle = to.x.at(point.x);
  const double upper = to.y.at(point.y + point.radius);
  const double lower =
      !plot.y.logarithmic || point.radius < point.y ? to.y.at(point.y - point.radius) : HUGE_VAL;
  if (lower - to.y.at(point.y) <= marker_radius && to.y.at(point.y) - upper <= marker_radius) return {};
  const auto across = [&](double at) {
    return at < top || at > bottom ? std::string()
                                   : "M" + coordinate(middle - half_width) + " " + coordinate(at) + "h" +
                                         coordinate(2 * half_width);
  };
  return "    <path d=\"M" + coordinate(middle) + " " + coordinate(std::max(upper, top)) + "V" +
         coordinate(std::min(lower, bottom)) + across(upper) + across(lower) +
         "\" fill=\"none\" stroke=\"currentColor\"/>\n";
}

/// What a marker says to who points at it.
std::string numbers(const PlotPoint& point, const Plot& plot) {
  const EnclosingText y = enclosing_text(point.y, point.radius, DecimalForm::general(5));
  return "<title>" +
         svg::escaped(plot.x.name + " " + nearest_text(point.x, DecimalForm::general(5)) + ": " + y.value +
                      (point.radius > 0 ? " \u00b1 " + y.radius : "")) +
         "</title>";
}

std::string drawn(const PlotCurve& curve, std::size_t number, const Plot& plot, const Scales& to) {
  std::string path;
  std::string markers;
  for (const PlotPoint& point : curve.points) {
    const double x = to.x.at(point.x);
    const double y = to.y.at(point.y);
    path += (path.empty() ? "M" : "L") + coordinate(x) + " " + coordinate(y);
    if (has_markers(curve))
      markers += error_bar(point, plot, to) + marker(number, x, y, numbers(point, plot));
  }
  if (path.empty()) return {};
  return group(curve, number) + (has_line(curve) ? "    <path d=\"" + path + stroke(curve) : std::string()) +
         markers + "  </g>\n";
}

/// The curves, cut off at the frame where the axes have ranges of their own: what an inner svg element shows
/// ends at its edges.
std::string all_curves(const Plot& plot, const Scales& to) {
  std::string out;
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    out += drawn(plot.curves[i], plot.number_of(i), plot, to);
  if (!plot.x.range && !plot.y.range) return out;
  const std::string place = attribute("x", left) + attribute("y", top) + attribute("width", plot_width) +
                            attribute("height", plot_height);
  return "  <svg" + place + " viewBox=\"" + coordinate(left) + " " + coordinate(top) + " " +
         coordinate(plot_width) + " " + coordinate(plot_height) + "\">\n" + out + "  </svg>\n";
}

std::string slopes(const Plot& plot, const Scales& to) {
  constexpr double gap = 5;
  std::string out;
  for (const SlopeTriangle& triangle : slope_triangles(plot)) {
    const auto [side, level] = triangle.right_angle();
    const double x[] = {to.x.at(triangle.x[0]), to.x.at(triangle.x[1]), to.x.at(side)};
    const double y[] = {to.y.at(triangle.y[0]), to.y.at(triangle.y[1]), to.y.at(level)};
    out += "  <path d=\"M" + coordinate(x[0]) + " " + coordinate(y[0]) + "L" + coordinate(x[1]) + " " +
           coordinate(y[1]) + "L" + coordinate(x[2]) + " " + coordinate(y[2]) +
           "z\" class=\"slope-line\"/>\n";
    out += svg::text((x[0] + x[1]) / 2, triangle.above ? y[2] - gap : y[2] + gap + 8, "1",
                     " class=\"slope\" text-anchor=\"middle\"");
    const bool on_the_left = x[2] < (x[0] + x[1]) / 2;
    out += svg::text(on_the_left ? x[2] - gap : x[2] + gap, (y[0] + y[1]) / 2 + 4,
                     nearest_text(std::abs(triangle.exponent), DecimalForm::fixed(2)),
                     on_the_left ? " class=\"slope\" text-anchor=\"end\"" : " class=\"slope\"");
  }
  return out;
}

std::string legend_text(const PlotCurve& curve) {
  return curve.name + (curve.name.empty() || curve.fit.empty() ? "" : ": ") + curve.fit;
}

std::string legend(const Plot& plot, double from) {
  std::string out;
  double y = from;
  for (std::size_t i = 0; i < plot.curves.size(); ++i, y += legend_line) {
    const PlotCurve& curve = plot.curves[i];
    out += group(curve, plot.number_of(i));
    if (has_line(curve))
      out += "    <path d=\"M" + coordinate(left) + " " + coordinate(y) + "h" + coordinate(legend_sample) +
             stroke(curve);
    if (has_markers(curve)) out += marker(plot.number_of(i), left + legend_sample / 2, y, "");
    out += "  </g>\n" + svg::text(left + legend_sample + 10, y + 4.5, legend_text(curve));
  }
  return out;
}

std::string frame(const Plot& plot, const Scales& to) {
  std::string out;
  for (const double tick : to.x.ticks()) {
    out += svg::line(to.x.at(tick), top, to.x.at(tick), bottom, "grid");
    out += svg::text(to.x.at(tick), bottom + 18, tick_text(tick), " text-anchor=\"middle\"");
  }
  for (const double tick : to.y.ticks()) {
    out += svg::line(left, to.y.at(tick), left + plot_width, to.y.at(tick), "grid");
    out += svg::text(left - 8, to.y.at(tick) + 4.5, tick_text(tick), " text-anchor=\"end\"");
  }
  for (const PlotMark& mark : plot.marks) {
    out += svg::line(to.x.at(mark.x), top, to.x.at(mark.x), bottom, "mark");
    out += svg::text(to.x.at(mark.x) + 5, top + 18, mark.name);
  }
  out += "  <rect" + attribute("x", left) + attribute("y", top) + attribute("width", plot_width) +
         attribute("height", plot_height) + " class=\"axis\"/>\n";
  const double middle = top + plot_height / 2;
  out += svg::text(left + plot_width / 2, bottom + 42, plot.x.name, " text-anchor=\"middle\"");
  out += svg::text(20, middle, plot.y.name,
                   " text-anchor=\"middle\" transform=\"rotate(-90 20 " + coordinate(middle) + ")\"");
  return out;
}

constexpr double legend_top = bottom + below_axis + legend_line / 2;

double height_of(const Plot& plot) {
  return legend_top + legend_line * static_cast<double>(plot.curves.size());
}

double width_of(const Plot& plot) {
  double widest = std::max(plot_width, svg::text_width(plot.title, title_size));
  for (const PlotCurve& curve : plot.curves)
    widest = std::max(widest, svg::text_width(legend_text(curve), text_size) + legend_sample + 10);
  return left + widest + right_margin;
}

std::string contents(const Plot& plot) {
  const PlotRange range = shown_range(plot);
  const Scales to{.x = {plot.x, range.x, left, left + plot_width}, .y = {plot.y, range.y, bottom, top}};
  return svg::text(left, 30, plot.title, " class=\"title\"") + frame(plot, to) + all_curves(plot, to) +
         slopes(plot, to) + legend(plot, legend_top);
}

}  // namespace

std::string svg_text(std::span<const Plot> plots) {
  expects(!plots.empty(), "a plot");
  double width = 0;
  double height = 0;
  std::string body;
  for (const Plot& plot : plots) {
    body += height == 0 ? contents(plot)
                        : "  <g transform=\"translate(0 " + coordinate(height) + ")\">\n" + contents(plot) +
                              "  </g>\n";
    width = std::max(width, width_of(plot));
    height += height_of(plot);
  }
  return svg::head(width, height, plots.front().title, plots.front().description, style()) + body +
         std::string(svg::foot);
}

std::string svg_text(const Plot& plot) { return svg_text({&plot, 1}); }

}  // namespace radcert
