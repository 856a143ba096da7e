// SPDX-License-Identifier: GPL-3.0-or-later

// On the ellipsoid with half axes a <= b <= c and A = diag(a^-2, b^-2, c^-2), h = Q - P = |h| e: |cos
// theta_P|/|P-Q| = e.Ae/(2|AP|), ellipsoids.h, and |G| = (e.Ae)^2/(4 |AP| |AQ|). Here e.Ae <= 1/a^2 and |AP|
// >= 1/c, so that c/(2a^2) and c^2/(4a^4) serve. No less does: with P = (0,0,c) and Q in the plane of the
// axes a and c, at the angle whose half has the tangent t, the quotient of (5) is c/(2a^2) - c t^2 (c^2 -
// a^2)/(2a^2 (a^2 + c^2 t^2)).
//
// Checked      equation_5, equation_6: that a constant exists for all pairs. On all ellipsoids, the sphere
//              among them: these identities, with the signs of their terms. By enclosing the least constant
//              on the roof of two_piece (p = 2, 3), from above by branch and bound and from below by a pair
//              of points of the library's charts, and on two ellipsoids. equation_6: between the two pieces
//              of two_piece, for all pairs, as well. Across an edge no constant serves: G = 1/(4 z^2) at P =
//              (1/2,0,z), Q = (1/2,z,0) of two_squares, exactly.
// Not checked  other smooth surfaces.

#include <array>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "radcert/geometry/vector.h"
#include "verification/claims/ac98/convex_bodies/ellipsoids.h"
#include "verification/claims/ac98/surfaces/exact_identity.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// |cos theta_P|/|P-Q| on two_squares for P = (1/2,0,z), Q = (1/2,eta,0): (Q-P).n_P = eta.
Rational cosine_across_the_edge(const Rational& z, const Rational& eta) { return eta / (eta * eta + z * z); }

Rational kernel_across_the_edge(const Rational& z) {
  const Rational half(1, 2);
  return two_squares_kernel(half, z, half, z);
}

// A quotient or kernel that is bounded on smooth surfaces, and not across an edge.
struct Bounded {
  std::string name;
  Ball SmoothBounds::*constant;
  Ball SmoothBounds::*pair;
  Rational (*of_ellipsoid)(const Rational& a, const Rational& c);
  std::string across_name;
  Rational across;
  double within;
};

double radius_of(const Bench& bench) {
  return bench.budget == Budget::quick ? 1e-5 : bench.budget == Budget::standard ? 1e-6 : 1e-8;
}

// The identities at the head of this file.
void require_ellipsoids(Finding& finding) {
  require_bounds_on_ellipsoids(finding);
  using Three = std::array<Rational, 3>;
  constexpr long values = 8;
  // P = (0,0,c) and Q = (a sin, 0, c cos), whose inner normal at P is (0,0,-1).
  const auto quotient = [](const Three& x) {
    const auto& [a, c, t] = x;
    const Rational square = 1 + t * t;
    const Vector<Rational> h{2 * a * t / square, 0, c * (1 - t * t) / square - c};
    return -h.z / dot(h, h);
  };
  const auto approached = [](const Rational& sign) {
    return [sign](const Three& x) {
      const auto& [a, c, t] = x;
      return c / (2 * a * a) + sign * c * t * t * (c * c - a * a) / (2 * a * a * (a * a + c * c * t * t));
    };
  };
  finding.require("pairs where cos theta_P/|P-Q| differs from c/(2a^2) less a multiple of t^2", IsExactly{0},
                  differing_on_grid<3>(values, quotient, approached(-1)));
  finding.control("pairs where it differs from c/(2a^2) with that multiple added", IsExactly{0},
                  differing_on_grid<3>(values, quotient, approached(1)));
}

