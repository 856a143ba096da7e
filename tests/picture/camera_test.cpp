// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "radcert/core/contract.h"
#include "tests/picture/draws.h"

namespace radcert {
namespace {

constexpr ImageRegion picture{.x = 30, .y = 20, .width = 640, .height = 480};

TEST(PinholeCamera, LooksAlongAnAxisAsWorkedOutByHand) {
  // Eye at the origin, looking along y, 90 degrees high: what is at distance 1 is shown from z = -1 to 1.
  const PinholeCamera camera(
      {.position = {0, 0, 0}, .look_at = {0, 5, 0}, .up = {0, 0, 2}, .vertical_angle = std::numbers::pi / 2});
  const auto middle = camera.image_of({0, 7, 0}, picture).value();
  EXPECT_NEAR(middle.x, 350, 1e-12);
  EXPECT_NEAR(middle.y, 260, 1e-12);
  const auto upper_right = camera.image_of({1, 2, 2}, picture).value();  // half of the height to the right
  EXPECT_NEAR(upper_right.x, 350 + 120, 1e-12);
  EXPECT_NEAR(upper_right.y, 20, 1e-12);
  EXPECT_FALSE(camera.image_of({0, -1, 0}, picture));
  EXPECT_FALSE(camera.image_of({3, 0, 2}, picture));
  const Vector<double> through = camera.through({350 + 240, 260 + 240}, picture);
  EXPECT_NEAR(through.x, 1, 1e-15);
  EXPECT_NEAR(through.y, 1, 1e-15);
  EXPECT_NEAR(through.z, -1, 1e-15);
}

TEST(PinholeCamera, ShowsThePointsOfARayWhereTheRayLeaves) {
  test::Draws draws(21);
  for (int k = 0; k < 500; ++k) {
    const Vector<double> eye = draws.point(-3, 3);
    const PinholeCamera camera({.position = eye,
                                .look_at = draws.point(4, 9),
                                .up = {draws.part(), -0.5, 1},
                                .vertical_angle = draws.between(0.05, 2.5)});
    const ImagePoint at{draws.between(0, 700), draws.between(0, 600)};
    const Vector<double> through = camera.through(at, picture);
    const auto back = camera.image_of(eye + draws.between(0.01, 100) * (through - eye), picture);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, at.x, 1e-8);
    EXPECT_NEAR(back->y, at.y, 1e-8);
  }
}

TEST(PinholeCamera, TurnsAnglesIntoPixelsByTheirTangents) {
  // Independent of the vectors: the angle between the axis and a ray, from its pixel alone.
  test::Draws draws(22);
  for (int k = 0; k < 200; ++k) {
    const double angle = draws.between(0.1, 2);
    const Vector<double> eye = draws.point(-1, 1);
    const Vector<double> target = draws.point(2, 5);
    const PinholeCamera camera({.position = eye, .look_at = target, .vertical_angle = angle});
    const ImagePoint at{draws.between(30, 670), draws.between(20, 500)};
    const Vector<double> ray = camera.through(at, picture) - eye;
    const Vector<double> axis = target - eye;
    const double off = std::hypot(at.x - 350, at.y - 260) * std::tan(angle / 2) / 240;
    EXPECT_NEAR(norm(cross(ray, axis)) / dot(ray, axis), off, 1e-12);
    // A row is level: `up` has no part across it.
    const Vector<double> along = camera.through({at.x + 10, at.y}, picture) - camera.through(at, picture);
    EXPECT_NEAR(along.z, 0, 1e-14);
    EXPECT_GT((camera.through({at.x, at.y - 10}, picture) - camera.through(at, picture)).z, 0);
  }
}

TEST(PinholeCamera, RefusesToLookNowhere) {
  const Vector<double> here{1, 2, 3};
  EXPECT_THROW((void)PinholeCamera({.position = here, .look_at = here}), ContractViolation);
  EXPECT_THROW((void)PinholeCamera({.position = here, .look_at = {1, 2, 5}}), ContractViolation);
  EXPECT_THROW((void)PinholeCamera({.position = here, .look_at = {0, 0, 0}, .vertical_angle = 0}),
               ContractViolation);
  EXPECT_THROW(
      (void)PinholeCamera({.position = here, .look_at = {0, 0, 0}, .vertical_angle = std::numbers::pi}),
      ContractViolation);
}

}  // namespace
}  // namespace radcert
