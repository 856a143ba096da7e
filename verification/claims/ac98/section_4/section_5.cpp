// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      section_5_centroid_rule: "on a smooth surface with a smooth u one would expect O(h^2)" of the
//              centroid rule at its nodes, where on the cube it is O(h): two_piece(2) and (3), u = x^2 + y^2
//              + z^2. section_5_1: a product Gauss rule for Int G l_j over one element, the node at the
//              distance d above the centroid of the element: the order that a given accuracy takes grows as d
//              falls, and a fixed rule loses its digits.
// Not checked  the rules of the package [3], which are not in the paper.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

// Int G l_3 over the triangle (0,0), (1,0), (0,1), times the leg, of the plane z = 0, l_3 = (s - 1/6)/(1 -
// 1/2), from a point at (leg/3, leg/3, d) with the normal that looks down at an angle, by a rule of that
// order.
double by_rule(int order, double d, double leg) {
  const Vector<double> p{leg / 3, leg / 3, d};
  const Vector<double> n_p{0.6, 0, -0.8};
  const Vector<double> n_q{0, 0, 1};
  const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const auto& x = rule.points[i].x;
    const Vector<double> q{leg * x[2], leg * x[1], 0};
    sum += leg * leg * rule.weights[i] * geometric_kernel(p, n_p, q, n_q) * 2 * (x[2] - 1.0 / 6);
  }
  return sum;
}

constexpr int finest_order = 96;

double error_of(int order, double d, double leg = 1) {
  return std::abs(by_rule(order, d, leg) - by_rule(finest_order, d, leg));
}

// The least order with an error of at most 1e-6, that of all higher ones included.
int order_needed(double d, double leg = 1) {
  constexpr double accuracy = 1e-6;
  for (int order = finest_order / 2; order >= 1; --order)
    if (error_of(order, d, leg) > accuracy) return order + 1;
  return 1;
}

}  // namespace

Finding section_5_centroid_rule(const Bench& bench) {
  const Order two = Order::at_least(2);
  Finding finding;
  const auto order_of = [&](const std::string& surface, std::vector<SurfaceParameter> parameters,
                            const std::string& rho) {
    const Problem problem =
        by_centroids(linear_problem_with_solution(surface, std::move(parameters), rho, "x^2 + y^2 + z^2"));
    return observed_order(node_errors(bench, problem, levels_from(1, bench.budget == Budget::quick ? 3 : 4)));
  };
  const ObservedOrder smooth = order_of("two_piece", {{"p", 2}}, "1");
  finding.require("order of the node error, two_piece(2)", two, smooth);
  finding.require("order of the node error, two_piece(3)", two, order_of("two_piece", {{"p", 3}}, "1"));
  finding.control("order of the node error, cube", two, order_of("cube", {}, "1/2"));
  finding.show(smooth.exponent);
  return finding;
}

Finding section_5_1(const Bench&) {
  Finding finding;
  const std::array<double, 5> distances{4, 1, 0.5, 0.25, 0.125};
  const AtMost fewer{.value = -1, .slack = 0, .why = "a farther element takes a lower order"};
  for (std::size_t i = 0; i + 1 < distances.size(); ++i)
    finding.require("order needed at the distance " + std::to_string(distances.at(i)) + " less that at " +
                        std::to_string(distances.at(i + 1)),
                    fewer,
                    Approximation{.value = static_cast<double>(order_needed(distances.at(i)) -
                                                               order_needed(distances.at(i + 1))),
                                  .radius = 0});
  // What counts is the distance in elements: at half the distance of an element of half the size the order is
  // the same.
  finding.control(
      "order needed at the distance 1/2 less that at 1/4 of an element with legs 1/2", fewer,
      Approximation{.value = static_cast<double>(order_needed(0.5) - order_needed(0.25, 0.5)), .radius = 0});
  for (const double d : distances) {
    finding.remark("order needed for 1e-6 at the distance " + std::to_string(d),
                   {.value = static_cast<double>(order_needed(d)), .radius = 0});
    finding.remark("error of order 4 at the distance " + std::to_string(d),
                   {.value = error_of(4, d), .radius = 1e-12});
  }
  return finding;
}

}  // namespace radcert::verification::ac98
