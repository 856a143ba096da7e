// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/section_2/lattice_functions.h"

#include <array>
#include <string>
#include <vector>

#include "radcert/polynomial/nodes/lattice.h"
#include "verification/claims/rational_function.h"

namespace radcert::verification::m06 {
namespace {

using Function = RationalFunction;
using Index = std::array<int, 3>;

Function symbol(const std::string& name) { return Function::variable(name); }

// y at the coordinate x, moved by so many alpha.
Function scaled(const Function& x, int shift) {
  const Function alpha = symbol("alpha");
  return (x - shift * alpha) / (1 - 3 * alpha);
}

// Terms in which r y at a coordinate of q_m differs from m.
Rational not_on_the_lattice(int shift) {
  const Function r = symbol("r");
  const Function m = symbol("m");
  return differing_terms(r * scaled((m + (r - 3 * m) * symbol("alpha")) / r, shift), m);
}

// Terms in which the factor of a = m differs from 0, or that of k = m from 1, of (m - a)/(k - a).
Rational other_factors(int shift) {
  const Function m = symbol("m");
  const Function a = symbol("a");
  const auto factor = [&](const Function& k, const Function& at) { return (m - at + shift) / (k - at); };
  return differing_terms(factor(symbol("k"), m), 0) + differing_terms(factor(m, a), 1);
}

Rational value_at(const Index& k, const Index& m) {
  Rational product = 1;
  for (std::size_t i = 0; i < k.size(); ++i)
    for (int a = 0; a < k.at(i); ++a) product *= Rational(m.at(i) - a, k.at(i) - a);
  return product;
}

// Pairs k, m with a product other than delta, m moved by so much in its first coordinate.
Rational pairs_off(int r, int moved) {
  long count = 0;
  const std::vector<Index> indices = lattice_indices(r);
  for (const Index& k : indices)
    for (Index m : indices) {
      const Rational delta = k == m ? 1 : 0;
      m[0] += moved;
      if (value_at(k, m) != delta) ++count;
    }
  return {count};
}

// Negative coefficients of 1/d - y, 1/d + y and so many r/d - (r/d + a), where x, 1 - x, alpha, a and r - a
// are not negative; 1 is d + 3 alpha, or x + (1 - x).
Rational beyond_the_bound(int so_many) {
  const Function d = symbol("d");
  const Function alpha = symbol("alpha");
  const Function x = symbol("x");
  const Function rest = symbol("1-x");
  const Function a = symbol("a");
  const Function gap = symbol("r-a");
  const Function one = d + 3 * alpha;
  const Function above = (x + rest - (x - alpha)) / d;
  const Function below = (one + (x - alpha)) / d;
  const Function left = (Function(so_many - 1) * (a + gap) * one - a * d) / d;
  return negative_terms(above) + negative_terms(below) + negative_terms(left);
}

}  // namespace

void require_delta_at_the_nodes(Finding& finding) {
  finding.require("terms of r (c_m - alpha)/(1 - 3 alpha) - m, every r, m and alpha", IsExactly{0},
                  not_on_the_lattice(1));
  finding.control("the same with c_m - 2 alpha", IsExactly{0}, not_on_the_lattice(2));
  finding.require("terms in which (m - a)/(k - a) differs from 0 for a = m, and from 1 for k = m",
                  IsExactly{0}, other_factors(0));
  finding.control("the same for m + 1 above", IsExactly{0}, other_factors(1));
  for (int r = 1; r <= 8; ++r)
    finding.require("pairs k, m with a product of these factors other than delta, r = " + std::to_string(r),
                    IsExactly{0}, pairs_off(r, 0));
  finding.control("the same for nodes moved by 1, r = 3", IsExactly{0}, pairs_off(3, 1));
}

void require_bound_of_the_functions(Finding& finding) {
  finding.require("negative coefficients of 1/d - y, 1/d + y and 2r/d - (r/d + a)", IsExactly{0},
                  beyond_the_bound(2));
  finding.control("the same with r/d for 2r/d", IsExactly{0}, beyond_the_bound(1));
}

}  // namespace radcert::verification::m06
