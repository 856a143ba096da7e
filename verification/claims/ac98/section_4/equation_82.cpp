// SPDX-License-Identifier: GPL-3.0-or-later

// (82) asks for E in C^2(S) alone. On the surface (20), which is two faces of the cube, E = 1, alpha = 1/6
// and any constant 0 < rho < 6/7 meet every hypothesis of Theorem 4.1: norm of K <= (rho/pi) (pi/2) = rho/2,
// so that (80) holds with gamma = 7 rho/6. But u is not continuous at the ends of the common edge. On the
// edge u = 1/(1 - rho/2), the largest value of u. On the diagonal x = z of a square
//   u(t,0,t) <= 1 + (rho/pi) (22)(t,t)/(1 - rho/2) <= 1 + (3 rho/8)/(1 - rho/2),
// as (22)(t,t) = [pi/4 + atan((1-t)/t) - ...]/2 with
// terms that are not negative left out is at most (pi/4 + pi/2)/2 for every t, and an element with a vertex
// at the end of the edge has points of both kinds next to that vertex, where u_n is continuous. Hence norm of
// (u - u_n) is at least half of what they differ by, rho/(16 - 8 rho), for every triangulation whose elements
// have a side on the edge and reach the diagonal there: 1/24 for rho = 1/2. Away from the ends u is
// continuous and behaves like r^b beside the edge, and so does the error like h^b. What (81) gives is O(h^2)
// if u is in C^2 of each closed face.
//
// Checked      that the hypotheses hold; the lower bound, as an identity in rho, and (22)(t,t) by balls; |u_n
//              - 4/3| on the edge as h is halved, at its middle and anywhere on it, rho = 1/2; and, as a
//              remark, the order of what u_n changes by beside an edge of the closed cube, where r^b has b =
//              0.81.
// Not checked  E for which u happens to be smooth; there (82) holds, as Table 4 shows.

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radcert/closed_form/two_squares.h"
#include "radcert/core/contract.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/polynomial/rational_polynomial.h"
#include "radcert/study/study.h"
#include "verification/claims/ac98/collocation/edge_value.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/fine_levels.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

// Half the difference of the limit of u on the edge and an upper bound of u(t,0,t).
Ball half_the_jump(const Rational& reflectivity, const Ball& t) {
  const Ball edge(solution_on_the_edge(reflectivity));
  const Ball factor = Ball(reflectivity) / Ball::pi();
  return (edge - (Ball(1) + factor * edge * TwoSquares<Ball>(t, t).one())) / Ball(2);
}

// Coefficients of [1/(1 - rho/2) - 1 - (3 rho/8)/(1 - rho/2)]/2 less rho/(16 - 8 rho), over their common
// denominator; `part` for 3/8.
Rational jumps_unlike_the_formula(const Rational& part) {
  const RationalPolynomial rho = RationalPolynomial::variable();
  const RationalPolynomial denominator = 1 - Rational(1, 2) * rho;
  const RationalPolynomial twice = 1 - denominator - part * rho;
  const RationalPolynomial difference = twice * (16 - 8 * rho) - 2 * rho * denominator;
  long count = 0;
  for (int k = 0; k <= difference.degree(); ++k)
    if (difference.coefficient(static_cast<std::size_t>(k)).sign() != 0) ++count;
  return {count};
}

// The mean of u_n at the vertex (1, 1/2, 0) of the cube over the elements of the face x = 1.
double value_beside_an_edge_of_the_cube(const LevelOutcome& level) {
  constexpr double at_the_vertex = 1e-9;
  double sum = 0;
  int count = 0;
  for (const ElementValue& element : level.elements) {
    if (element.piece != "east") continue;
    for (std::size_t i = 0; i < element.corners.size(); ++i) {
      if (norm(element.corners.at(i) - Vector<double>{1, 0.5, 0}) > at_the_vertex) continue;
      sum += element.corner_values.at(i);
      ++count;
    }
  }
  expects(count > 0, "a level with that vertex", named("level", level.result.level));
  return sum / count;
}

// At a corner |l_1| + |l_2| + |l_3| is 7/3.
Approximation value_with_radius_beside_an_edge(const LevelOutcome& level) {
  return {.value = value_beside_an_edge_of_the_cube(level),
          .radius = 7.0 / 3 * level.result.solution_radius.value()};
}

// E = x^2 and rho = 2/5, which (80) allows.
Problem cube_lit_by_x_squared() {
  Problem cube = linear_problem("cube", {}, "2/5");
  cube.emission = on_all_pieces("x^2");
  cube.solver = {.name = "gmres", .tolerance = std::nullopt};
  return cube;
}

// The order of what u_n changes by there from level to level.
Approximation order_on_the_cube(const Bench& bench, int finest) {
  const Problem cube = cube_lit_by_x_squared();
  const auto change = [&](int level) {
    const Approximation fine = value_with_radius_beside_an_edge(bench.levels.level(cube, level));
    const Approximation coarse = value_with_radius_beside_an_edge(bench.levels.level(cube, level - 1));
    return Approximation{.value = std::abs(fine.value - coarse.value), .radius = fine.radius + coarse.radius};
  };
  return exponent_between(change(finest - 1), change(finest));
}

