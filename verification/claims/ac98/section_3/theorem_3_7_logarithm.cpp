// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the error at a node has the |log h| of (79). Where it has, e = h^4 (c |log h| + d + ...), the
// number e/h^4 grows by c log 2 from level to level, and what it changes by does not tend to 0; where e = d
// h^4 (1 + O(h)) that change falls like h. So the order of the change tells them apart: 0 or 1. By (51) the
// error is bounded by Int G (u - P_n u) at the nodes, which is taken here, at nodes that have one place in
// their element, and whose element has one vertex, at every level: amid a chart, and at a seam, where the
// triangulations of two charts meet as mirror images and the second differences of u on both sides need not
// cancel.
//
// Why there is none: the bound of the proof takes |D_Q^2 G| where the error has D_Q^2 G itself. To leading
// order G depends on the direction of Q - P alone; a second derivative of such a function has mean 0 over
// circles about P, so that the integral over the annulus between h and 1 stays bounded. At a seam half
// circles count by themselves, of which this argument says nothing; that e/h^4 settles there is observed.
//
// Checked      ellipsoid (1,3/2,2), u = exp(x + y/2 - z/3), alpha = 1/6: the order of the change at a node of
//              an element amid a chart and at one of a seam, levels 3 to 6 at quick, 3 to 8 at standard, 3
//              to 9 at full, where there would be 6 million unknowns; with alpha = 1/10, where e falls more
//              slowly, the change grows. At full the order of the errors over all nodes of the solution on
//              two_piece(2), u = exp(4x + 2y - z), up to 196,608 unknowns, without a logarithm: of
//              |K(I - P_n)u| told from 3.96, of |u - hat u_n| from 3.9; h^4 |log h| would show as 3.76.
// Not checked  other surfaces and data; a logarithm with a coefficient so small that it does not show; level
//              10, where the radius of the elements about P exceeds the change.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "verification/claims/ac98/collocation/error_from_afar.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/framework/fine_levels.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

/// A node of the element that has its right angle at a vertex of level 1 or 2 of the first octant.
struct Place {
  std::string name;
  ParameterPoint<double> vertex;
  std::size_t node;
};

ParameterPoint<double> node_at(const Place& place, const std::vector<ParameterTriangle>& elements,
                               double alpha) {
  for (const ParameterTriangle& each : elements) {
    const ParameterPoint<double> middle = each.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
    if (each.chart != 0 || !(middle.s > place.vertex.s) || !(middle.t > place.vertex.t)) continue;
    for (const ParameterPoint<double>& v : each.vertices) {
      if (v.s != place.vertex.s || v.t != place.vertex.t) continue;
      std::array<double, 3> x{alpha, alpha, alpha};
      x.at(place.node) = 1 - 2 * alpha;
      return each.at(x);
    }
  }
  expects(false, "a level with that vertex");
  return {};
}

// |Int G (u - P_n u)|/h^4 at one level less that at the next, h = 2^(1/2) 2^-level.
LevelErrors changes_of_the_scaled_error(const Place& place, double alpha, int first, int last) {
  const Surface surface = ellipsoid(1, Rational(3, 2), 2);
  const auto scaled = [&](int level) {
    const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    const Approximation error =
        error_seen_from(surface, {0, node_at(place, elements, alpha)}, elements, alpha);
    const double scale = std::pow(16.0, level) / 4;
    return Approximation{.value = scale * error.value, .radius = scale * error.radius};
  };
  Approximation coarse = scaled(first);
  return over_levels(levels_from(first + 1, last), [&](int level) {
    const Approximation fine = scaled(level);
    const Approximation change{.value = std::abs(fine.value - coarse.value),
                               .radius = fine.radius + coarse.radius};
    coarse = fine;
    return change;
  });
}

}  // namespace

Finding theorem_3_7_logarithm(const Bench& bench) {
  const int last = bench.budget == Budget::quick ? 6 : bench.budget == Budget::standard ? 8 : 9;
  const Order none = Order::at_least(1, 0);
  Finding finding;
  const std::string of = "order of what Int G (u - P_n u)/h^4 changes by from level to level, a node ";
  const std::string levels = ", levels 3 to " + std::to_string(last);
  Approximation shown{.value = 0, .radius = 0};
  const Place amid{"amid a chart", {0.25, 0.25}, 0};
  for (const Place& place : {amid, Place{"beside a seam", {0.5, 0}, 2}}) {
    const LevelErrors changes = changes_of_the_scaled_error(place, 1.0 / 6, 3, last);
    const ObservedOrder order = observed_order(changes);
    finding.require(of + place.name + levels, none, order);
    finding.remark("the last such change, " + place.name, changes.errors.back());
    shown = order.exponent;
  }
  finding.control("the same, alpha = 1/10, levels 3 to 6, a node " + amid.name, none,
                  observed_order(changes_of_the_scaled_error(amid, 0.1, 3, 6)));
  if (bench.budget == Budget::full) {
    const auto over_all_nodes = [&](const Rational& alpha, int expected, const Rational& tolerance) {
      const FineStudy study{
          .problem = known_problem("two_piece", {{"p", 2}}, "1/2", "exp(4*x + 2*y - z)", 1, alpha),
          .first = 5,
          .last = 7,
          .tolerance = tolerance,
          .order = expected};
      return fine_levels(bench, study, {node_error_figure(), discretisation_error_figure()});
    };
    const std::vector<LevelErrors> sixth = over_all_nodes(Rational(1, 6), 4, Rational(1, 10000000000000));
    const std::vector<LevelErrors> tenth = over_all_nodes(Rational(1, 10), 2, Rational(1, 1000000000));
    // The radius of u_n is a larger part of the one than that of its source of the other.
    const std::array orders{Order::at_least(4, 3.9), Order::at_least(4, 3.96)};
    const std::array<std::string, 2> errors{"|u - hat u_n|", "|K(I - P_n)u|"};
    for (std::size_t i = 0; i < orders.size(); ++i) {
      const std::string what =
          "order of max " + errors.at(i) + " over the nodes, two_piece(2), levels 5 to 7";
      finding.require(what, orders.at(i), observed_order(sixth[i]));
      finding.control(what + ", alpha = 1/10", orders.at(i), observed_order(tenth[i]));
    }
  }
  finding.show(shown);
  return finding;
}

}  // namespace radcert::verification::ac98
