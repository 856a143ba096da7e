// SPDX-License-Identifier: GPL-3.0-or-later

// (80) with alpha = 1/6 is norm of K < 3/7. On a closed surface norm of K = norm of rho, (17) with equality,
// so that (80) is rho < 3/7 there: Table 4, on the cube with rho = 1/2, has norm of P_n norm of K = 7/6, and
// Theorem 4.1 says nothing of it. Table 5, with norm of P_n = 1, is covered. (80) is sufficient only: the
// error of u - u_n falls like h^2 in Table 4 all the same, and for rho = 99/100 too.
//
// Checked      equation_80_table_4: the product for the data of Table 4, by balls; of Table 5 likewise.
//              equation_81, for every linear K and P_n: u - u_n = (I - P_n K)^-1 (u - P_n u), whose norms are
//              (81), and Neumann's series for T = P_n K, both in the free algebra. As the norm of T is at
//              most gamma < 1 by (80), the sums are Cauchy, I - T has an inverse Y, and (1 - gamma) norm of Y
//              <= 1 by the norms of Y = I + T Y, an identity too. equation_81_cube: the norms of K_n and of
//              the inverse of I - K_n, enclosed, on the cube with rho = 3/8, which (80) allows: gamma = 7/8
//              bounds the first and 1/(1 - gamma) = 8 the second. The error on the cube with rho = 2/5, where
//              1/(1 - gamma) = 15.
// Not checked  finer levels; what is analysis in (81): that the space is complete, |a + b| <= |a| + |b| and
//              |A a| <= |A| |a|.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "radcert/formats/result/stored_levels.h"
#include "radcert/surface/catalogue.h"
#include "verification/claims/ac98/collocation/inverse_norm.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/ac98/surfaces/polyhedra.h"
#include "verification/claims/operator_algebra.h"
#include "verification/claims/operator_identities.h"
#include "verification/claims/proved_number.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
namespace {

// (37).
Rational norm_of_interpolation(const Rational& alpha) { return (1 + alpha) / (1 - 3 * alpha); }

// max |u - P_n u| over the barycentric lattice k/8 of a right triangle with legs h for u = x^2 + y^2: h^2
// times that of the unit triangle, as linear parts of u are reproduced.
double interpolation_error(double h) {
  constexpr int steps = 8;
  constexpr double alpha = 1.0 / 6;
  constexpr std::array<std::array<double, 2>, 3> nodes{
      {{alpha, alpha}, {alpha, 1 - 2 * alpha}, {1 - 2 * alpha, alpha}}};
  const auto u = [](double s, double t) { return s * s + t * t; };
  double largest = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double s = static_cast<double>(i) / steps;
      const double t = static_cast<double>(j) / steps;
      const std::array<double, 3> l{(1 - s - t - alpha) / (1 - 3 * alpha), (t - alpha) / (1 - 3 * alpha),
                                    (s - alpha) / (1 - 3 * alpha)};
      double interpolant = 0;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        interpolant += u(nodes.at(k)[0], nodes.at(k)[1]) * l.at(k);
      largest = std::max(largest, std::abs(u(s, t) - interpolant));
    }
  return h * h * largest;
}

}  // namespace

Finding equation_80_table_4(const Bench&) {
  const BallPrecision precision(128);
  const AtMost below_one{.value = 1 - 0x1p-20, .slack = 0, .why = "gamma < 1"};
  const Polyhedron cube = cube_polyhedron();
  const Ball of_kernel =
      total_factor(cube, floor_face, {Rational(1, 3), Rational(1, 5), 0}, 1 / power(Rational(10), 30)) /
      Ball::pi();
  const auto product = [&](const Rational& norm, const Rational& rho) {
    return proved(Ball(norm * rho) * of_kernel);
  };
  const Rational linear = norm_of_interpolation(Rational(1, 6));
  Finding finding;
  finding.require("norm of P_n norm of K, cube, alpha = 1/6, rho = 1/2 (Table 4)", below_one,
                  product(linear, Rational(1, 2)));
  finding.require("norm of P_n norm of K, cube, centroid rule, rho = 1/2 (Table 5)", below_one,
                  product(1, Rational(1, 2)));
  finding.require("norm of P_n norm of K, cube, alpha = 1/6, rho = 2/5", below_one,
                  product(linear, Rational(2, 5)));
  finding.control("norm of P_n norm of K, cube, centroid rule, rho = 1", below_one, product(1, 1));
  finding.show(product(linear, Rational(1, 2)));
  return finding;
}

