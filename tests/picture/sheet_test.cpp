// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radcert/core/base64.h"
#include "radcert/core/contract.h"
#include "radcert/picture/drawing.h"
#include "radcert/picture/png.h"

namespace radcert {
namespace {

using testing::HasSubstr;
using testing::Not;

bool overlap(const ImageRegion& a, const ImageRegion& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(Sheet, HasPanelsOfOneSizeThatDoNotMeet) {
  for (const bool has_words : {false, true}) {
    Sheet sheet(
        {.width = 613, .height = 407, .columns = 3, .rows = 2, .has_words = has_words, .has_scale = true});
    std::vector<ImageRegion> panels;
    for (std::size_t row = 0; row < 2; ++row)
      for (std::size_t column = 0; column < 3; ++column) panels.push_back(sheet.panel(column, row, "p"));
    for (std::size_t i = 0; i < panels.size(); ++i) {
      EXPECT_TRUE(sheet.image.contains(panels[i]));
      EXPECT_EQ(panels[i].width, panels[0].width);
      EXPECT_EQ(panels[i].height, panels[0].height);
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(panels[i], panels[j])) << i << " " << j;
    }
    EXPECT_EQ(sheet.titles().size(), 6U);
  }
}

TEST(Sheet, GivesASinglePanelWithoutWordsAllOfItself) {
  Sheet sheet({.width = 70, .height = 50, .has_words = false});
  const ImageRegion panel = sheet.panel(0, 0, "title");
  EXPECT_EQ(panel.width, 70U);
  EXPECT_EQ(panel.height, 50U);
  EXPECT_THAT(sheet.svg_text("d"), Not(HasSubstr("<text")));
}

TEST(Sheet, FitsIntoAnySize) {
  for (const std::size_t side : {1U, 7U, 64U, 400U})
    for (const bool has_words : {false, true}) {
      Sheet sheet({.width = side,
                   .height = side,
                   .columns = 2,
                   .rows = 2,
                   .has_words = has_words,
                   .has_scale = true});
      for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(sheet.image.contains(sheet.panel(k % 2, k / 2, "")));
      sheet.add_scale(sheet.panel(1, 0, ""), {.kind = ColourScale::Kind::map});
    }
  EXPECT_THROW(Sheet({.width = 1, .height = 1, .columns = 0}), ContractViolation);
}

TEST(Sheet, HoldsItsRasterAndItsWords) {
  Sheet sheet({.width = 300, .height = 200, .has_words = true, .has_scale = true});
  const ImageRegion panel = sheet.panel(0, 0, "a < b");
  fill(sheet.image, panel, {1, 0, 0});
  sheet.add_scale(panel, {.kind = ColourScale::Kind::map, .low = 0, .high = 1});
  const std::string text = sheet.svg_text("a picture");
  EXPECT_THAT(text, HasSubstr(">a &lt; b</text>"));
  EXPECT_THAT(text, HasSubstr(base64(png_bytes(sheet.image, "a picture"))));
  // The ticks of a scale from 0 to 1.
  EXPECT_THAT(text, HasSubstr(">0.2</text>"));
  EXPECT_THAT(text, HasSubstr("<title>a picture</title>"));
}

}  // namespace
}  // namespace radcert
