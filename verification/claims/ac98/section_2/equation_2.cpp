// SPDX-License-Identifier: GPL-3.0-or-later

// By the law of cosines in the triangle P, P + n_P, Q, with d = Q - P and a unit vector n_P, 2 |d| cos
// theta_P = 1 + |d|^2 - |d - n_P|^2, which knows no inner product of n_P and Q - P, and likewise at Q with
// -d. The second form of (2) is linear in each normal.
//
// Checked      for all P, Q and normals: |n|^2 + |d|^2 - |d - n|^2 = 2 n.d, so that cos theta_P cos theta_Q =
//              (n_P.d)(n_Q.(-d))/|d|^2; and |d|^4 times the library's kernel is (n_P.d)(n_Q.(-d)), for
//              normals along the axes, which is enough. Beside that (21), written out here, on two_squares.
// Not checked  that G is what radiometry asks for.

#include <array>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Point = Vector<Rational>;
using Six = std::array<Rational, 6>;

Point first(const Six& x) { return {x[0], x[1], x[2]}; }
Point second(const Six& x) { return {x[3], x[4], x[5]}; }

// Vectors n and d where |n|^2 + |d|^2 - |d - n|^2 is not so many times n.d.
Rational wrong_cosines(long multiple) {
  constexpr long values = 3;
  return differing_on_grid<6>(
      values,
      [](const Six& x) {
        const Point n = first(x);
        const Point d = second(x);
        return dot(n, n) + dot(d, d) - dot(d - n, d - n);
      },
      [multiple](const Six& x) { return multiple * dot(first(x), second(x)); });
}

// P and Q, with normals along axes, where |d|^power G is not sign (n_P.d)(n_Q.(-d)).
Rational differing_pairs(long half_power, const Rational& sign) {
  const std::array<Point, 3> axes{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  constexpr long values = 3;
  Rational count = 0;
  for (const Point& n_p : axes)
    for (const Point& n_q : axes)
      count += differing_on_grid<6>(
          values,
          [&](const Six& x) {
            const Point d = second(x) - first(x);
            Rational kernel = geometric_kernel(first(x), n_p, second(x), n_q);
            for (long k = 0; k < half_power; ++k) kernel *= dot(d, d);
            return kernel;
          },
          [&](const Six& x) {
            const Point d = second(x) - first(x);
            return sign * dot(n_p, d) * dot(n_q, -d);
          });
  return count;
}

// Pairs of two_squares at which the kernel differs from (21).
Rational differing_on_two_squares() {
  long count = 0;
  for (long i = 1; i < 6; ++i)
    for (long j = 1; j < 6; ++j)
      for (long k = 1; k < 6; ++k) {
        const Rational x(i, 7);
        const Rational z(j, 9);
        const Rational eta(k, 11);
        const Rational xi(3, 8);
        const Rational square = (x - xi) * (x - xi) + eta * eta + z * z;
        const Rational kernel = geometric_kernel<Rational>({x, 0, z}, {0, 1, 0}, {xi, eta, 0}, {0, 0, 1});
        if (kernel != z * eta / (square * square)) ++count;
      }
  return {count};
}

}  // namespace

Finding equation_2(const Bench&) {
  Finding finding;
  finding.require("vectors where |n|^2 + |d|^2 - |d - n|^2 differs from 2 n.d", IsExactly{0},
                  wrong_cosines(2));
  finding.control("vectors where it differs from n.d", IsExactly{0}, wrong_cosines(1));
  finding.require("pairs where |P-Q|^4 times the library's kernel differs from [(Q-P).n_P][(P-Q).n_Q]",
                  IsExactly{0}, differing_pairs(2, 1));
  finding.require("pairs of two_squares, of 125, where it differs from (21)", IsExactly{0},
                  differing_on_two_squares());
  finding.control("pairs where |P-Q|^2 times the kernel differs from it", IsExactly{0},
                  differing_pairs(1, 1));
  finding.control("pairs where the kernel has the other sign", IsExactly{0}, differing_pairs(2, -1));
  return finding;
}

}  // namespace radcert::verification::ac98
