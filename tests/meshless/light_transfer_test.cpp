// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/light_solution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/expression/parse.h"
#include "radcert/meshless/sampling.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/torus.h"
#include "tests/core/refusal.h"
#include "tests/meshless/lit_scenes.h"

namespace radcert {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

std::vector<double> ones(std::size_t n) { return std::vector<double>(n, 1.0); }

TEST(PointLightTransfer, TakesAnAlbedoForEachSite) {
  const LightScene scene = LightScene::make(test::room_with_block(), {0.25}).value();
  const SiteSet sites = uniform_sites(scene.surface(), {.count = 70, .seed = 2}).value();
  const Matrix<double> same = point_light_transfer(scene, sites, ones(70));
  std::vector<double> albedos(70);
  for (std::size_t i = 0; i < albedos.size(); ++i) albedos[i] = static_cast<double>(i) / 70;
  const Matrix<double> each = point_light_transfer(scene, sites, albedos, ones(70));
  for (std::size_t i = 0; i < 70; ++i)
    for (std::size_t j = 0; j < 70; ++j) EXPECT_NEAR(each(i, j), same(i, j) * albedos[i] / 0.25, 1e-15);
  EXPECT_THROW((void)point_light_transfer(scene, sites, ones(69), ones(70)), ContractViolation);
}

TEST(SiteKernel, IsTheProductOfTheCosinesOverTheSquaredDistance) {
  const Site<double> floor{{0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(site_kernel(floor, {{0, 0, 2}, {0, 0, -1}}), 0.25);
  EXPECT_EQ(site_kernel(floor, {{1, 0, 1}, {0, 0, -1}}), 0.25);        // 1/2 over 2
  EXPECT_EQ(site_kernel(floor, {{3, 0, 4}, {-1, 0, 0}}), 12.0 / 625);  // 4/5 times 3/5 over 25
  EXPECT_EQ(site_kernel(floor, {{3, 0, 4}, {1, 0, 0}}), 0);
  EXPECT_EQ(site_kernel(floor, {{1, 0, 0}, {0, 0, 1}}), 0);
  EXPECT_EQ(site_kernel(floor, floor), 0);
}

// Inside a unit sphere cos cos' / d^2 is 1/4 between any two points.
TEST(TransferMatrix, HasOneValueInAUnitSphere) {
  const SiteSet sites = uniform_sites(sphere(), {70, 3}).value();  // more than one tile
  std::vector<double> weights(sites.size());
  for (std::size_t j = 0; j < weights.size(); ++j) weights[j] = 1 + static_cast<double>(j);
  const LightScene scene = LightScene::make(sphere(), {0.75}).value();
  const Matrix<double> matrix = point_light_transfer(scene, sites, weights);
  for (std::size_t j = 0; j < sites.size(); ++j)
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const double expected = i == j ? 0 : 0.75 / (4 * pi) * weights[j];
      ASSERT_NEAR(matrix(i, j), expected, 1e-11 * weights[j]) << i << " " << j;
    }
}

TEST(TransferMatrix, TakesTheAlbedoOfTheReceiver) {
  const Surface unit_sphere = sphere();
  std::vector<double> albedo(unit_sphere.chart_count());
  for (std::size_t k = 0; k < albedo.size(); ++k) albedo[k] = 0.1 * static_cast<double>(k);
  const SiteSet sites = uniform_sites(unit_sphere, {20, 5}).value();
  const LightScene scene = LightScene::make(unit_sphere, albedo).value();
  const Matrix<double> matrix = point_light_transfer(scene, sites, ones(20));
  for (std::size_t i = 0; i < 20; ++i)
    ASSERT_NEAR(matrix(i, (i + 1) % 20), albedo[sites.at[i].chart] / (4 * pi), 1e-12);
}

/// Whether the open segment runs through the inside of the block: an interval of the segment for each
/// coordinate.
bool runs_through_block(const Vector<double>& p, const Vector<double>& q) {
  double first = 0;
  double last = 1;
  const auto cut = [&](double from, double to, double low, double high) {
    const double a = (low - from) / (to - from);
    const double b = (high - from) / (to - from);
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  cut(p.x, q.x, test::block_low.x, test::block_high.x);
  cut(p.y, q.y, test::block_low.y, test::block_high.y);
  cut(p.z, q.z, test::block_low.z, test::block_high.z);
  return first < last - 1e-9;
}

TEST(TransferMatrix, HidesWhatTheBlockHides) {
  const Surface room = test::room_with_block();
  const LightScene scene = LightScene::make(room, {0.5}).value();
  const SiteSet sites = uniform_sites(room, {150, 2}).value();
  const Matrix<double> matrix = point_light_transfer(scene, sites, ones(sites.size()));
  int hidden = 0;
  for (std::size_t j = 0; j < sites.size(); ++j)
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (i == j) continue;
      const bool blocked = sites.at[i].chart < 12 && sites.at[j].chart < 12 &&
                           runs_through_block(sites.points[i], sites.points[j]);
      const double expected = blocked ? 0 : 0.5 / pi * site_kernel(sites[i], sites[j]);
      ASSERT_NEAR(matrix(i, j), expected, 1e-14 * (1 + expected)) << i << " " << j;
      if (blocked && site_kernel(sites[i], sites[j]) > 0) ++hidden;
    }
  EXPECT_GT(hidden, 500);
}

TEST(TransferMatrix, HasTheSameBitsForEveryNumberOfThreads) {
  const Surface room = test::room_with_block();
  const LightScene scene = LightScene::make(room, {0.5}).value();
  const SiteSet sites = uniform_sites(room, {200, 2}).value();
  const Matrix<double> on_all = point_light_transfer(scene, sites, ones(200));
  const ThreadLimit one(1);
  const Matrix<double> on_one = point_light_transfer(scene, sites, ones(200));
  for (std::size_t j = 0; j < 200; ++j) EXPECT_TRUE(std::ranges::equal(on_all.column(j), on_one.column(j)));
}

TEST(TransferMatrix, StopsWhenAskedTo) {
  const SiteSet sites = uniform_sites(sphere(), {10, 1}).value();
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  request_interruption();
  EXPECT_THROW(static_cast<void>(point_light_transfer(scene, sites, ones(10))), Interrupted);
  clear_interruption();
}

TEST(TransferMatrix, SaysWhatMemoryItTakes) {
  EXPECT_EQ(transfer_memory(4000, 1).total(), 128'000'000U);
  EXPECT_THAT(test::refusal_of([] { transfer_memory(4000, 2).require(200'000'000); }),
              HasSubstr("4000 sites"));
}

TEST(TransferMatrix, WantsAWeightForEachSite) {
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  const SiteSet sites = uniform_sites(sphere(), {10, 1}).value();
  EXPECT_THROW(static_cast<void>(point_light_transfer(scene, sites, ones(9))), ContractViolation);
}

Matrix<double> matrix_of(std::size_t n, const std::vector<double>& by_rows) {
  Matrix<double> matrix(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) matrix(i, j) = by_rows[i * n + j];
  return matrix;
}

TEST(TransferSums, KnowRowsAndSpectralRadius) {
  const TransferSums swap = transfer_sums(matrix_of(2, {0, 0.5, 0.125, 0}));
  EXPECT_EQ(swap.largest_row_sum, 0.5);
  EXPECT_EQ(swap.row, 0U);
  EXPECT_EQ(swap.largest_entry, 0.5);
  EXPECT_NEAR(swap.spectral_radius, 0.25, 1e-14);
  EXPECT_NEAR(transfer_sums(matrix_of(2, {0.5, -3, 0, 0.25})).spectral_radius, 0.5, 1e-7);
  EXPECT_EQ(transfer_sums(matrix_of(2, {0, 7, 0, 0})).spectral_radius, 0);
}

TEST(NeumannSeries, SolvesWhereOnlyAPowerContracts) {
  // A rotation by 45 degrees, times 0.6 sqrt 2 < 1; its sizes have the spectral radius 1.2.
  const auto series = NeumannSeries::make(matrix_of(2, {0.6, -0.6, 0.6, 0.6}));
  ASSERT_TRUE(series);
  EXPECT_EQ(series->power(), 2U);
  EXPECT_GE(series->spectral_radius_bound(), 0.6 * std::sqrt(2.0));
  EXPECT_LT(series->spectral_radius_bound(), 0.86);
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(1e-6)}) {
    const auto solution = series->solve(std::array{1.0, 2.0}, tolerance);
    ASSERT_TRUE(solution);
    // (0.4, 0.6; -0.6, 0.4)^-1 = (0.4, -0.6; 0.6, 0.4) / 0.52
    const double error =
        std::max(std::abs(solution->values[0] + 0.8 / 0.52), std::abs(solution->values[1] - 1.4 / 0.52));
    EXPECT_LE(error, solution->error_bound);
    EXPECT_LE(solution->error_bound, tolerance ? 1.1e-6 * 1.4 / 0.52 : 1e-13);
  }
}

