// SPDX-License-Identifier: GPL-3.0-or-later

// Where raw elements are largest.
//
// Checked      (17), (18): 0 <= psi_i(p) <= 1 = psi_i(p_i). The cosine of two unit vectors is at most 1,
//              section_5_points. K of (13) on [0,1], with g = 1 - r: K = g^2 (1 + 2r) and 1 - K = r^2 (1 +
//              2g), sums of products of what is not negative. G <= 1/(1 + r^2/2) <= 1 as an exponential;
//              enclosed on [1/16, 4] in cells. (16): 1/r^2 falls, 1/r^2 - 1/(r + g)^2 having no negative
//              coefficient: largest in the limit at the centroid. Rejected: after (11) it need not hold.
//              Sites at 0 and 1/4 of a line, Lehtinen's radii 2: the normalised element of the first is
//              larger at -3/2 than at its centroid.
// Not checked  normalised elements otherwise.

#include <vector>

#include "radcert/meshless/mother_function.h"
#include "verification/claims/psg10/exact_sites.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using Function = RationalFunction;

/// K of (13) for r <= 1.
Function spline(const Function& r) { return Function(2) * r * r * r - Function(3) * r * r + 1; }

/// Cells of [1/16, 4] on which G is not certainly between 0 and 1.
Rational cells_of_gaussian() {
  constexpr long cells_a_unit = 16;
  long count = 0;
  for (long k = 1; k < 4 * cells_a_unit; ++k) {
    const Ball g = gaussian_bell(hull(Ball(Rational(k, cells_a_unit)), Ball(Rational(k + 1, cells_a_unit))));
    if (!certainly_positive(g) || !certainly_less(g, Ball(1))) ++count;
  }
  return count;
}

/// Whether the first of two elements is larger at a place than at its own, normalised or not.
Rational larger_elsewhere(bool normalise) {
  const std::vector<Site<Rational>> sites{{{0, 0, 0}, {0, 0, 1}}, {{Rational(1, 4), 0, 0}, {0, 0, 1}}};
  const auto first_at = [&](const Site<Rational>& p) {
    std::vector<Rational> values = raw_lehtinen(sites, 2, p);
    return (normalise ? normalised(std::move(values)) : values).front();
  };
  return first_at({{Rational(-3, 2), 0, 0}, {0, 0, 1}}) > first_at(sites.front()) ? 1 : 0;
}

}  // namespace

Finding section_5_largest(const Bench&) {
  const Function r = Function::variable("r");
  const Function g = Function::variable("g");
  const auto by_factors = [](const Function& first, const Function& second) {
    return first * first * (1 + Function(2) * second);
  };
  const auto inverse_squares = [&](const Function& step) {
    return negative_terms(inverse_square(r) - inverse_square(Function(r + step)));
  };
  Finding finding;
  finding.require("terms in which K differs from (1 - r)^2 (1 + 2r)", IsExactly{0},
                  differing_terms(by_factors(1 - r, r), spline(r)));
  finding.require("terms in which 1 - K differs from r^2 (1 + 2(1 - r))", IsExactly{0},
                  differing_terms(by_factors(r, 1 - r), 1 - spline(r)));
  finding.require("negative coefficients of g^2 (1 + 2r)", IsExactly{0}, negative_terms(by_factors(g, r)));
  finding.require("cells of [1/16, 4] on which G is not between 0 and 1", IsExactly{0}, cells_of_gaussian());
  finding.require("negative coefficients of 1/r^2 - 1/(r + g)^2", IsExactly{0}, inverse_squares(g));
  finding.require("whether a raw element is larger at -3/2 than at its centroid", IsExactly{0},
                  larger_elsewhere(false));
  finding.control("the same, normalised, the next site at 1/4", IsExactly{0}, larger_elsewhere(true));
  return finding;
}

}  // namespace radcert::verification::psg10
