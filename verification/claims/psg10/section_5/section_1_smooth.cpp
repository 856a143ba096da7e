// SPDX-License-Identifier: GPL-3.0-or-later

// Whether what Lehtinen's basis represents is smooth.
//
// Checked      smooth as against the jumps between the cells of a mesh: continuous on a smooth surface. Raw
//              elements (18) are K(d/alpha) max{0, c} with d, c continuous there; max{0, c} = (c + |c|)/2; K
//              is a polynomial up to r = 1, where K(1 - h) = h^2 (3 - 2h) tends to 0, its value beyond, and
//              its slope does. (11) is a quotient of continuous functions where the sum is positive.
//              Rejected: 1 - r, whose slope jumps, and G cut at 4, which itself jumps by e^-8.
// Not checked  derivatives where a normal is at 90 degrees to a site's: max{0, c} has a kink there. Edges of
//              a scene, at which all three bases jump as the normal does.

#include <optional>

#include "radcert/meshless/mother_function.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {

Finding section_1_smooth(const Bench&) {
  const BallPrecision precision(128);
  const AgreesWith beyond{.value = Ball(0), .within = 1e-30};
  // From below, 2r^3 - 3r^2 + 1 and, to be rejected, 1 - r.
  const RationalFunction h = RationalFunction::variable("h");
  const RationalFunction r = 1 - h;
  const RationalFunction spline = RationalFunction(2) * r * r * r - RationalFunction(3) * r * r + 1;
  const RationalFunction tent = 1 - r;
  const RationalFunction falls_like_a_square = h * h * (3 - RationalFunction(2) * h);
  Finding finding;
  finding.require("terms in which K(1 - h) differs from h^2 (3 - 2h)", IsExactly{0},
                  differing_terms(spline, falls_like_a_square));
  finding.control("the same for 1 - r", IsExactly{0}, differing_terms(tent, falls_like_a_square));
  finding.require("K at the end of its support, 0 beyond", beyond, spline_bell(Ball(1)));
  finding.control("G at 4, where it is cut to 0", beyond, gaussian_mother(std::nullopt).value(Ball(4)));
  return finding;
}

}  // namespace radcert::verification::psg10
