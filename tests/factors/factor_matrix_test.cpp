// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/factor_matrix.h"
#include "radcert/core/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/closed_form/polygon_to_polygon.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/factors/input/factor_scene.h"
#include "radcert/factors/ray_factors.h"
#include "radcert/surface/catalogue.h"
#include "sample_rooms.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert {
namespace {

constexpr double opposite = 0.19982489569838738304;
constexpr double adjacent = 0.20004377607540315424;

FactorMatrix matrix_of(const FacetScene& scene, const FactorUnits& units, const FactorDemand& demand) {
  return factor_matrix(scene, units, demand, {});
}

double between(const FactorMatrix& matrix, std::size_t from, std::size_t to) {
  for (const ConfigurationFactor& entry : matrix.entries)
    if (entry.from == from && entry.to == to) return entry.factor.value;
  return 0;
}

FactorMesh cube(int level) { return factor_mesh(find_surface("cube")->make({}), level); }

TEST(FactorMatrix, OfTheUnitCubeIsTheClosedForm) {
  for (const bool certified : {false, true}) {
    const FactorMesh mesh = cube(0);
    const FacetScene scene(mesh.mesh);
    const FactorMatrix matrix =
        matrix_of(scene, factor_units(mesh, FactorUnit::piece), {.certified = certified});
    EXPECT_EQ(matrix.guaranteed, certified);
    ASSERT_EQ(matrix.entries.size(), 30U);
    for (const ConfigurationFactor& entry : matrix.entries) {
      const double expected = entry.from / 2 == entry.to / 2 ? opposite : adjacent;
      EXPECT_NEAR(entry.factor.value, expected, 1e-14) << entry.from << " " << entry.to;
      EXPECT_LE(std::abs(entry.factor.value - expected), entry.factor.radius);
      EXPECT_LE(entry.factor.radius, certified ? 2e-16 : 1e-13);
    }
    EXPECT_LE(matrix.closure_defect(matrix.worst_row()), 1e-14);
  }
}

/// The corners of a box over [0, a] x [0, b] x [0, c] that those of a triangle of its scene stand for.
std::vector<Vector<Rational>> corners_of_box(const FactorScene& scene, std::size_t triangle,
                                             const std::vector<Rational>& sides) {
  const auto end = [&](double x, const Rational& side) {
    return 2 * scene.mesh.unit * Rational::exactly(x) > side ? side : Rational(0);
  };
  std::vector<Vector<Rational>> out;
  for (const Vector<double>& p : scene.scene.facet(triangle))
    out.push_back({end(p.x, sides[0]), end(p.y, sides[1]), end(p.z, sides[2])});
  return out;
}

TEST(FactorMatrix, OfABoxIsThatOfItsSidesAndNotOfRoundedOnes) {
  const auto fractions = [](std::array<const char*, 3> texts) {
    std::vector<Rational> out;
    for (const char* text : texts) out.push_back(Rational::parse(text).value());
    return out;
  };
  for (const std::vector<Rational>& sides :
       {fractions({"21/11", "51/86", "7/12"}), fractions({"13/87", "25/27", "2/7"}),
        fractions({"28/5", "1/2", "58/7"}), fractions({"0.1", "0.7", "1e-3"}),
        fractions({"3/4", "1/2", "5"})}) {
    const FactorScene scene =
        factor_scene("box", find_surface("box")->make(sides), 0, false, OptionStyle::argument);
    EXPECT_TRUE(scene.mesh.exact);
    EXPECT_TRUE(scene.remarks.empty());
    const FactorUnits units = factor_units(scene.mesh, FactorUnit::triangle);
    const FactorMatrix proved = matrix_of(scene.scene, units, {.certified = true});
    const FactorMatrix estimated = matrix_of(scene.scene, units, {});
    const FactorMatrix by_rays = ray_factors(scene.scene, units, {.accuracy = 1e-2}, {});
    const BallPrecision precision(200);
    const auto expect_holds = [&](const Approximation& found, const Ball& exact, const std::string& what) {
      EXPECT_LE(abs(exact - Ball(found.value)).upper_double(), found.radius)
          << sides[0].to_text() << " " << sides[1].to_text() << " " << sides[2].to_text() << ": " << what;
    };
    for (std::size_t i = 0; i < units.names.size(); ++i) {
      const std::vector<Vector<Rational>> corners = corners_of_box(scene, i, sides);
      const Vector<Rational> normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
      const Ball area = sqrt(Ball(dot(normal, normal) / 4));
      for (const FactorMatrix* matrix : {&proved, &estimated, &by_rays})
        expect_holds(matrix->rows[i].area, area, "area of " + units.names[i]);
      EXPECT_LE(proved.rows[i].area.radius, 0x1p-51 * proved.rows[i].area.value);
    }
    for (const ConfigurationFactor& entry : proved.entries) {
      const auto polygon = [&](std::size_t i) {
        return plane_polygon(corners_of_box(scene, i, sides)).value();
      };
      const Ball exact = polygon_to_polygon(polygon(entry.from), polygon(entry.to));
      const std::string what = units.names[entry.from] + " to " + units.names[entry.to];
      expect_holds(entry.factor, exact, what);
      EXPECT_LE(entry.factor.radius, 0x1p-51);
      const auto other = std::find_if(
          estimated.entries.begin(), estimated.entries.end(),
          [&](const ConfigurationFactor& one) { return one.from == entry.from && one.to == entry.to; });
      ASSERT_NE(other, estimated.entries.end());
      expect_holds(other->factor, exact, what + ", estimated");
      EXPECT_NEAR(between(by_rays, entry.from, entry.to), exact.to_double(), 1e-2) << what;
    }
  }
}

TEST(FactorMatrix, AsksForAnAccuracyAndAUnitForEachTriangle) {
  const FactorMesh mesh = factor_mesh(find_surface("cube")->make({}), 0);
  const FacetScene scene(mesh.mesh);
  FactorUnits units = factor_units(mesh, FactorUnit::piece);
  for (const bool certified : {false, true})
    EXPECT_THROW((void)factor_matrix(scene, units, {.certified = certified, .accuracy = 0}, {}),
                 ContractViolation);
  units.of_triangle.pop_back();
  EXPECT_THROW((void)factor_matrix(scene, units, {}, {}), ContractViolation);
}

TEST(FactorMatrix, OfACubeCutFinerIsClosed) {
  const FactorMesh mesh = cube(2);
  const FacetScene scene(mesh.mesh);
  const FactorMatrix matrix = matrix_of(scene, factor_units(mesh, FactorUnit::triangle), {});
  EXPECT_EQ(matrix.rows.size(), 192U);
  EXPECT_LE(matrix.closure_defect(matrix.worst_row()), 1e-13);
  // Each factor is a quotient E/A, rounded: two half units of E, which is no more than either area.
  EXPECT_LE(matrix.largest_reciprocity_defect, 0x1p-52);
  for (const FactorRow& row : matrix.rows) EXPECT_LE(std::abs(row.sum.value - 1), row.sum.radius);
  // Unions: the matrix by pieces of the finer cube is that of the cube.
  const FactorMatrix pieces = matrix_of(scene, factor_units(mesh, FactorUnit::piece), {});
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_NEAR(between(pieces, i, j), i == j ? 0 : i / 2 == j / 2 ? opposite : adjacent, 1e-14);
}

TEST(FactorMatrix, OfACubeInACubeHasTheRatiosOfAreas) {
  for (const double gap : {0.25, 1e-1, 1e-3, 1e-6, 1e-12}) {
    const FacetScene scene(sample::cube_in_cube(gap));
    FactorUnits bodies;
    bodies.names = {"outer", "inner"};
    for (std::size_t t = 0; t < scene.facet_count(); ++t) bodies.of_triangle.push_back(t < 12 ? 0 : 1);
    const FactorMatrix matrix = matrix_of(scene, bodies, {.accuracy = 1e-4});
    EXPECT_NEAR(between(matrix, 1, 0), 1, 1e-12) << gap;
    EXPECT_EQ(between(matrix, 1, 1), 0) << gap;
    EXPECT_NEAR(between(matrix, 0, 1), 0.25, 1e-12) << gap;
    EXPECT_NEAR(between(matrix, 0, 0), 0.75, 1e-4) << gap;
    EXPECT_LE(std::abs(between(matrix, 0, 0) - 0.75), matrix.rows[0].sum.radius) << gap;
  }
}

TEST(FactorMatrix, OfMeshesOfConcentricSpheresIsTheRoundOnes) {
  // Similar polyhedra about one centre have the ratio of areas of the spheres, and the inner one sees the
  // outer alone.
  const sample::Polyhedron inner = sample::sphere(1);
  sample::Polyhedron outer = inner;
  for (Vector<double>& v : outer.vertices) v = 2.0 * v;
  // The mesh looks into the room between.
  for (auto& face : outer.faces) std::reverse(face.begin(), face.end());
  const FacetScene scene(sample::mesh_of(sample::together(inner, outer, false)));
  FactorUnits spheres;
  spheres.names = {"inner", "outer"};
  for (std::size_t t = 0; t < scene.facet_count(); ++t)
    spheres.of_triangle.push_back(2 * t < scene.facet_count() ? 0 : 1);
  const FactorMatrix matrix = matrix_of(scene, spheres, {.accuracy = 1e-3});
  EXPECT_NEAR(between(matrix, 0, 1), 1, 1e-13);
  EXPECT_EQ(between(matrix, 0, 0), 0);
  EXPECT_NEAR(between(matrix, 1, 0), outer_sphere_to_inner(1, 2).to_double(), 1e-13);
  const double self = 1 - outer_sphere_to_inner(1, 2).to_double();
  EXPECT_NEAR(between(matrix, 1, 1), self, 1e-3);
  EXPECT_LE(std::abs(between(matrix, 1, 1) - self), matrix.rows[1].sum.radius);
}

// Each way in which shadows fall on walls: a lost one shows in the rows' sums, and no radius hides it.
TEST(FactorMatrix, OfARoomWithBoxesIsClosedWithinItsRadius) {
  const FacetScene scene(sample::room_with_two_boxes());
  FactorUnits units;
  for (std::size_t t = 0; t < scene.facet_count(); ++t) {
    units.of_triangle.push_back(t);
    units.names.push_back("triangle " + std::to_string(t));
  }
  const FactorMatrix matrix = matrix_of(scene, units, {.accuracy = 1e-5});
  EXPECT_GT(matrix.mixed_pairs, 100U);
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    EXPECT_LE(matrix.closure_defect(i), matrix.rows[i].sum.radius) << "row " << i;
    EXPECT_LE(matrix.rows[i].sum.radius, 4e-5) << "row " << i;
  }
}

