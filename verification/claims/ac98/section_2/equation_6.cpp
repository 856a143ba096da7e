// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      that a constant exists for all pairs, by enclosing the least one: on the roof of two_piece (p
//              = 2, 3) and on two ellipsoids, where it is c^2/(4a^4) for the half axes a <= b <= c, by branch
//              and bound from above and a pair of points of the library's charts from below; on the sphere,
//              where G = 1/4, exactly at rational points; between the two pieces of two_piece, for all pairs.
//              Across an edge G is unbounded: G = 1/(4 z^2) at P = (1/2,0,z), Q = (1/2,z,0) of two_squares,
//              exactly.
// Not checked  other smooth surfaces.

#include <array>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

Rational across_the_edge(const Rational& z) {
  const Rational half(1, 2);
  return two_squares_kernel(half, z, half, z);
}

}  // namespace

Finding equation_6(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-5 : bench.budget == Budget::standard ? 1e-6 : 1e-8;
  // The ellipsoid's constant is a product, whose relative error is that of its factors together.
  const double within = 20 * radius;
  Finding finding;
  const BallPrecision precision(128);
  const SmoothBounds quadratic_roof = roof_bounds(2, radius);
  const SmoothBounds cubic_roof = roof_bounds(3, radius);
  std::vector<SmoothBounds> all{quadratic_roof, cubic_roof};
  const std::string closed = "the closed form of the least constant, ";
  for (const auto& [a, b, c] :
       {std::array<Rational, 3>{1, 2, 5}, {Rational(2, 3), Rational(1), Rational(5, 4)}}) {
    all.push_back(ellipsoid_bounds(a, b, c, radius));
    const AgreesWith least{.value = Ball(c * c / (4 * a * a * a * a)), .within = within};
    finding.require(closed + all.back().name, least, all.back().kernel);
  }
  for (const SmoothBounds& bounds : all) {
    finding.require("largest G over all pairs, against one pair, " + bounds.name,
                    AgreesWith{.value = bounds.kernel_pair, .within = within}, bounds.kernel);
    finding.require("the pair less the constant, with the constant's error, " + bounds.name, AtMost{},
                    proved(bounds.kernel_pair - bounds.kernel.upper()));
    finding.control("the pair less nine tenths of the constant, " + bounds.name, AtMost{},
                    proved(bounds.kernel_pair - Ball(Rational(9, 10)) * bounds.kernel));
    finding.control("G across the edge of two_squares, z = 1/1000, less the constant of " + bounds.name,
                    AtMost{}, proved(Ball(across_the_edge(Rational(1, 1000))) - bounds.kernel.upper()));
  }
  finding.require(closed + quadratic_roof.name, AgreesWith{.value = Ball(1), .within = within},
                  quadratic_roof.kernel);
  for (const int p : {2, 3})
    finding.require("largest G between the pieces of two_piece(" + std::to_string(p) + "), less 1", AtMost{},
                    proved(largest_kernel_between_the_pieces(p, radius) - Ball(1)));
  finding.require("pairs of points of the sphere where G differs from 1/4", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 4)).kernel);
  finding.control("pairs of points of the sphere where G differs from 1/2", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 2)).kernel);
  for (const long places : {1L, 10L, 100L, 1000000000L}) {
    const Rational z(1, places + 1);
    finding.require("4 z^2 G across the edge of two_squares, z = " + z.to_text(), IsExactly{1},
                    4 * z * z * across_the_edge(z));
  }
  finding.show(proved(cubic_roof.kernel));
  return finding;
}

}  // namespace radcert::verification::ac98
