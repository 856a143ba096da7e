// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/surfaces/smooth_bounds.h"

#include <array>
#include <cmath>
#include <span>

#include "radcert/enclosure/domain_point.h"
#include "radcert/enclosure/maximum.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "verification/claims/ac98/surfaces/roof_pair.h"
#include "verification/claims/proved_number.h"

namespace radcert::verification::ac98 {
namespace {

using Parameters = ParameterPoint<Ball>;

// |cos theta_P|/|P-Q| and G for P = F(p), Q = F(p + w) through the library's chart.
struct PairValues {
  Ball cosine;
  Ball kernel;
};
PairValues values_at(const Chart& chart, const Parameters& p, const Parameters& w) {
  const ChartIn<Ball>& formula = chart.in<Ball>();
  const Chord<Ball> chord = formula.chord(p, w);
  const Vector<Ball> n_p = unit_normal(formula.frame(p));
  const Vector<Ball> n_q = unit_normal(formula.frame(p + w));
  return {.cosine = abs(dot(chord.bend_p, n_p)) / dot(chord.difference, chord.difference),
          .kernel = chord_kernel(chord, n_p, n_q)};
}

// A pair at which a function of x and xi is nearly largest: any pair is a lower bound. Lattices that shrink
// around the best pair so far.
struct LatticePair {
  Rational x;
  Rational xi;
};
template <class Function>
LatticePair nearly_largest(const Function& f) {
  constexpr long side = 8;
  LatticePair best{.x = Rational(1, 2), .xi = Rational(1, 2)};
  double largest = 0;
  Rational width(1, 2);
  const auto inside = [](const Rational& x) { return Rational(0) <= x && x <= Rational(1); };
  for (int round = 0; round < 10; ++round, width /= 4) {
    const LatticePair middle = best;
    for (long i = -side; i <= side; ++i)
      for (long j = -side; j <= side; ++j) {
        const LatticePair pair{.x = middle.x + Rational(i, side) * width,
                               .xi = middle.xi + Rational(j, side) * width};
        if (!inside(pair.x) || !inside(pair.xi)) continue;
        const double value = f(Ball(pair.x), Ball(pair.xi)).to_double();
        if (value > largest) {
          largest = value;
          best = pair;
        }
      }
  }
  // Q is not P: on the diagonal it goes a little aside.
  const Rational aside(1, 1L << 30);
  if (best.x == best.xi) best.xi += best.xi < Rational(1, 2) ? aside : -aside;
  return best;
}

// bend_p/(stretch_p chord) and the kernel, at e = 0.
template <class T>
T roof_cosine(int p, const T& x, const T& xi) {
  const RoofPair<T> pair(p, x, xi);
  return pair.bend_p / (pair.stretch_p * pair.chord);
}
template <class T>
T roof_kernel(int p, const T& x, const T& xi) {
  const RoofPair<T> pair(p, x, xi);
  return pair.bend_p * pair.bend_q / (pair.stretch_p * pair.stretch_q * pair.chord * pair.chord);
}

// The octant's unit vectors as e/|e|, e over the face of the octahedron, and a quotient of two quadratic
// forms there.
struct QuotientOnOctant {
  std::array<Rational, 3> numerator;
  std::array<Rational, 3> denominator;
  template <class T>
  T operator()(std::span<const T> x) const {
    const ParameterPoint<T> at = domain_point(ChartDomain::unit_triangle, x[0], x[1]);
    const T u = T(1) - (at.s + at.t);
    const auto form = [&](const std::array<Rational, 3>& q) {
      return from_rational<T>(q[0]) * u * u + from_rational<T>(q[1]) * at.s * at.s +
             from_rational<T>(q[2]) * at.t * at.t;
    };
    return form(numerator) / form(denominator);
  }
};

}  // namespace

SmoothBounds roof_bounds(int p, double radius) {
  const BallPrecision precision(128);
  const Demand demand{.radius = radius};
  const auto cosine = [p]<class T>(std::span<const T> x) -> T { return roof_cosine(p, x[0], x[1]); };
  const auto kernel = [p]<class T>(std::span<const T> x) -> T { return roof_kernel(p, x[0], x[1]); };
  const Chart roof = two_piece(p).charts[1];
  const auto at = [&](const LatticePair& pair) {
    const Ball half(Rational(1, 2));
    return values_at(roof, {Ball(pair.x), half}, {Ball(pair.xi - pair.x), Ball(0)});
  };
  const LatticePair for_cosine =
      nearly_largest([p](const Ball& x, const Ball& xi) { return roof_cosine(p, x, xi); });
  const LatticePair for_kernel =
      nearly_largest([p](const Ball& x, const Ball& xi) { return roof_kernel(p, x, xi); });
  return {.name = "the roof of two_piece(" + std::to_string(p) + ")",
          .cosine = known(maximum(cube_function(2, cosine), demand)),
          .kernel = known(maximum(cube_function(2, kernel), demand)),
          .cosine_pair = at(for_cosine).cosine,
          .kernel_pair = at(for_kernel).kernel};
}

SmoothBounds ellipsoid_bounds(const Rational& a, const Rational& b, const Rational& c, double radius) {
  const BallPrecision precision(128);
  const Demand demand{.radius = radius / 20};  // the bounds are products
  const std::array<Rational, 3> one{1, 1, 1};
  const std::array<Rational, 3> squares{a * a, b * b, c * c};
  const std::array<Rational, 3> inverse{1 / (a * a), 1 / (b * b), 1 / (c * c)};
  // With P = D u, h = D v |h|/|D v|, u and v on the sphere: 1/|AP|^2 = |u|^2/|D^-1 u|^2 and e.Ae = |v|^2/|D
  // v|^2.
  const Ball flattest = known(maximum(cube_function(2, QuotientOnOctant{one, inverse}), demand));
  const Ball sharpest = known(maximum(cube_function(2, QuotientOnOctant{one, squares}), demand));
  const Chart octant = ellipsoid(a, b, c).charts[0];
  const Ball step(Rational(1, 1L << 30));
  const PairValues pair = values_at(octant, {Ball(0), Ball(1)}, {Ball(0), -step});
  return {.name = "the ellipsoid (" + a.to_text() + "," + b.to_text() + "," + c.to_text() + ")",
          .cosine = sqrt(flattest) * sharpest / Ball(2),
          .kernel = flattest * sharpest * sharpest / Ball(4),
          .cosine_pair = pair.cosine,
          .kernel_pair = pair.kernel};
}

Ball largest_kernel_between_the_pieces(int p, double radius) {
  const BallPrecision precision(128);
  const auto kernel = [p]<class T>(std::span<const T> x) -> T {
    const T d = x[1] - x[0];
    const T z = T(2) - power(x[1], p);
    const T square = d * d + z * z;
    return z * (z + T(p) * power(x[1], p - 1) * d) / (RoofPair<T>::stretch(p, x[1]) * square * square);
  };
  return known(maximum(cube_function(2, kernel), {.radius = radius}));
}

}  // namespace radcert::verification::ac98