TEST(NeumannSeries, BoundsItsErrorAgainstRandomSolutions) {
  std::mt19937_64 bits(7);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };
  for (const double least : {0.0, -1.0})
    for (int k = 0; k < 20; ++k) {
      constexpr std::size_t n = 40;
      Matrix<double> r(n, n);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          r(i, j) = (least + (1 - least) * uniform()) / (least < 0 ? 10 : 30);
      std::vector<double> e(n);
      for (double& value : e) value = uniform() - 0.5;
      const auto series = NeumannSeries::make(r);
      ASSERT_TRUE(series) << k << ": " << series.reason().theta;
      const auto accurate = series->solve(e, std::nullopt);
      ASSERT_TRUE(accurate);
      double residual = 0;
      for (std::size_t i = 0; i < n; ++i) {
        double sum = e[i] - accurate->values[i];
        for (std::size_t j = 0; j < n; ++j) sum += r(i, j) * accurate->values[j];
        residual = std::max(residual, std::abs(sum));
      }
      EXPECT_LT(residual, 1e-13);
      for (const double tolerance : {1e-1, 1e-4, 1e-9}) {
        const auto rough = series->solve(e, tolerance);
        ASSERT_TRUE(rough);
        double error = 0;
        for (std::size_t i = 0; i < n; ++i)
          error = std::max(error, std::abs(rough->values[i] - accurate->values[i]));
        EXPECT_LE(error, rough->error_bound + accurate->error_bound);
        EXPECT_LT(rough->iterations, accurate->iterations);
      }
    }
}

