// SPDX-License-Identifier: GPL-3.0-or-later

// (39) is u_n inside each element; on a side the two elements that share it have a value each. There u_n
// has the order of linear interpolation, and no more: what alpha = 1/6 gains is gained at the nodes alone.
// The iterated solution E + K u_n keeps it at any point.
//
// Checked      at the corners and the middles of the sides of all elements, alpha = 1/6: the order of |u -
//              u_n| and of what the values of two elements at one point of a chart differ by, on
//              two_piece(2) and (3); the order of |u - hat u_n| at two such points of the roof, against
//              that of (39) there. Rejected: the centroid rule, and E = 1 on the edge of (20), where u_n
//              is off by r^b.
// Not checked  points between those; other surfaces and data.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "radcert/formats/result/stored_levels.h"
#include "radcert/study/study.h"
#include "verification/claims/ac98/collocation/edge_value.h"
#include "verification/claims/ac98/collocation/element_function.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

// The corners of an element and the middles of its sides.
constexpr std::array<std::array<double, 3>, 6> on_the_sides{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}};

struct SideErrors {
  Approximation error;  ///< the largest |u - u_n|
  Approximation jump;   ///< the largest difference of the values of (39) at one point of a chart
};

SideErrors side_errors(const Bench& bench, const Problem& problem, int level) {
  const LevelOutcome outcome = bench.levels.level(problem, level);
  const ElementFunction u_n(problem, outcome);
  const SurfaceFunction u(problem.solution.value(), u_n.surface());
  // Parameters of corners and middles are dyadic, and so are the same doubles for every element.
  std::map<std::tuple<std::size_t, double, double>, std::pair<double, double>> values;
  // 7/3 is the norm of P_n.
  const double radius = 7.0 / 3 * outcome.result.solution_radius.value();
  SideErrors largest{.error = {.value = 0, .radius = radius}, .jump = {.value = 0, .radius = 2 * radius}};
  for (std::size_t k = 0; k < u_n.triangles().size(); ++k)
    for (const auto& x : on_the_sides) {
      const ParameterTriangle& element = u_n.triangles()[k];
      const ParameterPoint<double> at = element.at(x);
      const double value = u_n(k, at);
      const Vector<double> point = u_n.surface().charts.at(element.chart).in<double>().frame(at).point;
      largest.error.value = std::max(largest.error.value, std::abs(u(element.chart, point) - value));
      auto& [low, high] = values.try_emplace({element.chart, at.s, at.t}, value, value).first->second;
      low = std::min(low, value);
      high = std::max(high, value);
      largest.jump.value = std::max(largest.jump.value, high - low);
    }
  return largest;
}

LevelErrors over(const Bench& bench, const Problem& problem, Approximation SideErrors::*which) {
  return over_levels(levels_from(1, 4), [&](int level) { return side_errors(bench, problem, level).*which; });
}

// On the roof, vertices from level 2 on.
constexpr std::array<ParameterPoint<double>, 2> places{{{0.5, 0.5}, {0.5, 0.25}}};

// |u - hat u_n| at those points; or |u - u_n| by (39), the largest of the elements that have the point.
LevelErrors at_the_places(const Bench& bench, const Problem& problem, bool iterated) {
  constexpr std::size_t roof = 1;
  return over_levels(levels_from(2, 4), [&](int level) {
    const LevelOutcome outcome = bench.levels.level(problem, level);
    const IteratedError iterated_error(bench.route, problem, outcome);
    const ElementFunction& u_n = iterated_error.u_n();
    const SurfaceFunction u(problem.solution.value(), u_n.surface());
    Approximation worst{.value = 0, .radius = 0};
    const auto take = [&](const Approximation& here) {
      worst.value = std::max(worst.value, here.value);
      worst.radius = std::max(worst.radius, here.radius);
    };
    for (const ParameterPoint<double>& p : places) {
      if (iterated) {
        take(iterated_error({roof, p}));
        continue;
      }
      const Vector<double> point = u_n.surface().charts.at(roof).in<double>().frame(p).point;
      for (std::size_t k = 0; k < u_n.triangles().size(); ++k) {
        const ParameterTriangle& element = u_n.triangles()[k];
        const bool has_it = std::any_of(on_the_sides.begin(), on_the_sides.end(), [&](const auto& x) {
          return element.at(x).s == p.s && element.at(x).t == p.t;
        });
        if (element.chart == roof && has_it)
          take({.value = std::abs(u(roof, point) - u_n(k, p)),
                .radius = 7.0 / 3 * outcome.result.solution_radius.value()});
      }
    }
    return worst;
  });
}

}  // namespace

Finding section_4_2_evaluation(const Bench& bench) {
  const Order two = Order::is(2);
  const Order at_least_four = Order::at_least(4);
  const OrderModel with_logarithm{.logarithm = true};
  Finding finding;
  const auto roof = [](int p) {
    return linear_problem_with_solution("two_piece", {{"p", p}}, "1", "x^2 + y^2 + z^2");
  };
  for (const int p : {2, 3}) {
    const std::string of = " at corners and middles of sides, two_piece(" + std::to_string(p) + ")";
    const ObservedOrder order = observed_order(over(bench, roof(p), &SideErrors::error));
    finding.require("order of |u - u_n|" + of, two, order);
    finding.require("order of what the values of two elements differ by" + of, two,
                    observed_order(over(bench, roof(p), &SideErrors::jump)));
    if (p == 2) finding.show(order.exponent);
  }
  const Problem constants = by_centroids(roof(2));
  finding.control("order of |u - u_n| there, centroid rule, two_piece(2)", two,
                  observed_order(over(bench, constants, &SideErrors::error)));
  finding.control("order of what the values of two elements differ by, centroid rule, two_piece(2)", two,
                  observed_order(over(bench, constants, &SideErrors::jump)));
  const Rational half(1, 2);
  const Problem edge = constant_emission_on_two_squares(half, 1);
  finding.control("order of |u - u_n| in the middle of the edge of (20), E = 1, rho = 1/2", two,
                  observed_order(over_levels(levels_from(2, 4), [&](int level) {
                    return edge_error(bench.levels.level(edge, level), half).at_midpoint;
                  })));
  finding.require(
      "order of |u - hat u_n| beside |log h| at (1/2,1/2) and (1/2,1/4) of the roof, two_piece(2)",
      at_least_four, observed_order(at_the_places(bench, roof(2), true), with_logarithm));
  finding.control("order of |u - u_n| beside |log h| there by (39)", at_least_four,
                  observed_order(at_the_places(bench, roof(2), false), with_logarithm));
  return finding;
}

}  // namespace radcert::verification::ac98
