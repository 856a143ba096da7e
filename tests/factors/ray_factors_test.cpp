// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/ray_factors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/surface/catalogue.h"
#include "sample_rooms.h"

namespace radcert {
namespace {

Approximation between(const FactorMatrix& matrix, std::size_t from, std::size_t to) {
  for (const ConfigurationFactor& entry : matrix.entries)
    if (entry.from == from && entry.to == to) return entry.factor;
  return Approximation::exact(0);
}

TEST(RayFactors, OfTheUnitCubeAreTheClosedFormWithinTheirRadius) {
  constexpr double opposite = 0.19982489569838738304;
  constexpr double adjacent = 0.20004377607540315424;
  const FactorMesh mesh = factor_mesh(find_surface("cube")->make({}), 1);
  const FacetScene scene(mesh.mesh);
  const RayDemand demand{.accuracy = 5e-4};
  const FactorMatrix matrix = ray_factors(scene, factor_units(mesh, FactorUnit::piece), demand, {});
  ASSERT_EQ(matrix.entries.size(), 30U);
  EXPECT_FALSE(matrix.guaranteed);
  EXPECT_GT(matrix.rays, 0U);
  for (const ConfigurationFactor& entry : matrix.entries) {
    EXPECT_NEAR(entry.factor.value, entry.from / 2 == entry.to / 2 ? opposite : adjacent,
                entry.factor.radius);
    EXPECT_LE(entry.factor.radius, 1.01 * demand.accuracy);
    EXPECT_FALSE(entry.factor.guaranteed);
  }
  for (const FactorRow& row : matrix.rows) {
    EXPECT_NEAR(row.sum.value, 1, row.sum.radius);
    EXPECT_LE(row.sum.radius, demand.accuracy);
    EXPECT_NEAR(row.area.value, 1, row.area.radius);
  }
  EXPECT_LE(matrix.largest_reciprocity_defect, 0x1p-52);
}

TEST(RayFactors, AgreeWithThoseByPairsWhereBodiesHideEachOther) {
  const FacetScene scene(sample::room_with_two_boxes());
  FactorUnits units;
  units.names = {"room", "box", "other box"};
  for (std::size_t t = 0; t < scene.facet_count(); ++t) units.of_triangle.push_back(t / 12);
  const FactorMatrix rays = ray_factors(scene, units, {.accuracy = 1e-3}, {});
  const FactorMatrix pairs = factor_matrix(scene, units, {.accuracy = 1e-5}, {});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Approximation ours = between(rays, i, j);
      const Approximation theirs = between(pairs, i, j);
      EXPECT_NEAR(ours.value, theirs.value, ours.radius + theirs.radius) << i << " " << j;
      EXPECT_LE(ours.radius, 1.01e-3);
    }
  // A convex body does not see itself, which is decided exactly.
  EXPECT_EQ(between(rays, 1, 1).radius, 0);
}

/// Of boxes, whose pairs are wholly seen: the errors of many factors, in parts of their radii, are spread as
/// Student's distribution has it, so that a radius is 4.49 standard errors and not less.
TEST(RayFactors, HaveRadiiAsTheirErrorsAreSpread) {
  double squares = 0;
  double count = 0;
  for (const long length : {1, 2, 3, 4, 5, 6}) {
    const std::array<Rational, 3> edges{1, 2, Rational(length) / 2};
    const FactorMesh mesh = factor_mesh(find_surface("box")->make(edges), 0);
    const FacetScene scene(mesh.mesh);
    const FactorUnits units = factor_units(mesh, FactorUnit::piece);
    const FactorMatrix rays = ray_factors(scene, units, {.accuracy = 2e-3}, {});
    const FactorMatrix pairs = factor_matrix(scene, units, {}, {});
    for (std::size_t i = 0; i < units.names.size(); ++i)
      for (std::size_t j = i + 1; j < units.names.size(); ++j) {
        const Approximation ours = between(rays, i, j);
        const double error = (ours.value - between(pairs, i, j).value) / ours.radius;
        EXPECT_LE(std::abs(error), 1) << length << ": " << i << ", " << j;
        squares += error * error;
        count += 1;
      }
  }
  const double spread = 4.49 * std::sqrt(squares / count);
  EXPECT_GT(spread, 0.8);
  EXPECT_LT(spread, 1.2);
}

TEST(RayFactors, EndAtBacksWithoutAnyExchange) {
  // Two sheets one above the other that both look upwards: the lower one sees the back of the upper.
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    const std::size_t first = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  mesh.group.assign(4, 0);
  mesh.face.assign(4, 0);
  mesh.group_names = {""};
  const FacetScene scene(std::move(mesh));
  const FactorUnits units{.of_triangle = {0, 0, 1, 1}, .names = {"lower", "upper"}};
  const FactorMatrix matrix = ray_factors(scene, units, {.accuracy = 1e-2, .open_to_space = true}, {});
  EXPECT_EQ(between(matrix, 0, 1).value, 0);
  EXPECT_EQ(matrix.rows[0].sum.value, 0);
  EXPECT_EQ(matrix.rows[1].sum.value, 0);
}

TEST(RayFactors, OfAnOpenSceneLeaveTheRestToSpace) {
  const TriangleMesh mesh = sample::obstructed_squares();
  const FacetScene scene(mesh);
  const FactorMatrix matrix =
      ray_factors(scene, sample::by_face(mesh), {.accuracy = 1e-3, .open_to_space = true}, {});
  EXPECT_NEAR(between(matrix, 0, 1).value, 0.14986867177379053728, between(matrix, 0, 1).radius);
  for (const FactorRow& row : matrix.rows) {
    ASSERT_TRUE(row.to_space.has_value());
    EXPECT_NEAR(row.to_space->value, 1 - row.sum.value, 1e-15);
    EXPECT_GT(row.to_space->value, 0.5);
  }
}

TEST(RayFactors, HaveTheSameBitsForAnyThreadsAndFromTheStore) {
  const TriangleMesh mesh = sample::cube_in_cube(0.25);
  const FacetScene scene(mesh);
  const FactorUnits units = sample::by_face(mesh);
  const RayDemand demand{.accuracy = 5e-3};
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "radcert_ray_factors_test";
  std::filesystem::remove_all(folder);
  ResultStore store(folder);
  const FactorMatrix first = ray_factors(scene, units, demand, {.key = "a test", .store = &store});
  const FactorMatrix kept = ray_factors(scene, units, demand, {.key = "a test", .store = &store});
  const ThreadLimit one(1);
  FactorMatrix alone = ray_factors(scene, units, demand, {.row = [](auto) {}});
  EXPECT_TRUE(alone.entries.empty());
  EXPECT_EQ(alone.entry_count, first.entries.size());
  alone = ray_factors(scene, units, demand, {});
  for (const FactorMatrix* other : std::array<const FactorMatrix*, 2>{&kept, &alone}) {
    ASSERT_EQ(first.entries.size(), other->entries.size());
    for (std::size_t k = 0; k < first.entries.size(); ++k) {
      EXPECT_EQ(first.entries[k].factor.value, other->entries[k].factor.value);
      EXPECT_EQ(first.entries[k].factor.radius, other->entries[k].factor.radius);
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(RayFactors, OfOtherUnitsAreNotTakenFromTheStore) {
  const FacetScene scene(sample::room_with_two_boxes());
  FactorUnits units;
  units.names = {"room", "box", "other box"};
  for (std::size_t t = 0; t < scene.facet_count(); ++t) units.of_triangle.push_back(t / 12);
  FactorUnits others = units;  // as many rows
  for (std::size_t t = 0; t < scene.facet_count(); ++t) others.of_triangle[t] = t % 3;
  const RayDemand demand{.accuracy = 2e-2};
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "radcert_ray_units_test";
  std::filesystem::remove_all(folder);
  ResultStore store(folder);
  static_cast<void>(ray_factors(scene, units, demand, {.key = "a test", .store = &store}));
  const FactorMatrix kept = ray_factors(scene, others, demand, {.key = "a test", .store = &store});
  const FactorMatrix fresh = ray_factors(scene, others, demand, {});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(between(kept, i, j).value, between(fresh, i, j).value) << i << " " << j;
  std::filesystem::remove_all(folder);
}

TEST(RayFactors, StopAtTheMostPointsWithTheRadiusReached) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  const FactorUnits units = sample::by_face(scene.scene().mesh());
  const FactorMatrix matrix = ray_factors(scene, units, {.accuracy = 1e-6, .most_points = 64}, {});
  EXPECT_GT(matrix.largest_radius(), 1e-3);
  for (std::size_t i = 0; i < matrix.rows.size(); ++i)
    EXPECT_LE(matrix.closure_defect(i), matrix.rows[i].sum.radius);
  request_interruption();
  EXPECT_THROW(static_cast<void>(ray_factors(scene, units, {}, {})), Interrupted);
  clear_interruption();
}

}  // namespace
}  // namespace radcert