void require_constants(Finding& finding, const Bounded& of, double radius) {
  const SmoothBounds quadratic_roof = roof_bounds(2, radius);
  const SmoothBounds cubic_roof = roof_bounds(3, radius);
  std::vector<SmoothBounds> all{quadratic_roof, cubic_roof};
  const std::string closed = "the closed form of the least constant, ";
  for (const auto& [a, b, c] :
       {std::array<Rational, 3>{1, 2, 5}, {Rational(2, 3), Rational(1), Rational(5, 4)}}) {
    all.push_back(ellipsoid_bounds(a, b, c, radius));
    const AgreesWith least{.value = Ball(of.of_ellipsoid(a, c)), .within = of.within};
    finding.require(closed + all.back().name, least, all.back().*of.constant);
  }
  for (const SmoothBounds& bounds : all) {
    const Ball& constant = bounds.*of.constant;
    const Ball& pair = bounds.*of.pair;
    finding.require("largest " + of.name + " over all pairs, against one pair, " + bounds.name,
                    AgreesWith{.value = pair, .within = of.within}, constant);
    finding.require("the pair less the constant, with the constant's error, " + bounds.name, AtMost{},
                    proved(pair - constant.upper()));
    finding.control(of.across_name + ", less the constant of " + bounds.name, AtMost{},
                    proved(Ball(of.across) - constant.upper()));
  }
  finding.control("c/(2a^2), c^2/(4a^4) with the middle axis for c, the ellipsoid (1,2,3)",
                  AgreesWith{.value = Ball(of.of_ellipsoid(1, 2)), .within = of.within},
                  ellipsoid_bounds(1, 2, 3, radius).*of.constant);
  finding.require(closed + quadratic_roof.name, AgreesWith{.value = Ball(1), .within = of.within},
                  quadratic_roof.*of.constant);
  finding.show(proved(cubic_roof.*of.constant));
}

}  // namespace

Finding equation_5(const Bench& bench) {
  const double radius = radius_of(bench);
  Finding finding;
  const BallPrecision precision(128);
  const Rational close(1, 1000);
  require_constants(finding,
                    {.name = "|cos theta_P|/|P-Q|",
                     .constant = &SmoothBounds::cosine,
                     .pair = &SmoothBounds::cosine_pair,
                     .of_ellipsoid = [](const Rational& a, const Rational& c) { return c / (2 * a * a); },
                     .across_name = "|cos theta_P|/|P-Q| across the edge of two_squares",
                     .across = cosine_across_the_edge(close, close),
                     .within = 4 * radius},
                    radius);
  require_ellipsoids(finding);
  return finding;
}

Finding equation_6(const Bench& bench) {
  const double radius = radius_of(bench);
  Finding finding;
  const BallPrecision precision(128);
  // The ellipsoid's constant is a product, whose relative error is that of its factors together.
  require_constants(
      finding,
      {.name = "G",
       .constant = &SmoothBounds::kernel,
       .pair = &SmoothBounds::kernel_pair,
       .of_ellipsoid = [](const Rational& a, const Rational& c) { return c * c / (4 * a * a * a * a); },
       .across_name = "G across the edge of two_squares, z = 1/1000",
       .across = kernel_across_the_edge(Rational(1, 1000)),
       .within = 20 * radius},
      radius);
  for (const int p : {2, 3})
    finding.require("largest G between the pieces of two_piece(" + std::to_string(p) + "), less 1", AtMost{},
                    proved(largest_kernel_between_the_pieces(p, radius) - Ball(1)));
  require_ellipsoids(finding);
  finding.require("points with P = (1/2,0,z), Q = (1/2,z,0) of two_squares where G differs from 1/(4 z^2)",
                  IsExactly{0},
                  differing_on_grid<1>(
                      5, [](const std::array<Rational, 1>& x) { return kernel_across_the_edge(x[0]); },
                      [](const std::array<Rational, 1>& x) { return 1 / (4 * x[0] * x[0]); }));
  return finding;
}

}  // namespace radcert::verification::ac98
