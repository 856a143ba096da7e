// SPDX-License-Identifier: GPL-3.0-or-later

// What (2) and (4) say of light that comes from behind, that depends on its direction, or that is in
// another's way.
//
// Checked      Translucent surfaces: light 1 from behind alone, H = n.v of (3) negative there: (2) gives the
//              surface less than nothing, and pi rho with |n.v|. Rejected: light -c from before. The
//              direction in (4): by (2) the light of y is that which leaves it along -v = y -> x. Of a disk
//              of radius 2 with Z(y,u) = max(0, n(y).u), seen from height 1 above its middle, that is 2 pi
//              Int c^2 dc; along x -> y, as (4) prints it, nothing arrives. Rejected: Z = 1. The first point
//              hit: a disk of radius b at the depth h, a smaller one of radius a before it at the depth g,
//              both about the axis that x is on, light 1 on the far one alone. Int cos cos'/d^2 over the part
//              of the disk from u_0 to b is pi (F(b) - F(u_0)), F(u) = u^2/(u^2 + h^2), as F' is twice the
//              integrand; V = 0 where the segment crosses the near disk, at the distance u g/h from the axis:
//              u_0 = a h/g. By directions the far disk is seen between the sines squared b^2/(b^2 + h^2) and
//              a^2/(a^2 + g^2). Both are the same for all a, b, g, h. Rejected: V = 1.
// Not checked  surfaces other than these.

#include <string>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;
using Derivative = Dual<Function>;

Function symbol(const std::string& name) { return Function::variable(name); }

Demand demand() { return {.radius = 1e-24}; }

/// 2 pi Int f(c) dc, light of all azimuths, by the cosine c.
template <class Light>
Ball over_cosines(const Light& f, const Ball& from, const Ball& to) {
  return Ball(2) * Ball::pi() * known(integral_on_interval(line_function(f), from, to, demand()));
}

/// 2 pi Int f(u) du over the disk of radius 2 at the depth 1.
template <class Light>
Ball over_disk(const Light& f) {
  return Ball(2) * Ball::pi() * known(integral_on_interval(line_function(f), Ball(0), Ball(2), demand()));
}

/// F(u) = u^2/(u^2 + h^2) in any arithmetic.
template <Field R>
R squared_sine(const R& u, const R& h) {
  return u * u / (u * u + h * h);
}

}  // namespace

Finding section_2_translucent(const Bench&) {
  const BallPrecision precision(160);
  const AtMost nothing_less{.value = 0, .slack = 0, .why = "light takes nothing away"};
  const auto minus_received = [](const auto& light, const Ball& from, const Ball& to) {
    return proved(-over_cosines(light, from, to));
  };
  Finding finding;
  finding.require("minus the light that arrives, light 1 from behind, H = n.v", nothing_less,
                  minus_received([](const auto& c) { return c; }, Ball(-1), Ball(0)));
  finding.instead("the same, H = |n.v|", nothing_less,
                  minus_received([](const auto& c) { return -c; }, Ball(-1), Ball(0)));
  finding.control("the same for light -c from before, H = n.v", nothing_less,
                  minus_received([](const auto& c) { return -(c * c); }, Ball(0), Ball(1)));
  return finding;
}

Finding section_2_direction(const Bench&) {
  const BallPrecision precision(160);
  const Ball rim = Ball(1) / sqrt(Ball(5));
  const AgreesWith by_directions{.value = over_cosines([](const auto& c) { return c * c; }, rim, Ball(1)),
                                 .within = 1e-20};
  // cos = cos' = 1/d, d^2 = u^2 + 1; Z = max(0, n(y).(y -> x)) = 1/d, or along x -> y max(0, -1/d).
  const auto towards_x = [](const auto& u) {
    const auto square = u * u + 1;
    return u / (square * square * sqrt(square));
  };
  const Ball along_v = -Ball(1) / sqrt(hull(Ball(1), Ball(5)));
  const Ball light_along_v = max(Ball(0), along_v);
  Finding finding;
  finding.require("light that arrives by (4), Z along x -> y", by_directions,
                  light_along_v * over_disk([](const auto& u) {
                    const auto square = u * u + 1;
                    return u / (square * square);
                  }));
  finding.instead("light that arrives by (4), Z along y -> x", by_directions, over_disk(towards_x));
  finding.control("light that arrives by (4), Z = 1", by_directions, over_disk([](const auto& u) {
                    const auto square = u * u + 1;
                    return u / (square * square);
                  }));
  return finding;
}

Finding section_2_first_hit(const Bench&) {
  const Function a = symbol("a");
  const Function b = symbol("b");
  const Function g = symbol("g");
  const Function h = symbol("h");
  const Function by_directions = squared_sine(b, h) - squared_sine(a, g);
  const auto over_surface = [&](const Function& from) { return squared_sine(b, h) - squared_sine(from, h); };
  // 2 u cos cos'/d^2, cos = cos' = h/d.
  const Derivative u(symbol("u"), 1, 0);
  const Function square = u.value * u.value + h * h;
  const Function integrand = Function(2) * u.value * h * h / (square * square);
  // F with u^2 + h in the denominator.
  const Derivative wrong = u * u / (u * u + Derivative(h));
  Finding finding;
  finding.require("terms in which the derivative of F differs from the integrand", IsExactly{0},
                  differing_terms(squared_sine(u, Derivative(h)).by_s, integrand));
  finding.control("the same, u^2 + h in the place of the squared distance", IsExactly{0},
                  differing_terms(wrong.by_s, integrand));
  finding.require("terms in which the surface's integral with V differs from that over directions",
                  IsExactly{0}, differing_terms(over_surface(a * h / g), by_directions));
  finding.control("the same with V = 1", IsExactly{0}, differing_terms(over_surface(0), by_directions));
  return finding;
}

}  // namespace radcert::verification::psg10
