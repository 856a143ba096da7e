// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/scenes/sphere_over_disk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/sampling.h"
#include "verification/claims/psg10/scenes/profile_errors.h"
#include "verification/claims/psg10/sphere_over_disk/solution.h"

namespace radcert::verification::psg10 {
namespace {

using std::numbers::pi;

TEST(SphereOverDiskLightScene, RefusesAnAlbedoThatIsNotBelow1) {
  EXPECT_FALSE(sphere_over_disk_light_scene(1.0));
}

TEST(SphereOverDiskSurface, HasTheAreaAndTheNormalsOfTheScene) {
  const Surface surface = sphere_over_disk_surface();
  ASSERT_EQ(surface.chart_count(), 12U);
  const SiteSet sites = uniform_sites(surface, {300, 1}).value();
  std::size_t on_sphere = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Vector<double> from_centre = sites.points[i] - Vector<double>{0, 0, 20};
    if (surface.charts[sites.at[i].chart].facts().piece == "sphere") {
      ++on_sphere;
      EXPECT_NEAR(norm(from_centre), 5, 1e-13);
      EXPECT_NEAR(dot(from_centre, sites.normals[i]), 5, 1e-13);
    } else {
      EXPECT_EQ(sites.points[i].z, 0);
      EXPECT_LE(norm(sites.points[i]), 40 + 1e-12);
      EXPECT_NEAR(sites.normals[i].z, 1, 1e-15);
    }
  }
  // 100/1700 of 300 expected.
  EXPECT_GT(on_sphere, 8U);
  EXPECT_LT(on_sphere, 32U);
}

TEST(DirectRadiance, IsThatOfEquation20) {
  const LightScene scene = sphere_over_disk_light_scene(0.75).value();
  const Light light = ParallelLight{.towards = {0, 0, 3}, .power = 0.5};
  const SiteSet sites = uniform_sites(scene.surface(), {400, 4}).value();
  int dark = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const LitPoint at{.site = sites[i], .chart = sites.at[i].chart};
    double expected = 0.375;
    if (at.chart < 8) {
      expected *= std::max(0.0, (sites.points[i].z - 20) / 5);
    } else if (std::hypot(sites.points[i].x, sites.points[i].y) < 5) {
      expected = 0;
    }
    dark += expected == 0 ? 1 : 0;
    EXPECT_NEAR(direct_radiance(scene, light, at), expected, 1e-14) << i;
  }
  EXPECT_GT(dark, 5);
}

TEST(ProfileErrors, SeparateBiasAndOscillation) {
  const auto truth = [](double t) { return 2 + t; };
  const std::vector<ProfilePoint> profile = sphere_profile(5, 20, 12, truth);
  const auto radiance = [](const LitPoint& at) {
    const double t = (at.site.point.z - 20) / 5;
    const double phi = std::atan2(at.site.point.y, at.site.point.x);
    return std::optional(2 + t + 0.25 + 0.5 * std::cos(phi));
  };
  const ProfileErrors errors = profile_errors(radiance, profile, 16);
  EXPECT_NEAR(errors.bias, 0.25, 1e-14);
  EXPECT_NEAR(errors.mean, 0.25, 1e-14);
  EXPECT_NEAR(errors.oscillation, 0.5 / std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(errors.max, 0.75, 1e-14);
  EXPECT_NEAR(errors.l2, std::sqrt(0.0625 + 0.125), 1e-14);
  EXPECT_EQ(errors.without_value, 0);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    EXPECT_NEAR(errors.circles[k].ray, profile[k].truth + 0.75, 1e-14);
    EXPECT_NEAR(errors.circles[k].mean, profile[k].truth + 0.25, 1e-14);
  }
}

TEST(ProfileErrors, LeaveOutWhatHasNoValue) {
  const std::vector<ProfilePoint> profile = disk_profile(40, 10, [](double) { return 1.0; });
  double area = 0;
  for (const ProfilePoint& at : profile) area += at.area;
  EXPECT_NEAR(area, 1600 * pi, 1e-9);
  const auto half = [](const LitPoint& at) {
    return at.site.point.y > -1e-9 ? std::optional(1.5) : std::nullopt;
  };
  const ProfileErrors errors = profile_errors(half, profile, 8);
  EXPECT_NEAR(errors.without_value, 3.0 / 8, 1e-14);
  EXPECT_NEAR(errors.l2, 0.5, 1e-14);
  EXPECT_EQ(errors.oscillation, 0);
}

// The bounds are three times what these sites give: a lost factor of the albedo, of the weights or of pi
// exceeds them.
TEST(SphereOverDiskLightScene, AgreesWithTheSolutionOfTheSphereOverTheDisk) {
  const LightScene scene = sphere_over_disk_light_scene().value();
  const Light light = ParallelLight{.towards = {0, 0, 1}, .power = 0.9};
  const SphereOverDisk<double> truth({}, {.nodes = 12, .points = 16});
  const TransferChoice choice{
      .meshless = {.basis = lehtinen_basis(), .sites = PoissonDiskSites{.separation = 2.5, .seed = 1}},
      .integration = {.relative_error = 1e-3, .most_points = 400'000}};
  const LightTransfer transfer = LightTransfer::make(scene, choice).value();
  const LightSolution solution = transfer.solve(light).value();
  const auto radiance = [&](const LitPoint& at) { return transfer.radiance(solution, light, at); };
  const ProfileErrors on_disk =
      profile_errors(radiance, disk_profile(40, 40, [&](double u) { return truth.disk(u).total(); }), 24);
  const ProfileErrors on_sphere = profile_errors(
      radiance, sphere_profile(5, 20, 40, [&](double t) { return truth.sphere(t).total(); }), 24);
  EXPECT_LT(on_disk.l2, 0.0015);
  EXPECT_LT(on_disk.max, 0.005);
  EXPECT_LT(on_sphere.l2, 0.1);
  EXPECT_LT(std::abs(on_sphere.mean), 0.01);
  // In the basis the shadow's edge is as wide as an element.
  const ProfileErrors smooth =
      profile_errors([&](const LitPoint& at) { return transfer.radiance(solution, at); },
                     disk_profile(40, 40, [&](double u) { return truth.disk(u).total(); }), 24);
  EXPECT_GT(smooth.max, 0.3);
  EXPECT_LT(smooth.l2, 0.15);
  EXPECT_LT(transfer.sums().spectral_radius, 0.13);
  EXPECT_GT(transfer.sums().spectral_radius, 0.11);
}

}  // namespace
}  // namespace radcert::verification::psg10
