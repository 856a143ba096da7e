// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/sheet.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/base64.h"
#include "radcert/core/contract.h"
#include "radcert/formats/plot/plot.h"
#include "radcert/formats/plot/svg_elements.h"
#include "radcert/picture/drawing.h"
#include "radcert/picture/png.h"

namespace radcert {
namespace {

constexpr std::string_view style =
    "\n.radcert text { font-family: system-ui, \"DejaVu Sans\", sans-serif; fill: #1b1b1b; }\n"
    ".radcert .paper { fill: #ffffff; }\n.radcert .axis { stroke: #1b1b1b; fill: none; }\n";

double as_double(std::size_t n) { return static_cast<double>(n); }
std::size_t pixels(double length) { return static_cast<std::size_t>(std::max(1.0, std::round(length))); }

std::size_t part(std::size_t whole, std::size_t taken, std::size_t count) {
  return whole > taken + count ? (whole - taken) / count : 1;
}

const Sheet::Layout& checked(const Sheet::Layout& layout) {
  expects(layout.columns > 0 && layout.rows > 0, "a panel");
  return layout;
}

std::string font_size(double size) { return svg::attribute("font-size", size); }

}  // namespace

Sheet::Sheet(const Layout& layout)
    : image(layout.width, layout.height),
      layout_(checked(layout)),
      text_(layout.has_words ? std::clamp(std::min(as_double(layout.height / layout.rows) / 25,
                                                   as_double(layout.width / layout.columns) / 30),
                                          7.0, 50.0)
                             : 0),
      gap_(layout.has_words                          ? pixels(0.7 * text_)
           : layout.columns == 1 && layout.rows == 1 ? 0
                                                     : pixels(as_double(layout.width) / 100)),
      above_(layout.has_words ? pixels(1.7 * text_) : gap_),
      strip_(layout.has_words && layout.has_scale ? std::min(pixels(5 * text_), layout.width / 3) : 0) {}

ImageRegion Sheet::panel(std::size_t column, std::size_t row, std::string_view title) {
  const std::size_t width = part(image.width() - strip_, (layout_.columns + 1) * gap_, layout_.columns);
  const std::size_t height = part(image.height(), gap_ + layout_.rows * above_, layout_.rows);
  const ImageRegion region{.x = std::min(gap_ + column * (width + gap_), image.width() - width),
                           .y = std::min(row * (height + above_) + above_, image.height() - height),
                           .width = width,
                           .height = height};
  titled_.push_back({region, std::string(title)});
  return region;
}

void Sheet::add_scale(const ImageRegion& beside, const ColourScale& scale) {
  if (strip_ == 0) return;
  const ImageRegion bar{.x = image.width() - strip_,
                        .y = beside.y,
                        .width = std::min(pixels(0.9 * text_), strip_),
                        .height = beside.height};
  for (std::size_t row = 0; row < bar.height; ++row) {
    const double place = 1 - (as_double(row) + 0.5) / as_double(bar.height);
    fill(image, {.x = bar.x, .y = bar.y + row, .width = bar.width, .height = 1},
         scale.colour(scale.low + place * (scale.high - scale.low)));
  }
  scale_ = Scale{.bar = bar, .colours = scale};
}

std::vector<std::string> Sheet::titles() const {
  std::vector<std::string> out;
  for (const Titled& each : titled_) out.push_back(each.title);
  return out;
}

std::string Sheet::svg_text(const std::string& description) const {
  const double width = as_double(image.width());
  const double height = as_double(image.height());
  const std::string data = "data:image/png;base64," + base64(png_bytes(image, description));
  std::string out = svg::head(width, height, description, description, style) + "  <image" +
                    svg::attribute("width", width) + svg::attribute("height", height) + " xlink:href=\"" +
                    data + "\"/>\n";
  if (text_ > 0)
    for (const auto& [region, title] : titled_) {
      const double room = as_double(region.width) / std::max(1.0, svg::text_width(title, 1));
      out += svg::text(as_double(region.x), as_double(region.y) - 0.5 * text_, title,
                       font_size(std::min(text_, room)));
    }
  if (scale_) {
    const auto& [bar, colours] = *scale_;
    const double right = as_double(bar.x + bar.width);
    const double size = 0.8 * text_;
    out += "  <rect" + svg::attribute("x", as_double(bar.x)) + svg::attribute("y", as_double(bar.y)) +
           svg::attribute("width", as_double(bar.width)) + svg::attribute("height", as_double(bar.height)) +
           " class=\"axis\"/>\n";
    for (const double tick : axis_ticks(colours.low, colours.high, false)) {
      const double y = as_double(bar.y + bar.height) -
                       as_double(bar.height) * (tick - colours.low) / (colours.high - colours.low);
      out += svg::line(right, y, right + 0.3 * text_, y, "axis");
      out += svg::text(right + 0.5 * text_, y + 0.35 * size, tick_text(tick), font_size(size));
    }
  }
  return out + std::string(svg::foot);
}

}  // namespace radcert
