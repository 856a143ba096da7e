// SPDX-License-Identifier: GPL-3.0-or-later

// The concluding remarks. On the surface (20) with E = 1 the solution is 1/(1 - rho/2) on the common edge,
// whatever it is elsewhere, so that the error of u_n there is known without a reference solution.
//
// Checked      section_6_ill_behaved: u - u_n in the middle of the edge falls like h^b with the b of r^b
//              beside a right-angled edge, for two reflectivities: u is no smoother than that.
//              section_6_grading: with vertices at c -> (2c)^q/2 it falls like h^(q b), up to h^2.
//              section_6_piecewise_emissivity: a jump of E on the sphere, where u is known, leaves an error
//              that does not fall with h in the elements that it crosses.
// Not checked  corners of closed surfaces; other angles than the right one; where several edges meet.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "radcert/formats/result/stored_levels.h"
#include "radcert/study/study.h"
#include "verification/claims/ac98/collocation/edge_value.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

// At level 1 the only vertex amid a side is 1/2: grading leaves it where it is.
LevelErrors errors_in_the_middle(const Bench& bench, const Rational& reflectivity, const Rational& grading) {
  constexpr int finest_level = 4;
  const Problem problem = constant_emission_on_two_squares(reflectivity, grading);
  return over_levels(levels_from(2, finest_level), [&](int level) {
    return edge_error(bench.levels.level(problem, level), reflectivity).at_midpoint;
  });
}

// E on the unit sphere as a function of z, and its mean M(E). G = 1/4 there: u = E + M(E) rho/(1 - rho).
struct ZonalEmission {
  std::string emission;
  std::function<double(double)> at;
  double mean;
};

ObservedOrder order_on_the_sphere(const Bench& bench, const ZonalEmission& data, int last) {
  Problem problem = linear_problem("sphere", {}, "1/2");
  problem.emission = on_all_pieces(data.emission);
  return observed_order(over_levels(levels_from(0, last), [&](int level) {
    const LevelOutcome outcome = bench.levels.level(problem, level);
    // At a corner |l_1| + |l_2| + |l_3| is 7/3.
    Approximation largest{.value = 0, .radius = 7.0 / 3 * outcome.result.solution_radius.value()};
    for (const ElementValue& element : outcome.elements)
      for (std::size_t i = 0; i < element.corners.size(); ++i)
        largest.value = std::max(largest.value, std::abs(element.corner_values.at(i) - data.mean -
                                                         data.at(element.corners.at(i).z)));
    return largest;
  }));
}

}  // namespace

Finding section_6_ill_behaved(const Bench& bench) {
  Finding finding;
  for (const Rational& rho : {Rational(1, 2), Rational(9, 10)}) {
    const double b = edge_exponent(rho);
    // Told from that of the other reflectivity, and from a u that jumps or is smooth up to the edge.
    const double half = edge_exponent(Rational(1, 2));
    const double nine_tenths = edge_exponent(Rational(9, 10));
    const Order exponent = rho == Rational(1, 2) ? Order::is(b, nine_tenths, 1) : Order::is(b, 0, half);
    const ObservedOrder order = observed_order(errors_in_the_middle(bench, rho, 1));
    finding.require("order of u - u_n in the middle of the edge, rho = " + rho.to_text() + ", against b",
                    exponent, order);
    finding.control("order of u - u_n for a smooth u, against b of rho = " + rho.to_text(), exponent,
                    observed_order(uniform_errors(
                        bench, linear_problem_with_solution("two_squares", {}, rho.to_text(), "x^2"),
                        levels_from(1, 3))));
    if (rho == Rational(1, 2)) finding.show(order.exponent);
  }
  return finding;
}

Finding section_6_grading(const Bench& bench) {
  Finding finding;
  for (const Rational& rho : {Rational(1, 2), Rational(9, 10)})
    for (const int grading : {2, 3}) {
      if (bench.budget == Budget::quick && rho != Rational(1, 2)) continue;
      const double b = edge_exponent(rho);
      const LevelErrors graded = errors_in_the_middle(bench, rho, grading);
      // What is left of it beyond the order b without grading: h^(q b) from the edge, h^2 from elsewhere.
      const Order better = Order::at_least(std::min(2.0, grading * b), b);
      const std::string with = ", rho = " + rho.to_text();
      finding.require("order in the middle of the edge, graded by " + std::to_string(grading) + with, better,
                      observed_order(graded));
      finding.control("order there without grading, against " + std::to_string(grading) + " b" + with, better,
                      observed_order(errors_in_the_middle(bench, rho, 1)));
    }
  return finding;
}

Finding section_6_piecewise_emissivity(const Bench& bench) {
  const int level = bench.budget == Budget::quick ? 2 : 3;
  const Order lost = Order::at_most(0, 2);
  const ObservedOrder kinked = order_on_the_sphere(bench,
                                                   {.emission = "2 + abs(z - 1/3)/(z - 1/3)",
                                                    .at = [](double z) { return 3 * z > 1 ? 3.0 : 1.0; },
                                                    .mean = 5.0 / 3},
                                                   level);
  Finding finding;
  finding.require("order of u - u_n at vertices of elements, sphere, E = 2 + sign(z - 1/3)", lost, kinked);
  finding.control(
      "order of u - u_n at vertices of elements, sphere, E = z^2", lost,
      order_on_the_sphere(bench, {.emission = "z^2", .at = [](double z) { return z * z; }, .mean = 1.0 / 3},
                          level));
  finding.show(kinked.exponent);
  return finding;
}

}  // namespace radcert::verification::ac98
