// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/rendering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/scenes/lit_room.h"

namespace radcert {
namespace {

using namespace verification::psg10;

std::string bytes_of(const Image& image) { return {image.bytes().begin(), image.bytes().end()}; }

std::function<PointValue()> shared(PointValue value) {
  return [value = std::move(value)] { return value; };
}

struct Room {
  LitRoom room = lit_room();
  RayCaster caster = RayCaster::make(room.scene.surface()).value();
};

TEST(Show, GivesTheSameBytesForAnyNumberOfThreads) {
  const Room room;
  const SiteSet sites = poisson_disk_sites(room.room.scene.surface(), {.separation = 0.6}).value();
  const RadialBasis basis = RadialBasis::make(sites, lehtinen_basis()).value();
  std::vector<double> coefficients(basis.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = 0.1 * static_cast<double>(i % 11);
  for (const bool smooth : {false, true}) {
    const auto picture = [&](std::size_t threads, Seen& seen) {
      const ThreadLimit limit(threads);
      Image image(70, 50);
      seen =
          show(image, {.camera = room.room.camera, .picture = image.whole(), .samples = 2, .smooth = smooth},
               room.caster, combination(basis, coefficients), {.outline = 0.5});
      return bytes_of(image);
    };
    Seen one;
    Seen two;
    EXPECT_EQ(picture(1, one), picture(2, two));
    EXPECT_EQ(one.values, two.values);
    EXPECT_EQ(one.least, two.least);
    EXPECT_EQ(one.largest, two.largest);
    EXPECT_GT(one.largest, one.least);
  }
}

TEST(Show, PutsEveryPointWhereTheCameraHasIt) {
  // The value at a point is the column of its image: each pixel must be its own column's colour.
  const Room room;
  const PinholeCamera camera(room.room.camera);
  Image image(60, 40);
  const ImageRegion region{.x = 7, .y = 5, .width = 44, .height = 33};
  const auto column = [&](const LitPoint& at) -> std::optional<double> {
    return camera.image_of(at.site.point, region)->x;
  };
  const Seen seen = show(image, {.camera = room.room.camera, .picture = region, .samples = 1}, room.caster,
                         shared(column), {.scale = {.low = 0, .high = 60}});
  EXPECT_EQ(seen.values, 44U * 33U);
  EXPECT_EQ(seen.nothing, 0U);
  EXPECT_NEAR(seen.least, 7.5, 1e-6);
  EXPECT_NEAR(seen.largest, 50.5, 1e-6);
  for (std::size_t y = 0; y < 40; ++y)
    for (std::size_t x = 0; x < 60; ++x) {
      const bool inside = x >= 7 && x < 51 && y >= 5 && y < 38;
      const Pixel wanted =
          inside ? screen_pixel(grey((static_cast<double>(x) + 0.5) / 60)) : Pixel{255, 255, 255};
      EXPECT_NEAR(image.at(x, y)[1], wanted[1], 1) << x << ", " << y;
    }
}

TEST(Show, AveragesLight) {
  // A wall half of which is black and half white, through the middle of a pixel, seen by two rays each way:
  // half the light.
  const Room room;
  const PinholeCamera camera(room.room.camera);
  Image image(61, 41);
  const auto half = [&](const LitPoint& at) -> std::optional<double> {
    return camera.image_of(at.site.point, image.whole())->x < 30.5 ? 0 : 1;
  };
  (void)show(image, {.camera = room.room.camera, .picture = image.whole(), .samples = 2}, room.caster,
             shared(half), {});
  EXPECT_EQ(image.at(29, 20)[0], 0);
  EXPECT_EQ(image.at(30, 20), screen_pixel(grey(0.5)));
  EXPECT_EQ(image.at(31, 20)[0], 255);
}

TEST(Show, TakesOneValueAFaceWhereTheViewIsSmooth) {
  const Room room;
  Image plain(64, 48);
  Image smooth(64, 48);
  const auto height = [](const LitPoint& at) -> std::optional<double> { return at.site.point.z / 3; };
  View view{.camera = room.room.camera, .picture = plain.whole(), .samples = 4};
  const Seen all = show(plain, view, room.caster, shared(height), {});
  view.smooth = true;
  const Seen few = show(smooth, view, room.caster, shared(height), {});
  EXPECT_EQ(all.values, 64U * 48U * 16U);
  EXPECT_GE(few.values, 64U * 48U);
  EXPECT_LT(few.values, 64U * 48U * 3U / 2U);
  // A pixel is up to 0.04 of the height.
  int differing = 0;
  for (std::size_t y = 0; y < 48; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      const auto light = [&](const Image& image) { return light_of_screen_value(image.at(x, y)[0] / 255.0); };
      if (std::abs(light(plain) - light(smooth)) > 0.02) ++differing;
    }
  EXPECT_LT(differing, 10);
}

TEST(Show, CountsAndColoursWhatHasNoValue) {
  const Room room;
  Image image(40, 30);
  const auto floor_alone = [](const LitPoint& at) -> std::optional<double> {
    return at.site.normal.z > 0.5 ? std::optional(2.0) : std::nullopt;
  };
  const Seen seen = show(image, {.camera = room.room.camera, .picture = image.whole(), .samples = 1},
                         room.caster, shared(floor_alone), {.scale = {.low = 0, .high = 1}});
  EXPECT_EQ(seen.values, 40U * 30U);
  EXPECT_GT(seen.without_value, 500U);
  EXPECT_EQ(seen.above, seen.values - seen.without_value);
  EXPECT_EQ(seen.below, 0U);
  EXPECT_EQ(seen.least, 2);
  EXPECT_EQ(image.at(20, 1), (Pixel{255, 0, 255}));
  EXPECT_EQ(image.at(20, 29), (Pixel{255, 255, 255}));
  const auto outside = shared([](const LitPoint&) -> std::optional<double> { return 1; });
  const CameraPose away{.position = {2, -5, 1}, .look_at = {2, -9, 1}};
  const Seen none = show(image, {.camera = away, .picture = image.whole(), .samples = 1}, room.caster,
                         outside, {.background = grey(0)});
  EXPECT_EQ(none.nothing, 40U * 30U);
  EXPECT_EQ(none.values, 0U);
  EXPECT_EQ(none.least, 0);
  EXPECT_EQ(image.at(3, 3), (Pixel{0, 0, 0}));
}

TEST(Show, OutlinesWhereFacesEnd) {
  const Room room;
  Image image(80, 60);
  const auto white = shared([](const LitPoint&) -> std::optional<double> { return 1; });
  (void)show(image, {.camera = room.room.camera, .picture = image.whole(), .samples = 3}, room.caster, white,
             {.outline = 1});
  // Each row of the back wall's height crosses its two upright edges.
  const PinholeCamera camera(room.room.camera);
  const auto corner = camera.image_of({0, 4, 2.5}, image.whole()).value();
  const auto x = static_cast<std::size_t>(corner.x);
  const auto y = static_cast<std::size_t>(corner.y);
  int darkest = 255;
  for (std::size_t k = x - 1; k <= x + 1; ++k) darkest = std::min(darkest, int{image.at(k, y)[0]});
  EXPECT_LT(darkest, 140);
  EXPECT_EQ(image.at(x + 4, y)[0], 255);
}

TEST(Show, RefusesWhatCannotBeShown) {
  const Room room;
  Image image(10, 10);
  const auto value = shared([](const LitPoint&) -> std::optional<double> { return 1; });
  View view{.camera = room.room.camera, .picture = image.whole(), .samples = 0};
  EXPECT_THROW((void)show(image, view, room.caster, value, {}), ContractViolation);
  view.samples = 1;
  EXPECT_THROW((void)show(image, view, room.caster, value, {.scale = {.low = 1, .high = 1}}),
               ContractViolation);
  EXPECT_THROW((void)show(image, view, room.caster, value, {.outline = 2}), ContractViolation);
  const auto nan = shared([](const LitPoint&) { return std::optional(std::nan("")); });
  EXPECT_THROW((void)show(image, view, room.caster, nan, {}), ContractViolation);
  view.picture.width = 11;
  EXPECT_THROW((void)show(image, view, room.caster, value, {}), ContractViolation);
}

TEST(Combination, IsTheBasisOwn) {
  const Room room;
  const SiteSet sites = poisson_disk_sites(room.room.scene.surface(), {.separation = 0.8}).value();
  const RadialBasis basis = RadialBasis::make(sites, shepard_basis()).value();
  std::vector<double> coefficients(basis.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = std::sin(static_cast<double>(i));
  const PointValue value = combination(basis, coefficients)();
  for (std::size_t i = 0; i < sites.size(); i += 5) {
    EXPECT_EQ(value({.site = sites[i], .chart = sites.at[i].chart}), coefficients[i]);
    Site<double> beside = sites[i];
    beside.point = beside.point + 0.01 * beside.normal;
    EXPECT_EQ(value({.site = beside, .chart = 0}), basis.at(beside, coefficients));
  }
  EXPECT_THROW((void)combination(basis, std::vector<double>(3)), ContractViolation);
}

}  // namespace
}  // namespace radcert
