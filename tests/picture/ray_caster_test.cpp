// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/ray_caster.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/picture/draws.h"
#include "verification/claims/psg10/scenes/lit_room.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"

namespace radcert {
namespace {

using namespace verification::psg10;

Vector<Rational> exact(const Vector<double>& v) {
  return {Rational::exactly(v.x), Rational::exactly(v.y), Rational::exactly(v.z)};
}

/// The first lit triangle along the ray by Cramer's rule in rational numbers, over all triangles; of several
/// at once all.
struct ExactHit {
  std::vector<std::size_t> triangles;
  Rational t{0};
};

ExactHit brute_force(const Surface& surface, const Vector<double>& eye, const Vector<double>& through) {
  ExactHit best;
  const Vector<Rational> e = exact(eye);
  const Vector<Rational> d = exact(through) - e;
  for (std::size_t k = 0; k < surface.chart_count(); ++k) {
    const auto corners = surface.mesh->corners(k);
    const Vector<Rational> a = exact(corners[0]);
    const Vector<Rational> u = exact(corners[1]) - a;
    const Vector<Rational> v = exact(corners[2]) - a;
    const bool along = surface.charts[k].facts().orientation == Orientation::along_the_cross_product;
    const Vector<Rational> normal = along ? cross(u, v) : cross(v, u);
    const Rational falling = dot(normal, d);
    if (falling.sign() >= 0) continue;
    // e + t d = a + r u + s v.
    const Rational t = dot(normal, a - e) / falling;
    if (t.sign() <= 0) continue;
    const Vector<Rational> p = e + t * d - a;
    const Vector<Rational> full = cross(u, v);
    const Rational square = dot(full, full);
    const Rational r = dot(cross(p, v), full) / square;
    const Rational s = dot(cross(u, p), full) / square;
    if (r.sign() < 0 || s.sign() < 0 || (Rational(1) - r - s).sign() < 0) continue;
    if (best.triangles.empty() || t < best.t)
      best = {.triangles = {k}, .t = t};
    else if (t == best.t)
      best.triangles.push_back(k);
  }
  return best;
}

void expect_same(const Surface& surface, const RayCaster& caster, const Vector<double>& eye,
                 const Vector<double>& through) {
  const auto found = caster.first(eye, through);
  const ExactHit truth = brute_force(surface, eye, through);
  ASSERT_EQ(found.has_value(), !truth.triangles.empty());
  if (!found) return;
  const double t = truth.t.to_double();
  EXPECT_NEAR(found->distance, t, 1e-9 * (1 + t));
  const Vector<double> point = eye + t * (through - eye);
  EXPECT_LT(norm(found->at.site.point - point), 1e-9);
  if (truth.triangles.size() == 1) {
    EXPECT_EQ(found->at.chart, truth.triangles.front());
  } else {
    EXPECT_NE(std::find(truth.triangles.begin(), truth.triangles.end(), found->at.chart),
              truth.triangles.end());
  }
  EXPECT_LT(dot(found->at.site.normal, through - eye), 0);
}

TEST(RayCaster, FindsWhatAllTrianglesTogetherHave) {
  const LitRoom room = lit_room();
  const Surface& surface = room.scene.surface();
  const RayCaster caster = RayCaster::make(surface).value();
  test::Draws draws(31);
  for (int k = 0; k < 150; ++k) {
    SCOPED_TRACE(k);
    expect_same(surface, caster, draws.point(-2, 6), draws.point(0, 4));
  }
  // Aimed at vertices, at the middles of sides, and along the axes, where roundings decide if anything does.
  const Vector<double> eye = room.camera.position;
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const auto corners = surface.mesh->corners(draws.below(surface.chart_count()));
    const Vector<double> target = k % 2 == 0 ? corners[0] : 0.5 * (corners[0] + corners[1]);
    expect_same(surface, caster, eye, target);
    expect_same(surface, caster, eye, {target.x, target.y, eye.z});
    expect_same(surface, caster, eye, {eye.x, target.y, eye.z});
  }
}

TEST(RayCaster, LetsNoRayPassBetweenNeighbours) {
  // A closed body seen from outside its light: each line from within meets a face, also through sides and
  // vertices.
  const LitRoom room = lit_room();
  const RayCaster caster = RayCaster::make(room.scene.surface()).value();
  test::Draws draws(32);
  const Vector<double> inside{2, 0.5, 1.5};
  for (int k = 0; k < 3000; ++k) EXPECT_TRUE(caster.first(inside, draws.point(-1, 5)));
  for (const Vector<double>& v : room.scene.surface().mesh->vertices) {
    EXPECT_TRUE(caster.first(inside, v));
    EXPECT_TRUE(caster.first(inside, inside + 0.001 * (v - inside)));
  }
}

TEST(RayCaster, SeesPointsBesideTheFirstHitOnlyIfNothingHidesThem) {
  const LitRoom room = lit_room();
  const RayCaster caster = RayCaster::make(room.scene.surface()).value();
  const Vector<double> eye = room.camera.position;
  EXPECT_TRUE(caster.sees(eye, {.point = {3.9, 4, 2.9}, .normal = {0, -1, 0}}));
  // Behind the tall block, and on the back of a wall.
  EXPECT_FALSE(caster.sees(eye, {.point = {1.25, 4, 0.5}, .normal = {0, -1, 0}}));
  EXPECT_FALSE(caster.sees(eye, {.point = {2, 0, 0.125}, .normal = {0, 1, 0}}));
}

TEST(RayCaster, MeetsSphereAndDiskWhereTheirFormulasSay) {
  const Surface surface = sphere_over_disk_surface();
  const std::array<RoundBlocker, 2> bodies{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "sphere"},
       {.shape = DiskBlocker{.centre = {0, 0, 0}, .normal = {0, 0, 2}, .radius = 40}, .piece = "disk"}}};
  const RayCaster caster = RayCaster::make(surface, bodies).value();
  test::Draws draws(33);
  int spheres = 0;
  int disks = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector<double> eye{draws.between(-50, 50), draws.between(-80, -45), draws.between(-10, 60)};
    // A point of one of the bodies, or somewhere.
    const double z = draws.between(-1, 1);
    const double phi = draws.between(0, 6.28);
    const double across = std::sqrt(1 - z * z);
    const Vector<double> target =
        k % 3 == 0   ? Vector<double>{5 * across * std::cos(phi), 5 * across * std::sin(phi), 20 + 5 * z}
        : k % 3 == 1 ? Vector<double>{42 * z * std::cos(phi), 42 * z * std::sin(phi), 0}
                     : draws.point(-40, 40);
    const auto hit = caster.first(eye, target);
    // Independent: the height over the disk along the line, and the least root by halving of the ball's
    // quadratic.
    const Vector<double> d = target - eye;
    double best = -1;
    bool on_sphere = false;
    if (d.z < 0 && eye.z > 0) {
      const double t = eye.z / -d.z;
      const Vector<double> p = eye + t * d;
      if (std::hypot(p.x, p.y) <= 40) best = t;
    }
    const Vector<double> centre{0, 0, 20};
    const double nearest = dot(centre - eye, d) / dot(d, d);
    if (nearest > 0 && norm(eye + nearest * d - centre) < 5) {
      double outside = 0;
      double inside = nearest;
      for (int step = 0; step < 80; ++step) {
        const double middle = (outside + inside) / 2;
        (norm(eye + middle * d - centre) < 5 ? inside : outside) = middle;
      }
      if (best < 0 || inside < best) best = inside, on_sphere = true;
    }
    ASSERT_EQ(hit.has_value(), best >= 0) << k;
    if (!hit) continue;
    (on_sphere ? spheres : disks) += 1;
    EXPECT_NEAR(hit->distance, best, 1e-7 * (1 + best)) << k;
    EXPECT_EQ(surface.charts[hit->at.chart].facts().piece, on_sphere ? "sphere" : "disk");
    EXPECT_EQ(hit->face, on_sphere ? 0U : 1U);
    EXPECT_NEAR(norm(hit->at.site.normal), 1, 1e-14);
    if (on_sphere) {
      EXPECT_NEAR(norm(hit->at.site.point - centre), 5, 1e-13);
      EXPECT_LT(norm(hit->at.site.point - centre - 5 * hit->at.site.normal), 1e-13);
    } else {
      EXPECT_EQ(hit->at.site.normal, (Vector<double>{0, 0, 1}));
    }
  }
  EXPECT_GT(spheres, 300);
  EXPECT_GT(disks, 300);
}

