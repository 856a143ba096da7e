// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/version.h"
#include "tests/picture/draws.h"

namespace radcert {
namespace {

Image random_image(std::size_t width, std::size_t height, std::uint64_t seed) {
  test::Draws draws(seed);
  Image image(width, height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const auto byte = [&] { return static_cast<std::uint8_t>(draws.below(256)); };
      const std::uint8_t red = byte();
      const std::uint8_t green = byte();
      image.set(x, y, {red, green, byte()});
    }
  return image;
}

/// The chunks of a file in their order: type and data.
std::vector<std::pair<std::string, std::string>> chunks(const std::string& file) {
  std::vector<std::pair<std::string, std::string>> out;
  for (std::size_t at = 8; at + 12 <= file.size();) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k) length = 256 * length + static_cast<unsigned char>(file[at + k]);
    out.emplace_back(file.substr(at + 4, 4), file.substr(at + 8, length));
    at += 12 + length;
  }
  return out;
}

TEST(Png, ReadsBackAsTheSamePixels) {
  for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{1, 1}, {1, 7}, {5, 1}, {64, 33}}) {
    const Image image = random_image(width, height, 11 * width + height);
    const std::string file = png_bytes(image, "a random picture");
    png_image read{};
    read.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&read, file.data(), file.size()), 0) << read.message;
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    read.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(3 * width * height);
    ASSERT_NE(png_image_finish_read(&read, nullptr, bytes.data(), 0, nullptr), 0) << read.message;
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), image.bytes().begin(), image.bytes().end()));
  }
}

TEST(Png, SaysWhatItShowsAndNotWhen) {
  const std::string file = png_bytes(random_image(20, 10, 3), "what it shows");
  std::map<std::string, int> count;
  std::vector<std::string> texts;
  for (const auto& [type, data] : chunks(file)) {
    ++count[type];
    if (type == "tEXt") texts.push_back(data);
  }
  const std::string zero(1, '\0');
  EXPECT_THAT(texts, testing::ElementsAre("Software" + zero + "radcert " + std::string(version()),
                                          "Description" + zero + "what it shows"));
  EXPECT_EQ(count["sRGB"], 1);
  EXPECT_EQ(count["tIME"], 0);
  EXPECT_EQ(file, png_bytes(random_image(20, 10, 3), "what it shows"));
}

TEST(Png, TakesPrintableTextAlone) {
  const Image image(2, 2);
  EXPECT_THROW((void)png_bytes(image, "two\nlines"), ContractViolation);
  EXPECT_THROW((void)png_bytes(image, "caf\xc3\xa9"), ContractViolation);
}

TEST(Image, ScreenValuesAreThoseOfSrgb) {
  // 18 % grey, the joint of the two pieces, and the ends; the first from the standard's own formula by hand.
  EXPECT_NEAR(screen_value(0.18), 0.4613561295004409, 1e-15);
  EXPECT_EQ(screen_value(0), 0);
  EXPECT_DOUBLE_EQ(screen_value(1), 1);
  EXPECT_EQ(screen_value(-3), 0);
  EXPECT_DOUBLE_EQ(screen_value(1e9), 1);
  EXPECT_EQ(screen_pixel(grey(0.5)), (Pixel{188, 188, 188}));
  test::Draws draws(5);
  for (int k = 0; k < 1000; ++k) {
    const double light = draws.part();
    EXPECT_NEAR(light_of_screen_value(screen_value(light)), light, 1e-12) << light;
    EXPECT_LT(screen_value(light), screen_value(light + 1e-6));
  }
  EXPECT_THROW((void)screen_value(std::nan("")), ContractViolation);
}

TEST(Image, MixesByCoverage) {
  Image image(3, 2, grey(0));
  image.mix(1, 1, {200, 100, 50}, 0.5);
  EXPECT_EQ(image.at(1, 1), (Pixel{100, 50, 25}));
  image.mix(1, 1, {7, 8, 9}, 1);
  EXPECT_EQ(image.at(1, 1), (Pixel{7, 8, 9}));
  EXPECT_EQ(image.at(0, 1), (Pixel{0, 0, 0}));
  // Rows from the top, three bytes a pixel.
  EXPECT_EQ(image.bytes()[3 * (1 * 3 + 1)], 7);
}

TEST(Image, RefusesWhatIsNoneOfItsPixels) {
  EXPECT_THROW((void)Image(0, 5), ContractViolation);
  EXPECT_THROW((void)Image(5, Image::most_side + 1), ContractViolation);
  Image image(4, 4);
  EXPECT_THROW(image.set(4, 0, {}), ContractViolation);
  EXPECT_THROW((void)image.at(0, 4), ContractViolation);
  EXPECT_THROW(image.mix(0, 0, {}, 1.5), ContractViolation);
  EXPECT_TRUE(image.contains({.x = 1, .y = 2, .width = 3, .height = 2}));
  EXPECT_FALSE(image.contains({.x = 1, .y = 2, .width = 4, .height = 2}));
  EXPECT_FALSE(image.contains({.x = 1, .y = 2, .width = static_cast<std::size_t>(-1), .height = 2}));
}

}  // namespace
}  // namespace radcert
