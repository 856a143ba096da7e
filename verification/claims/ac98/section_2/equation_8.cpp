// SPDX-License-Identifier: GPL-3.0-or-later

// (8) and (9) together: Int_S G = Int_(S_e) G + Int_(T_e) G + Int_(U_e) G, where the first integral, of a
// field without divergence, is zero. S_e is S without T_e, and U_e with its normal reversed: Int_(S-T) G =
// Int_U G.
//
// Checked      div v = 0 for all Q and all n_P, as an identity of rational functions: n_P enters linearly,
//              and degree 3 over |Q-P|^6 is below that of the grid. v . n_Q = G for all Q and both normals.
//              (8) and (9) at the tip of the ellipsoid (1,2,5) and on the sphere, each part an enclosure of
//              its own, for five radii.
// Not checked  the divergence theorem itself.

#include <array>

#include "radcert/geometry/vector.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/excluded_ball.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// v = (h.n) (-h)/|h|^(2 half_power), h = Q - P.
template <class T>
Vector<T> field(const Vector<T>& h, const Vector<T>& n, int half_power) {
  T factor = dot(h, n);
  for (int k = 0; k < half_power; ++k) factor = factor / dot(h, h);
  return -(factor * h);
}

Rational divergence(const Rational& x, const Rational& y, const Rational& z, std::size_t axis,
                    int half_power) {
  using D = Dual<Rational>;
  std::array<Rational, 3> unit{0, 0, 0};
  unit.at(axis) = 1;
  const Vector<D> n{D(unit[0]), D(unit[1]), D(unit[2])};
  const Vector<D> first = field<D>({D(x, 1, 0), D(y, 0, 1), D(z)}, n, half_power);
  const Vector<D> second = field<D>({D(x), D(y), D(z, 1, 0)}, n, half_power);
  return first.x.by_s + first.y.by_t + second.z.by_s;
}

Rational points_with_divergence(std::size_t axis, int half_power) {
  return differing_points([=](const Rational& x, const Rational& y,
                              const Rational& z) { return divergence(x, y, z, axis, half_power); },
                          [](const Rational&, const Rational&, const Rational&) { return Rational(0); });
}

// Both sides are linear in each normal: normals along the axes are enough.
Rational points_where_the_flux_differs(const Rational& sign) {
  const std::array<Vector<Rational>, 3> axes{Vector<Rational>{1, 0, 0}, Vector<Rational>{0, 1, 0},
                                             Vector<Rational>{0, 0, 1}};
  Rational count = 0;
  for (const Vector<Rational>& n_p : axes)
    for (const Vector<Rational>& n_q : axes)
      count += differing_points(
          [&](const Rational& x, const Rational& y, const Rational& z) {
            return sign * dot(field<Rational>({x, y, z}, n_p, 2), n_q);
          },
          [&](const Rational& x, const Rational& y, const Rational& z) {
            return geometric_kernel<Rational>({0, 0, 0}, n_p, {x, y, z}, n_q);
          });
  return count;
}

}  // namespace

Finding equation_8(const Bench&) {
  Finding finding;
  const std::array<std::string, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    finding.require("points where div v is not 0, n_P along " + axes.at(axis), IsExactly{0},
                    points_with_divergence(axis, 2));
  finding.control("points where div v is not 0 with |P-Q|^6 for |P-Q|^4", IsExactly{0},
                  points_with_divergence(0, 3));
  finding.require("points where v . n_Q differs from G", IsExactly{0}, points_where_the_flux_differs(1));
  finding.control("points where v . n_Q differs from G, the normal at Q pointing outwards", IsExactly{0},
                  points_where_the_flux_differs(-1));
  const BallPrecision precision(192);
  constexpr double error = 1e-32;
  constexpr double within = 1e-30;
  for (const auto& [name, tip] :
       {std::pair<std::string, EllipsoidTip>{"ellipsoid (1,2,5)", {1, 2, 5}}, {"sphere", {1, 1, 1}}})
    for (const Rational& radius :
         {Rational(3, 2), Rational(1), Rational(1, 10), Rational(1, 1000), Rational(1, 1000000)}) {
      const std::string at = ", " + name + ", epsilon = " + radius.to_text();
      const Ball cap = tip.over_cap(radius, error);
      const Ball rest = tip.over_rest(radius, error);
      const Ball sphere = tip.over_sphere(radius, error);
      const AgreesWith pi{.value = Ball::pi(), .within = within};
      finding.require("Int_(S-T) G + Int_T G" + at, pi, rest + cap);
      finding.require("(9): Int_T G + Int_U G" + at, pi, cap + sphere);
      finding.require("Int_(S-T) G, against Int_U G: nothing flows through S_epsilon" + at,
                      AgreesWith{.value = sphere, .within = within}, rest);
      // Parts that do not fit together: T_epsilon with U of half the radius, which leaves a gap.
      finding.control("Int_T G + Int_U G, U of the radius epsilon/2" + at, pi,
                      cap + tip.over_sphere(radius / 2, error));
      finding.control("Int_(S-T) G, T of the radius epsilon/2, against Int_U G" + at,
                      AgreesWith{.value = sphere, .within = within}, tip.over_rest(radius / 2, error));
    }
  return finding;
}

}  // namespace radcert::verification::ac98
