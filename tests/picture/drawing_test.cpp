// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/drawing.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/picture/curve_panel.h"
#include "radcert/picture/stroke_font.h"

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

TEST(DrawText, HasALetterForEveryCharacterThatIsPrinted) {
  for (char c = ' '; c <= '~'; ++c) {
    const StrokeLetter& letter = stroke_letter(c);
    EXPECT_EQ(letter.strokes.empty(), c == ' ') << c;
    for (const auto& stroke : letter.strokes)
      for (const ImagePoint& p : stroke) {
        EXPECT_GE(p.x, -0.5) << c;
        EXPECT_LE(p.x, letter.advance - 1.5) << c;
        EXPECT_GE(p.y, -2.6) << c;
        EXPECT_LE(p.y, 9.1) << c;
      }
  }
  EXPECT_THROW((void)stroke_letter('\n'), ContractViolation);
  EXPECT_THROW((void)stroke_letter('\x80'), ContractViolation);
}

TEST(DrawText, LooksDifferentForEveryCharacter) {
  std::map<std::string, char> seen;
  for (char c = '!'; c <= '~'; ++c) {
    Image image(40, 40);
    draw_text(image, {5, 28}, 20, std::string(1, c), grey(0));
    EXPECT_GT(ink(image), 3) << c;
    const auto [other, is_new] = seen.try_emplace({image.bytes().begin(), image.bytes().end()}, c);
    EXPECT_TRUE(is_new) << other->second << " and " << c;
  }
}

TEST(DrawText, IsAsWideAsItSays) {
  const std::string text = "H10 H";
  const double width = text_width(16, text);
  Image image(200, 40);
  draw_text(image, {20, 30}, 16, text, grey(0));
  const auto inked = [&](std::size_t x) {
    for (std::size_t y = 0; y < image.height(); ++y)
      if (image.at(x, y)[0] < 128) return true;
    return false;
  };
  std::size_t first = 0;
  while (!inked(first)) ++first;
  std::size_t last = image.width() - 1;
  while (!inked(last)) --last;
  EXPECT_NEAR(static_cast<double>(first), 20, 1.5);
  EXPECT_NEAR(static_cast<double>(last), 20 + width, 1.5);
  Image right(200, 40);
  draw_text(right, {20 + width, 30}, 16, text, grey(0), TextAlign::right);
  EXPECT_TRUE(std::equal(image.bytes().begin(), image.bytes().end(), right.bytes().begin()));
}

TEST(DrawPanel, PutsAMarkWhereItsNumbersAre) {
  // Without words the frame is the region.
  Image image(140, 90);
  const CurvePanel panel{.title = "t",
                         .x_name = "x",
                         .y_name = "y",
                         .low_x = -2,
                         .high_x = 5,
                         .low_y = 10,
                         .high_y = 40,
                         .marks = {{0, 20}}};
  draw_panel(image, image.whole(), panel);
  EXPECT_LT(image.at(40, 60)[0], 60);  // 2/7 of 140, 2/3 of 90
  EXPECT_EQ(image.at(60, 40)[0], 255);
  EXPECT_THROW(draw_panel(image, image.whole(), {.low_x = 1, .high_x = 1}), ContractViolation);
}

TEST(DrawPanel, FitsIntoAnyRegion) {
  for (const std::size_t side : {1U, 7U, 64U, 151U, 400U}) {
    Image image(side, side);
    draw_panel(image, image.whole(), {.title = "a title", .low_y = -1, .high_y = 1});
    draw_scale(image, image.whole(), {.kind = ColourScale::Kind::map}, 10);
  }
}

}  // namespace
}  // namespace radcert