// What u_n changes by there on a uniform mesh of up to 589,824 unknowns. It is a sum of h^b and of h, whose
// powers are near each other, so that its exponent comes down slowly, and that of what is left without the
// multiple of h goes up.
void add_fine_orders_on_the_cube(Finding& finding, const Bench& bench) {
  const FineStudy study{.problem = cube_lit_by_x_squared(),
                        .first = 1,
                        .last = 7,
                        .tolerance = Rational(1, 10000000),
                        .order = 0};
  const LevelFigure beside_the_edge{"beside (1, 1/2, 0) on x = 1", [](const LevelOutcome& level) {
                                      return value_with_radius_beside_an_edge(level);
                                    }};
  const std::vector<Approximation> values = fine_levels(bench, study, {beside_the_edge}).front().errors;
  const auto difference = [](double a, const Approximation& x, double b, const Approximation& y) {
    return Approximation{.value = a * x.value - b * y.value, .radius = a * x.radius + b * y.radius};
  };
  std::vector<Approximation> changes;
  for (std::size_t k = 1; k < values.size(); ++k)
    changes.push_back(difference(1, values[k], 1, values[k - 1]));
  for (std::size_t k = 1; k < changes.size(); ++k)
    finding.remark("the same, E = x^2, from level " + std::to_string(k) + " to " + std::to_string(k + 2),
                   exponent_between(changes[k - 1], changes[k]));
  std::vector<Approximation> without_h;
  for (std::size_t k = 2; k < changes.size(); ++k)
    without_h.push_back(difference(2, changes[k], 1, changes[k - 1]));
  for (std::size_t k = 1; k < without_h.size(); ++k)
    finding.remark("the same of the changes without the multiple of h, up to level " + std::to_string(k + 4),
                   exponent_between(without_h[k - 1], without_h[k]));
}

}  // namespace

Finding equation_82(const Bench& bench) {
  const BallPrecision precision(128);
  Finding finding;
  const Rational half(1, 2);
  const Order two = Order::at_least(2);
  const AtMost vanishing{
      .value = 0.01, .slack = 0, .why = "what tends to 0 with h falls below any number, such as 1/100"};

  finding.remark("gamma of (80): 7/3 times the bound rho/2 of norm of K, rho = 1/2",
                 proved(Ball(Rational(7, 12))));
  finding.require("half the jump at the end of the edge: coefficients other than those of rho/(16 - 8 rho)",
                  IsExactly{0}, jumps_unlike_the_formula(Rational(3, 8)));
  finding.control("the same along the edge, where (22) is pi/2", IsExactly{0},
                  jumps_unlike_the_formula(Rational(1, 2)));
  for (const int exponent : {1, 10, 40}) {
    const Ball t = power(Ball(2), -exponent);
    finding.require("(22)(t,t)/pi, t = 2^-" + std::to_string(exponent), LiesIn{0, Rational(3, 8)},
                    TwoSquares<Ball>(t, t).one() / Ball::pi());
  }
  const Ball tiny = power(Ball(2), -40);
  finding.control("(22)/pi beside the middle of the edge", LiesIn{0, Rational(3, 8)},
                  TwoSquares<Ball>(Ball(Rational(1, 2)), tiny).one() / Ball::pi());
  finding.require("a lower bound of norm of (u - u_n), whatever h, rho = 1/2", vanishing,
                  proved(half_the_jump(half, tiny)));

  const Problem problem = constant_emission_on_two_squares(half, 1);
  const auto on_the_edge = [&](Approximation EdgeError::*which) {
    return observed_order(over_levels(levels_from(1, 4), [&](int level) {
      return edge_error(bench.levels.level(problem, level), half).*which;
    }));
  };
  const ObservedOrder in_the_middle = on_the_edge(&EdgeError::at_midpoint);
  finding.require("order of |u - u_n| in the middle of the edge, levels 1 to 4", two, in_the_middle);
  finding.require("order of the largest |u - u_n| at vertices on the edge, levels 1 to 4", two,
                  on_the_edge(&EdgeError::anywhere));
  finding.show(in_the_middle.exponent);
  // With u in C^2 of each closed square (82) holds; for such a u the centroid rule has the order 1.
  const Problem smooth = linear_problem_with_solution("two_squares", {}, "1/2", "x^2 + y^2 + z^2");
  const LevelErrors of_smooth = uniform_errors(bench, smooth, levels_from(1, 3));
  const LevelErrors of_constant = uniform_errors(bench, by_centroids(smooth), levels_from(1, 3));
  finding.instead("order of u - u_n for u = x^2 + y^2 + z^2, linear interpolation", two,
                  observed_order(of_smooth));
  finding.control("order of u - u_n for u = x^2 + y^2 + z^2 and the centroid rule", two,
                  observed_order(of_constant));
  finding.instead("|u - u_n| for u = x^2 + y^2 + z^2, linear interpolation, h = 1/8", vanishing,
                  of_smooth.errors.back());
  finding.control("|u - u_n| for u = x^2 + y^2 + z^2 and the centroid rule, h = 1/8", vanishing,
                  of_constant.errors.back());
  finding.remark("order of the change of u_n beside an edge of the cube, E = x^2, rho = 2/5",
                 order_on_the_cube(bench, bench.budget == Budget::quick ? 3 : 4));
  if (bench.budget == Budget::full) add_fine_orders_on_the_cube(finding, bench);
  return finding;
}

}  // namespace radcert::verification::ac98
