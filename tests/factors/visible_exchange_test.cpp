// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/visible_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/sight_events.h"
#include "radcert/geometry/orientation.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "sample_rooms.h"
#include "tests/visibility/solid_configuration.h"

namespace radcert {
namespace {

// Exactly 3/4 of the factor between opposite faces of the unit cube: by symmetry of the lines through z =
// 1/2.
constexpr double obstruction = 0.14986867177379053728;

TEST(VisibleExchangeArea, IsTheKnownValueOfTheObstructedSquares) {
  const FacetScene scene(sample::obstructed_squares());
  Approximation sum = Approximation::exact(0);
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {2U, 3U}) {
      const Approximation part = visible_exchange_area(scene, scene.pair(i, j), {.tolerance = 1e-8});
      EXPECT_LE(part.radius, 1.001e-8);
      sum += part;
    }
  EXPECT_LE(std::abs(sum.value - obstruction), sum.radius);
  EXPECT_LE(std::abs(sum.value - obstruction), 1e-8);
}

TEST(VisibleExchangeArea, IsTheExchangeAreaWhereNothingStandsBetween) {
  const FacetScene scene(sample::mesh_of(sample::box({0, 0, 0}, {1, 1, 1}, true)));
  for (const std::size_t j : {2U, 3U, 4U}) {
    const FacetPair pair = scene.pair(0, j);
    ASSERT_EQ(pair.sight, PairSight::whole);
    const Approximation adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-8});
    EXPECT_LE(std::abs(adaptive.value - exchange_area(pair.first, pair.second).value), 1e-8) << j;
  }
}

/// What a test asks of one pair of a scene: geometry, all screens, and what a point sees of the source past
/// some of them.
struct PairSights {
  PairSights(const FacetScene& scene, const FacetPair& pair)
      : geometry(exchange_geometry(scene, {pair.first, pair.first_normal}, {pair.second, pair.second_normal},
                                   pair.occluders)),
        viewer(geometry) {
    for (std::size_t k = 0; k < geometry.screens.size(); ++k) all.push_back(k);
  }
  ExchangeGeometry geometry;
  std::vector<std::size_t> all;
  SourceViewer viewer;
};

TEST(SightEvents, KnowWhatACellSees) {
  const FacetScene scene(sample::room_with_two_boxes());
  constexpr unsigned seed = 5;
  std::mt19937_64 stream(seed);
  const auto uniform = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  std::size_t hidden = 0;
  std::size_t whole = 0;
  std::size_t steady = 0;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < 12; ++j) {
      const FacetPair pair = scene.pair(i, j);
      if (pair.sight != PairSight::mixed) continue;
      PairSights sights(scene, pair);
      SightEvents events(sights.geometry);
      const FacetCorners& receiver = sights.geometry.receiver;
      const auto point = [&](const ReceiverCell& c) {
        const double s = uniform();
        const double t = (1 - s) * uniform();
        return c[0] + s * (c[1] - c[0]) + t * (c[2] - c[0]);
      };
      for (int k = 0; k < 20; ++k) {
        const ReceiverCell large{receiver[0], receiver[1], receiver[2]};
        ReceiverCell cell{point(large), point(large), point(large)};
        for (int corner : {1, 2}) cell[corner] = cell[0] + 0.2 * uniform() * (cell[corner] - cell[0]);
        const CellSight sight = events.of(cell, sights.all);
        // Whether a part is seen, all or none is the same on all of a cell without events.
        std::array<int, 3> kinds{};
        for (int n = 0; n < 30; ++n) {
          const Vector<double> at = point(cell);
          const double unoccluded = sights.viewer.flux(at, {});
          const double seen = sights.viewer.flux(at, sights.all);
          constexpr double rounding = 1e-13;
          EXPECT_NEAR(sights.viewer.flux(at, sight.hidden ? sights.all : sight.screens), seen, rounding);
          if (sight.hidden) {
            EXPECT_LE(seen, rounding) << i << " " << j;
          } else if (sight.screens.empty()) {
            EXPECT_NEAR(seen, unoccluded, rounding) << i << " " << j;
          }
          ++kinds[seen >= unoccluded - rounding ? 2U : seen <= rounding ? 0U : 1U];
        }
        hidden += sight.hidden ? 1 : 0;
        whole += !sight.hidden && sight.screens.empty() ? 1 : 0;
        if (sight.change > 0) continue;
        ++steady;
        EXPECT_EQ(*std::max_element(kinds.begin(), kinds.end()), 30) << i << " " << j;
      }
    }
  EXPECT_GT(hidden, 0U);
  EXPECT_GT(whole, 200U);
  EXPECT_GT(steady, 500U);
}

