// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/visible_exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "radcert/factors/receiver_cells.h"
#include "radcert/geometry/orientation.h"
#include "radcert/visibility/solid_configuration.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

// Exactly 3/4 of the factor between opposite faces of the unit cube: by symmetry of the lines through z =
// 1/2.
constexpr double obstruction = 0.14986867177379053728;

TEST(VisibleExchangeArea, IsTheKnownValueOfTheObstructedSquares) {
  const FacetScene scene(sample::obstructed_squares());
  Estimate sum;
  for (const std::size_t i : {0U, 1U})
    for (const std::size_t j : {2U, 3U}) {
      const Estimate part = visible_exchange_area(scene, scene.pair(i, j), {.tolerance = 1e-8});
      EXPECT_LE(part.radius, 4.001e-8);
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
    const Estimate adaptive = visible_exchange_area(scene, pair, {.tolerance = 1e-8});
    EXPECT_LE(std::abs(adaptive.value - exchange_area(pair.first, pair.second).value), 1e-8) << j;
  }
}

TEST(ReceiverCells, CoverTheReceiverAndPartItWhereWhatIsSeenHasKinks) {
  const FacetScene scene(sample::room_with_two_boxes());
  std::size_t parted = 0;
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < 12; ++j) {
      const FacetPair pair = scene.pair(i, j);
      if (pair.sight != PairSight::mixed) continue;
      const auto area = vector_area(pair.first);
      const Vector<double> normal = (1 / norm(area)) * area;
      const std::size_t solid = scene.occluders()[pair.occluders.front()].solid;
      std::vector<std::size_t> body;
      for (const std::size_t k : pair.occluders)
        if (scene.occluders()[k].solid == solid) body.push_back(k);
      double sum = 0;
      const std::vector<FacetCorners> cells = receiver_cells(scene, pair.first, pair.second, body);
      parted += cells.size() > 1 ? 1 : 0;
      for (const FacetCorners& cell : cells) {
        ASSERT_GE(cell.size(), 3U);
        EXPECT_GT(dot(vector_area(cell), normal), 0);
        sum += norm(vector_area(cell));
        // All points see the same: everything, nothing, or a part.
        const auto kind = [&](const Vector<double>& at) {
          const double whole = visible_flux(scene, at, normal, pair.second, {});
          const double seen = visible_flux(scene, at, normal, pair.second, body);
          constexpr double rounding = 1e-14;
          return seen >= whole - rounding ? 2 : seen <= rounding ? 0 : 1;
        };
        const Vector<double> centre = roundness(cell).centre;
        const int expected = kind(centre);
        for (const Vector<double>& corner : cell) {
          EXPECT_EQ(kind(centre + 0.9 * (corner - centre)), expected) << i << " " << j;
          ++looked_at;
        }
      }
      EXPECT_NEAR(sum, norm(area), 1e-14);
    }
  EXPECT_GT(parted, 20U);
  EXPECT_GT(looked_at, 1000U);
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
