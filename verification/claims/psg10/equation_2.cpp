// SPDX-License-Identifier: GPL-3.0-or-later

// The two forms of the transfer operator, and the albedo.
//
// Checked      By enclosed integrals, for light Z = 1: a point at height 1 above the middle of a disk of
//              radius 2 that faces it, all of it in sight. (2) integrates H over the directions, by the
//              cosine c of their angle; (4) G over the disk, by the distance u from its middle. With dv the
//              area on the unit sphere (4) is 1/(4 pi) of (2), and without the 1/(4 pi) of (5) the two agree;
//              with dv the mean over the sphere they agree as printed. The paper does not say which. The albedo: light 1 from all sides of a
//              surface, rho = 2 beta. (2) gives back 2 pi beta, (4) with (5) over a dome beta/2; an albedo
//              beta means beta. rho = beta/pi in (2) gives beta: with it (1) is the radiosity equation.
// Rejected     the same integrals without the cosines, of H = 1 and of 1/d^2.
// Not checked  other shapes: that dv = cos' dy/d^2 is a change of variables. V, which is 1 here. Surfaces
// that are not Lambertian.

#include "radcert/enclosure/interval_integral.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

Demand demand() { return {.radius = 1e-24}; }

Ball beta() { return Ball(Rational(9, 10)); }

/// Int H dv over the directions with a cosine between `least` and 1.
Ball over_directions(const Ball& least) {
  return ac98::known(
             integral_on_interval(line_function([](const auto& c) { return c; }), least, Ball(1), demand())) *
         Ball(2) * Ball::pi();
}

/// Int dv over the same directions: light that is received without Lambert's cosine.
Ball solid_angle(const Ball& least) {
  return ac98::known(integral_on_interval(line_function([](const auto& c) { return c - c + 1; }), least,
                                          Ball(1), demand())) *
         Ball(2) * Ball::pi();
}

/// Int cos cos'/d^2 dy over the disk of radius 2 at height 1, without the 1/(4 pi) of (5).
Ball over_disk() {
  const auto integrand = [](const auto& u) {
    const auto square = u * u + 1;
    return u / (square * square);
  };
  return ac98::known(integral_on_interval(line_function(integrand), Ball(0), Ball(2), demand())) * Ball(2) *
         Ball::pi();
}

/// Int dy/d^2 over the same disk: neither cosine.
Ball over_disk_without_cosines() {
  const auto integrand = [](const auto& u) { return u / (u * u + 1); };
  return ac98::known(integral_on_interval(line_function(integrand), Ball(0), Ball(2), demand())) * Ball(2) *
         Ball::pi();
}

/// The least cosine under which the disk is seen, 1/sqrt 5.
Ball rim() { return Ball(1) / sqrt(Ball(5)); }

Ball factor_of_5() { return Ball(1) / (Ball(4) * Ball::pi()); }

}  // namespace

Finding equation_2(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith albedo{.value = beta(), .within = 1e-20};
  const Ball all = over_directions(Ball(0));
  Finding finding;
  finding.require("light given back by (2), rho = 2 beta, beta = 9/10", albedo, Ball(2) * beta() * all);
  finding.instead("light given back by (2), rho = beta/pi", albedo, beta() / Ball::pi() * all);
  finding.control("light given back by (2), rho = beta/pi, H = 1", albedo,
                  beta() / Ball::pi() * solid_angle(Ball(0)));
  return finding;
}

Finding section_2_albedo(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith albedo{.value = beta(), .within = 1e-20};
  // On a dome of radius 1 about the point G = c/(4 pi) and dy = dv.
  const Ball dome = over_directions(Ball(0)) * factor_of_5();
  Finding finding;
  finding.require("light given back by (4) and (5), rho = 2 beta, beta = 9/10", albedo,
                  Ball(2) * beta() * dome);
  finding.instead("light given back by (4) and (5), rho = 4 beta", albedo, Ball(4) * beta() * dome);
  finding.control("light given back by (4) and (5), rho = 4 beta, H = 1", albedo,
                  Ball(4) * beta() * solid_angle(Ball(0)) * factor_of_5());
  return finding;
}

Finding section_2_radiosity(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith albedo{.value = beta(), .within = 1e-20};
  const Ball all = over_directions(Ball(0));
  Finding finding;
  finding.require("light given back by (2), rho = beta/pi, beta = 9/10", albedo, beta() / Ball::pi() * all);
  finding.require("light given back by (4) and (5), rho = 4 beta", albedo,
                  Ball(4) * beta() * all * factor_of_5());
  finding.control("light given back by (2), rho = beta/pi, H = 1", albedo,
                  beta() / Ball::pi() * solid_angle(Ball(0)));
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
  finding.remark("Int G over the disk less Int H dv, dv the area", ac98::proved(printed - by_area));
  finding.remark("Int G over the disk less Int H dv, dv the mean", ac98::proved(printed - by_mean));
  finding.instead("Int 4 pi G over the disk, (5) without the 1/(4 pi)", by_directions, over_disk());
  finding.control("Int 1/(4 pi d^2) over the disk, without the cosines", by_directions,
                  over_disk_without_cosines() * factor_of_5());
  return finding;
}

Finding section_2_surface_form(const Bench&) {
  const BallPrecision precision(160);
  const AgreesWith by_directions{.value = over_directions(rim()), .within = 1e-20};
  Finding finding;
  finding.require("Int cos cos'/d^2 over the disk", by_directions, over_disk());
  finding.control("Int 1/d^2 over the disk, without the cosines", by_directions, over_disk_without_cosines());
  return finding;
}

}  // namespace radcert::verification::psg10
