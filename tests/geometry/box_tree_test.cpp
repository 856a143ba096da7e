// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

/// Points on a coarse grid, so that many have equal coordinates.
std::vector<Vector<double>> grid_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] { return static_cast<double>(random() % 7); };
  std::vector<Vector<double>> points;
  while (points.size() < count) points.push_back({number(), number(), number()});
  return points;
}

constexpr std::array both_partings{TreeParting::middle, TreeParting::least_surface};

BoxTree tree_of(const std::vector<Vector<double>>& points, std::size_t leaf_size, TreeParting parting) {
  std::vector<BoundingBox> boxes;
  for (const Vector<double>& p : points) boxes.push_back({p, p});
  return {std::move(boxes), points, leaf_size, parting};
}

TEST(BoxTree, HasEveryBoxInOneLeafAndItsLeavesFull) {
  for (const TreeParting parting : both_partings)
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 64U, 131U}) {
      const BoxTree tree = tree_of(grid_points(count, 1), 8, parting);
      std::size_t next = 0;
      EXPECT_TRUE(tree.visit_leaves([](const BoundingBox&) { return true; },
                                    [&](std::size_t begin, std::size_t end) {
                                      EXPECT_EQ(begin, next);
                                      EXPECT_EQ(end, std::min(begin + 8, count));
                                      next = end;
                                      return true;
                                    }));
      EXPECT_EQ(next, count);
      std::vector<std::size_t> order = tree.order();
      std::sort(order.begin(), order.end());
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(order[k], k);
    }
}

TEST(BoxTree, FindsTheGreatestValueWithoutLookingAtAll) {
  const std::vector<Vector<double>> points = grid_points(500, 2);
  for (const TreeParting parting : both_partings)
    for (const Vector<double>& direction : grid_points(50, 3)) {
      const BoxTree tree = tree_of(points, 4, parting);
      const Vector<double> along = direction - Vector<double>{3, 3, 3};
      double greatest = -100;
      for (const Vector<double>& p : points) greatest = std::max(greatest, dot(along, p));
      const auto upper = [&](const BoundingBox& box) {
        return std::max(along.x * box.low.x, along.x * box.high.x) +
               std::max(along.y * box.low.y, along.y * box.high.y) +
               std::max(along.z * box.low.z, along.z * box.high.z);
      };
      double found = -100;
      std::size_t looked = 0;
      tree.search(found, upper, [&](std::size_t k) {
        ++looked;
        return found = std::max(found, dot(along, points[k]));
      });
      EXPECT_EQ(found, greatest);
      EXPECT_LT(looked, points.size() / 4);
    }
}

TEST(BoxTree, OfLeastSurfaceIsLookedIntoByFewerLines) {
  // A fine sphere in a coarse room: many small boxes in the middle of few large ones.
  std::mt19937_64 random(4);
  const auto number = [&] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
  std::vector<BoundingBox> boxes;
  for (std::size_t k = 0; k < 2000; ++k) {
    const Vector<double> p{number(), number(), number()};
    const double size = k < 200 ? 2 : 0.01;
    const Vector<double> low = (k < 200 ? 8 : 0.5) * p;
    boxes.push_back({low, low + Vector<double>{size, size, size}});
  }
  std::array<std::size_t, 2> looked{};
  for (std::size_t which = 0; which < 2; ++which) {
    const BoxTree tree(boxes, both_partings[which]);
    for (const Vector<double>& x : grid_points(40, 5))
      static_cast<void>(tree.visit(
          [&](const BoundingBox& box) {
            ++looked[which];
            return box.low.x <= 2 * x.x - 6 && 2 * x.x - 6 <= box.high.x && box.low.y <= 2 * x.y - 6 &&
                   2 * x.y - 6 <= box.high.y;
          },
          [](std::size_t) { return true; }));
  }
  EXPECT_LT(looked[1], looked[0]);
}

TEST(BoxTree, OfLeastSurfaceEndsWhereAllBoxesAreTheSame) {
  const std::vector<BoundingBox> boxes(3000, BoundingBox{{1, 2, 3}, {1, 2, 4}});
  const BoxTree tree(boxes, TreeParting::least_surface);
  std::size_t found = 0;
  tree.search(
      -1, [](const BoundingBox&) { return 1.0; }, [&](std::size_t) { return ++found < 2000 ? 0.0 : 2.0; });
  EXPECT_EQ(found, 2000U);
}

TEST(BoxTree, OfNothingShowsNothing) {
  const BoxTree tree;
  EXPECT_TRUE(tree.visit([](const BoundingBox&) { return true; }, [](std::size_t) { return false; }));
  EXPECT_THROW((void)tree.box(), ContractViolation);
  const std::vector<Vector<double>> point{{0, 0, 0}};
  EXPECT_THROW(BoxTree({}, point), ContractViolation);
}

}  // namespace
}  // namespace radcert
