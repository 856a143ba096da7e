// SPDX-License-Identifier: GPL-3.0-or-later

// G >= 0, so that the norm of K on C(S) is max_P rho(P)/pi Int G. On a closed surface the integral is pi
// everywhere and the norm is that of rho: the bound is sharp there, for every rho, and (16) cannot be spared,
// as K 1 = 1 for rho = 1. On other surfaces it is not necessary.
//
// Checked      the norm of K on two_piece (p = 2, 3) for rho = 1 and 9/10, enclosed over all P, and its order
//              among the norm of rho and 1; equality on the cube at points, and (I - K) 1 = 0 there for rho =
//              1, which the last inequality rejects.
// Not checked  compactness.

#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/ac98/surfaces/two_piece_total.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding equation_17(const Bench& bench) {
  const double radius = bench.budget == Budget::quick ? 1e-3 : bench.budget == Budget::standard ? 1e-4 : 1e-6;
  const BallPrecision precision(128);
  Finding finding;
  const AtMost clearly_below_zero{.value = -0x1p-20, .slack = 0, .why = "(17) ends in a strict inequality"};
  Ball shown;
  for (const int p : {2, 3}) {
    const std::string of = ", two_piece(" + std::to_string(p) + ")";
    const Ball total = largest_total(p, radius);
    const Ball norm = total / Ball::pi();
    const Ball nine_tenths(Rational(9, 10));
    finding.require("norm of K - 9/10 for rho = 9/10" + of, AtMost{},
                    proved(nine_tenths * norm - nine_tenths));
    finding.require("norm of K - 1 for rho = 9/10" + of, clearly_below_zero,
                    proved(nine_tenths * norm - Ball(1)));
    finding.require("norm of K - 1 for rho = 1" + of, clearly_below_zero, proved(norm - Ball(1)));
    finding.remark("norm of K for rho = 1" + of, proved(norm));
    finding.control("norm of K - a tenth of the norm of rho, rho = 1" + of, AtMost{},
                    proved(norm - Ball(Rational(1, 10))));
    if (p == 2) shown = norm;
  }
  const Polyhedron cube = cube_polyhedron();
  const Rational third(1, 3);
  const Ball mean =
      total_factor(cube, floor_face, {third, Rational(1, 5), 0}, 1 / power(Rational(10), 30)) / Ball::pi();
  for (const Rational& rho : {Rational(1, 10), Rational(99, 100)}) {
    const std::string with = ", cube, rho = " + rho.to_text();
    finding.require("K 1 at a point against the norm of rho" + with,
                    AgreesWith{.value = Ball(rho), .within = 1e-25}, Ball(rho) * mean);
    finding.require("K 1 at a point - 1" + with, clearly_below_zero, proved(Ball(rho) * mean - Ball(1)));
    finding.control("K 1 at a point, of the kernel without 1/pi, against the norm of rho" + with,
                    AgreesWith{.value = Ball(rho), .within = 1e-25}, Ball(rho) * mean * Ball::pi());
  }
  finding.require("(I - K) 1 for rho = 1 at a point of the cube",
                  AgreesWith{.value = Ball(0), .within = 1e-25}, Ball(1) - mean);
  finding.control("norm of K - 1 for rho = 1, cube, which (16) excludes", clearly_below_zero,
                  proved(mean - Ball(1)));
  finding.show(proved(shown));
  return finding;
}

}  // namespace radcert::verification::ac98
