// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/compactness/kernel_derivative.h"

#include "radcert/scalar/dual.h"
#include "verification/claims/ac98/surfaces/roof_pair.h"

namespace radcert::verification::ac98 {
namespace {

using D = Dual<Ball>;

// A and chord with their derivatives by x.
struct RoofCoefficients {
  D coefficient;
  D chord;
  RoofCoefficients(int p, const Ball& x, const Ball& xi) {
    const RoofPair<D> pair(p, D(x, Ball(1), Ball(0)), D(xi));
    coefficient = pair.bend_p * pair.bend_q / (pair.stretch_p * pair.stretch_q);
    chord = pair.chord;
  }
};

// The i-th of n equal parts of [low, high].
Ball part(long i, long n, const Rational& low, const Rational& high) {
  const Rational width = (high - low) / Rational(n);
  return widened(Ball(low + width * (Rational(i) + Rational(1, 2))), Ball(width / 2));
}

// G from (x, y, 0) on the square to (xi, y + e, 2 - xi^p) on the roof.
D between_the_pieces(int p, const D& x, const D& xi, const D& e) {
  const D d = xi - x;
  const D z = D(Ball(2)) - power(xi, p);
  const D square = d * d + e * e + z * z;
  const D steepness = Ball(p) * power(xi, p - 1);
  return z * (z + steepness * d) / (RoofPair<D>::stretch(p, xi) * square * square);
}

Ball steepest(const D& g) { return abs(g.by_s) + abs(g.by_t); }

}  // namespace

RoofKernel roof_kernel(int p, const Ball& x, const Ball& xi, const Ball& e) {
  const RoofCoefficients at(p, x, xi);
  const Ball& a = at.coefficient.value;
  const Ball& a_x = at.coefficient.by_s;
  const Ball& chord = at.chord.value;
  const Ball& chord_x = at.chord.by_s;
  const Ball d = xi - x;
  const Ball square = d * d * chord + e * e;
  const Ball third = power(square, 3);
  const Ball fourth = power(square, 4);
  return {.g = a * power(d, 4) / (square * square),
          .by_x = a_x * power(d, 4) / (square * square) - Ball(4) * a * power(d, 3) * e * e / third -
                  Ball(2) * a * power(d, 6) * chord_x / third,
          .by_y = Ball(4) * a * power(d, 4) * e / third,
          .by_x_and_y = Ball(4) * e *
                        (a_x * power(d, 4) / third +
                         a * (-Ball(4) * power(d, 3) / third + Ball(6) * power(d, 5) * chord / fourth -
                              Ball(3) * power(d, 6) * chord_x / fourth))};
}

KernelDerivativeBounds roof_derivative_bounds(int p) {
  const BallPrecision precision(64);
  constexpr long parts = 16;
  Ball a(0);
  Ball slope(0);
  Ball chord_slope(0);
  for (long i = 0; i < parts; ++i)
    for (long j = 0; j < parts; ++j) {
      const RoofCoefficients at(p, part(i, parts, 0, 1), part(j, parts, 0, 1));
      a = max(a, abs(at.coefficient.value).upper());
      slope = max(slope, abs(at.coefficient.by_s).upper());
      chord_slope = max(chord_slope, abs(at.coefficient.value * at.chord.by_s).upper());
    }
  const Ball diagonal = sqrt(Ball(2));
  return {.first = diagonal * (slope + Ball(2) * chord_slope) + Ball(3) * a,
          .second = Ball(4) * (diagonal * (slope + Ball(3) * chord_slope) + Ball(10) * a)};
}

Ball derivative_bound_between_the_pieces(int p) {
  const BallPrecision precision(64);
  constexpr long parts = 16;
  Ball largest(0);
  for (long i = 0; i < parts; ++i)
    for (long j = 0; j < parts; ++j)
      for (long k = 0; k < 2 * parts; ++k) {
        const Ball x = part(i, parts, 0, 1);
        const Ball xi = part(j, parts, 0, 1);
        const D e(part(k, 2 * parts, -1, 1), Ball(0), Ball(1));
        const D from_square = between_the_pieces(p, D(x, Ball(1), Ball(0)), D(xi), e);
        const D from_roof = between_the_pieces(p, D(x), D(xi, Ball(1), Ball(0)), e);
        largest = max(largest, max(steepest(from_square).upper(), steepest(from_roof).upper()));
      }
  return largest;
}

Ball lipschitz_bound(int p) {
  const Ball area_element = RoofPair<Ball>::stretch(p, Ball(1));
  const Ball over_the_square = Ball(2) * sqrt(Ball::pi());  // of 1/r
  return area_element *
         (roof_derivative_bounds(p).first * over_the_square + derivative_bound_between_the_pieces(p));
}

}  // namespace radcert::verification::ac98
