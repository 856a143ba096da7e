// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sphere_over_disk/solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "radcert/core/contract.h"
#include "radcert/polynomial/rules/gauss.h"
#include "verification/claims/psg10/sphere_over_disk/cubature.h"
#include "verification/claims/psg10/sphere_over_disk/estimate.h"
#include "verification/claims/psg10/sphere_over_disk/sums.h"

namespace radcert::verification::psg10 {
namespace {

constexpr double pi = std::numbers::pi;
using Scene = SceneNumbers<double>;

/// The paper's scene, a large near sphere, a small far one, a disk hardly larger than the sphere.
std::vector<SphereOverDiskScene> scenes() {
  return {{},
          {.radius = 3, .disk_radius = 7, .height = 5, .albedo = Rational(1, 2), .intensity = 2},
          {.radius = Rational(1, 10), .disk_radius = 2, .height = 3, .albedo = Rational(99, 100)},
          {.radius = 1, .disk_radius = Rational(11, 10), .height = 2}};
}

SphereOverDisk<double> solution(const SphereOverDiskScene& scene, int nodes) {
  return {scene, {.nodes = nodes, .points = 2 * nodes}};
}

/// Int f over [from, to] by Gauss' rule in x, place = from + (to - from) sin^2(pi x/2).
template <class F>
double integral(double from, double to, const F& f) {
  if (!(from < to)) return 0;
  static const IntervalRule<double> rule = gauss_rule<double>(60, IntervalWeight::one);
  double sum = 0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double sine = std::sin(pi / 2 * rule.nodes[k]);
    sum += rule.weights[k] * (to - from) * pi / 2 * std::sin(pi * rule.nodes[k]) *
           f(from + (to - from) * sine * sine);
  }
  return sum;
}

/// Int f over [from, to], cut at the given places.
template <class F>
double integral(double from, double to, std::vector<double> cuts, const F& f) {
  cuts.push_back(from);
  cuts.push_back(to);
  for (double& cut : cuts) cut = std::clamp(cut, from, to);
  std::sort(cuts.begin(), cuts.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) sum += integral(cuts[i], cuts[i + 1], f);
  return sum;
}

/// max(0, cos cos')/(pi d^2) over a full turn, from lengths and angles.
double kernel_by_quadrature(const Scene& scene, double u, double t) {
  const double c = std::sqrt((1 - t) * (1 + t));
  const double plane = scene.height * t + scene.radius;
  if (c * u <= plane) return 0;
  const double limit = c * u <= -plane ? pi : std::acos(plane / (c * u));
  return 2 * integral(0, limit, [&](double tau) {
           const double dx = u - scene.radius * c * std::cos(tau);
           const double dy = scene.radius * c * std::sin(tau);
           const double dz = scene.height + scene.radius * t;
           const double square = dx * dx + dy * dy + dz * dz;
           const double cosine = c * std::cos(tau) * dx - c * std::sin(tau) * dy - t * dz;
           return std::max(0.0, cosine) * dz / (pi * square * square);
         });
}

TEST(SphereOverDiskKernel, IsTheAzimuthIntegral) {
  std::mt19937_64 bits(20);
  const auto unit = [&bits] { return static_cast<double>(bits() >> 11U) * 0x1p-53; };
  for (const SphereOverDiskScene& exact : scenes()) {
    const Scene scene(exact);
    for (int trial = 0; trial < 60; ++trial) {
      // Ends, the rim and the horizon come up as often as points in between.
      const int kind = static_cast<int>(bits() % 6);
      const double u = kind == 0   ? 0
                       : kind == 1 ? scene.disk_radius
                       : kind == 2 ? scene.radius
                                   : scene.disk_radius * unit();
      const HorizonLatitudes<double> horizon = horizon_latitudes(scene, u);
      const int place = static_cast<int>(bits() % 5);
      const double t = place == 0   ? -1
                       : place == 1 ? horizon.whole + 1e-6 * unit()
                       : place == 2 ? horizon.last - 1e-6 * unit()
                                    : 2 * unit() - 1;
      const double expected = kernel_by_quadrature(scene, u, t);
      EXPECT_NEAR(azimuth_kernel(scene, u, t), expected, 1e-13 * (1 + expected))
          << "u = " << u << ", t = " << t << ", height " << scene.height;
    }
  }
}

TEST(SphereOverDiskKernel, GivesTheFactorOfASphereSeenFromAPoint) {
  // An element sees a sphere that does not meet its plane with the cosine times the sine squared of the half
  // angle.
  for (const SphereOverDiskScene& exact : scenes()) {
    const Scene scene(exact);
    for (const double share : {0.0, 0.01, 0.3, 0.5, 1.0}) {
      const double u = share * scene.disk_radius;
      const HorizonLatitudes<double> horizon = horizon_latitudes(scene, u);
      const double factor = scene.radius * scene.radius *
                            integral(-1, 1, {horizon.whole, horizon.last},
                                     [&](double t) { return azimuth_kernel(scene, u, t); });
      const double square = scene.height * scene.height + u * u;
      EXPECT_NEAR(factor, scene.radius * scene.radius * scene.height / (square * std::sqrt(square)), 1e-14)
          << u;
    }
  }
}

TEST(SphereOverDiskKernel, GivesTheFactorOfTheDiskSeenFromTheLowestPoint) {
  for (const SphereOverDiskScene& exact : scenes()) {
    const Scene scene(exact);
    const double gap = scene.height - scene.radius;
    const double factor =
        integral(0, scene.disk_radius, [&](double u) { return u * azimuth_kernel(scene, u, -1.0); });
    const double square = scene.disk_radius * scene.disk_radius;
    EXPECT_NEAR(factor, square / (square + gap * gap), 1e-13);
  }
}

TEST(SphereOverDisk, ConvergesFast) {
  const SphereOverDisk<double> fine = solution({}, 40);
  double last = 1;
  for (const int nodes : {8, 16, 24, 32}) {
    const SphereOverDisk<double> coarse = solution({}, nodes);
    double error = 0;
    for (int i = 0; i <= 50; ++i) {
      const double t = 2 * i / 50.0 - 1;
      const double u = 40 * i / 50.0;
      error = std::max({error, std::abs(fine.sphere(t).total() - coarse.sphere(t).total()),
                        std::abs(fine.disk(u).total() - coarse.disk(u).total())});
    }
    EXPECT_LT(error, last / 100) << nodes;
    last = std::max(error, 1e-13);
  }
  EXPECT_LE(last, 2e-13);
}

TEST(SphereOverDisk, MeetsItsEquationsByCubatureOfTheKernel) {
  for (const SphereOverDiskScene& scene : {scenes()[0], scenes()[1], scenes()[3]}) {
    const SphereOverDisk<double> fine = solution(scene, 48);
    for (const double t : {-1.0, -0.95, -0.7, -0.2, 0.0, 0.3, 0.83})
      EXPECT_NEAR(indirect_on_sphere(fine, t, 10), fine.sphere(t).indirect, 2e-12) << "t = " << t;
    const double rim = scene.radius.to_double();
    const double edge = scene.disk_radius.to_double();
    for (const double u : {0.0, rim / 2, rim, (rim + edge) / 2, edge})
      EXPECT_NEAR(indirect_on_disk(fine, u, 10), fine.disk(u).indirect, 2e-12) << "u = " << u;
  }
}

TEST(SphereOverDisk, BalancesWhatTheSphereTakesUp) {
  // By reciprocity the light that goes from the disk to the sphere is Int D times the factor of the sphere, a
  // closed form.
  for (const SphereOverDiskScene& exact : scenes()) {
    const SphereOverDisk<double> all = solution(exact, 40);
    const Scene& scene = all.scene();
    const double taken = scene.radius * scene.radius *
                         integral(-1, 1, all.latitudes(), [&](double t) { return all.sphere(t).indirect; });
    const double sent = integral(0, scene.disk_radius, {scene.radius}, [&](double u) {
      const double square = scene.height * scene.height + u * u;
      return u * all.disk(u).total() * scene.radius * scene.radius * scene.height /
             (square * std::sqrt(square));
    });
    EXPECT_NEAR(taken, scene.albedo * sent, 1e-10 * sent);
  }
}

TEST(SphereOverDisk, BeginsForSmallAlbedoWithLightScatteredTwice) {
  // B+ at the lowest point is then beta^2 mu times the factor of the lit ring.
  SphereOverDiskScene scene;
  scene.albedo = Rational(1, 1000000);
  const SphereOverDisk<double> dark = solution(scene, 24);
  const double factor = 1600.0 / (1600 + 225) - 25.0 / (25 + 225);
  EXPECT_NEAR(dark.sphere(-1).indirect / (1e-12 * 0.9), factor, 1e-5);
  scene.albedo = 0;
  EXPECT_EQ(solution(scene, 8).sphere(-1).total(), 0);
  EXPECT_EQ(solution(scene, 8).disk(20).total(), 0);
}

TEST(SphereOverDisk, HasTheJumpAndTheLimitsOfItsScene) {
  const SphereOverDisk<double> all = solution({}, 24);
  EXPECT_EQ(all.disk(5).emission, 0.81);
  EXPECT_EQ(all.disk(std::nextafter(5.0, 0.0)).emission, 0);
  EXPECT_NEAR(all.disk(5).indirect, all.disk(5 - 1e-9).indirect, 1e-10);
  // Above the last latitude the tangent plane passes over the disk.
  const double last = all.latitudes()[4];
  EXPECT_EQ(all.sphere(last + 1e-12).indirect, 0);
  EXPECT_GT(all.sphere(last - 1e-3).indirect, 0);
  EXPECT_EQ(all.sphere(1).total(), 0.81);
}

TEST(SphereOverDisk, KnowsNoUnits) {
  const SphereOverDisk<double> one = solution({}, 24);
  const SphereOverDisk<double> three =
      solution({.radius = 15, .disk_radius = 120, .height = 60, .intensity = Rational(9, 5)}, 24);
  for (const double t : {-1.0, -0.4, 0.1})
    EXPECT_NEAR(2 * one.sphere(t).total(), three.sphere(t).total(), 1e-14);
  for (const double u : {0.0, 7.0, 40.0})
    EXPECT_NEAR(2 * one.disk(u).total(), three.disk(3 * u).total(), 1e-14);
}

TEST(SphereOverDisk, RefusesScenesThatAreNone) {
  for (const SphereOverDiskScene& scene : std::vector<SphereOverDiskScene>{
           {.radius = 0}, {.radius = 20}, {.radius = 5, .disk_radius = 5}, {.albedo = 1}, {.intensity = -1}})
    EXPECT_THROW((void)solution(scene, 8), ContractViolation);
  EXPECT_THROW((void)solution({}, 1), ContractViolation);
  const SphereOverDisk<double> all = solution({}, 8);
  EXPECT_THROW((void)all.sphere(1.5), ContractViolation);
  EXPECT_THROW((void)all.disk(-1), ContractViolation);
  EXPECT_THROW((void)all.disk(41), ContractViolation);
}

// The largest difference between the sums and the solution, at the sums' own points.
double error_of(const SumReading& reading, const SphereOverDisk<double>& truth) {
  const SumSolution sums = sum_solution({}, reading, 100, 1e-15);
  double error = 0;
  for (std::size_t i = 0; i < sums.sphere.size(); ++i) {
    const double t = std::clamp(std::sin(sums.latitudes[i]), -1.0, 1.0);
    error = std::max(error, std::abs(sums.sphere[i] - truth.sphere(t).total()));
  }
  for (std::size_t j = 0; j < sums.disk.size(); ++j)
    error = std::max(error, std::abs(sums.disk[j] - truth.disk(std::min(40.0, sums.distances[j])).total()));
  return error;
}

TEST(SphereOverDiskSums, ApproachTheSolution) {
  // A shadow's rim between two rings: 8 divides the number of rings.
  const SphereOverDisk<double> truth = solution({}, 32);
  const double coarse = error_of({.rings = 40, .parallels = 40, .azimuths = 80}, truth);
  const double fine = error_of({.rings = 160, .parallels = 160, .azimuths = 160}, truth);
  EXPECT_LT(fine, coarse / 8);
  EXPECT_LT(fine, 2e-4);
  // A ring that lies half in the shadow counts as lit, or rings and parallels at the ends count whole.
  EXPECT_NEAR(error_of({}, truth), 0.0053, 0.0005);
  EXPECT_NEAR(error_of({.spacing = Spacing::with_ends}, truth), 0.0062, 0.0005);
}

TEST(SphereOverDiskSums, DivergeWithTheMatrixAsPrinted) {
  const SumSolution printed = sum_solution({}, {.weights = SumWeights::as_in_the_text}, 30, 0);
  EXPECT_GT(printed.changes[29], 1.5 * printed.changes[27]);
  const SumSolution meant = sum_solution({}, {}, 30, 1e-12);
  EXPECT_LT(meant.changes.size(), 16U);
}

using Part = SphereOverDiskPoint::Part;

TEST(SphereOverDiskValues, HaveTheDigitsThatAreDemanded) {
  const std::vector<SphereOverDiskPoint> points = {{Part::sphere, 0, -1},
                                                   {Part::sphere, Rational(1, 4), 0},
                                                   {Part::sphere, Rational(3, 2), 0},
                                                   {Part::disk, 10, 0},
                                                   {Part::disk, 40, 0}};
  const auto few = estimate({}, points, 6);
  const auto more = estimate({}, points, 12);
  ASSERT_TRUE(few) << few.reason();
  ASSERT_TRUE(more) << more.reason();
  const SphereOverDisk<double> in_double = solution({}, 32);
  const std::vector<Radiance<double>> expected = {in_double.sphere(-1), in_double.sphere(std::sin(0.25)),
                                                  in_double.sphere(std::sin(1.5)), in_double.disk(10),
                                                  in_double.disk(40)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR((*more)[i].total.to_double(), expected[i].total(), 1e-13) << i;
    EXPECT_NEAR((*more)[i].emission.to_double(), expected[i].emission, 1e-15) << i;
    EXPECT_NEAR((*more)[i].indirect.to_double(), expected[i].indirect, 1e-13) << i;
    EXPECT_LE((*few)[i].total.radius(), 0.51e-6) << i;
    EXPECT_LE((*more)[i].total.radius(), 0.51e-12) << i;
    EXPECT_TRUE(overlaps((*few)[i].total, (*more)[i].total)) << i;
    EXPECT_LE((*more)[i].second.radius(), 1e-9) << i;
  }
  // Above the last latitude, beta mu sin(zeta).
  EXPECT_NEAR((*more)[2].total.to_double(), 0.81 * std::sin(1.5), 1e-15);
}

TEST(SphereOverDiskValues, KnowTheirPoints) {
  const SphereOverDiskScene scene;
  EXPECT_TRUE(allows(scene, {Part::sphere, Rational::parse("1.5707963267948966").value(), 0}));
  EXPECT_FALSE(allows(scene, {Part::sphere, Rational::parse("1.5707963267948967").value(), 0}));
  EXPECT_FALSE(allows(scene, {Part::sphere, Rational::parse("-1.5707963267948967").value(), 0}));
  EXPECT_TRUE(allows(scene, {Part::disk, 40, 0}));
  EXPECT_FALSE(allows(scene, {Part::disk, Rational(401, 10), 0}));
  EXPECT_FALSE(allows(scene, {Part::disk, -1, 0}));
  EXPECT_FALSE(allows(scene, {Part::disk, 0, 1}));
}

TEST(SphereOverDiskValues, MakeCurvesWithBothSidesOfTheRim) {
  const std::vector<CurvePoint> both = curves({}, 9);
  ASSERT_EQ(both.size(), 9U + 10U);
  const SphereOverDisk<double> truth = solution({}, 32);
  for (const CurvePoint& point : both) {
    EXPECT_NEAR(point.total, point.emission + point.indirect, 3e-16);
    const Radiance<double> expected =
        point.part == Part::sphere ? truth.sphere(std::sin(point.place)) : truth.disk(point.place);
    EXPECT_NEAR(point.indirect, expected.indirect, 1e-13) << point.place;
    EXPECT_EQ(point.lit, point.emission > 0) << point.place;
  }
  EXPECT_EQ(both[9].place, 0);
  EXPECT_EQ(both[10].place, 5);
  EXPECT_FALSE(both[10].lit);
  EXPECT_EQ(both[11].place, 5);
  EXPECT_TRUE(both[11].lit);
  EXPECT_EQ(both[18].place, 40);
}

}  // namespace
}  // namespace radcert::verification::psg10
