// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/image.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr double largest_byte = 255;

std::uint8_t rounded(double byte) { return static_cast<std::uint8_t>(std::floor(byte + 0.5)); }

}  // namespace

double screen_value(double light) {
  expects(!std::isnan(light), "light that is a number");
  const double x = std::clamp(light, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

double light_of_screen_value(double value) {
  expects(value >= 0 && value <= 1, "a screen value in [0,1]", named("value", value));
  return value <= 12.92 * 0.0031308 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Pixel screen_pixel(const Colour& colour) {
  return {rounded(largest_byte * screen_value(colour.red)),
          rounded(largest_byte * screen_value(colour.green)),
          rounded(largest_byte * screen_value(colour.blue))};
}

Image::Image(std::size_t width, std::size_t height, const Colour& background)
    : width_(width), height_(height) {
  expects(width >= 1 && width <= most_side && height >= 1 && height <= most_side, "sides from 1 to most_side",
          named("width", width), named("height", height));
  const Pixel pixel = screen_pixel(background);
  bytes_.resize(3 * width * height);
  for (std::size_t k = 0; k < bytes_.size(); ++k) bytes_[k] = pixel[k % 3];
}

std::size_t Image::place(std::size_t x, std::size_t y) const {
  expects(x < width_ && y < height_, "a pixel of the image", named("x", x), named("y", y));
  return 3 * (y * width_ + x);
}

Pixel Image::at(std::size_t x, std::size_t y) const {
  const std::size_t k = place(x, y);
  return {bytes_[k], bytes_[k + 1], bytes_[k + 2]};
}

void Image::set(std::size_t x, std::size_t y, const Pixel& pixel) {
  const std::size_t k = place(x, y);
  std::copy(pixel.begin(), pixel.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(k));
}

void Image::mix(std::size_t x, std::size_t y, const Pixel& pixel, double coverage) {
  expects(coverage >= 0 && coverage <= 1, "a coverage in [0,1]", named("coverage", coverage));
  const std::size_t k = place(x, y);
  for (std::size_t part = 0; part < pixel.size(); ++part)
    bytes_[k + part] = rounded((1 - coverage) * bytes_[k + part] + coverage * pixel[part]);
}

bool Image::contains(const ImageRegion& region) const {
  return region.width >= 1 && region.height >= 1 && region.x < width_ && region.y < height_ &&
         region.width <= width_ - region.x && region.height <= height_ - region.y;
}

}  // namespace radcert
