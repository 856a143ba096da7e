// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

double squared(double x) { return x * x; }

double distance(const ImagePoint& p, const ImagePoint& a, const ImagePoint& b) {
  const double length = squared(b.x - a.x) + squared(b.y - a.y);
  double t = 0;
  if (length > 0) t = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y));
}

/// How much of each pixel of a region a shape covers: of several parts the largest.
class Mask {
public:
  /// Of the part of `within` that has the points in it, and `margin` about them.
  Mask(const Image& image, const ImageRegion& within, std::span<const ImagePoint> points, double margin) {
    expects(image.contains(within), "a region of the image", named("width", within.width),
            named("height", within.height));
    if (points.empty()) return;
    double low_x = points[0].x;
    double high_x = points[0].x;
    double low_y = points[0].y;
    double high_y = points[0].y;
    for (const ImagePoint& p : points) {
      expects(std::isfinite(p.x) && std::isfinite(p.y), "finite points", named("x", p.x), named("y", p.y));
      low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
    }
    const auto clipped = [](double low, double high, std::size_t first, std::size_t count, std::size_t& from,
                            std::size_t& length) {
      const auto least = static_cast<double>(first);
      const auto most = static_cast<double>(first + count);
      const double begin = std::clamp(std::floor(low), least, most);
      const double end = std::clamp(std::ceil(high), least, most);
      from = static_cast<std::size_t>(begin);
      length = end > begin ? static_cast<std::size_t>(end - begin) : 0;
    };
    clipped(low_x - margin, high_x + margin, within.x, within.width, region_.x, region_.width);
    clipped(low_y - margin, high_y + margin, within.y, within.height, region_.y, region_.height);
    coverage_.resize(region_.width * region_.height);
  }

  /// `covers` tells how much of the pixel with this middle, in [0,1]; asked within `margin` of the points.
  template <class Covers>
  void add(std::span<const ImagePoint> points, double margin, const Covers& covers) {
    if (coverage_.empty()) return;
    const auto range = [margin](double low, double high, std::size_t first, std::size_t count) {
      const auto place = [&](double x) {
        return static_cast<std::size_t>(
            std::clamp(x - static_cast<double>(first), 0.0, static_cast<double>(count)));
      };
      return std::pair(place(std::floor(low - margin)), place(std::ceil(high + margin)));
    };
    const auto [low_x, high_x] = std::minmax_element(points.begin(), points.end(),
                                                     [](const auto& a, const auto& b) { return a.x < b.x; });
    const auto [low_y, high_y] = std::minmax_element(points.begin(), points.end(),
                                                     [](const auto& a, const auto& b) { return a.y < b.y; });
    const auto columns = range(low_x->x, high_x->x, region_.x, region_.width);
    const auto rows = range(low_y->y, high_y->y, region_.y, region_.height);
    for (std::size_t y = rows.first; y < rows.second; ++y)
      for (std::size_t x = columns.first; x < columns.second; ++x) {
        double& here = coverage_[y * region_.width + x];
        here = std::max(here, covers(ImagePoint{static_cast<double>(region_.x + x) + 0.5,
                                                static_cast<double>(region_.y + y) + 0.5}));
      }
  }

  void lay(Image& image, const Colour& colour, double opacity) const {
    expects(opacity >= 0 && opacity <= 1, "an opacity in [0,1]", named("opacity", opacity));
    const Pixel pixel = screen_pixel(colour);
    for (std::size_t y = 0; y < region_.height; ++y)
      for (std::size_t x = 0; x < region_.width; ++x)
        if (const double coverage = coverage_[y * region_.width + x]; coverage > 0)
          image.mix(region_.x + x, region_.y + y, pixel, opacity * coverage);
  }

private:
  ImageRegion region_;
  std::vector<double> coverage_;
};

/// A line of less than a pixel is as wide as one, and paler.
double line_coverage(double distance, double width) {
  return std::min(1.0, width) * std::clamp(0.5 + std::max(1.0, width) / 2 - distance, 0.0, 1.0);
}

void add_line(Mask& mask, std::span<const ImagePoint> points, double width) {
  const double margin = std::max(1.0, width) / 2 + 1;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    mask.add(points.subspan(k, 2), margin, [&](const ImagePoint& p) {
      return line_coverage(distance(p, points[k], points[k + 1]), width);
    });
}

}  // namespace

void draw_line(Image& image, const ImageRegion& within, std::span<const ImagePoint> points, double width,
               const Colour& colour, double opacity) {
  expects(width > 0 && std::isfinite(width), "a positive width", named("width", width));
  Mask mask(image, within, points, width + 1);
  add_line(mask, points, width);
  mask.lay(image, colour, opacity);
}

void draw_disc(Image& image, const ImageRegion& within, const ImagePoint& middle, double radius,
               const Colour& colour, double opacity) {
  expects(radius > 0 && std::isfinite(radius), "a positive radius", named("radius", radius));
  const std::span<const ImagePoint> points(&middle, 1);
  Mask mask(image, within, points, radius + 1);
  mask.add(points, radius + 1, [&](const ImagePoint& p) {
    return std::clamp(0.5 + radius - std::hypot(p.x - middle.x, p.y - middle.y), 0.0, 1.0);
  });
  mask.lay(image, colour, opacity);
}

void fill(Image& image, const ImageRegion& region, const Colour& colour) {
  expects(image.contains(region), "a region of the image");
  const Pixel pixel = screen_pixel(colour);
  for (std::size_t y = 0; y < region.height; ++y)
    for (std::size_t x = 0; x < region.width; ++x) image.set(region.x + x, region.y + y, pixel);
}

}  // namespace radcert
