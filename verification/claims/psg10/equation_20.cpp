// SPDX-License-Identifier: GPL-3.0-or-later

// Light that falls parallel to the axis onto the sphere over the disk.
//
// Checked      Exactly, at 400 points each. Disk: the vertical through a point at the distance u meets the
//              sphere where r^2 - u^2 > 0, touches it at u = r, and passes elsewhere: the point is lit if u
//              >= r, as (20) has it. Sphere: the vertical upwards from a point leaves the sphere if its
//              latitude is not below the equator, and the plane there stands to the light at the cosine sin
//              zeta. A surface of albedo beta gives back beta of what arrives, and B*, D* are in the unit in
//              which a white surface across the light has mu. What the sphere catches is what the shadow
//              lacks: Int B*/(beta mu) over the sphere, 2 pi r^2 Int_0^1 t dt, is pi r^2.
// Not checked  that radiance in this unit is what the figures show.

#include "verification/claims/psg10/exact_scene.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr int points = 400;

/// How many points of the disk are lit and not in [from, R], or in it and not lit.
long disagreeing_on_disk(const Rational& from) {
  ExactScene scene(8);
  const Rational& r = scene.numbers().radius;
  long count = 0;
  for (int i = 0; i < points; ++i) {
    const Vector<Rational> q = ExactScene::on_disk(scene.distance(), scene.direction(false));
    // The sphere's chord on the vertical has the square 4 (r^2 - x^2 - y^2).
    const bool shadowed = q.x * q.x + q.y * q.y < r * r;
    if (shadowed == (from * from <= q.x * q.x + q.y * q.y)) ++count;
  }
  return count;
}

/// How many points of the sphere receive other than max(0, sin zeta + shift) per area.
long disagreeing_on_sphere(const Rational& shift) {
  ExactScene scene(9);
  long count = 0;
  for (int i = 0; i < points; ++i) {
    const Direction latitude = scene.direction(true);
    const Vector<Rational> normal = ExactScene::normal(latitude, scene.direction(false));
    const Vector<Rational> from_centre = scene.on_sphere(normal) - scene.centre();
    // p + s e_z is on the sphere again for s = -2 (p - c).e_z: in the way of the light if s > 0.
    const bool shadowed = Rational(0) < -Rational(2) * from_centre.z;
    const Rational received = shadowed ? Rational(0) : normal.z;
    const Rational stated = latitude.sine + shift;
    if (received != (stated.sign() > 0 ? stated : Rational(0))) ++count;
  }
  return count;
}

}  // namespace

Finding equation_20(const Bench&) {
  Finding finding;
  const Rational r = SphereOverDiskScene{}.radius;
  finding.require("points of the disk that are lit, or not, against (20)", IsExactly{0},
                  Rational(disagreeing_on_disk(r)));
  finding.control("the same with a shadow of radius 6", IsExactly{0}, Rational(disagreeing_on_disk(6)));
  finding.require("points of the sphere that receive other than max(0, sin zeta)", IsExactly{0},
                  Rational(disagreeing_on_sphere(0)));
  finding.control("the same with sin zeta + 1/100", IsExactly{0},
                  Rational(disagreeing_on_sphere(Rational(1, 100))));
  // Int_0^1 t dt = 1/2.
  finding.require("light on the sphere over light missing in the shadow", IsExactly{1},
                  Rational(2) * r * r * Rational(1, 2) / (r * r));
  return finding;
}

}  // namespace radcert::verification::psg10