// Of max(D, 0) the exact mean is a divided difference of the cubes at the corners.
TEST(VisibleExchangeArea, BoundsTheErrorOfRulesWhereAFunctionBegins) {
  constexpr unsigned seed = 3;
  std::mt19937_64 stream(seed);
  const auto uniform = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  for (const int order : {3, 5}) {
    const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
    double largest = 0;
    for (int k = 0; k < 20'000; ++k) {
      std::array<double, 3> d{1, 1 + (k % 2 == 0 ? 0.01 : 0.3) * std::log(uniform()), 1 - 9 * uniform()};
      std::shuffle(d.begin(), d.end(), stream);
      const auto cube = [](double x) { return x > 0 ? x * x * x : 0; };
      const double low = (cube(d[1]) - cube(d[0])) / (d[1] - d[0]);
      const double high = (cube(d[2]) - cube(d[1])) / (d[2] - d[1]);
      const double mean = (high - low) / (d[2] - d[0]) / 3;
      double found = 0;
      for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const auto& x = rule.points[i].x;
        found += 2 * rule.weights[i] * std::max(x[0] * d[0] + x[1] * d[1] + x[2] * d[2], 0.0);
      }
      largest = std::max(largest, std::abs(found - mean));
    }
    EXPECT_LE(largest, rule_error_on_kinks(order)) << order;
    EXPECT_GE(largest, rule_error_on_kinks(order) / 2) << order;
  }
}

TEST(VisibleExchangeArea, HoldsWhereRulesAgreeOverAKink) {
  // The triangle's shadow begins within the only cell. At this place of it rules of orders 2 and 3 differ by
  // 4e-9, and are off by 7e-8.
  constexpr double x = 0.0014956957667521845;
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.125, 0, 0},   {0, 0.125, 0},          {0, 0, 1},      {0, 1, 1},
                   {1, 0, 1}, {x, 0.125, 0.5}, {x + 0.25, 0.125, 0.5}, {x, 0.375, 0.5}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  mesh.group = {0, 0, 0};
  mesh.face = {0, 1, 2};
  mesh.group_names = {""};
  const FacetScene scene(mesh);
  const FacetPair pair = scene.pair(0, 1);
  const Approximation coarse = visible_exchange_area(scene, pair, {.tolerance = 1e-12, .most_cells = 1});
  const Ball exact = certified_exchange_area(scene, 0, 1, pair, {.radius = 1e-7});
  const double error = abs(Ball(coarse.value) - exact).upper_double();
  EXPECT_LE(error, coarse.radius);
  EXPECT_GE(error, 6e-8);
}

// At each limit of work the radius covers what was not looked at.
TEST(VisibleExchangeArea, HoldsWhereCellsAreUsedUp) {
  const FacetScene scene(sample::room_with_two_boxes());
  for (std::size_t i = 0; i < 12; i += 3)
    for (std::size_t j = 1; j < 12; j += 2) {
      const FacetPair pair = scene.pair(i, j);
      if (pair.sight != PairSight::mixed) continue;
      const Approximation fine = visible_exchange_area(scene, pair, {.tolerance = 1e-5});
      double last = 1;
      for (const std::size_t most : {1U, 4U, 16U, 64U, 256U}) {
        const Approximation coarse =
            visible_exchange_area(scene, pair, {.tolerance = 1e-5, .most_cells = most});
        EXPECT_LE(std::abs(coarse.value - fine.value), coarse.radius + fine.radius)
            << i << " " << j << " " << most;
        EXPECT_LE(coarse.radius, 2 * last);
        last = coarse.radius;
      }
    }
}

// The layer visibility finds the parts exactly, triangle by triangle, and knows nothing of joined occluders.
TEST(VisibleFlux, IsThatOfTheExactVisibleParts) {
  const FacetScene scene(sample::cube_in_cube(0.125));
  constexpr unsigned seed = 11;
  std::mt19937_64 stream(seed);
  const auto uniform = [&stream] { return static_cast<double>(stream() >> 11U) * 0x1p-53; };
  int partly = 0;
  for (int k = 0; k < 60; ++k) {
    const std::size_t from = stream() % scene.facet_count();
    const FacetCorners corners = scene.facet(from);
    const double s = uniform();
    const double t = (1 - s) * uniform();
    const Vector<double> at = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
    const Vector<double> area = vector_area(corners);
    const Vector<double> normal = (1 / norm(area)) * area;
    PointView view(scene.scene(), {at, normal, from});
    double sum = 0;
    for (std::size_t to = 0; to < scene.facet_count(); ++to) {
      const FacetPair pair = scene.pair(from, to);
      if (pair.sight == PairSight::nothing) continue;
      const FacetCorners source = scene.facet(to);
      if (orientation(source[0], source[1], source[2], at) <= 0) continue;
      const double found = visible_flux(scene, at, normal, pair.second, pair.occluders);
      const VisibleRegion region = view.region(to);
      const double expected = solid_configuration(scene.scene(), view.viewpoint(), to, region).to_double();
      EXPECT_NEAR(found, expected, 1e-12) << "seed 11, point " << k << " of " << from << " to " << to;
      partly += region.sight == Sight::part ? 1 : 0;
      sum += found;
    }
    EXPECT_NEAR(sum, std::numbers::pi, 1e-12) << "seed 11, point " << k;
  }
  EXPECT_GT(partly, 20);
}

}  // namespace
}  // namespace radcert