TEST(NeumannSeries, CountsTheRoundingsOfThePowerThatContracts) {
  // A rotation, for which R R is taken, and beside it x = 1 + sum b_j y_j, y_j = c_j x. What R R makes of the
  // latter, sum b_j c_j, loses all products but the first.
  constexpr std::size_t others = 200;
  constexpr std::size_t n = 3 + others;
  constexpr double b = 0x1p-28;
  constexpr double c = 0x1.fffp-28;
  Matrix<double> r(n, n);
  r(0, 0) = r(1, 0) = r(1, 1) = 0.6;
  r(0, 1) = -0.6;
  r(2, 3) = r(3, 2) = 0.6875;
  for (std::size_t j = 4; j < n; ++j) {
    r(2, j) = b;
    r(j, 2) = c;
  }
  const auto series = NeumannSeries::make(r);
  ASSERT_TRUE(series);
  EXPECT_EQ(series->power(), 2U);
  std::vector<double> e(n);
  e[2] = 1;
  const auto solution = series->solve(e, std::nullopt);
  ASSERT_TRUE(solution);
  const Rational first(11, 16);
  const Rational product =
      first * first + Rational(static_cast<long>(others - 1)) * Rational::exactly(b) * Rational::exactly(c);
  const Rational off = abs(1 / (1 - product) - Rational::exactly(solution->values[2]));
  EXPECT_LE(off, Rational::exactly(solution->error_bound));
  EXPECT_GE(Rational(100) * off, Rational::exactly(solution->error_bound));
}

TEST(NeumannSeries, CountsTheRoundingsOfItsSteps) {
  // x = e + k x: the steps end where a rounding takes back what they add, some units from e / (1 - k), and
  // the last of them changes nothing.
  for (const double k : {0.99, 0.9, 0.75})
    for (const double e : {0.1, 0.3, 0.7}) {
      const auto series = NeumannSeries::make(matrix_of(1, {k}));
      ASSERT_TRUE(series);
      const Rational exact = Rational::exactly(e) / (1 - Rational::exactly(k));
      for (const double tolerance : {0x1p-51, 0x1p-45, 0x1p-42}) {
        const auto solution = series->solve(std::array{e}, tolerance);
        if (!solution) continue;
        EXPECT_LE(abs(exact - Rational::exactly(solution->values[0])),
                  Rational::exactly(solution->error_bound))
            << k << " " << e << " " << tolerance;
      }
    }
}

