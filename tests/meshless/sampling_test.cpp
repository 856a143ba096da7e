// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/meshless/surface_cells.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/surface/default_surface.h"

namespace radcert {
namespace {

using ::testing::HasSubstr;

// A square, a sliver a thousand times as long as wide, and a small triangle.
Surface uneven_mesh() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0},     {1, 1, 0}, {0, 1, 0},        {0, 0, 2},
                   {4, 0, 2}, {4, 0.004, 2}, {0, 0, 3}, {1.0 / 64, 0, 3}, {0, 1.0 / 64, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  mesh.group = {0, 0, 0, 0};
  mesh.group_names = {"all"};
  mesh.face = {0, 1, 2, 3};
  const std::vector<std::size_t> pieces{0, 0, 1, 2};
  const std::vector<std::string> names{"square", "sliver", "small"};
  return mesh_surface("uneven", mesh, pieces, names, {});
}

void expect_sites_of(const Surface& surface, const SiteSet& sites) {
  ASSERT_EQ(sites.points.size(), sites.at.size());
  ASSERT_EQ(sites.normals.size(), sites.at.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto& [chart, at] = sites.at[i];
    ASSERT_LT(chart, surface.chart_count());
    EXPECT_TRUE(0 <= at.s && at.s <= 1 && 0 <= at.t && at.t <= 1);
    if (surface.charts[chart].facts().domain == ChartDomain::unit_triangle) {
      EXPECT_LE(at.t, 1 - at.s);
    }
    const Site<double> there = site_at(surface, sites.at[i]);
    EXPECT_EQ(there.point, sites.points[i]);
    EXPECT_EQ(there.normal, sites.normals[i]);
    EXPECT_NEAR(norm(there.normal), 1, 1e-15);
  }
}

// The mean of values in [0, 1] is within five standard deviations, at most 1/2 each, of the expected one.
double allowed(std::size_t count) { return 5 * 0.5 / std::sqrt(static_cast<double>(count)); }

TEST(UniformSites, FollowTheAreaOfThePieces) {
  const Surface surface = box(1, 2, 3);
  const SiteSet sites = uniform_sites(surface, {.count = 20000, .seed = 3}).value();
  ASSERT_EQ(sites.size(), 20000U);
  expect_sites_of(surface, sites);
  std::vector<double> found(surface.chart_count(), 0);
  for (const auto& at : sites.at) found[at.chart] += 1.0 / 20000;
  double area = 0;
  std::vector<double> areas;
  for (const Chart& chart : surface.charts) {
    areas.push_back(area_element(chart.in<double>().frame({0.5, 0.5})));
    area += areas.back();
  }
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], areas[k] / area, allowed(20000)) << k;
}

TEST(UniformSites, FollowTheAreaWithinACurvedChart) {
  const SiteSet on_sphere = uniform_sites(sphere(), {.count = 20000, .seed = 4}).value();
  expect_sites_of(sphere(), on_sphere);
  // Archimedes: each coordinate is uniform on [-1, 1].
  double squares = 0;
  double below = 0;
  for (const Vector<double>& p : on_sphere.points) {
    squares += p.z * p.z / 20000;
    below += p.x < 0.5 ? 1.0 / 20000 : 0;
  }
  EXPECT_NEAR(squares, 1.0 / 3, allowed(20000));
  EXPECT_NEAR(below, 0.75, allowed(20000));
  for (std::size_t i = 0; i < on_sphere.size(); ++i)
    EXPECT_NEAR(dot(on_sphere.points[i], on_sphere.normals[i]), -1, 1e-14) << "inner normals";
  // On a disk the squared distance from the centre is uniform.
  const Surface can = cylinder(2, 1);
  const SiteSet on_can = uniform_sites(can, {.count = 20000, .seed = 5}).value();
  double mean = 0;
  double count = 0;
  for (std::size_t i = 0; i < on_can.size(); ++i)
    if (can.charts[on_can.at[i].chart].facts().plane_of_disk) {
      const Vector<double>& p = on_can.points[i];
      mean += p.x * p.x + p.y * p.y;
      count += 1;
    }
  ASSERT_GT(count, 1000);
  EXPECT_NEAR(mean / (4 * count), 0.5, 5 * 0.5 / std::sqrt(count)) << "the radius is 2";
}

TEST(UniformSites, FollowTheAreaWithinATriangle) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.group = {0};
  mesh.group_names = {"all"};
  mesh.face = {0};
  const std::vector<std::size_t> pieces{0};
  const std::vector<std::string> names{"all"};
  const SiteSet sites =
      uniform_sites(mesh_surface("triangle", mesh, pieces, names, {}), {.count = 20000, .seed = 6}).value();
  // The four triangles that the middles of the sides make have a quarter each.
  std::array<double, 4> found{};
  for (const Vector<double>& p : sites.points)
    found.at(p.x > 1 ? 0 : p.y > 1 ? 1 : p.x + p.y < 1 ? 2 : 3) += 1.0 / 20000;
  for (const double part : found) EXPECT_NEAR(part, 0.25, allowed(20000));
}

TEST(UniformSites, FollowTheAreaOfPlaneAndCurvedCharts) {
  Surface surface = sphere();
  surface.name = "sphere and rectangle";
  surface.charts.push_back(
      make_rectangle({.name = "plate", .piece = "plate"}, {0, 0, 2}, {4, 0, 0}, {0, 3, 0}));
  surface.diagonals.push_back(Diagonal::main);
  const SiteSet sites = uniform_sites(surface, {.count = 20000, .seed = 7}).value();
  const auto on_plate =
      std::count_if(sites.at.begin(), sites.at.end(), [](const auto& at) { return at.chart == 8; });
  EXPECT_NEAR(static_cast<double>(on_plate) / 20000, 12 / (12 + 4 * std::numbers::pi), allowed(20000));
}

