// SPDX-License-Identifier: GPL-3.0-or-later

// (91) has one solution where I - K~_n is regular, and it is stable where the norm of the inverse has a bound
// that does not depend on n. With q the largest sum of |entries| of a row of K~_n the inverse is at most 1/(1
// - q) where q < 1.
//
// Checked      theorem_4_2_stable: both norms, enclosed, for the matrix of (91) on the interpolants of degree
//              1 and 2 of a roof and of the sphere.
// Not checked  other levels: that q stays below 1.

#include <string>
#include <vector>

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "verification/claims/ac98/collocation/inverse_norm.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

CollocationNorms of_interpolant(const Surface& surface, int level, int degree, const Rational& alpha,
                                double rho) {
  const InterpolatedSurface interpolant = interpolate(surface, triangulate(surface, level), degree);
  return collocation_norms(interpolant.surface, interpolant.triangulation, alpha, rho);
}

}  // namespace

Finding theorem_4_2_stable(const Bench& bench) {
  const int finest = bench.budget == Budget::quick ? 0 : bench.budget == Budget::standard ? 1 : 2;
  Finding finding;
  const Rational sixth(1, 6);
  struct Case {
    std::string name;
    Surface surface;
    double rho;
    // A bound of q for all levels taken: norm of K is below 1/4 on the roof, and rho on the sphere.
    Rational largest;
  };
  const std::vector<Case> cases{{"two_piece(6), rho = 1", two_piece(6), 1, Rational(1, 2)},
                                {"sphere, rho = 1/2", sphere(), 0.5, Rational(4, 5)}};
  for (const Case& each : cases)
    for (int degree = bench.budget == Budget::quick ? 2 : 1; degree <= 2; ++degree)
      for (int level = 0; level <= finest; ++level) {
        const CollocationNorms norms = of_interpolant(each.surface, level, degree, sixth, each.rho);
        const std::string of =
            ", " + each.name + ", r = " + std::to_string(degree) + ", level " + std::to_string(level);
        finding.require("norm of K~_n" + of, LiesIn{0, each.largest}, norms.matrix);
        finding.require("norm of the inverse of I - K~_n" + of, LiesIn{1, 1 / (1 - each.largest)},
                        norms.inverse);
        if (level == finest) finding.show(proved(norms.inverse));
      }
  const CollocationNorms brighter = of_interpolant(cases[1].surface, 0, 2, sixth, 0.875);
  finding.control("norm of K~_n, sphere, rho = 7/8, r = 2, level 0", LiesIn{0, Rational(4, 5)},
                  brighter.matrix);
  finding.control("norm of the inverse of I - K~_n, sphere, rho = 7/8, r = 2, level 0", LiesIn{1, 5},
                  brighter.inverse);
  return finding;
}

}  // namespace radcert::verification::ac98