TEST(NeumannSeries, CountsWhatUnderflows) {
  // x = k x + e, and a turn of which the square contracts, for e of a few of the least numbers.
  constexpr double least = std::numeric_limits<double>::denorm_min();
  int solved = 0;
  for (const double k : {0.4, 0.6, 0.9})
    for (int units = 1; units < 40; ++units)
      for (const double tolerance : {0.9, 0.5, 0.1, 1e-3}) {
        const double e = units * least;
        const auto series = NeumannSeries::make(matrix_of(1, {k}));
        ASSERT_TRUE(series);
        const auto solution = series->solve(std::array{e}, tolerance);
        if (!solution) continue;
        ++solved;
        const Rational exact = Rational::exactly(e) / (1 - Rational::exactly(k));
        EXPECT_LE(abs(exact - Rational::exactly(solution->values[0])),
                  Rational::exactly(solution->error_bound))
            << k << " " << units << " " << tolerance;
      }
  EXPECT_GT(solved, 0);
  const Rational part = Rational::exactly(0.6);
  const auto turn = NeumannSeries::make(matrix_of(2, {0.6, -0.6, 0.6, 0.6}));
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->power(), 2U);
  for (int units = 1; units < 40; ++units)
    for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(0.5)}) {
      const std::array<double, 2> e{units * least, 3 * least};
      const auto solution = turn->solve(e, tolerance);
      if (!solution) continue;
      const Rational a = 1 - part;
      const Rational square = a * a + part * part;
      const Rational first = Rational::exactly(e[0]);
      const Rational second = Rational::exactly(e[1]);
      const std::array<Rational, 2> exact{(a * first - part * second) / square,
                                          (part * first + a * second) / square};
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_LE(abs(exact[i] - Rational::exactly(solution->values[i])),
                  Rational::exactly(solution->error_bound))
            << units;
    }
  // Nothing underflows where there is nothing.
  EXPECT_EQ(turn->solve(std::array{0.0, 0.0}, 0.5)->error_bound, 0);
}

TEST(NeumannSeries, RefusesWhatLeavesTheDoubles) {
  constexpr double largest = std::numeric_limits<double>::max();
  // x = e / (1 - 3/4) = 4 e; a turn, of which the square contracts, where the sum e + R e is too large, or
  // where all but its radius is a double.
  const auto quadruple = NeumannSeries::make(matrix_of(1, {0.75}));
  const auto turn = NeumannSeries::make(matrix_of(2, {0.6, -0.6, 0.6, 0.6}));
  ASSERT_TRUE(quadruple);
  ASSERT_TRUE(turn);
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(1e-6)}) {
    const auto large = quadruple->solve(std::array{largest / 2}, tolerance);
    ASSERT_FALSE(large);
    EXPECT_TRUE(std::isinf(large.reason().error_bound));
    for (const double part : {1.0, 0.9, 0.7, 0.6, 0.5}) {
      const auto turned = turn->solve(std::array{part * largest, -part * largest}, tolerance);
      EXPECT_EQ(std::isfinite(turned ? turned->error_bound : turned.reason().error_bound), turned.has_value())
          << part;
    }
    EXPECT_TRUE(quadruple->solve(std::array{largest / 8}, tolerance));
  }
}

TEST(NeumannSeries, RefusesWhatDiverges) {
  const auto swap = NeumannSeries::make(matrix_of(2, {0, 4, 1, 0}));
  ASSERT_FALSE(swap);
  EXPECT_TRUE(swap.reason().diverges);
  EXPECT_NEAR(swap.reason().theta, 2, 1e-3);
  const auto turn = NeumannSeries::make(matrix_of(2, {0.8, -0.8, 0.8, 0.8}));
  ASSERT_FALSE(turn);
  EXPECT_FALSE(turn.reason().diverges);
  EXPECT_EQ(turn.reason().power, 16U);
  EXPECT_FALSE(NeumannSeries::make(matrix_of(1, {std::numeric_limits<double>::infinity()})));
}

