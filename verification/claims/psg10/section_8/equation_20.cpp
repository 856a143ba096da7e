// SPDX-License-Identifier: GPL-3.0-or-later

// Light that falls parallel to the axis onto the sphere over the disk.
//
// Checked      Exactly. The ray p + s e meets the sphere where a s^2 + 2 b s + c = 0, a = e.e, b = e.(p - C),
//              c = |p - C|^2 - r^2. For all scenes and points, e = e_z, as identities of polynomials of
//              degree 2 in each variable, which three values of each prove. Disk, p = (x,y,0): b^2 - a c =
//              r^2 - u^2, u^2 = x^2 + y^2: the ray enters the sphere if u < r, touches it at u = r and passes
//              elsewhere; c = u^2 + (h^2 - r^2) > 0 and b = -h < 0 for h > r > 0: where it meets it, it does
//              so above the disk. Lit if u >= r, as (20) has it. Sphere, p = C + r n: c = r^2 (n.n - 1) = 0
//              and b = r n_z: the other end is at s = -2 r n_z, in the way of the light if n_z < 0. Else the
//              plane there stands to the light at the cosine n_z = sin zeta. At 400 points of either, the
//              same by that equation in numbers, whether or not they are lit: rejected for light that falls
//              in along (3/5, 0, 4/5). What the sphere catches is what the shadow lacks: the enclosed
//              integral of max(0, sin zeta) over the sphere is pi r^2.
// Not checked  that radiance in this unit is what the figures show.

#include <array>

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/psg10/exact_scene.h"
#include "verification/claims/psg10/section_8/ray_on_sphere.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr int points = 400;

using Point = Vector<Rational>;
using Ray = RayOnSphere<Rational>;

/// Whether it is inside the sphere at some s > 0, for c >= 0: p is not inside.
bool enters(const Ray& ray) { return ray.discriminant().sign() > 0 && ray.b.sign() < 0; }

/// Towards the light.
Point upwards() { return {0, 0, 1}; }
Point aslant() { return {Rational(3, 5), 0, Rational(4, 5)}; }

/// How many of the scenes and points x, y, h, r in {1,2,3}, and of their normals, fail one of the identities.
Rational failing_identities() {
  const std::array<Rational, 3> values{1, 2, 3};
  long total = 0;
  const auto count = [&](const Rational& left, const Rational& right) {
    if (left != right) ++total;
  };
  for (const Rational& x : values)
    for (const Rational& y : values)
      for (const Rational& h : values)
        for (const Rational& r : values) {
          const Point centre{0, 0, h};
          const Ray from_disk({x, y, 0}, upwards(), centre, r);
          const Rational square = x * x + y * y;
          count(from_disk.discriminant(), r * r - square);
          count(from_disk.c, square + (h * h - r * r));
          count(from_disk.b, -h);
          for (const Rational& z : values) {
            const Point n{x, y, z};
            const Ray from_sphere(centre + r * n, upwards(), centre, r);
            count(from_sphere.c, r * r * (dot(n, n) - Rational(1)));
            count(from_sphere.b, r * z);
          }
        }
  return total;
}

/// How many points of the disk are lit and not in [r, R], or in it and not lit.
Rational disagreeing_on_disk(const Point& to_light) {
  ExactScene scene(8);
  const Rational& r = scene.numbers().radius;
  long count = 0;
  for (int i = 0; i < points; ++i) {
    const Point q = ExactScene::on_disk(scene.distance(), scene.direction(false));
    const bool is_lit = !enters(Ray(q, to_light, scene.centre(), r));
    if (is_lit != (r * r <= q.x * q.x + q.y * q.y)) ++count;
  }
  return count;
}

/// How many points of the sphere receive other than max(0, sin zeta) per area.
Rational disagreeing_on_sphere(const Point& to_light) {
  ExactScene scene(9);
  long count = 0;
  for (int i = 0; i < points; ++i) {
    const Direction latitude = scene.direction(true);
    const Point normal = ExactScene::normal(latitude, scene.direction(false));
    const Point p = scene.on_sphere(normal);
    const bool shadowed = enters(Ray(p, to_light, scene.centre(), scene.numbers().radius));
    const Rational received = shadowed ? Rational(0) : dot(normal, to_light);
    if (received != (latitude.sine.sign() > 0 ? latitude.sine : Rational(0))) ++count;
  }
  return count;
}

/// 2 pi r^2 Int sin zeta cos zeta dzeta from the latitude 0 to 90 degrees, where sin zeta > 0; or without the
/// plane's slope, sin zeta.
Ball caught(const Ball& radius, bool with_slope) {
  const auto integrand = [with_slope](const auto& zeta) {
    const auto ring = cos(zeta);
    return with_slope ? sin(zeta) * ring : ring;
  };
  return Ball(2) * Ball::pi() * radius * radius *
         known(integral_on_interval(line_function(integrand), Ball(0), Ball::pi() / Ball(2),
                                    {.radius = 1e-24}));
}

}  // namespace

Finding equation_20(const Bench&) {
  const BallPrecision precision(160);
  Finding finding;
  finding.require("scenes and points at which an identity of the ray's equation fails", IsExactly{0},
                  failing_identities());
  finding.require("points of the disk that are lit, or not, against (20)", IsExactly{0},
                  disagreeing_on_disk(upwards()));
  finding.control("the same, light along (3/5, 0, 4/5)", IsExactly{0}, disagreeing_on_disk(aslant()));
  finding.require("points of the sphere that receive other than max(0, sin zeta)", IsExactly{0},
                  disagreeing_on_sphere(upwards()));
  finding.control("the same, light along (3/5, 0, 4/5)", IsExactly{0}, disagreeing_on_sphere(aslant()));
  const Ball radius(SphereOverDiskScene{}.radius);
  const AgreesWith shadow{.value = Ball::pi() * radius * radius, .within = 1e-18};
  finding.require("light on the sphere, against what the shadow lacks, pi r^2", shadow, caught(radius, true));
  finding.control("the same without the slope of the sphere to the light", shadow, caught(radius, false));
  return finding;
}

}  // namespace radcert::verification::psg10