TEST(UniformSites, AreAFunctionOfTheSeed) {
  const SiteSet a = uniform_sites(sphere(), {.count = 100, .seed = 1}).value();
  EXPECT_EQ(a.points, uniform_sites(sphere(), {.count = 100, .seed = 1})->points);
  EXPECT_NE(a.points, uniform_sites(sphere(), {.count = 100, .seed = 2})->points);
  const SiteSet more = uniform_sites(sphere(), {.count = 150, .seed = 1}).value();
  EXPECT_TRUE(std::equal(a.points.begin(), a.points.end(), more.points.begin()));
}

TEST(UniformSites, RefuseACountOfZero) {
  const auto none = uniform_sites(sphere(), {.count = 0, .seed = 1});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.reason(), HasSubstr("count"));
  EXPECT_FALSE(uniform_sites(Surface{}, {.count = 1, .seed = 1}));
}

TEST(PoissonDiskSites, KeepTheirDistanceAndLeaveNoRoom) {
  struct Case {
    Surface surface;
    double separation;
  };
  for (const auto& [surface, separation] :
       {Case{sphere(), 0.25}, Case{box(1, 2, 3), 0.375}, Case{torus(2, Rational(1, 4)), 0.3},
        Case{cylinder(2, 1), 0.3}, Case{uneven_mesh(), 0.0625}, Case{sphere(), 1.75}}) {
    SCOPED_TRACE(surface.name);
    const SiteSet sites = poisson_disk_sites(surface, {separation, 9}).value();
    expect_sites_of(surface, sites);
    for (std::size_t i = 0; i < sites.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_GE(norm(sites.points[i] - sites.points[j]), separation) << i << ' ' << j;
    const SiteSet everywhere = uniform_sites(surface, {.count = 5000, .seed = 10}).value();
    for (const Vector<double>& p : everywhere.points) {
      const bool is_near =
          std::any_of(sites.points.begin(), sites.points.end(),
                      [&](const Vector<double>& q) { return norm(p - q) < separation * (1 + 0x1p-10); });
      ASSERT_TRUE(is_near) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(PoissonDiskSites, ReachCornersThatDartsSeldomHit) {
  // The small triangle is a hundred thousandth of the area.
  const SiteSet sites = poisson_disk_sites(uneven_mesh(), {0.125, 2}).value();
  EXPECT_EQ(std::count_if(sites.at.begin(), sites.at.end(), [](const auto& at) { return at.chart == 3; }), 1);
}

TEST(PoissonDiskSites, OfASeparationBeyondTheSurfaceAreOne) {
  EXPECT_EQ(poisson_disk_sites(sphere(), {2.5, 1})->size(), 1U);
}

TEST(PoissonDiskSites, AreAFunctionOfTheSeed) {
  const SiteSet a = poisson_disk_sites(sphere(), {0.5, 1}).value();
  EXPECT_EQ(a.points, poisson_disk_sites(sphere(), {0.5, 1})->points);
  EXPECT_NE(a.points, poisson_disk_sites(sphere(), {0.5, 2})->points);
  EXPECT_EQ(a.points, make_sites(sphere(), PoissonDiskSites{0.5, 1})->points);
  EXPECT_EQ(make_sites(sphere(), UniformSites{.count = 7, .seed = 1})->size(), 7U);
}

TEST(PoissonDiskSites, RefuseASeparationThatIsNoneOrTooSmall) {
  for (const double separation :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const auto none = poisson_disk_sites(sphere(), {separation, 1});
    ASSERT_FALSE(none) << separation;
    EXPECT_THAT(none.reason(), HasSubstr("separation"));
  }
  const auto many = poisson_disk_sites(sphere(), {1e-7, 1});
  ASSERT_FALSE(many);
  EXPECT_THAT(many.reason(), HasSubstr("too small"));
}

TEST(Sampling, TakesEverySurfaceOfTheCatalogue) {
  for (const SurfaceDescription& description : surface_catalogue()) {
    SCOPED_TRACE(description.name);
    const Surface surface = default_surface(description);
    expect_sites_of(surface, uniform_sites(surface, {.count = 50, .seed = 1}).value());
    const SiteSet sites = poisson_disk_sites(surface, {0.5, 1}).value();
    EXPECT_GE(sites.size(), 2U);
    expect_sites_of(surface, sites);
  }
}

TEST(SurfaceCells, AreSmallAndTileTheParameters) {
  for (const Surface& surface : {sphere(), uneven_mesh(), box(1, 2, 3)}) {
    const auto cells = cells_below(surface, 0.2, 100000);
    ASSERT_TRUE(cells);
    std::vector<double> areas(surface.chart_count(), 0);
    for (const SurfaceCell& cell : *cells) {
      EXPECT_LT(cell.longest_chord(), 0.2);
      areas[cell.chart] += cell.parameter_area();
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(cell.images[k], surface.charts[cell.chart].in<double>().frame(cell.corners[k]).point);
    }
    for (std::size_t k = 0; k < areas.size(); ++k)
      EXPECT_EQ(areas[k], surface.charts[k].facts().domain == ChartDomain::unit_triangle ? 0.5 : 1);
    EXPECT_FALSE(cells_below(surface, 0.2, cells->size() - 1));
  }
}

}  // namespace
}  // namespace radcert
