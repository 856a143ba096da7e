// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/visibility/solid_configuration.h"

#include <gtest/gtest.h>

#include <numbers>

#include "radcert/closed_form/point_to_polygon.h"
#include "tests/visibility/exact_sight.h"
#include "tests/visibility/sample_scenes.h"

namespace radcert {
namespace {

using sample::Numbers;

PlanePolynomial<Rational> one() {
  PlanePolynomial<Rational> q(0);
  q(0, 0) = 1;
  return q;
}

/// Without what hides: the closed form over the whole triangle.
Ball unoccluded(const Scene& scene, const Viewpoint& from, std::size_t triangle) {
  const auto corners = scene.corners(triangle);
  const PlanePolygon polygon =
      plane_polygon({sample::exact(corners[0]), sample::exact(corners[1]), sample::exact(corners[2])})
          .value();
  return point_to_polygon(sample::exact(from.point), sample::exact(from.normal), polygon, one());
}

struct Total {
  double rounded = 0;
  Ball enclosed = 0;
};

Total total_over(const Scene& scene, const Viewpoint& from, bool with_balls) {
  Total total;
  PointView view(scene, from);
  for (std::size_t k = 0; k < scene.triangle_count(); ++k) {
    const VisibleRegion region = view.region(k);
    total.rounded += solid_configuration_in_double(scene, from, k, region);
    if (with_balls) total.enclosed += solid_configuration(scene, from, k, region);
  }
  return total;
}

void expect_closed(const Scene& scene, Numbers& random, int count) {
  for (int k = 0; k < count; ++k) {
    const std::size_t own = random.below(scene.triangle_count());
    // On the grid of a box P lies in the plane of its triangle exactly.
    const auto at = k % 2 == 0 ? sample::random_parameters(random, 16)
                               : ParameterPoint<double>{random.fraction() / 2, random.fraction() / 2};
    const Viewpoint from{sample::point_of(scene, own, at.s, at.t), sample::normal_of(scene, own), own};
    const Total total = total_over(scene, from, k < 2);
    EXPECT_NEAR(total.rounded, std::numbers::pi, 1e-13)
        << shortest(from.point.x) << " " << shortest(from.point.y) << " " << shortest(from.point.z);
    if (k == 0) {
      EXPECT_TRUE(overlaps(total.enclosed, Ball::pi())) << (total.enclosed - Ball::pi()).to_text();
      EXPECT_LT(total.enclosed.radius(), 1e-20);
    }
  }
}

TEST(SolidConfiguration, SumsToPiInRooms) {
  Numbers random(21);
  expect_closed(sample::cube_room(), random, 6);
  expect_closed(sample::l_room(), random, 12);
  for (const unsigned seed : {1U, 2U}) {
    expect_closed(sample::boxes_in_box(seed, true, 6), random, 8);
    expect_closed(sample::boxes_in_box(seed, false, 6), random, 7);
  }
}

TEST(SolidConfiguration, SumsToPiHoweverNarrowTheGap) {
  Numbers random(22);
  for (const double gap : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12})
    expect_closed(sample::cube_in_cube(gap), random, 10);
  // Below the inner cube, where all but the gap is dark.
  for (const double gap : {0x1p-4, 0x1p-20, 0x1p-40}) {
    const Scene scene = sample::cube_in_cube(gap);
    for (std::size_t own = 0; own < scene.triangle_count(); ++own) {
      const auto [a, b, c] = scene.corners(own);
      if (a.z != 0 || b.z != 0 || c.z != 0) continue;
      const Total total = total_over(scene, {{0.375, 0.5, 0}, {0, 0, 1}, own}, true);
      EXPECT_NEAR(total.rounded, std::numbers::pi, 1e-13) << gap;
      EXPECT_TRUE(overlaps(total.enclosed, Ball::pi())) << gap;
    }
  }
}

TEST(SolidConfiguration, IsTheClosedFormWhereNothingHides) {
  Numbers random(23);
  const BallPrecision scope(200);
  const Scene room = sample::cube_room();
  for (int k = 0; k < 40; ++k) {
    Viewpoint from{{random.fraction(), random.fraction(), random.fraction()},
                   {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
                   std::nullopt};
    if (k % 5 == 0) from.point = {random.on_grid(4), 0.5, 0x1p-20};
    for (std::size_t t = 0; t < room.triangle_count(); ++t) {
      const VisibleRegion region = visible_region(room, from, t);
      const Ball expected = region.sight == Sight::nothing ? Ball(0) : unoccluded(room, from, t);
      const Ball value = solid_configuration(room, from, t, region);
      EXPECT_TRUE(overlaps(value, expected)) << t << ": " << value.to_text() << ", " << expected.to_text();
      EXPECT_LT(value.radius(), 1e-50);
      EXPECT_NEAR(solid_configuration_in_double(room, from, t, region), value.to_double(), 2e-15);
    }
  }
}

TEST(SolidConfiguration, IsTheClosedFormOverTheShadowsRest) {
  const Scene scene = sample::occluded_squares();
  const BallPrecision scope(150);
  for (const auto& [x, y] : {std::pair{Rational(1, 4), Rational(1, 2)}, {Rational(5, 8), Rational(1, 8)}}) {
    const Viewpoint from{{x.to_double(), y.to_double(), 0}, {0, 0, 1}, 0};
    Ball seen = 0;
    double rounded = 0;
    for (const std::size_t t : {2U, 3U}) {
      const VisibleRegion region = visible_region(scene, from, t);
      EXPECT_EQ(region.sight, Sight::part);
      seen += solid_configuration(scene, from, t, region);
      rounded += solid_configuration_in_double(scene, from, t, region);
    }
    const Rational right = Rational(1) - x;
    const Rational upper = Rational(1) - y;
    // The square less its corner, counterclockwise as seen from below.
    const PlanePolygon rest =
        plane_polygon({{right, 0, 1}, {right, upper, 1}, {0, upper, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}})
            .value();
    const Ball expected = point_to_polygon({x, y, 0}, {0, 0, 1}, rest, one());
    EXPECT_TRUE(overlaps(seen, expected)) << seen.to_text() << ", " << expected.to_text();
    EXPECT_LT(seen.radius(), 1e-35);
    EXPECT_NEAR(rounded, expected.to_double(), 1e-15);
  }
}

TEST(SolidConfiguration, LosesNoDigitsNextToASide) {
  TriangleMesh mesh;
  mesh.vertices = {{0.1, 0.2, 0.3}, {1.1, 0.7, 0.4}, {0.3, 1.4, 0.8}};
  mesh.triangles = {{0, 1, 2}};
  const Scene scene(std::move(mesh));
  const Vector<double> front = sample::normal_of(scene, 0);
  for (const double height : {1e-3, 1e-7, 1e-11, 1e-14})
    for (const double aside : {-1.0, 0.0, 1.0}) {
      const Vector<double> middle = 0.5 * (scene.vertex(0) + scene.vertex(1));
      const Viewpoint from{middle + height * front + (aside * height) * (scene.vertex(2) - middle),
                           {0.5 - front.x, -front.y, 0.25 - front.z},
                           std::nullopt};
      const VisibleRegion region = visible_region(scene, from, 0);
      EXPECT_NE(region.sight, Sight::nothing);
      const BallPrecision scope(300);
      EXPECT_NEAR(solid_configuration_in_double(scene, from, 0, region),
                  solid_configuration(scene, from, 0, region).to_double(), 2e-15)
          << height << " " << aside;
    }
}

TEST(SolidConfiguration, LosesNoDigitsOnSlivers) {
  Numbers random(24);
  for (const double gap : {1e-6, 1e-12}) {
    const Scene scene = sample::cube_in_cube(gap);
    for (int k = 0; k < 6; ++k) {
      const std::size_t own = random.below(scene.triangle_count());
      const auto at = sample::random_parameters(random, 16);
      const Viewpoint from{sample::point_of(scene, own, at.s, at.t), sample::normal_of(scene, own), own};
      PointView view(scene, from);
      for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
        const VisibleRegion region = view.region(t);
        EXPECT_NEAR(solid_configuration_in_double(scene, from, t, region),
                    solid_configuration(scene, from, t, region).to_double(), 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace radcert
