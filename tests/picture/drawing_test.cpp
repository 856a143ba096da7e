// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/drawing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace radcert {
namespace {

/// How much black there is on white, in pixels.
double ink(const Image& image) {
  double sum = 0;
  for (const std::uint8_t byte : image.bytes()) sum += 1 - byte / 255.0;
  return sum / 3;
}

TEST(DrawLine, CoversItsArea) {
  Image image(120, 90);
  const std::array<ImagePoint, 2> line{{{20.3, 15.2}, {95.7, 70.9}}};
  draw_line(image, image.whole(), line, 4, grey(0));
  // A stadium: 4 wide, with half discs at both ends.
  const double length = std::hypot(95.7 - 20.3, 70.9 - 15.2);
  EXPECT_NEAR(ink(image), 4 * length + 3.1416 * 4, 0.02 * 4 * length);
}

TEST(DrawLine, IsNotDarkerWhereItMeetsItself) {
  Image once(40, 40);
  Image twice(40, 40);
  const std::array<ImagePoint, 2> there{{{5.2, 6.1}, {33.3, 30.7}}};
  const std::array<ImagePoint, 3> back{{there[0], there[1], there[0]}};
  draw_line(once, once.whole(), there, 1.5, grey(0), 0.5);
  draw_line(twice, twice.whole(), back, 1.5, grey(0), 0.5);
  EXPECT_TRUE(std::equal(once.bytes().begin(), once.bytes().end(), twice.bytes().begin()));
  EXPECT_EQ(once.at(19, 18)[0], 128);
}

TEST(DrawLine, StaysWithinItsRegion) {
  Image image(30, 30);
  const ImageRegion within{.x = 10, .y = 10, .width = 10, .height = 10};
  const std::array<ImagePoint, 3> line{{{-1e6, 15}, {15, 15}, {15, 1e6}}};
  draw_line(image, within, line, 3, grey(0));
  EXPECT_EQ(image.at(10, 15)[0], 0);
  EXPECT_EQ(image.at(15, 19)[0], 0);
  EXPECT_EQ(image.at(9, 15)[0], 255);
  EXPECT_EQ(image.at(15, 20)[0], 255);
  EXPECT_NEAR(ink(image), 3 * 6 + 3 * 4, 4);
}

TEST(DrawDisc, CoversItsArea) {
  Image image(60, 60);
  draw_disc(image, image.whole(), {31.3, 28.6}, 17, grey(0));
  EXPECT_NEAR(ink(image), 3.14159 * 17 * 17, 4);
  EXPECT_EQ(image.at(31, 28)[0], 0);
}

}  // namespace
}  // namespace radcert
