// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      (23), the norm of u - u_n over the sample of 45 points an element: r = 0 to 5 on two_piece(2),
//              r = 0 to 2 on the sphere and the ellipsoid (1, 5/4, 3/2), u = exp(x/2 + y/3 - z/4), on the
//              sphere x^4.
// Not checked  the supremum off the sample. F_j and u are analytic here: that r + 2 and r + 1 derivatives
//              suffice is not looked at. E in C^(r+1) does not give u in C^(r+1): theorem_3_b.

#include "verification/claims/m06/rates.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding theorem_4_order(const Bench& bench) {
  Finding finding;
  const auto bound = [](int r) {
    return Bound{
        .order = static_cast<double>(r + 1),
        .slack = 0.7,
        .why =
            "coarse levels: u - P_n u has a longer way to its last power for large r; less than one order"};
  };
  const auto order = [&](const Problem& problem) {
    return last_order(uniform_errors(problem, levels_for(problem, bench.budget), bench));
  };
  for (const char* name :
       {"two_piece_r0", "two_piece_r1", "two_piece_r2", "two_piece_r3", "two_piece_r4", "two_piece_r5",
        "sphere_r0", "sphere_r1", "sphere_r2", "ellipsoid_r0", "ellipsoid_r1", "ellipsoid_r2"}) {
    const Problem problem = problem_named(name);
    finding.require("order of |u - u_n| over the sample, " + std::string(name),
                    bound(triangle_basis_of(problem.method).degree), order(problem));
  }
  // Interpolation of one degree less, at alpha = 1/10.
  for (const char* name : {"two_piece_r1_other", "two_piece_r3_other", "ellipsoid_r1_other"}) {
    const Problem problem = problem_named(name);
    finding.control(
        "order of |u - u_n| over the sample against that of the next degree, " + std::string(name),
        bound(triangle_basis_of(problem.method).degree + 1), order(problem));
  }
  return finding;
}

}  // namespace radcert::verification::m06