TEST(FactorMatrix, GivesWhatLeavesAnOpenSceneToSpace) {
  const TriangleMesh mesh = sample::obstructed_squares();
  const FacetScene scene(mesh);
  const FactorMatrix matrix =
      matrix_of(scene, sample::by_face(mesh), {.accuracy = 1e-6, .open_to_space = true});
  EXPECT_NEAR(between(matrix, 0, 1), 0.14986867177379053728, 1e-6);
  for (const FactorRow& row : matrix.rows) {
    ASSERT_TRUE(row.to_space.has_value());
    EXPECT_NEAR(row.to_space->value, 1 - row.sum.value, 1e-15);
  }
}

TEST(FactorMatrix, HasTheSameBitsForAnyThreadsAndFromTheStore) {
  const TriangleMesh mesh = sample::cube_in_cube(0.25);
  const FacetScene scene(mesh);
  const FactorUnits units = sample::by_face(mesh);
  const FactorDemand demand{.accuracy = 1e-3};
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "radcert_factor_matrix_test";
  std::filesystem::remove_all(folder);
  ResultStore store(folder);
  const FactorMatrix first = factor_matrix(scene, units, demand, {.key = "a test", .store = &store});
  EXPECT_FALSE(std::filesystem::is_empty(folder));
  const FactorMatrix kept = factor_matrix(scene, units, demand, {.key = "a test", .store = &store});
  const ThreadLimit one(1);
  const FactorMatrix alone = factor_matrix(scene, units, demand, {});
  for (const FactorMatrix* other : {&kept, &alone}) {
    ASSERT_EQ(first.entries.size(), other->entries.size());
    EXPECT_EQ(first.mixed_pairs, other->mixed_pairs);
    for (std::size_t k = 0; k < first.entries.size(); ++k) {
      EXPECT_EQ(first.entries[k].factor.value, other->entries[k].factor.value);
      EXPECT_EQ(first.entries[k].factor.radius, other->entries[k].factor.radius);
      EXPECT_FALSE(other->entries[k].factor.guaranteed);
    }
  }
  // Another demand is another key.
  const FactorMatrix finer =
      factor_matrix(scene, units, {.accuracy = 1e-5}, {.key = "a test", .store = &store});
  EXPECT_LT(finer.largest_radius(), first.largest_radius());
  std::filesystem::remove_all(folder);
}

