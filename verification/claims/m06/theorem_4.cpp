// SPDX-License-Identifier: GPL-3.0-or-later

// Theorem 4. (22) follows from (I - P_n K)(u - u_n) = u - P_n u; with B = (I - P_n K)^-1 = I + P_n (I -
// K_n)^-1 K its norm is at most 1 + |P_n| |K|/(1 - |K_n|), K_n the matrix, as long as the norm of K_n is
// below 1.
//
// Checked      (22) on two_piece(2), r = 0 to 3: the norm of u - u_n over the sample of 45 points an element
//              is at most that bound of the inverse times the norm of u - P_n u, taken over the same sample.
//              (23), the norm of u - u_n over this sample: r = 0 to 5 on two_piece(2), r = 0 to 2 on the
//              sphere and the ellipsoid (1, 5/4, 3/2), u = exp(x/2 + y/3 - z/4), on the sphere x^4.
// Not checked  the supremum off the sample. F_j and u are analytic here: that r + 2 and r + 1 derivatives
// suffice is not looked at. E in
//              C^(r+1) does not give u in C^(r+1): theorem_3_b.

#include <algorithm>
#include <cmath>

#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/m06/rates.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

// max |u - P_n u| over the points with barycentric coordinates k/8 of every element, the sample of a level's
// uniform error.
double interpolation_error(const Problem& problem, int level) {
  constexpr int parts = 8;
  const Surface surface = surface_of(problem);
  const SurfaceFunction u(problem.solution.value(), surface);
  const TriangleBasis<double> basis = triangle_basis(triangle_basis_of(problem.method));
  const std::vector<Barycentric<double>> nodes = basis.nodes();
  std::vector<double> values(basis.size());
  double largest = 0;
  for (const ParameterTriangle& t : triangulate(surface, level).triangles) {
    const auto at = [&](const Barycentric<double>& x) {
      return u(t.chart, surface.charts[t.chart].in<double>().frame(t.at(x.x)).point);
    };
    std::vector<double> at_nodes;
    for (const Barycentric<double>& q : nodes) at_nodes.push_back(at(q));
    for (const Barycentric<double>& x : inset_nodes<double>(parts, 0)) {
      basis.values(x, std::span<double>(values));
      double interpolant = 0;
      for (std::size_t j = 0; j < values.size(); ++j) interpolant += at_nodes[j] * values[j];
      largest = std::max(largest, std::abs(at(x) - interpolant));
    }
  }
  return largest;
}

double norm_of_interpolation(const Problem& problem) {
  const int r = triangle_basis_of(problem.method).degree;
  if (r == 0) return 1;
  return lebesgue_constant(
             lagrange_functions(inset_nodes(r, triangle_basis_of(problem.method).alpha.value())).value(),
             Rational(1, 100))
      .upper.to_double();
}

}  // namespace

Finding theorem_4(const Bench& bench) {
  const AtMost bound{
      .value = 1, .slack = 1e-6, .why = "the two samples are the same points, but both sides round"};
  Finding finding;
  for (const char* name : {"two_piece_r0", "two_piece_r1", "two_piece_r2", "two_piece_r3_other"}) {
    const Problem problem = problem_named(name);
    const double norm = norm_of_interpolation(problem);
    for (const int level : levels_for(problem, Budget::quick)) {
      const LevelResult result = bench.levels.level(problem, level).result;
      // The norm of K itself is below that of rho, 1/2; norm_K is the largest sum of absolute values of a
      // row.
      const double inverse = 1 + norm * 0.5 / (1 - result.norm_K.value);
      const double of_u = interpolation_error(problem, level);
      const std::string of = ", " + std::string(name) + ", level " + std::to_string(level);
      finding.require(
          "|u - u_n| over the bound of the inverse times |u - P_n u|" + of, bound,
          Approximation{.value = result.uniform_error.value().value / (inverse * of_u), .radius = 0});
      if (level > 1)
        finding.control("the same with |K(I - P_n)u| at the nodes in the place of |u - P_n u|" + of, bound,
                        Approximation{.value = result.uniform_error.value().value /
                                               (inverse * result.discretisation_error.value().value),
                                      .radius = 0});
    }
  }
  return finding;
}

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
