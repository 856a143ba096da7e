// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/curve_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/picture/drawing.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

constexpr Colour ink{0.02, 0.02, 0.02};
constexpr Colour pale{0.7, 0.7, 0.7};

/// A tick's number: six digits are more than any tick has.
std::string tick_text(double x) { return nearest_text(x, DecimalForm::general(6)); }

double as_double(std::size_t n) { return static_cast<double>(n); }

/// Whole pixels, at least one.
std::size_t pixels(double length) { return static_cast<std::size_t>(std::max(1.0, std::round(length))); }

void draw_frame(Image& image, const ImageRegion& frame) {
  const double left = as_double(frame.x);
  const double right = as_double(frame.x + frame.width);
  const double top = as_double(frame.y);
  const double bottom = as_double(frame.y + frame.height);
  const std::array<ImagePoint, 5> corners{
      {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}};
  draw_line(image, image.whole(), corners, 1, ink);
}

}  // namespace

void draw_panel(Image& image, const ImageRegion& region, const CurvePanel& panel) {
  expects(image.contains(region), "a region of the image");
  expects(panel.low_x < panel.high_x && panel.low_y < panel.high_y, "axes of some length",
          named("low x", panel.low_x), named("high x", panel.high_x), named("low y", panel.low_y),
          named("high y", panel.high_y));
  constexpr double least_width = 150;
  constexpr double least_height = 100;
  const bool with_words = as_double(region.width) >= least_width && as_double(region.height) >= least_height;
  const double text = std::clamp(as_double(region.height) / 22, 7.0, 40.0);
  ImageRegion frame = region;
  if (with_words) {
    double widest = 0;
    for (const double y : axis_ticks(panel.low_y, panel.high_y, true))
      widest = std::max(widest, text_width(text, tick_text(y)));
    const std::size_t left = pixels(widest + 2.2 * text);
    const std::size_t above = pixels(2.4 * text);
    frame = {.x = region.x + left,
             .y = region.y + above,
             .width = region.width - left - pixels(1.5 * text),
             .height = region.height - above - pixels(4.3 * text)};
  }
  const auto place = [&](const ImagePoint& p) {
    return ImagePoint{
        as_double(frame.x) + as_double(frame.width) * (p.x - panel.low_x) / (panel.high_x - panel.low_x),
        as_double(frame.y + frame.height) -
            as_double(frame.height) * (p.y - panel.low_y) / (panel.high_y - panel.low_y)};
  };
  if (panel.low_y < 0 && panel.high_y > 0) {
    const std::array<ImagePoint, 2> zero{place({panel.low_x, 0}), place({panel.high_x, 0})};
    draw_line(image, frame, zero, 1, pale);
  }
  const double hundredth = as_double(region.height) / 100;
  for (const PanelCurve& curve : panel.curves) {
    std::vector<ImagePoint> points;
    points.reserve(curve.points.size());
    for (const ImagePoint& p : curve.points) points.push_back(place(p));
    draw_line(image, frame, points, std::max(1.0, curve.width * hundredth), curve.colour);
  }
  for (const ImagePoint& mark : panel.marks)
    draw_disc(image, frame, place(mark), std::max(2.0, 1.3 * hundredth), ink);
  draw_frame(image, frame);
  if (!with_words) return;
  const double tick = text / 2;
  for (const double x : axis_ticks(panel.low_x, panel.high_x, true)) {
    const ImagePoint at = place({x, panel.low_y});
    const std::array<ImagePoint, 2> line{at, ImagePoint{at.x, at.y + tick}};
    draw_line(image, image.whole(), line, 1, ink);
    draw_text(image, {at.x, at.y + tick + 1.4 * text}, text, tick_text(x), ink, TextAlign::middle);
  }
  for (const double y : axis_ticks(panel.low_y, panel.high_y, true)) {
    const ImagePoint at = place({panel.low_x, y});
    const std::array<ImagePoint, 2> line{at, ImagePoint{at.x - tick, at.y}};
    draw_line(image, image.whole(), line, 1, ink);
    draw_text(image, {at.x - 1.8 * tick, at.y + text / 2}, text, tick_text(y), ink, TextAlign::right);
  }
  draw_text(image, {as_double(frame.x), as_double(frame.y) - 0.9 * text}, 1.15 * text, panel.title, ink);
  draw_text(image,
            {as_double(frame.x) + as_double(frame.width) / 2,
             as_double(frame.y + frame.height) + tick + 3.2 * text},
            text, panel.x_name, ink, TextAlign::middle);
  draw_text(image, {as_double(frame.x + frame.width), as_double(frame.y) - 0.9 * text}, text, panel.y_name,
            ink, TextAlign::right);
}

void draw_scale(Image& image, const ImageRegion& region, const ColourScale& scale, double text_height) {
  expects(image.contains(region), "a region of the image");
  const std::size_t margin = pixels(text_height / 2);
  const std::size_t width = pixels(1.2 * text_height);
  const std::vector<double> ticks = axis_ticks(scale.low, scale.high, true);
  double widest = 0;
  for (const double x : ticks) widest = std::max(widest, text_width(text_height, tick_text(x)));
  if (region.height < 2 * margin + 4 * width ||
      as_double(region.width) < as_double(width) + text_height + widest)
    return;
  const ImageRegion bar{
      .x = region.x, .y = region.y + margin, .width = width, .height = region.height - 2 * margin};
  for (std::size_t row = 0; row < bar.height; ++row) {
    const double part = 1 - (as_double(row) + 0.5) / as_double(bar.height);
    fill(image, {.x = bar.x, .y = bar.y + row, .width = bar.width, .height = 1},
         scale.colour(scale.low + part * (scale.high - scale.low)));
  }
  draw_frame(image, bar);
  for (const double x : ticks) {
    const double y =
        as_double(bar.y + bar.height) - as_double(bar.height) * (x - scale.low) / (scale.high - scale.low);
    const double right = as_double(bar.x + bar.width);
    const std::array<ImagePoint, 2> line{{{right, y}, {right + text_height / 3, y}}};
    draw_line(image, image.whole(), line, 1, ink);
    draw_text(image, {right + 0.7 * text_height, y + text_height / 2}, text_height, tick_text(x), ink);
  }
}

}  // namespace radcert
