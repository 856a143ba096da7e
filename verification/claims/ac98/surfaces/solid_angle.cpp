// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/solid_angle.h"

#include <array>

#include "radcert/geometry/vector.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"

namespace radcert::verification::ac98 {
namespace {

using Four = std::array<Rational, 4>;

Rational determinant(const Vector<Rational>& a, const Vector<Rational>& b, const Vector<Rational>& c) {
  return dot(cross(a, b), c);
}

// A change of r, or of a coordinate of w, alone.
struct Change {
  Rational r;
  Vector<Rational> w;
  explicit Change(std::size_t which)
      : r(which == 0 ? 1 : 0), w{which == 1 ? 1 : 0, which == 2 ? 1 : 0, which == 3 ? 1 : 0} {}
};

// Values of w, r and the changes where det(Q_1, Q_2, w) is not r^power det(w_1, w_2, w).
Rational differing_elements(int power) {
  constexpr long values = 4;
  Rational count = 0;
  for (std::size_t first = 0; first < 4; ++first)
    for (std::size_t second = 0; second < 4; ++second) {
      const Change one(first);
      const Change two(second);
      const auto direction = [](const Four& x) { return Vector<Rational>{x[0], x[1], x[2]}; };
      count += differing_on_grid<4>(
          values,
          [&](const Four& x) {
            const Vector<Rational> w = direction(x);
            return determinant(one.r * w + x[3] * one.w, two.r * w + x[3] * two.w, w);
          },
          [&](const Four& x) {
            Rational scaled = determinant(one.w, two.w, direction(x));
            for (int k = 0; k < power; ++k) scaled *= x[3];
            return scaled;
          });
    }
  return count;
}

// One coordinate of an identity in the coefficient of A, the two points and t.
template <class Left, class Right>
Rational differing_coordinates(const Left& left, const Right& right) {
  constexpr long values = 4;
  return differing_on_grid<4>(
      values, [&](const Four& x) { return x[0] * left(x[1], x[2], x[3]); },
      [&](const Four& x) { return x[0] * right(x[1], x[2], x[3]); });
}

}  // namespace

void require_kernel_by_directions(Finding& finding) {
  finding.require("elements where cos theta_Q dS_Q differs from r^2 dw", IsExactly{0}, differing_elements(2));
  finding.control("elements where it differs from r dw", IsExactly{0}, differing_elements(1));
}

void require_convex_ellipsoids(Finding& finding) {
  const auto chord = [](const Rational& half) {
    return [half](const Rational& p, const Rational& q, const Rational&) {
      return (q - p) * p + half * (q - p) * (q - p);
    };
  };
  const auto between = [](const Rational& p, const Rational& q, const Rational&) {
    return (q * q - p * p) / 2;
  };
  finding.require("points where h.AP + h.Ah/2 differs from (Q.AQ - P.AP)/2", IsExactly{0},
                  differing_coordinates(chord(Rational(1, 2)), between));
  finding.control("points where h.AP + h.Ah differs from it", IsExactly{0},
                  differing_coordinates(chord(1), between));
  finding.require("points where |P + r w|^2 - |P|^2, by A, differs from r (2 w.AP + r w.Aw)", IsExactly{0},
                  differing_coordinates([](const Rational& p, const Rational& w,
                                           const Rational& r) { return (p + r * w) * (p + r * w) - p * p; },
                                        [](const Rational& p, const Rational& w, const Rational& r) {
                                          return r * (2 * w * p + r * w * w);
                                        }));
  finding.require("points where |X|^2, by A, differs from (1-t) |P|^2 + t |Q|^2 - t(1-t) |h|^2", IsExactly{0},
                  differing_coordinates(
                      [](const Rational& p, const Rational& q, const Rational& t) {
                        const Rational x = (1 - t) * p + t * q;
                        return x * x;
                      },
                      [](const Rational& p, const Rational& q, const Rational& t) {
                        return (1 - t) * p * p + t * q * q - t * (1 - t) * (q - p) * (q - p);
                      }));
}

}  // namespace radcert::verification::ac98
