// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace radcert {

/// A colour as an amount of light.
/// Maths     red, green, blue parts, 1 what a screen shows at most
/// Source    IEC 61966-2-1, sRGB: its primaries, before its transfer function
/// Result    plain data; sums and multiples are those of light
/// Limits    parts outside [0,1] are cut off where they are shown
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;

  friend Colour operator+(const Colour& a, const Colour& b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue};
  }
  friend Colour operator*(double c, const Colour& a) { return {c * a.red, c * a.green, c * a.blue}; }
  friend bool operator==(const Colour& a, const Colour& b) = default;
};

/// The same amount of the three parts.
[[nodiscard]] constexpr Colour grey(double light) { return {light, light, light}; }

/// The pixel value of an amount of light.
/// Maths     12.92 x for x <= 0.0031308, else 1.055 x^(1/2.4) - 0.055
/// Source    IEC 61966-2-1, sRGB
/// Requires  not NaN, else ContractViolation
/// Result    in [0,1]; light below 0 is shown as 0, above 1 as 1; monotone
[[nodiscard]] double screen_value(double light);
/// The light of a screen value: the inverse of screen_value on [0,1].
[[nodiscard]] double light_of_screen_value(double value);

/// A pixel as files have it: red, green, blue screen values times 255, rounded.
using Pixel = std::array<std::uint8_t, 3>;
[[nodiscard]] Pixel screen_pixel(const Colour& colour);

/// A part of an image: columns [x, x + width), rows [y, y + height), row 0 on top.
struct ImageRegion {
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t width = 0;
  std::size_t height = 0;
};

/// A picture of 8-bit pixels.
/// Maths     pixel (x, y), x to the right, y downwards, covers [x, x+1) x [y, y+1)
/// Requires  1 <= width, height <= most_side, places within the image, else ContractViolation
/// Result    bytes() row by row from the top, three a pixel
/// Limits    sRGB alone, opaque
class Image {
public:
  static constexpr std::size_t most_side = 8192;

  Image(std::size_t width, std::size_t height, const Colour& background = grey(1));

  [[nodiscard]] std::size_t width() const { return width_; }
  [[nodiscard]] std::size_t height() const { return height_; }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }
  [[nodiscard]] ImageRegion whole() const { return {.x = 0, .y = 0, .width = width_, .height = height_}; }
  [[nodiscard]] Pixel at(std::size_t x, std::size_t y) const;
  void set(std::size_t x, std::size_t y, const Pixel& pixel);
  /// Lays a colour over a pixel; coverage 0 leaves it, 1 replaces it, between them screen values are mixed.
  void mix(std::size_t x, std::size_t y, const Pixel& pixel, double coverage);
  /// Whether a region lies within the image.
  [[nodiscard]] bool contains(const ImageRegion& region) const;

private:
  [[nodiscard]] std::size_t place(std::size_t x, std::size_t y) const;
  std::size_t width_;
  std::size_t height_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace radcert