TEST(LightScene, RefusesWhatIsNoScene) {
  EXPECT_THAT(LightScene::make(sphere(), {1.0}).reason(), HasSubstr("albedo 1 "));
  EXPECT_THAT(LightScene::make(sphere(), {-0.5}).reason(), HasSubstr("albedo -0.5 "));
  EXPECT_FALSE(LightScene::make(sphere(), {std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_THAT(LightScene::make(sphere(), {0.1, 0.2}).reason(), HasSubstr("2 albedos for 8 charts"));
  EXPECT_THAT(LightScene::make(torus(2, Rational(1, 2)), {0.5}).reason(), HasSubstr("hides parts of itself"));
  EXPECT_THAT(LightScene::make(sphere(), {0.5},
                               {{.shape = BallBlocker{.centre = {}, .radius = 0.25}, .piece = "cube"}})
                  .reason(),
              HasSubstr("no piece \"cube\""));
  EXPECT_FALSE(
      LightScene::make(sphere(), {0.5}, {{.shape = BallBlocker{.centre = {}, .radius = -1}, .piece = ""}}));
}

TEST(LightScene, HidesByRoundBlockers) {
  const RoundBlocker ball{.shape = BallBlocker{.centre = {}, .radius = 0.5}, .piece = ""};
  const LightScene scene = LightScene::make(sphere(), {0.5}, {ball}).value();
  const LitPoint top{.site = {{0, 0, 1}, {0, 0, -1}}, .chart = 0};
  const LitPoint bottom{.site = {{0, 0, -1}, {0, 0, 1}}, .chart = 4};
  const LitPoint side{.site = {{1, 0, 0}, {-1, 0, 0}}, .chart = 0};
  EXPECT_FALSE(scene.visible(top, bottom));
  EXPECT_TRUE(scene.visible(top, side));  // 1/sqrt 2 from the centre
  EXPECT_FALSE(scene.visible(top, Vector<double>{0, 0, -0.75}));
  EXPECT_TRUE(scene.visible(top, Vector<double>{0, 0, 0.75}));
}

TEST(DirectRadiance, OfAPointLightFallsWithTheSquareOfTheDistance) {
  const LightScene scene = LightScene::make(test::room_with_block(), {0.5}).value();
  const auto floor_at = [&](double x, double y, const Vector<double>& light) {
    // The floor is charts 0 and 1, divided by the diagonal through (0,0).
    const std::size_t chart = 3 * x > 4 * y ? 1 : 0;
    return direct_radiance(scene, PointLight{.at = light, .intensity = 8},
                           {.site = {{x, y, 0}, {0, 0, 1}}, .chart = chart});
  };
  EXPECT_DOUBLE_EQ(floor_at(0.5, 0.25, {0.5, 0.25, 2}), 1);  // 8/2 over 4
  EXPECT_DOUBLE_EQ(floor_at(3.5, 0.25, {0.5, 0.25, 2}), 4 * 2 / std::pow(13, 1.5));
  EXPECT_EQ(floor_at(1.5, 2, {1.5, 2, 2.25}), 0);      // below the block
  EXPECT_EQ(floor_at(0.5, 0.25, {0.5, 0.25, -1}), 0);  // behind the floor
}

/// The sphere with equal weights: R has the rows sum beta (1 - 1/n).
TransferChoice on_sphere(const RadialBasisChoice& basis, CoefficientRule rule) {
  return {.meshless = {.basis = basis, .sites = PoissonDiskSites{.separation = 0.4, .seed = 2}},
          .weights = WeightRule::mean_density,
          .coefficients = rule};
}

/// Lehtinen's basis with smaller elements: its interpolation is well conditioned.
RadialBasisChoice narrow_basis() {
  RadialBasisChoice basis = lehtinen_basis();
  basis.radius.neighbour = 5;
  return basis;
}

TEST(LightTransfer, SolvesTheSphereWithConstantLight) {
  const LightScene scene = LightScene::make(sphere(), {0.75}).value();
  const Light light = SurfaceEmission{[](const LitPoint&) { return 2.0; }};
  for (const RadialBasisChoice& basis : {shepard_basis(), narrow_basis()})
    for (const CoefficientRule rule : {CoefficientRule::as_values, CoefficientRule::interpolated}) {
      const auto transfer = LightTransfer::make(scene, on_sphere(basis, rule));
      ASSERT_TRUE(transfer) << transfer.reason();
      const auto n = static_cast<double>(transfer->basis().size());
      const double exact = 2 / (1 - 0.75 * (1 - 1 / n));
      const auto solution = transfer->solve(light, 1e-10);
      ASSERT_TRUE(solution) << solution.reason();
      // A partition of unity has a constant's coefficients equal, also where it is solved for.
      for (const double lambda : solution->total) EXPECT_NEAR(lambda, exact, 1e-4);
      EXPECT_LE(std::abs(solution->total[0] - exact), solution->error_bound + 1e-3);
      const double there = *transfer->basis().at({{0, 0.6, 0.8}, {0, -0.6, -0.8}}, solution->total);
      EXPECT_NEAR(there, exact, 1e-4);
      for (std::size_t i = 0; i < solution->total.size(); ++i)
        EXPECT_EQ(solution->indirect[i], solution->total[i] - solution->emission[i]);
    }
}

TEST(LightTransfer, InterpolatesTheValuesItWasMadeOf) {
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  const auto values = LightTransfer::make(scene, on_sphere(narrow_basis(), CoefficientRule::as_values));
  const auto solved = LightTransfer::make(scene, on_sphere(narrow_basis(), CoefficientRule::interpolated));
  ASSERT_TRUE(values);
  ASSERT_TRUE(solved);
  const Light light = SurfaceEmission{[](const LitPoint& at) { return 1 + at.site.point.x; }};
  const LightSolution solution = solved->solve(light, 1e-10).value();
  // At the sites the solution is E + N lambda.
  const std::vector<double> emission = solved->emission_at_sites(light);
  for (std::size_t i = 0; i < emission.size(); ++i) {
    double expected = emission[i];
    for (std::size_t j = 0; j < emission.size(); ++j) expected += values->matrix()(i, j) * solution.total[j];
    EXPECT_NEAR(*solved->basis().at(solved->basis().sites()[i], solution.total), expected, 1e-7);
  }
  EXPECT_GT(solved->condition(), 1);
  EXPECT_EQ(values->condition(), 1);
}

TEST(LightTransfer, IsDarkWithoutLight) {
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  const auto transfer = LightTransfer::make(scene, on_sphere(lehtinen_basis(), CoefficientRule::as_values));
  const LightSolution solution =
      transfer->solve(SurfaceEmission{[](const LitPoint&) { return 0.0; }}).value();
  for (const double lambda : solution.total) EXPECT_EQ(lambda, 0);
  EXPECT_EQ(solution.error_bound, 0);
}

// The elements of the Gaussian basis add up to about 20 where ten neighbours make the radius: all light comes
// back twenty times.
TEST(LightTransfer, RefusesAnIterationThatDiverges) {
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  TransferChoice choice = on_sphere(gaussian_basis(), CoefficientRule::as_values);
  choice.weights = WeightRule::plane;
  const auto transfer = LightTransfer::make(scene, choice);
  ASSERT_FALSE(transfer);
  EXPECT_THAT(transfer.reason(), HasSubstr("diverges"));
  EXPECT_THAT(transfer.reason(), HasSubstr("row sum"));
}

// Near an edge two sites on different walls come as close as they like, and the kernel grows like 1/d^2;
// sites that keep a distance do not.
TEST(LightTransfer, RefusesPointLightsThatCrowdInACorner) {
  const LightScene scene = LightScene::make(test::room_with_block(), {0.75}).value();
  TransferChoice choice{
      .meshless = {.basis = lehtinen_basis(), .sites = UniformSites{.count = 400, .seed = 1}},
      .weights = WeightRule::mean_density};
  const auto crowded = LightTransfer::make(scene, choice);
  ASSERT_FALSE(crowded);
  EXPECT_THAT(crowded.reason(), HasSubstr("diverges"));
  choice.meshless.sites = PoissonDiskSites{.separation = 0.4, .seed = 1};
  const auto apart = LightTransfer::make(scene, choice);
  ASSERT_TRUE(apart) << apart.reason();
  EXPECT_LT(apart->series().spectral_radius_bound(), 0.95);
  const auto solution = apart->solve(PointLight{.at = {3, 1, 2}, .intensity = 1});
  ASSERT_TRUE(solution) << solution.reason();
  // The block's shadow is not black.
  EXPECT_GT(*std::min_element(solution->total.begin(), solution->total.end()), 0);
}

TEST(LightTransfer, RefusesWhatSitesAndBasesRefuse) {
  const LightScene scene = LightScene::make(sphere(), {0.5}).value();
  TransferChoice choice;
  choice.meshless.sites = UniformSites{.count = 5, .seed = 1};
  EXPECT_FALSE(LightTransfer::make(scene, choice));
  choice.meshless.sites = PoissonDiskSites{.separation = -1, .seed = 1};
  EXPECT_FALSE(LightTransfer::make(scene, choice));
  choice = on_sphere(shepard_basis(), CoefficientRule::as_values);
  choice.weights = WeightRule::plane;
  EXPECT_FALSE(LightTransfer::make(scene, choice));
}

}  // namespace
}  // namespace radcert
