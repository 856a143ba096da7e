// SPDX-License-Identifier: GPL-3.0-or-later

// The two forms of the transfer operator, and the albedo.
//
// Checked      The change of variables, for all surfaces: v = y - x, tangents a and b at y. By the quotient
//              rule the direction v/|v| has the derivatives (|v|^2 a - v (v.a))/|v|^3 and the same with b.
//              Their vector product is v (v.(a x b))/|v|^4, an identity of polynomials in the nine
//              coordinates: its length is dv = cos' dy/d^2, with cos' = n(y).(y -> x). So H dv = cos
//              cos'/d^2 dy on what x sees, V = 1 and both cosines positive. Rejected: projection from x onto
//              a plane in the place of the sphere. K dy is dv/(4 pi), the share of all directions. (4) has H
//              K dy: with dv the area on the unit sphere 1/(4 pi) of (2), with dv the mean over the sphere
//              the same; the paper does not say which. The same by enclosed integrals for a disk of radius 2
//              seen from height 1 above its middle, rejected without the cosines. The albedo is what a
//              surface of any beta gives back of light 1 from all sides, over beta: with rho = 2 beta (2)
//              gives 2 pi where dv is the area, 1/2 where it is the mean over the sphere, and 1 where it is
//              the mean over the half that the surface faces, by which (4) with (5) is half of (2) and no
//              integral over all directions is meant; (4) with (5) gives 1/2. All are linear in rho. rho =
//              beta/pi in (2) with the area, 4 beta with the mean, or 4 beta in (4) and (5), gives 1, and
//              the kernel beta cos cos'/(pi d^2): (1) is then the radiosity equation. Rejected: H = 1.
// Not checked  surfaces that are not Lambertian.

#include <string>

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;

Function symbol(const std::string& name) { return Function::variable(name); }
Vector<Function> vector(const std::string& name) {
  return {symbol(name + "x"), symbol(name + "y"), symbol(name + "z")};
}

Rational differing_terms_of(const Vector<Function>& a, const Vector<Function>& b) {
  return differing_terms(a.x, b.x) + differing_terms(a.y, b.y) + differing_terms(a.z, b.z);
}

/// Terms in which D_a w x D_b w |v|^4 differs from v (v.(a x b)), w = v/|v|.
Rational not_the_solid_angle() {
  const Vector<Function> v = vector("v");
  const Function square = dot(v, v);
  const auto derivative = [&](const Vector<Function>& a) { return square * a - dot(v, a) * v; };
  const Vector<Function> a = vector("a");
  const Vector<Function> b = vector("b");
  return differing_terms_of(cross(derivative(a), derivative(b)), square * dot(v, cross(a, b)) * v);
}
/// The same for w = v/v_z, on a plane.
Rational not_the_solid_angle_on_a_plane() {
  const Vector<Function> v = vector("v");
  const auto derivative = [&](const Vector<Function>& a) { return v.z * a - a.z * v; };
  const Vector<Function> a = vector("a");
  const Vector<Function> b = vector("b");
  return differing_terms_of(cross(derivative(a), derivative(b)), dot(v, cross(a, b)) * v);
}

/// Terms in which rho H K of (4) and (5) differs from beta cos cos'/(pi d^2), rho = so many beta.
Rational not_the_kernel(int factor) {
  const Function cosines = symbol("cos") * symbol("cos'") / symbol("d2");
  const Function printed = Function(factor) * symbol("beta") * cosines / (Function(4) * symbol("pi"));
  return differing_terms(printed, symbol("beta") * cosines / symbol("pi"));
}

Demand demand() { return {.radius = 1e-24}; }

/// Int H dv over the directions with a cosine between `least` and 1.
Ball over_directions(const Ball& least) {
  return known(
             integral_on_interval(line_function([](const auto& c) { return c; }), least, Ball(1), demand())) *
         Ball(2) * Ball::pi();
}

/// Int dv over the same directions: light that is received without Lambert's cosine.
Ball solid_angle(const Ball& least) {
  return known(integral_on_interval(line_function([](const auto& c) { return c - c + 1; }), least, Ball(1),
                                    demand())) *
         Ball(2) * Ball::pi();
}

/// Int cos cos'/d^2 dy over the disk of radius 2 at height 1, without the 1/(4 pi) of (5).
Ball over_disk() {
  const auto integrand = [](const auto& u) {
    const auto square = u * u + 1;
    return u / (square * square);
  };
  return known(integral_on_interval(line_function(integrand), Ball(0), Ball(2), demand())) * Ball(2) *
         Ball::pi();
}

/// Int dy/d^2 over the same disk: neither cosine.
Ball over_disk_without_cosines() {
  const auto integrand = [](const auto& u) { return u / (u * u + 1); };
  return known(integral_on_interval(line_function(integrand), Ball(0), Ball(2), demand())) * Ball(2) *
         Ball::pi();
}

/// The least cosine under which the disk is seen, 1/sqrt 5.
Ball rim() { return Ball(1) / sqrt(Ball(5)); }

Ball factor_of_5() { return Ball(1) / (Ball(4) * Ball::pi()); }

/// The share of light 1 from all sides that is given back is beta.
AgreesWith albedo() { return {.value = Ball(1), .within = 1e-20}; }

void require_change_of_variables(Finding& finding) {
  finding.require(
      "terms in which the vector product of the direction's derivatives differs from v (v.(a x b))/|v|^4",
      IsExactly{0}, not_the_solid_angle());
  finding.control("the same on a plane in the place of the sphere", IsExactly{0},
                  not_the_solid_angle_on_a_plane());
}

}  // namespace

