// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      that a constant exists for all pairs, by enclosing the least one: on the roof of two_piece (p
//              = 2, 3) and on two ellipsoids, where it is c/(2a^2) for the half axes a <= b <= c, by branch
//              and bound from above and a pair of points of the library's charts from below; on the sphere,
//              where |cos theta_P| = |P-Q|/2, exactly at rational points. Across an edge no constant serves.
// Not checked  other smooth surfaces.

#include <array>
#include <vector>

#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// |cos theta_P|/|P-Q| on two_squares for P = (1/2,0,z), Q = (1/2,eta,0): (Q-P).n_P = eta.
Rational across_the_edge(const Rational& z, const Rational& eta) { return eta / (eta * eta + z * z); }

}  // namespace

Finding equation_5(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-5 : bench.budget == Budget::standard ? 1e-6 : 1e-8;
  const double within = 4 * radius;
  Finding finding;
  const BallPrecision precision(128);
  const SmoothBounds quadratic_roof = roof_bounds(2, radius);
  const SmoothBounds cubic_roof = roof_bounds(3, radius);
  std::vector<SmoothBounds> all{quadratic_roof, cubic_roof};
  const std::string closed = "the closed form of the least constant, ";
  for (const auto& [a, b, c] :
       {std::array<Rational, 3>{1, 2, 5}, {Rational(2, 3), Rational(1), Rational(5, 4)}}) {
    all.push_back(ellipsoid_bounds(a, b, c, radius));
    const AgreesWith least{.value = Ball(c / (2 * a * a)), .within = within};
    finding.require(closed + all.back().name, least, all.back().cosine);
  }
  for (const SmoothBounds& bounds : all) {
    finding.require("largest |cos theta_P|/|P-Q| over all pairs, against one pair, " + bounds.name,
                    AgreesWith{.value = bounds.cosine_pair, .within = within}, bounds.cosine);
    const Ball less = Ball(Rational(9, 10)) * bounds.cosine;
    finding.control("the pair less nine tenths of the constant, " + bounds.name, AtMost{},
                    proved(bounds.cosine_pair - less));
    finding.require("the pair less the constant, with the constant's error, " + bounds.name, AtMost{},
                    proved(bounds.cosine_pair - bounds.cosine.upper()));
    const Rational close = Rational(1, 1000);
    finding.control("|cos theta_P|/|P-Q| across the edge of two_squares, less the constant of " + bounds.name,
                    AtMost{}, proved(Ball(across_the_edge(close, close)) - bounds.cosine.upper()));
  }
  finding.require(closed + quadratic_roof.name, AgreesWith{.value = Ball(1), .within = within},
                  quadratic_roof.cosine);
  finding.require("pairs of points of the sphere where cos theta_P differs from |P-Q|/2", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 4)).cosine);
  finding.control("pairs of points of the sphere where cos theta_P differs from |P-Q|/3", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 3), Rational(1, 4)).cosine);
  finding.show(proved(cubic_roof.cosine));
  return finding;
}

}  // namespace radcert::verification::ac98
