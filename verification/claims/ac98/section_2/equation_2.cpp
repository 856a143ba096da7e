// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      the two forms of (2) with each other and with the library's kernel, exactly, at pairs of
//              points with rational coordinates and unit normals whose distance is rational. The cosines come
//              from the law of cosines in the triangle P, P + n_P, Q, and know no inner product of n_P and Q
//              - P. Beside that (21), written out here, on two_squares.
// Not checked  that G is what radiometry asks for.

#include <array>
#include <vector>

#include "radcert/kernel/geometric_kernel.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

using Point = Vector<Rational>;

// The unit vectors (2u, 2v, 1 - u^2 - v^2)/(1 + u^2 + v^2), some of them and their negatives.
std::vector<Point> unit_vectors() {
  std::vector<Point> vectors;
  for (const auto& [u, v] : {std::array<Rational, 2>{0, 0},
                             {Rational(1), 0},
                             {Rational(1, 2), Rational(1, 3)},
                             {Rational(-2, 7), Rational(5, 4)},
                             {Rational(3, 5), Rational(-8, 3)}}) {
    const Rational squared = u * u + v * v;
    const Rational inverse = 1 / (1 + squared);
    const Point vector{2 * u * inverse, 2 * v * inverse, (1 - squared) * inverse};
    vectors.push_back(vector);
    vectors.push_back(-vector);
  }
  return vectors;
}

// cos of the angle between the unit vector n and d, |d| = length, by the law of cosines.
Rational cosine(const Point& n, const Point& d, const Rational& length) {
  const Point side = d - n;
  return (1 + length * length - dot(side, side)) / (2 * length);
}

// Pairs at which the kernel differs from sign cos theta_P cos theta_Q / |P-Q|^exponent.
Rational differing_pairs(long exponent, const Rational& sign) {
  long count = 0;
  const Point p{Rational(1, 3), Rational(-2, 5), Rational(7, 2)};
  for (const Rational& length : {Rational(1, 100), Rational(2, 3), Rational(50)})
    for (const Point& direction : unit_vectors())
      for (const Point& n_p : unit_vectors())
        for (const Point& n_q : unit_vectors()) {
          const Point d = length * direction;
          Rational first = sign * cosine(n_p, d, length) * cosine(n_q, -d, length);
          for (long k = 0; k < exponent; ++k) first /= length;
          if (first != geometric_kernel(p, n_p, p + d, n_q)) ++count;
        }
  return {count};
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
  finding.require(
      "pairs, of 3000, where the kernel of the library differs from cos theta_P cos theta_Q / |P-Q|^2",
      IsExactly{0}, differing_pairs(2, 1));
  finding.require("pairs of two_squares, of 125, where it differs from (21)", IsExactly{0},
                  differing_on_two_squares());
  finding.control("pairs where it differs from cos theta_P cos theta_Q / |P-Q|", IsExactly{0},
                  differing_pairs(1, 1));
  finding.control("pairs where it differs from -cos theta_P cos theta_Q / |P-Q|^2", IsExactly{0},
                  differing_pairs(2, -1));
  return finding;
}

}  // namespace radcert::verification::ac98