Finding equation_2(const Bench&) {
  const BallPrecision precision(160);
  // dv is the area on the unit sphere, or the mean over it: the paper does not say.
  const Ball by_area = over_directions(Ball(0));
  const Ball all_directions = Ball(2) * solid_angle(Ball(0));
  const Ball by_mean = by_area / all_directions;
  const Ball by_half = by_area / solid_angle(Ball(0));
  Finding finding;
  finding.require("light given back by (2), over beta, rho = 2 beta, dv the area", albedo(),
                  Ball(2) * by_area);
  finding.require("light given back by (2), over beta, rho = 2 beta, dv the mean over all directions",
                  albedo(), Ball(2) * by_mean);
  finding.instead("light given back by (2), over beta, rho = beta/pi, dv the area", albedo(),
                  by_area / Ball::pi());
  finding.instead("light given back by (2), over beta, rho = 4 beta, dv the mean over all directions",
                  albedo(), Ball(4) * by_mean);
  finding.instead("light given back by (2), over beta, rho = 2 beta, dv the mean over the half sphere",
                  albedo(), Ball(2) * by_half);
  finding.control("light given back by (2), over beta, rho = beta/pi, dv the area, H = 1", albedo(),
                  solid_angle(Ball(0)) / Ball::pi());
  finding.control("light given back by (2), over beta, rho = 4 beta, dv the mean over all directions, H = 1",
                  albedo(), Ball(4) * solid_angle(Ball(0)) / all_directions);
  // The disk of equation_4: what (2) gives by the half sphere, against (4).
  const AgreesWith printed{.value = over_disk() * factor_of_5(), .within = 1e-20};
  finding.instead("Int H dv over the disk, dv the mean over all directions, against (4) with (5)", printed,
                  over_directions(rim()) / all_directions);
  finding.control("the same, dv the mean over the half sphere", printed,
                  over_directions(rim()) / solid_angle(Ball(0)));
  return finding;
}

Finding section_2_albedo(const Bench&) {
  const BallPrecision precision(160);
  // On a dome of radius 1 about the point G = c/(4 pi) and dy = dv; any other surface gives the same, by the
  // change of variables.
  const Ball dome = over_directions(Ball(0)) * factor_of_5();
  Finding finding;
  finding.require("light given back by (4) and (5), over beta, rho = 2 beta", albedo(), Ball(2) * dome);
  finding.instead("light given back by (4) and (5), over beta, rho = 4 beta", albedo(), Ball(4) * dome);
  finding.control("light given back by (4) and (5), over beta, rho = 4 beta, H = 1", albedo(),
                  Ball(4) * solid_angle(Ball(0)) * factor_of_5());
  return finding;
}

Finding section_2_radiosity(const Bench&) {
  const BallPrecision precision(160);
  const Ball all = over_directions(Ball(0));
  Finding finding;
  require_change_of_variables(finding);
  finding.require("terms in which rho G differs from beta cos cos'/(pi d^2), rho = 4 beta", IsExactly{0},
                  not_the_kernel(4));
  finding.control("the same, rho = 2 beta", IsExactly{0}, not_the_kernel(2));
  finding.require("light given back by (2), over beta, rho = beta/pi", albedo(), all / Ball::pi());
  finding.require("light given back by (4) and (5), over beta, rho = 4 beta", albedo(),
                  Ball(4) * all * factor_of_5());
  finding.control("light given back by (2), over beta, rho = beta/pi, H = 1", albedo(),
                  solid_angle(Ball(0)) / Ball::pi());
  return finding;
}

Finding equation_4(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith by_directions{.value = over_directions(rim()), .within = 1e-20};
  Finding finding;
  // dv is the area on the unit sphere, or the mean over it: the paper does not say.
  const Ball by_area = over_directions(rim());
  const Ball by_mean = by_area / (Ball(4) * Ball::pi());
  const Ball printed = over_disk() * factor_of_5();
  const AgreesWith none{.value = Ball(0), .within = 1e-20};
  finding.require("Int G over the disk less Int H dv, dv from the mean to the area", none,
                  hull(printed - by_mean, printed - by_area));
  finding.remark("Int G over the disk less Int H dv, dv the area", proved(printed - by_area));
  finding.remark("Int G over the disk less Int H dv, dv the mean", proved(printed - by_mean));
  finding.instead("Int 4 pi G over the disk, (5) without the 1/(4 pi)", by_directions, over_disk());
  finding.control("Int 1/(4 pi d^2) over the disk, without the cosines", by_directions,
                  over_disk_without_cosines() * factor_of_5());
  require_change_of_variables(finding);
  return finding;
}

Finding section_2_surface_form(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith by_directions{.value = over_directions(rim()), .within = 1e-20};
  Finding finding;
  require_change_of_variables(finding);
  finding.require("Int cos cos'/d^2 over the disk", by_directions, over_disk());
  finding.control("Int 1/d^2 over the disk, without the cosines", by_directions, over_disk_without_cosines());
  return finding;
}

Finding section_2_apparent_size(const Bench&) {
  const BallPrecision precision(160);
  Finding finding;
  require_change_of_variables(finding);
  // All directions, before and behind.
  const Ball all = Ball(2) * solid_angle(Ball(0));
  finding.require("Int K over a surface about x", albedo(), all * factor_of_5());
  finding.control("the same with 1/(2 pi), half of the directions", albedo(), Ball(2) * all * factor_of_5());
  return finding;
}

}  // namespace radcert::verification::psg10
