// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {

namespace {

// Lengths are in units of the view box, about a pixel each.
constexpr double left = 84;
constexpr double top = 48;
constexpr double plot_width = 560;
constexpr double plot_height = 380;
constexpr double right_margin = 26;
constexpr double below_axis = 62;  // tick labels and the axis' name
constexpr double legend_line = 20;
constexpr double character = 7.2;  // the width of a letter of 13 units in the usual fonts
constexpr std::size_t colours = 8;
constexpr double marker_radius = 4;
constexpr double least_length = 1e-6;  // of an axis, relative: far above the rounding of its ticks

// Colours that people with the usual deficiencies tell apart (after Okabe and Ito), each dark enough on white and bright
// enough on black.
constexpr std::string_view style = R"css(
    text { font: 13px system-ui, "DejaVu Sans", sans-serif; fill: #1b1b1b; }
    .title { font-size: 16px; font-weight: 600; }
    .paper { fill: #ffffff; }
    .axis { stroke: #1b1b1b; fill: none; }
    .grid { stroke: #d9d9d9; }
    .mark { stroke: #777777; stroke-dasharray: 2 4; }
    .c0 { color: #0072b2; } .c1 { color: #d55e00; } .c2 { color: #008a64; } .c3 { color: #b8588f; }
    .c4 { color: #3d9fd6; } .c5 { color: #b98000; } .c6 { color: #6a4fa3; } .c7 { color: #6b6b6b; }
    @media (prefers-color-scheme: dark) {
      text { fill: #e8e8e8; }
      .paper { fill: #15171a; }
      .axis { stroke: #e8e8e8; }
      .grid { stroke: #3a3d42; }
      .c0 { color: #4aa8e0; } .c1 { color: #f08a4b; } .c2 { color: #35c297; } .c3 { color: #dc8fbb; }
      .c4 { color: #86c9ef; } .c5 { color: #e6b23c; } .c6 { color: #a58fdc; } .c7 { color: #a8a8a8; }
    }
)css";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      // No other control character may stand in XML.
      default: out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  return out;
}

/// To a hundredth of a unit.
std::string coordinate(double value) { return shortest(std::round(value * 100) / 100); }

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + coordinate(value) + "\"";
}

/// A whole multiple of a power of ten, as near as double holds.
double decimal(double multiple, int power) {
  return parse_double(shortest(multiple) + "e" + std::to_string(power)).value_or(0);
}

std::string tick_text(double value) {
  const double size = std::abs(value);
  if (size == 0 || (size >= 1e-3 && size < 1e6)) {
    // Without an exponent: the shortest form of 100000 is 1e+05.
    if (value == std::floor(value)) return std::to_string(static_cast<long long>(value));
    return shortest(value);
  }
  std::string text = shortest(value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string power = text.substr(e + 1);
  const bool negative = power.front() == '-';
  power.erase(0, power.find_first_not_of("+-0"));
  return text.substr(0, e) + "e" + (negative ? "-" : "") + power;
}

/// Multiples of 1, 2 or 5 times a power of ten: the widest step that leaves four ticks at least.
std::vector<double> even_ticks(double least, double largest) {
  constexpr double enough = 4;
  constexpr int largest_power = 307;  // five times that is still a double
  int power = std::min(static_cast<int>(std::ceil(std::log10(largest - least))), largest_power);
  double step = 1;
  const auto fits = [&](double multiple, int exponent) {
    const double width = decimal(multiple, exponent);
    expects(width > 0, "an axis no shorter than the least double", named("least", least),
            named("largest", largest));
    return std::floor(largest / width) - std::ceil(least / width) + 1 >= enough;
  };
  while (!fits(step, power)) {
    if (step == 1) --power;
    step = step == 1 ? 5 : (step == 5 ? 2 : 1);
  }
  std::vector<double> ticks;
  const double width = decimal(step, power);
  for (double k = std::ceil(least / width); k <= std::floor(largest / width); ++k)
    ticks.push_back(decimal(k * step, power));
  return ticks;
}

/// From data to units of the view box.
class Axis {
public:
  Axis(double least, double largest, bool linear, double from, double to)
      : least_(least), largest_(largest), linear_(linear), from_(from), to_(to) {}
  [[nodiscard]] double at(double value) const {
    return from_ + (to_ - from_) * ((scaled(value) - scaled(least_)) / (scaled(largest_) - scaled(least_)));
  }
  [[nodiscard]] std::vector<double> ticks() const { return axis_ticks(least_, largest_, linear_); }

private:
  [[nodiscard]] double scaled(double value) const { return linear_ ? value : std::log(value); }
  double least_, largest_;
  bool linear_;
  double from_, to_;
};

/// The range of an axis: the data's, and a twentieth of it on either side; a single value lies in the middle of a range.
std::pair<double, double> range(const std::vector<double>& values, bool linear) {
  if (values.empty()) return {1, 10};
  constexpr double margin = 0.05;
  constexpr double single = 2;         // the factor, or length, on either side of a single value
  constexpr double least_room = 1e-3;  // relative: keeps ticks apart where values hardly differ
  const double least = *std::min_element(values.begin(), values.end());
  const double largest = *std::max_element(values.begin(), values.end());
  if (linear) {
    const double room =
        std::max(margin * (largest - least), least_room * std::max(std::abs(least), std::abs(largest)));
    return least < largest ? std::pair{least - room, largest + room}
                           : std::pair{least - single, least + single};
  }
  const double factor =
      least < largest ? std::max(std::pow(largest / least, margin), 1 + least_room) : single;
  return {std::max(least / factor, std::numeric_limits<double>::min()),
          std::min(largest * factor, std::numeric_limits<double>::max())};
}

std::string line(double x1, double y1, double x2, double y2, std::string_view of) {
  return "  <line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
         " class=\"" + std::string(of) + "\"/>\n";
}

std::string text_at(double x, double y, std::string_view text, std::string_view more) {
  return "  <text" + attribute("x", x) + attribute("y", y) + std::string(more) + ">" + escaped(text) +
         "</text>\n";
}

/// The marker of a series: a disk, a square, a triangle, a cross, by turns of the colours.
std::string marker(std::size_t series, double x, double y) {
  constexpr double r = marker_radius;
  const std::string filled = " fill=\"currentColor\"/>\n";
  switch ((series / colours) % 4) {
    case 0: return "    <circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", r) + filled;
    case 1:
      return "    <rect" + attribute("x", x - r) + attribute("y", y - r) + attribute("width", 2 * r) +
             attribute("height", 2 * r) + filled;
    case 2:
      return "    <path d=\"M" + coordinate(x) + " " + coordinate(y - r) + "l" + coordinate(r) + " " +
             coordinate(2 * r) + "h" + coordinate(-2 * r) + "z\"" + filled;
    default:
      return "    <path d=\"M" + coordinate(x - r) + " " + coordinate(y - r) + "l" + coordinate(2 * r) + " " +
             coordinate(2 * r) + "m0 " + coordinate(-2 * r) + "l" + coordinate(-2 * r) + " " +
             coordinate(2 * r) + "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"/>\n";
  }
}

std::string group(std::size_t series) {
  return "  <g class=\"c" + std::to_string(series % colours) + "\">\n";
}

/// From y - radius to y + radius, with a short line across each end inside the frame; nothing where the marker hides it.
std::string error_bar(const PlotPoint& point, const Axis& x, const Axis& y) {
  constexpr double half_width = 5;
  constexpr double bottom = top + plot_height;
  const double middle = x.at(point.x);
  const double upper = y.at(point.y + point.radius);
  const double lower = point.radius < point.y ? y.at(point.y - point.radius) : HUGE_VAL;
  if (lower - y.at(point.y) <= marker_radius && y.at(point.y) - upper <= marker_radius) return {};
  const auto across = [&](double at) {
    return at < top || at > bottom ? std::string()
                                   : "M" + coordinate(middle - half_width) + " " + coordinate(at) + "h" +
                                         coordinate(2 * half_width);
  };
  return "    <path d=\"M" + coordinate(middle) + " " + coordinate(std::max(upper, top)) + "V" +
         coordinate(std::min(lower, bottom)) + across(upper) + across(lower) +
         "\" fill=\"none\" stroke=\"currentColor\"/>\n";
}

std::string curve(const PlotSeries& series, std::size_t number, const Axis& x, const Axis& y) {
  std::string path;
  std::string markers;
  for (const PlotPoint& point : series.points) {
    path += (path.empty() ? "M" : "L") + coordinate(x.at(point.x)) + " " + coordinate(y.at(point.y));
    markers += error_bar(point, x, y) + marker(number, x.at(point.x), y.at(point.y));
  }
  if (path.empty()) return {};
  return group(number) + "    <path d=\"" + path +
         "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\"/>\n" + markers + "  </g>\n";
}

std::string legend(const Plot& plot, double from) {
  constexpr double sample = 26;
  std::string out;
  double y = from;
  for (std::size_t i = 0; i < plot.series.size(); ++i, y += legend_line) {
    out += group(i) + "    <path d=\"M" + coordinate(left) + " " + coordinate(y) + "h" + coordinate(sample) +
           "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\"/>\n" +
           marker(i, left + sample / 2, y) + "  </g>\n";
    out += text_at(left + sample + 10, y + 4.5, plot.series[i].name, "");
  }
  return out;
}

std::string frame(const Plot& plot, const Axis& x, const Axis& y) {
  const double bottom = top + plot_height;
  std::string out;
  for (const double tick : x.ticks()) {
    out += line(x.at(tick), top, x.at(tick), bottom, "grid");
    out += text_at(x.at(tick), bottom + 18, tick_text(tick), " text-anchor=\"middle\"");
  }
  for (const double tick : y.ticks()) {
    out += line(left, y.at(tick), left + plot_width, y.at(tick), "grid");
    out += text_at(left - 8, y.at(tick) + 4.5, tick_text(tick), " text-anchor=\"end\"");
  }
  for (const PlotMark& mark : plot.marks) {
    out += line(x.at(mark.x), top, x.at(mark.x), bottom, "mark");
    out += text_at(x.at(mark.x) + 5, top + 18, mark.name, "");
  }
  out += "  <rect" + attribute("x", left) + attribute("y", top) + attribute("width", plot_width) +
         attribute("height", plot_height) + " class=\"axis\"/>\n";
  const double middle = top + plot_height / 2;
  out += text_at(left + plot_width / 2, bottom + 42, plot.x_name, " text-anchor=\"middle\"");
  out += text_at(20, middle, plot.y_name,
                 " text-anchor=\"middle\" transform=\"rotate(-90 20 " + coordinate(middle) + ")\"");
  return out;
}

/// Characters of a UTF-8 text.
double length(std::string_view text) {
  return static_cast<double>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::vector<double> axis_ticks(double least, double largest, bool linear) {
  expects(std::isfinite(least) && std::isfinite(largest) && (linear || least > 0) &&
              largest - least > least_length * std::max(std::abs(least), std::abs(largest)),
          "an axis with a length", named("least", least), named("largest", largest));
  if (linear) return even_ticks(least, largest);
  const int first = static_cast<int>(std::floor(std::log10(least))) - 1;
  const int last = static_cast<int>(std::ceil(std::log10(largest)));
  constexpr double few_decades = 4;
  constexpr double many_decades = 12;
  const double decades = std::log10(largest / least);
  std::vector<double> ticks;
  for (int power = first; power <= last; ++power) {
    if (decades > many_decades && power % 3 != 0) continue;
    for (const double multiple : {1.0, 2.0, 5.0}) {
      if (multiple != 1 && decades >= few_decades) continue;
      const double tick = decimal(multiple, power);
      if (least <= tick && tick <= largest) ticks.push_back(tick);
    }
  }
  return ticks.size() < 3 ? even_ticks(least, largest) : ticks;
}

std::string svg_text(const Plot& plot) {
  std::vector<double> xs;
  std::vector<double> ys;
  double widest = length(plot.title) * 9;  // the title's letters are larger
  for (const PlotSeries& series : plot.series) {
    widest = std::max(widest, length(series.name) * character + 36);
    for (const auto& [x, y, radius] : series.points) {
      constexpr double least = std::numeric_limits<double>::min();
      expects(std::isfinite(x) && std::isfinite(y) && y >= least && (plot.linear_x || x >= least),
              "finite points, normal and positive on logarithmic axes", named("x", x), named("y", y));
      expects(radius >= 0, "a radius that is not negative", named("radius", radius));
      xs.push_back(x);
      ys.push_back(y);
    }
  }
  for (const PlotMark& mark : plot.marks) xs.push_back(mark.x);
  const auto [x_least, x_largest] = range(xs, plot.linear_x);
  const auto [y_least, y_largest] = range(ys, false);
  const Axis x(x_least, x_largest, plot.linear_x, left, left + plot_width);
  const Axis y(y_least, y_largest, false, top + plot_height, top);

  const double width = std::max(left + plot_width, left + widest) + right_margin;
  const double legend_top = top + plot_height + below_axis + legend_line / 2;
  const double height = legend_top + legend_line * static_cast<double>(plot.series.size());
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
  out += attribute("width", width) + attribute("height", height) + " viewBox=\"0 0 " + coordinate(width) +
         " " + coordinate(height) + "\" role=\"img\" aria-labelledby=\"title desc\">\n";
  out += "  <title id=\"title\">" + escaped(plot.title) + "</title>\n";
  out += "  <desc id=\"desc\">" + escaped(plot.description) + "</desc>\n";
  out += "  <style>" + std::string(style) + "  </style>\n";
  out += "  <rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
  out += text_at(left, 30, plot.title, " class=\"title\"");
  out += frame(plot, x, y);
  for (std::size_t i = 0; i < plot.series.size(); ++i) out += curve(plot.series[i], i, x, y);
  out += legend(plot, legend_top);
  return out + "</svg>\n";
}

}  // namespace radcert
