// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (21) against (2) with the inner normals of the catalogue's surface, as an identity of rational
//              functions: both are over |P-Q|^4, and the numerators are of degree 2 at most in each variable.
//              0 within one square. What the text adds: at x = xi = 1/2 the first factor is at most 1/2, and
//              1/2 for z = eta, where G = 1/(4 z^2) is unbounded.
// Not checked  nothing is left out.

#include "radcert/closed_form/two_squares.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Triple = Vector<Rational>;
const Triple& up_y() {
  static const Triple y{0, 1, 0};
  return y;
}
const Triple& up_z() {
  static const Triple z{0, 0, 1};
  return z;
}

Rational printed(const Rational& offset, const Rational& height, const Rational& distance) {
  const Rational squared = offset * offset + distance * distance + height * height;
  return height * distance / (squared * squared);
}

// How many of the two charts have another normal than the one that points into the quarter space y, z > 0.
Rational wrong_normals() {
  const BallPrecision precision(128);
  const Surface surface = two_squares();
  long count = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector<Ball> normal =
        unit_normal(surface.charts[k].in<Ball>().frame({Ball(Rational(1, 3)), Ball(Rational(1, 7))}));
    const Triple expected = k == 0 ? up_y() : up_z();
    const bool same = certainly_zero(normal.x - Ball(expected.x)) &&
                      certainly_zero(normal.y - Ball(expected.y)) &&
                      certainly_zero(normal.z - Ball(expected.z));
    if (!same) ++count;
  }
  return {count};
}

}  // namespace

Finding equation_21(const Bench&) {
  Finding finding;
  const Rational x(2, 7);
  const auto from_xz = [&](const Rational& s, const Rational& eta, const Rational& z) {
    return geometric_kernel<Rational>({x, 0, z}, up_y(), {x + s, eta, 0}, up_z());
  };
  const auto from_xy = [&](const Rational& s, const Rational& y, const Rational& zeta) {
    return geometric_kernel<Rational>({x, y, 0}, up_z(), {x + s, 0, zeta}, up_y());
  };
  const auto formula = [](const Rational& s, const Rational& a, const Rational& b) {
    return printed(s, a, b);
  };
  const auto library = [&](const Rational& s, const Rational& eta, const Rational& z) {
    return two_squares_kernel(x, z, x + s, eta);
  };
  finding.require("charts whose normal is not the inner one, +y and +z", IsExactly{0}, wrong_normals());
  finding.require("P in S_xz, Q in S_xy: points where (21) differs from (2)", IsExactly{0},
                  differing_points(from_xz, formula));
  finding.require("P in S_xy, Q in S_xz: points where (21) differs from (2)", IsExactly{0},
                  differing_points(from_xy, formula));
  finding.require("points where the library's kernel differs from (21)", IsExactly{0},
                  differing_points(library, formula));
  const auto zero = [](const Rational&, const Rational&, const Rational&) { return Rational(0); };
  finding.require("P, Q in S_xz: points where (2) is not 0", IsExactly{0},
                  differing_points(
                      [&](const Rational& s, const Rational& zeta, const Rational& z) {
                        return geometric_kernel<Rational>({x, 0, z}, up_y(), {x + s + 3, 0, zeta}, up_y());
                      },
                      zero));
  finding.require("P, Q in S_xy: points where (2) is not 0", IsExactly{0},
                  differing_points(
                      [&](const Rational& s, const Rational& eta, const Rational& y) {
                        return geometric_kernel<Rational>({x, y, 0}, up_z(), {x + s + 3, eta, 0}, up_z());
                      },
                      zero));
  // A square over a sum of squares, hence never negative.
  finding.require(
      "points where 1/2 - z eta/(eta^2 + z^2) differs from (eta - z)^2/(2 (eta^2 + z^2))", IsExactly{0},
      differing_points([](const Rational&, const Rational& eta,
                          const Rational& z) { return Rational(1, 2) - z * eta / (eta * eta + z * z); },
                       [](const Rational&, const Rational& eta, const Rational& z) {
                         return (eta - z) * (eta - z) / (2 * (eta * eta + z * z));
                       }));
  finding.require(
      "points with eta = z, x = xi where G differs from 1/(4 z^2)", IsExactly{0},
      differing_points([&](const Rational&, const Rational&, const Rational& z) { return from_xz(0, z, z); },
                       [](const Rational&, const Rational&, const Rational& z) { return 1 / (4 * z * z); }));
  finding.control("points where (21) with the first power of its denominator differs from (2)", IsExactly{0},
                  differing_points(from_xz, [](const Rational& s, const Rational& eta, const Rational& z) {
                    return z * eta / (s * s + eta * eta + z * z);
                  }));
  finding.control("points where (21) differs from (2) with a normal that points outwards", IsExactly{0},
                  differing_points(
                      [&](const Rational& s, const Rational& eta, const Rational& z) {
                        return geometric_kernel<Rational>({x, 0, z}, -up_y(), {x + s, eta, 0}, up_z());
                      },
                      formula));
  return finding;
}

}  // namespace radcert::verification::ac98
