// SPDX-License-Identifier: GPL-3.0-or-later

// The special choice of nodes, alpha_0, is what raises the order at the nodes. The order r + 1 needs none:
// interpolation at (13) takes a polynomial of degree r to itself for every alpha, so that |u - P_n u| on
// an element is at most 1 + Lambda times what Taylor's polynomial of degree r about its centroid leaves of
// u, which is O(h^(r+1)), Lambda the norm of P_n, which does not depend on n (equation_17). On the unit
// sphere with constant rho, where P_n 1 = 1, u - u_n = w + rho M(w)/(1 - rho) with w = E - P_n E, so that
// |u - u_n| is at most 1/(1 - rho) times the largest |w|: the order r + 1 for every alpha below 1/3, every
// r and every triangulation.
//
// Checked      that interpolation takes the monomials of degree r and less to themselves, as identities in
//              alpha, r = 1 to 4; rejected for x^(r+1). The order of max |u - u_n| over a sample of S at
//              alpha = 1/10 and 1/20: r = 1 and 3 on the sphere, u = x^4; r = 1 on two_piece(2) and the
//              ellipsoid (1,5/4,3/2) at alpha = 1/10, r = 3 on two_piece(2) beyond quick: it is r + 1, and
//              not less. Rejected: a u with a kink amid elements, and alpha_0, which has no less than r +
//              1 either.
// Not checked  points off the sample; other surfaces and data.

#include <cmath>
#include <string>
#include <vector>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/scalar/real.h"
#include "verification/claims/m06/named_problems.h"
#include "verification/claims/m06/sphere_errors.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::m06 {
namespace {

// At how many of 2r + 2 values of alpha and of as many points x as settle an equality in P_(r+1) the
// interpolant of x_2^a x_3^b differs from it: (1 - 3 alpha)^r times the difference is a polynomial in alpha
// of degree r + a + b at most, so that 0 proves an identity.
Rational values_apart(int r, int a, int b) {
  const InsetFamily family(r);
  long count = 0;
  for (const Barycentric<Rational>& x : inset_nodes<Rational>(r + 1, 0)) {
    std::vector<InsetFunction> functions;
    for (std::size_t j = 0; j < family.size(); ++j) functions.push_back(family.value(j, x));
    for (int k = 0; k < 2 * r + 2; ++k) {
      const Rational alpha(k, 3 * (2 * r + 2));
      Rational left = -power(x.x[1], a) * power(x.x[2], b);
      for (std::size_t j = 0; j < functions.size(); ++j)
        left += power(family.node(j)[1](alpha), a) * power(family.node(j)[2](alpha), b) * functions[j](alpha);
      if (left.sign() != 0) ++count;
    }
  }
  return {count};
}

// Not smooth on circles that go through the middles of elements, in the same way at every level.
double kink(const Vector<double>& q) { return std::abs(std::abs(q.x) - std::abs(q.y)); }

ObservedOrder on_the_sphere(int r, double alpha, Solution u) {
  return observed_order(errors_on_the_sphere({InsetBasis<double>(r, alpha)}, u, levels_from(3, 6)).uniform);
}

}  // namespace

Finding abstract_special_choice(const Bench& bench) {
  Finding finding;
  for (int r = 1; r <= 4; ++r) {
    Rational left(0);
    for (int a = 0; a <= r; ++a)
      for (int b = 0; a + b <= r; ++b) left += values_apart(r, a, b);
    const std::string what = "values of alpha and points where interpolation changes ";
    finding.instead(what + "P_r, r = " + std::to_string(r), IsExactly{0}, left);
    finding.control(what + "x^(r+1), r = " + std::to_string(r), IsExactly{0}, values_apart(r, r + 1, 0));
  }
  // Without the choice less than r + 1; and what holds: r + 1.
  const auto both = [&](const std::string& of, int r, const ObservedOrder& order) {
    finding.require("order of max |u - u_n|, " + of, Order::at_most(r, r + 1), order);
    finding.instead("the same, " + of, Order::at_least(r + 1), order);
  };
  for (const int r : {1, 3}) {
    const std::string sphere = "sphere, r = " + std::to_string(r) + ", ";
    both(sphere + "alpha = 1/10", r, on_the_sphere(r, 0.1, fourth_power));
    both(sphere + "alpha = 1/20", r, on_the_sphere(r, 0.05, fourth_power));
    finding.control(
        "order of max |u - u_n|, " + sphere + "alpha_0", Order::at_most(r, r + 1),
        observed_order(errors_on_the_sphere(chosen_nodes(r), fourth_power, levels_from(2, 5)).uniform));
    finding.control("order of max |u - u_n|, " + sphere + "alpha = 1/10, ||x| - |y||", Order::at_least(r + 1),
                    on_the_sphere(r, 0.1, kink));
  }
  std::vector<std::string> names{"two_piece_r1_other", "ellipsoid_r1_other"};
  if (bench.budget != Budget::quick) names.emplace_back("two_piece_r3_other");
  for (const std::string& name : names) {
    const Problem problem = problem_named(name);
    both(name, triangle_basis_of(problem.method).degree,
         observed_order(uniform_errors(bench, problem, levels_of_an_order(problem, bench.budget))));
  }
  return finding;
}

}  // namespace radcert::verification::m06