Finding equation_81(const Bench&) {
  Finding finding;
  require_error_by_inverse(finding);
  require_neumann_series(finding);
  // Y is the inverse of I - T.
  const Operator one(1);
  const Operator t("K");
  const Operator y("Y");
  const OperatorRelations inverse({{.product = "KY", .replacement = y - one},  //
                                   {.product = "YK", .replacement = y - one}});
  finding.require("words of (I - T)^-1 - (I + T (I - T)^-1)", IsExactly{0},
                  inverse.differing_words(y, one + t * y));
  finding.control("words of the same for any other operator in its place", IsExactly{0},
                  OperatorRelations({}).differing_words(y, one + t * y));
  // y <= 1 + gamma y: 1 less (1 - gamma) y is what is left over, e >= 0, so that 1/(1 - gamma) - y has no
  // negative coefficient in e and in d = 1 - gamma > 0.
  const RationalFunction d = RationalFunction::variable("d");
  const RationalFunction e = RationalFunction::variable("e");
  const auto norm_of_inverse = [&](const RationalFunction& left_over) { return (1 - left_over) / d; };
  finding.require("negative coefficients of 1/(1 - gamma) - y, where y + e = 1 + gamma y", IsExactly{0},
                  negative_terms(1 / d - norm_of_inverse(e)));
  finding.control("the same where y = 1 + gamma y + e", IsExactly{0},
                  negative_terms(1 / d - norm_of_inverse(-e)));
  return finding;
}

Finding equation_81_cube(const Bench& bench) {
  const Rational rho(2, 5);
  const Rational inverse = 1 / (1 - norm_of_interpolation(Rational(1, 6)) * rho);
  const AtMost bound{.value = inverse.to_double(),
                     .slack = 0,
                     .why = "norm of (I - P_n K)^-1 <= 1/(1 - gamma), gamma = 14/15"};
  const Problem problem = linear_problem_with_solution("cube", {}, rho.to_text(), "x^2 + y^2 + z^2");
  const Problem beyond = linear_problem_with_solution("cube", {}, "99/100", "x^2 + y^2 + z^2");
  const int finest = bench.budget == Budget::quick ? 1 : bench.budget == Budget::standard ? 2 : 3;
  Finding finding;
  for (int level = 0; level <= finest; ++level) {
    const double leg = std::ldexp(1.0, -level);
    const auto quotient = [&](const Problem& of) {
      const Approximation error = as_sampled(bench.levels.level(of, level).result.uniform_error.value());
      return Approximation::estimated(error.value / interpolation_error(leg),
                                      error.radius / interpolation_error(leg));
    };
    const std::string at = ", level " + std::to_string(level);
    finding.require("norm of (u - u_n)/norm of (u - P_n u), cube, rho = 2/5" + at, bound, quotient(problem));
    finding.remark("the same for rho = 99/100, where (80) fails" + at, quotient(beyond));
    if (level == finest) finding.show(quotient(problem));
  }
  const Surface cube = find_surface("cube")->make({});
  const Rational sixth(1, 6);
  const LiesIn below_gamma{0, Rational(7, 8)};
  const LiesIn below_8{1, 8};
  for (int level = 0; level <= (bench.budget == Budget::quick ? 0 : 1); ++level) {
    const CollocationNorms norms = collocation_norms(cube, triangulate(cube, level), sixth, 0.375);
    const std::string at = ", cube, rho = 3/8, level " + std::to_string(level);
    finding.require("norm of K_n" + at, below_gamma, norms.matrix);
    finding.require("norm of the inverse of I - K_n" + at, below_8, norms.inverse);
  }
  const CollocationNorms brighter = collocation_norms(cube, triangulate(cube, 0), sixth, 0.9375);
  finding.control("norm of K_n, cube, rho = 15/16, level 0", below_gamma, brighter.matrix);
  finding.control("norm of the inverse of I - K_n, cube, rho = 15/16, level 0", below_8, brighter.inverse);
  // (80) is false for rho near 1, and the part of the error that is constant on S grows like 1/(1 - rho).
  const Problem far_beyond = linear_problem_with_solution("cube", {}, "9999/10000", "x^2 + y^2 + z^2");
  const Approximation far_off = as_sampled(bench.levels.level(far_beyond, 0).result.uniform_error.value());
  finding.control("norm of (u - u_n)/norm of (u - P_n u), cube, rho = 9999/10000, level 0", bound,
                  Approximation::estimated(far_off.value / interpolation_error(1),
                                           far_off.radius / interpolation_error(1)));
  return finding;
}

}  // namespace radcert::verification::ac98
