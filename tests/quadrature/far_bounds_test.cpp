// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radcert/quadrature/far_field.h"
#include "radcert/quadrature/kernel_sums.h"

namespace radcert {
namespace {

/// A far element about the origin, of which the bounds of its points are known, and one observer.
struct Far {
  Vector<double> point;
  Vector<double> normal;
  double radius = 0;
  double height = 0;
  double rise = 0;

  [[nodiscard]] FarBounds<double> bounds() const {
    FarView<double> view;
    view.area = 1;
    view.normal = {0, 0, 1};
    view.height = height;
    view.rise = rise;
    CollocationPointBlock<double> block;
    block.point = {Pack(point.x), Pack(point.y), Pack(point.z)};
    block.normal = {Pack(normal.x), Pack(normal.y), Pack(normal.z)};
    return {block, view, {0, 0, 0}, radius, 2};
  }
  /// |G| at a point with the normal of the element, and what a change of coordinates by X does to it.
  void expect_bounded_at(const Vector<double>& q) const {
    const Vector<double> d = q - point;
    const double square = dot(d, d) * dot(d, d);
    const double of_p = std::abs(dot(d, normal));
    const double of_q = std::abs(d.z);
    const FarBounds<double> found = bounds();
    EXPECT_GE(found.largest.lane(0) * (1 + 1e-14), of_p * of_q / square);
    EXPECT_GE(found.lean.lane(0) * (1 + 1e-14), 2 * (of_p + of_q) / square);
  }
};

TEST(FarBounds, HoldAtTheNearestPoint) {
  for (const double radius : {0.1, 0.4, 0.8}) {
    // In its plane, nearly, and looking at it.
    const Far along{.point = {1, 0, 0.01}, .normal = {-1, 0, 0}, .radius = radius};
    along.expect_bounded_at({radius, 0, 0});
    along.expect_bounded_at({-radius, 0, 0});
    // Straight above points that rise towards P.
    const Far above{
        .point = {0, 0, 1}, .normal = {0, 0, -1}, .radius = radius, .height = radius, .rise = radius};
    above.expect_bounded_at({0, 0, radius});
    above.expect_bounded_at({0, 0, -radius});
  }
}

TEST(FarBounds, HoldWhereTheObserverLooksPastTheMiddle) {
  for (const double radius : {0.1, 0.4}) {
    const Far across{.point = {1, 0, 0.3}, .normal = {0, 1, 0}, .radius = radius};
    across.expect_bounded_at({0, radius, 0});
    const Far level{
        .point = {1, 0, 0}, .normal = {0, 0, 1}, .radius = radius, .height = radius, .rise = radius};
    level.expect_bounded_at({0, 0, radius});
    const Far above{.point = {0, 0, 1}, .normal = {1, 0, 0}, .radius = radius};
    above.expect_bounded_at({radius, 0, 0});
    above.expect_bounded_at({0, 0, 0});
  }
}

TEST(RoundingBound, CountsEveryPointAndTheCoordinates) {
  constexpr double u = unit_roundoff<double>();
  EXPECT_GE(rounding_bound<double>(100, 45, 1, 0, u), 160 * u);
  EXPECT_GE(rounding_bound<double>(100, 55, 1, 0, u), 300 * u);
  EXPECT_GE(rounding_bound<double>(0, 1, 0, 3, u), 24 * u);
  EXPECT_GE(least_distance(2.0), 1024 * u);
}

}  // namespace
}  // namespace radcert
