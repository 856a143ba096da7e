// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 4, (23), asks for E in C^(r+1)(S). On a closed analytic surface without edges K u is as smooth as
// u, so that an analytic u belongs to an analytic E; at the corners of a smooth piece it does not: lemma_2.
//
// Checked      the order of max |u - u_n| over 45 points of every element: r = 0 to 5 on the sphere, u = x^4,
//              without a matrix, as G is constant; r = 0 and 1 on the ellipsoid (1, 5/4, 3/2), u = exp(x/2 +
//              y/3 - z/4), where G has no limit at P = Q. Rejected: on the sphere u = ||x| - |y|| for r >= 1,
//              which has a kink amid elements, and one that jumps there for r = 0.
// Not checked  the supremum off the sample; that r + 2 derivatives of F_j and r + 1 of E suffice. E in
//              C^(r+1) does not give u in C^(r+1) on surfaces with corners: theorem_3_b.

#include <cmath>

#include "verification/claims/m06/named_problems.h"
#include "verification/claims/m06/sphere_errors.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::m06 {
namespace {

// Not smooth on circles that go through the middles of elements, in the same way at every level.
double kink(const Vector<double>& q) { return std::abs(std::abs(q.x) - std::abs(q.y)); }
double jump(const Vector<double>& q) { return std::abs(q.x) < std::abs(q.y) ? 0 : 1; }

}  // namespace

Finding theorem_4_order(const Bench& bench) {
  Finding finding;
  for (int r = 0; r <= 5; ++r) {
    const std::string of = ", sphere, r = " + std::to_string(r);
    const TriangleBasis<double> basis = chosen_nodes(r);
    finding.require("order of |u - u_n| over the sample" + of + ", x^4", Order::at_least(r + 1),
                    observed_order(errors_on_the_sphere(basis, fourth_power, levels_from(3, 6)).uniform));
    finding.control(
        "order of |u - u_n| over the sample" + of + (r == 0 ? ", the sign of |x| - |y|" : ", ||x| - |y||"),
        Order::at_least(r + 1),
        observed_order(errors_on_the_sphere(basis, r == 0 ? jump : kink, levels_from(2, 4)).uniform));
  }
  for (const char* name : {"ellipsoid_r0", "ellipsoid_r1"}) {
    const Problem problem = problem_named(name);
    finding.require(
        "order of |u - u_n| over the sample, " + std::string(name),
        Order::at_least(triangle_basis_of(problem.method).degree + 1),
        observed_order(uniform_errors(bench, problem, levels_of_an_order(problem, bench.budget))));
  }
  return finding;
}

}  // namespace radcert::verification::m06