TEST(FactorMatrix, ProvesEachNumberWhereThatIsAsked) {
  const TriangleMesh mesh = sample::obstructed_squares();
  const FacetScene scene(mesh);
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "radcert_factor_matrix_proof_test";
  std::filesystem::remove_all(folder);
  ResultStore store(folder);
  for (const bool certified : {true, false, true}) {
    const FactorMatrix matrix = factor_matrix(
        scene, sample::by_face(mesh), {.certified = certified, .accuracy = 1e-6, .open_to_space = true},
        {.key = "a proof", .store = &store});
    EXPECT_EQ(matrix.guaranteed, certified);
    for (const ConfigurationFactor& entry : matrix.entries) EXPECT_EQ(entry.factor.guaranteed, certified);
    for (const FactorRow& row : matrix.rows) {
      EXPECT_TRUE(row.area.guaranteed);
      EXPECT_EQ(row.sum.guaranteed, certified);
      EXPECT_EQ(row.to_space->guaranteed, certified);
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(FactorMatrix, GivesRowsAwayAsItWouldKeepThem) {
  const TriangleMesh mesh = sample::cube_in_cube(0.25);
  const FacetScene scene(mesh);
  const FactorUnits units = sample::by_face(mesh);
  const FactorMatrix kept = matrix_of(scene, units, {.accuracy = 1e-3});
  std::vector<ConfigurationFactor> given;
  const FactorMatrix streamed =
      factor_matrix(scene, units, {.accuracy = 1e-3}, {.row = [&](std::span<const ConfigurationFactor> row) {
                      given.insert(given.end(), row.begin(), row.end());
                    }});
  EXPECT_TRUE(streamed.entries.empty());
  EXPECT_EQ(streamed.entry_count, kept.entries.size());
  EXPECT_EQ(streamed.largest_radius(), kept.largest_radius());
  ASSERT_EQ(given.size(), kept.entries.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    EXPECT_EQ(given[k].from, kept.entries[k].from);
    EXPECT_EQ(given[k].to, kept.entries[k].to);
    EXPECT_EQ(given[k].factor.value, kept.entries[k].factor.value);
  }
}

TEST(FactorMatrix, PlansItsMemory) {
  const FactorMesh mesh = cube(2);
  const FacetScene scene(mesh.mesh);
  const FactorUnits units = factor_units(mesh, FactorUnit::triangle);
  const FactorPlan all = factor_plan(scene, units, {}, FactorsKept::all);
  const FactorPlan rows = factor_plan(scene, units, {}, FactorsKept::none);
  EXPECT_EQ(all.pairs, 192U * 191 / 2);
  EXPECT_GT(all.seconds, 0);
  EXPECT_EQ(all.memory.total() - rows.memory.total(), 192U * 192 * sizeof(ConfigurationFactor));
}

TEST(FactorMatrix, StopsWhenAskedTo) {
  const FacetScene scene(sample::cube_in_cube(0.25));
  request_interruption();
  EXPECT_THROW(static_cast<void>(factor_matrix(scene, sample::by_face(scene.scene().mesh()), {}, {})),
               Interrupted);
  clear_interruption();
}

TEST(FactorMatrix, TellsOfItsProgressInSmallStepsThatStandForTheRest) {
  // What is done is the same share of each row, whatever it costs: of a block of rows it would not be.
  const FactorMesh mesh = factor_mesh(find_surface("cube")->make({}), 2);
  const FacetScene scene(mesh.mesh);
  std::vector<double> told{0};
  static_cast<void>(factor_matrix(scene, factor_units(mesh, FactorUnit::piece), {},
                                  {.at = [&](double fraction) { told.push_back(fraction); }}));
  ASSERT_GE(told.size(), 40U);
  EXPECT_EQ(told.back(), 1);
  for (std::size_t k = 1; k < told.size(); ++k) EXPECT_LE(told[k] - told[k - 1], 0.03);
}

TEST(FactorPlan, SaysToWhatRadiusRowsWillBeKnown) {
  const TriangleMesh mesh = sample::cube_in_cube(0.25);
  const FacetScene scene(mesh);
  const FactorUnits units = sample::by_face(mesh);
  const FactorDemand demand{.certified = true, .accuracy = 1e-4};
  const FactorPlan plan = factor_plan(scene, units, demand, FactorsKept::all);
  const FactorMatrix matrix = factor_matrix(scene, units, demand, {});
  double radius = 0;
  for (const FactorRow& row : matrix.rows) radius += row.sum.radius * row.area.value / scene.total_area();
  EXPECT_LE(radius, demand.accuracy);
  EXPECT_LE(plan.radius, 2 * radius);
  EXPECT_GE(plan.radius, radius / 2);
}

}  // namespace
}  // namespace radcert
