// SPDX-License-Identifier: GPL-3.0-or-later

// G(P,Q) = 1/4 on the unit sphere, whatever P != Q.
//
// Checked      For all P and Q, exactly. Both points are given their stereographic coordinates,
//                P = (2a, 2b, a^2 + b^2 - 1) / (1 + a^2 + b^2),   Q likewise in c, d,   n_P = -P, n_Q = -Q.
//              Multiplied by the fourth powers of both denominators, 4 [(Q-P).n_P] [(P-Q).n_Q] - |P-Q|^4 is a
//              polynomial of degree 8 at most in each of a, b, c, d: it is of the second degree in P.P, P.Q
//              and Q.Q; P.P has degree 4 in a and in b over the square of its denominator, P.Q has degree 2
//              in each variable over both. A polynomial of degree 8 in each variable that vanishes on a grid
//              of 9^4 points is zero. The grid's P and Q differ, so that the kernel itself, in fractions,
//              must be 1/4 there. Stereographic coordinates leave out one point, which continuity takes in.
//              Beside that, the library's charts of the sphere: G by frames and by chords at random
//              parameters, enclosed in balls.
// Not checked  nothing is left of this statement.

#include <array>
#include <random>
#include <string>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

Vector<Rational> on_the_sphere(const Rational& a, const Rational& b) {
  const Rational squares = a * a + b * b;
  const Rational denominator = Rational(1) + squares;
  return {Rational(2) * a / denominator, Rational(2) * b / denominator,
          (squares - Rational(1)) / denominator};
}

/// How many of 9^4 pairs of points of a sphere have G other than 1/4.
long pairs_off_a_quarter(const Rational& radius) {
  constexpr long degree = 8;
  long count = 0;
  for (long i = 0; i <= degree; ++i)
    for (long j = 0; j <= degree; ++j) {
      const Vector<Rational> p = on_the_sphere(i, j);
      for (long k = 0; k <= degree; ++k)
        for (long l = 0; l <= degree; ++l) {
          // Halves: none of them is a whole number, as all coordinates of P are.
          const Vector<Rational> q = on_the_sphere(Rational(2 * k + 1, 2), Rational(2 * l + 1, 2));
          const Rational g = geometric_kernel(radius * p, -p, radius * q, -q);
          if (g != Rational(1, 4)) ++count;
        }
    }
  return count;
}

/// How many of random pairs on the library's charts have a G whose ball is wide or does not contain 1/4.
long chart_pairs_off_a_quarter(const Surface& surface, int pairs) {
  std::mt19937_64 bits(6);
  const auto unit = [&bits] { return Rational(static_cast<long>(1 + bits() % 997), 1999); };
  long count = 0;
  for (int pair = 0; pair < pairs; ++pair) {
    const ChartIn<Ball>& here = surface.charts[bits() % surface.charts.size()].in<Ball>();
    const ChartIn<Ball>& there = surface.charts[bits() % surface.charts.size()].in<Ball>();
    const ParameterPoint<Ball> p{Ball(unit()), Ball(unit())};
    const ParameterPoint<Ball> q{Ball(unit() + Rational(1, 9973)), Ball(unit())};
    const Frame<Ball> at_p = here.frame(p);
    const Frame<Ball> at_q = there.frame(q);
    const Ball by_frames = geometric_kernel(at_p.point, unit_normal(at_p), at_q.point, unit_normal(at_q));
    Ball g = by_frames;
    if (&here == &there)
      g = intersection(by_frames, chord_kernel(here.chord(p, q - p), unit_normal(at_p), unit_normal(at_q)));
    if (!g.contains(Rational(1, 4)) || !(g.radius() < 1e-20)) ++count;
  }
  return count;
}

}  // namespace

Finding lemma_1_d(const Bench& bench) {
  const int pairs = bench.budget == Budget::quick ? 2000 : 20000;
  Finding finding;
  finding.require("pairs of a grid of 9^4 on the unit sphere, in fractions, where G is not 1/4", IsExactly{0},
                  Rational(pairs_off_a_quarter(1)));
  finding.require("random pairs on the charts of the sphere whose enclosure of G is not 1/4", IsExactly{0},
                  Rational(chart_pairs_off_a_quarter(sphere(), pairs)));
  finding.control("the same grid on the sphere of radius 2, where G = 1/16", IsExactly{0},
                  Rational(pairs_off_a_quarter(2)));
  finding.control("random pairs on the ellipsoid with half axes 1, 1 and 1001/1000", IsExactly{0},
                  Rational(chart_pairs_off_a_quarter(ellipsoid(1, 1, Rational(1001, 1000)), 100)));
  finding.show({.value = 0.25, .radius = 0, .guaranteed = true});
  return finding;
}

}  // namespace radcert::verification::m06
