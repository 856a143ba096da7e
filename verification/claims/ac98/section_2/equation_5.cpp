// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      equation_5, equation_6: that a constant exists for all pairs, by enclosing the least one: on
//              the roof of two_piece (p = 2, 3) and on two ellipsoids, where it is c/(2a^2) and c^2/(4a^4)
//              for the half axes a <= b <= c, by branch and bound from above and a pair of points of the
//              library's charts from below; on the sphere, where |cos theta_P| = |P-Q|/2 and G = 1/4, exactly
//              at rational points. Across an edge no constant serves: G = 1/(4 z^2) at P = (1/2,0,z), Q =
//              (1/2,z,0) of two_squares, exactly. equation_6: between the two pieces of two_piece, for all
//              pairs, as well.
// Not checked  other smooth surfaces.

#include <array>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/smooth_bounds.h"
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
    finding.control("the pair less nine tenths of the constant, " + bounds.name, AtMost{},
                    proved(pair - Ball(Rational(9, 10)) * constant));
    finding.control(of.across_name + ", less the constant of " + bounds.name, AtMost{},
                    proved(Ball(of.across) - constant.upper()));
  }
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
  finding.require("pairs of points of the sphere where cos theta_P differs from |P-Q|/2", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 4)).cosine);
  finding.control("pairs of points of the sphere where cos theta_P differs from |P-Q|/3", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 3), Rational(1, 4)).cosine);
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
  finding.require("pairs of points of the sphere where G differs from 1/4", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 4)).kernel);
  finding.control("pairs of points of the sphere where G differs from 1/2", IsExactly{0},
                  differing_on_the_sphere(Rational(1, 2), Rational(1, 2)).kernel);
  for (const long places : {1L, 10L, 100L, 1000000000L}) {
    const Rational z(1, places + 1);
    finding.require("4 z^2 G across the edge of two_squares, z = " + z.to_text(), IsExactly{1},
                    4 * z * z * kernel_across_the_edge(z));
  }
  return finding;
}

}  // namespace radcert::verification::ac98
