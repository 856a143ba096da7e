// SPDX-License-Identifier: GPL-3.0-or-later

// (82) on the closed cube, where u is not known and is enclosed. rho = 2/5, alpha = 1/6 and E = (1 - z)^4
// meet what Theorem 4.1 asks for: a piecewise smooth unoccluded surface that is the boundary of a convex
// body, affine charts, gamma = 14/15 in (80), and E in C^2(S) as section 4 has it, continuous on S and a
// polynomial on each face. The mean over a face is a number that norm of (u - u_n) bounds the error of, so
// that (82) gives it the order 2 at least. Beside an edge u behaves like r^b, (rho/4) B((b+2)/2, (1-b)/2)
// = 1: an element there misses h^b on an area h^2, and 1/h of them have an edge, so that the mean over the
// face is missed by h^(1+b) = h^1.81, if the errors there do not cancel.
//
// Checked      the order of the error of the mean of u_n over the floor against the enclosure, levels 1 to 4:
//              too few to tell 2 from 1.81. Rejected: the same by the rule of the centroids. With u = x^2 +
//              y^2 + z^2 on the same cube, where the mean is 2/3, the order 2 is kept.
// Not checked  finer levels; the claims of the certificate, which radcert check --all proves.

#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/enclosed_means.h"
#include "verification/claims/proved_number.h"

namespace radcert::verification::ac98 {

Finding equation_82_cube(const Bench& bench) {
  const Rational rho(2, 5);
  const double of_the_edge = 1 + exponent_beside_right_angles(rho);
  const Order two = Order::at_least(2, of_the_edge);
  const Ball mean = mean_over_the_floor();
  const std::vector<int> levels = levels_from(1, 4);
  const Problem linear = quartic_emission_on_the_cube(1, Rational(1, 6));
  Finding finding;
  finding.remark("the mean of u over the floor", proved(mean));
  finding.remark("1 + b", Approximation{.value = of_the_edge, .radius = 1e-8, .guaranteed = true});
  const LevelErrors errors = floor_errors(bench, linear, mean, levels);
  finding.remark("error of the mean at the last level", errors.errors.back());
  const ObservedOrder order = observed_order(errors);
  finding.require("order of the error of the mean over the floor, E = (1 - z)^4", two, order);
  finding.control("the same by the centroid rule", two,
                  observed_order(floor_errors(bench, by_centroids(linear), mean, levels)));
  const Problem smooth = linear_problem_with_solution("cube", {}, "2/5", "x^2 + y^2 + z^2");
  finding.instead("order of the error of the mean, u = x^2 + y^2 + z^2", two,
                  observed_order(floor_errors(bench, smooth, Ball(Rational(2, 3)), levels)));
  finding.show(order.exponent);
  return finding;
}

}  // namespace radcert::verification::ac98
