// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/neighbour_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

// On a coarse lattice, so that equal points and equal distances occur.
std::vector<Vector<double>> lattice_points(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  const auto coordinate = [&random] { return static_cast<double>(random() % 9) / 8; };
  std::vector<Vector<double>> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
  return points;
}

double squared_distance(const Vector<double>& a, const Vector<double>& b) { return dot(a - b, a - b); }

TEST(NeighbourTree, VisitsAllPointsInTheOrderOfTheirDistance) {
  const std::vector<Vector<double>> points = lattice_points(1, 500);
  const NeighbourTree tree(points);
  EXPECT_EQ(tree.size(), points.size());
  for (const Vector<double>& from : lattice_points(2, 20)) {
    std::vector<int> visits(points.size(), 0);
    double last = 0;
    tree.visit_by_distance(from, [&](std::size_t place, double squared) {
      ++visits[place];
      EXPECT_EQ(squared, squared_distance(points[place], from));  // exact on the lattice
      EXPECT_GE(squared, last);
      last = squared;
      return true;
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 500);
  }
}

TEST(NeighbourTree, StopsWhenItIsTold) {
  const std::vector<Vector<double>> points = lattice_points(3, 100);
  const NeighbourTree tree(points);
  int visits = 0;
  tree.visit_by_distance({0.5, 0.5, 0.5}, [&](std::size_t, double) { return ++visits < 7; });
  EXPECT_EQ(visits, 7);
}

TEST(NeighbourTree, OfNoPointsVisitsNone) {
  const NeighbourTree tree({});
  tree.visit_by_distance({0, 0, 0}, [](std::size_t, double) {
    ADD_FAILURE() << "there is no point";
    return true;
  });
  EXPECT_EQ(tree.size(), 0U);
}

TEST(NeighbourTree, RefusesCoordinatesThatAreNotFinite) {
  const std::vector<Vector<double>> points{{0, 0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THROW(NeighbourTree{points}, ContractViolation);
}

}  // namespace
}  // namespace radcert
