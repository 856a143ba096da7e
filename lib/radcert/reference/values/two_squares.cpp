// SPDX-License-Identifier: GPL-3.0-or-later

// The integrals of section 2.2 of ac98, without 1/pi: their closed forms, and the double integral of the
// kernel.
#include "radcert/closed_form/two_squares.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/reference/values/families.h"
#include "radcert/surface/catalogue/rectangle.h"

namespace radcert::reference::values {
namespace {

constexpr int digits_of_a_double_integral = 40;

/// P = (x, 0, z) with n_P = +y over the unit square of z = 0, whose inner normal is +z; the density is 1, xi
/// - x or eta.
enum class Factor { one, offset, distance };

Route by_double_integral(Factor factor) {
  return by_integral("double integral of the kernel by enclosed Gauss rules", digits_of_a_double_integral,
                     [factor](const Arguments& a, const Demand& demand) {
                       Surface surface;
                       surface.name = "square";
                       surface.charts.push_back(make_rectangle({.name = "square", .piece = "square"},
                                                               {0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
                       const DensityFormula q = density([&a, factor]<class R>(const DensityPoint<R>& at) {
                         switch (factor) {
                           case Factor::offset: return at.at.s - from_rational<R>(a[0]);
                           case Factor::distance: return at.at.t;
                           case Factor::one: break;
                         }
                         return R(1);
                       });
                       return kernel_integral(ExactObserver::off_surface({a[0], 0, a[1]}, {0, 1, 0}), surface,
                                              0, domain_polygon(surface.charts[0]), q, demand);
                     });
}

// A ball about 0 < x < 1 that reaches neither end, with as many bits as that takes.
Ball inside(const Rational& x) {
  for (long bits = BallPrecision::current();; bits *= 2) {
    const BallPrecision scope(bits);
    const Ball ball(x);
    if (certainly_positive(ball) && certainly_less(ball, Ball(1))) return ball;
  }
}

ValueFamily family(std::string name, const std::string& density, int equation, Factor factor,
                   Ball (TwoSquares<Ball>::*value)() const) {
  return {
      .name = std::move(name),
      .summary =
          "Int G " + density + " over one unit square from the point (x, 0, z) of the other, without 1/pi",
      .formula = "Int_0^1 Int_0^1 " + density + " z eta / [(x-xi)^2 + eta^2 + z^2]^2 dxi deta",
      .source = "ac98 (" + std::to_string(equation) + ")",
      .parameters = {strictly_between("x", "1/3", 0, 1), strictly_between("z", "1/7", 0, 1)},
      .route = by_formula(
          "closed form" + std::string(factor == Factor::distance ? ", its last integral by Clausen's" : ""),
          [value](const Arguments& a) { return (TwoSquares<Ball>(inside(a[0]), inside(a[1])).*value)(); }),
      .second_route = by_double_integral(factor)};
}

}  // namespace

Theme two_squares() {
  const Rational x(1, 3);
  const Rational z(1, 7);
  Theme theme;
  theme.families = {
      family("two_squares_one", "1", 22, Factor::one, &TwoSquares<Ball>::one),
      family("two_squares_offset", "(xi - x)", 23, Factor::offset, &TwoSquares<Ball>::offset),
      family("two_squares_distance", "eta", 24, Factor::distance, &TwoSquares<Ball>::distance),
  };
  theme.named = {
      {"two_squares_1", "two_squares_one", {x, z}},
      {"two_squares_1_near_the_edge", "two_squares_one", {x, Rational(1, 1000)}},
      {"two_squares_xi_minus_x", "two_squares_offset", {x, z}},
      {"two_squares_eta", "two_squares_distance", {x, z}},
      {"two_squares_eta_near_the_edge", "two_squares_distance", {x, Rational(1, 1000)}},
  };
  return theme;
}

}  // namespace radcert::reference::values