TEST(RayCaster, PassesThroughBacks) {
  const Surface surface = sphere_over_disk_surface();
  const std::array<RoundBlocker, 2> bodies{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "sphere"},
       {.shape = DiskBlocker{.centre = {0, 0, 0}, .normal = {0, 0, 1}, .radius = 40}, .piece = "disk"}}};
  const RayCaster caster = RayCaster::make(surface, bodies).value();
  // From below the disk only the sphere is seen; from within the sphere only the disk.
  EXPECT_NEAR(caster.first({0, 0, -10}, {0, 0, 0})->at.site.point.z, 15, 1e-12);
  EXPECT_NEAR(caster.first({0, 0, 20}, {0, 0, 19})->at.site.point.z, 0, 1e-12);
  EXPECT_FALSE(caster.first({0, 0, 20}, {0, 0, 21}));
  EXPECT_FALSE(caster.first({0, 0, 30}, {0, 0, 31}));
  EXPECT_THROW((void)caster.first({1, 1, 1}, {1, 1, 1}), ContractViolation);
}

TEST(RayCaster, RefusesCurvedSurfacesWithoutABody) {
  const Surface surface = sphere_over_disk_surface();
  const std::array<RoundBlocker, 1> ball{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "sphere"}}};
  EXPECT_EQ(
      RayCaster::make(surface, ball).reason(),
      "the piece \"disk\" is neither a mesh nor the skin of a ball or disk: take a mesh of the surface");
  const std::array<RoundBlocker, 1> other{
      {{.shape = BallBlocker{.centre = {0, 0, 20}, .radius = 5}, .piece = "moon"}}};
  EXPECT_EQ(RayCaster::make(surface, other).reason(), "the surface has no piece \"moon\"");
}

}  // namespace
}  // namespace radcert
