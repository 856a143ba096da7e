// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

double luminance(const Colour& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

/// OKLab's lightness, by its forward formulas: the other way than the map goes.
double lightness(const Colour& c) {
  const double l = std::cbrt(0.4122214708 * c.red + 0.5363325363 * c.green + 0.0514459929 * c.blue);
  const double m = std::cbrt(0.2119034982 * c.red + 0.6806995451 * c.green + 0.1073969566 * c.blue);
  const double s = std::cbrt(0.0883024619 * c.red + 0.2817188376 * c.green + 0.6299787005 * c.blue);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

TEST(ColourMap, GetsBrighterAndStaysWithinSrgb) {
  constexpr int steps = 2000;
  double before = -1;
  for (int k = 0; k <= steps; ++k) {
    const Colour c = map_colour(static_cast<double>(k) / steps);
    for (const double part : {c.red, c.green, c.blue}) {
      EXPECT_GE(part, -1e-4) << k;
      EXPECT_LE(part, 1) << k;
    }
    EXPECT_GT(luminance(c), before) << k;
    before = luminance(c);
  }
}

TEST(ColourMap, HasALightnessThatIsLinear) {
  for (int k = 0; k <= 100; ++k) {
    const double x = k / 100.0;
    EXPECT_NEAR(lightness(map_colour(x)), 0.97 * x, 1e-5) << x;
  }
}

TEST(ColourMap, GoesFromBlackAndCutsOff) {
  EXPECT_EQ(screen_pixel(map_colour(0)), (Pixel{0, 0, 0}));
  EXPECT_EQ(screen_pixel(map_colour(-5)), screen_pixel(map_colour(0)));
  EXPECT_EQ(screen_pixel(map_colour(7)), screen_pixel(map_colour(1)));
  EXPECT_THROW((void)map_colour(std::nan("")), ContractViolation);
}

TEST(ColourMap, TakesOklabsGreysForGreys) {
  for (const double l : {0.1, 0.5, 0.9, 1.0}) {
    const Colour c = colour_of_oklab(l, 0, 0);
    EXPECT_NEAR(c.red, l * l * l, 1e-6);
    EXPECT_NEAR(c.green, l * l * l, 1e-6);
    EXPECT_NEAR(c.blue, l * l * l, 1e-6);
  }
}

}  // namespace
}  // namespace radcert
