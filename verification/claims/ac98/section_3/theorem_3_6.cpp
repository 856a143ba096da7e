// SPDX-License-Identifier: GPL-3.0-or-later

// A symmetric triangulation pairs its triangles and is better than Theorem 3.6 says. Here every triangle that
// is not turned against its chart is divided in three at its centroid: conforming, of one shape at every
// level, and the error terms of order h^5 of neighbours do not cancel.
//
// Checked      theorem_3_6: the order 3, and that it is not 4, for such triangulations; in balls on the
//              sphere, and on an ellipsoid from K(I - P_n)u at points by cubature, which by (49) bounds the
//              error. Alpha = 1/10 must be rejected. theorem_3_7: the order 4 up to the logarithm at the
//              nodes of symmetric triangulations, on two_piece, an ellipsoid and, in balls, the sphere; nodes
//              at the borders of charts and the others apart. theorem_3_7_own_element: the integral over the
//              triangle of v_i has an error O(h^4) of itself, whatever alpha: G is bounded, the area is
//              O(h^2) and u - P_n u = O(h^2). The theorem need not assume it.
// Not checked  the logarithm by itself; constants.
//
// The logarithm is not seen: error/h^4 settles faster than |log h| would let it. The bound of the proof takes
// |D_Q^2 G| where the error has D_Q^2 G itself. To leading order G depends on the direction of Q - P alone; a
// second derivative of such a function has mean 0 over circles about P, so that the integral over the annulus
// between h and 1 stays bounded.

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/ac98/collocation/error_from_afar.h"
#include "verification/claims/ac98/collocation/known_problems.h"
#include "verification/claims/ac98/collocation/sphere_collocation.h"
#include "verification/claims/proved_number.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::ac98 {
namespace {

Surface test_ellipsoid() { return ellipsoid(1, Rational(3, 2), 2); }

std::vector<ParameterTriangle> symmetric_elements(const Surface& surface, int level) {
  return triangulate(surface, level).triangles;
}

// On a unit triangle those that are not turned have their right angle below and left of their other corners.
bool upright(const std::array<ParameterPoint<double>, 3>& v) {
  const double s = std::min({v[0].s, v[1].s, v[2].s});
  const double t = std::min({v[0].t, v[1].t, v[2].t});
  return std::any_of(v.begin(), v.end(), [&](const auto& p) { return p.s == s && p.t == t; });
}

std::vector<ParameterTriangle> upright_divided_elements(const Surface& surface, int level) {
  std::vector<ParameterTriangle> result;
  for (const ParameterTriangle& each : symmetric_elements(surface, level)) {
    const auto& v = each.vertices;
    if (!upright(v)) {
      result.push_back(each);
      continue;
    }
    const ParameterPoint<double> centroid = (1.0 / 3) * (v[0] + v[1] + v[2]);
    result.push_back({each.chart, {v[0], v[1], centroid}});
    result.push_back({each.chart, {centroid, v[1], v[2]}});
    result.push_back({each.chart, {v[0], centroid, v[2]}});
  }
  return result;
}

Approximation largest_over_points(const Surface& surface, const std::vector<ParameterTriangle>& elements,
                                  double alpha) {
  Approximation worst{.value = 0, .radius = 0};
  for (const auto& [chart, s, t] :
       {std::tuple<std::size_t, double, double>{0, 0.31, 0.42}, {1, 0.17, 0.29}, {6, 0.55, 0.13}}) {
    const Approximation here = error_seen_from(surface, {chart, {s, t}}, elements, alpha);
    worst.value = std::max(worst.value, std::abs(here.value));
    worst.radius = std::max(worst.radius, here.radius);
  }
  return worst;
}

bool contains(const std::array<ParameterPoint<double>, 3>& v, const ParameterPoint<double>& p) {
  return cross(v[1] - v[0], p - v[0]) >= 0 && cross(v[2] - v[1], p - v[1]) >= 0 &&
         cross(v[0] - v[2], p - v[2]) >= 0;
}

// |Int G (u - P_n u)| over the triangle of v_i alone, largest over the nodes of two triangles: those that
// have their right angle at a vertex of level 2, of one shape and at one place at every level from there on.
Approximation own_element(const Surface& surface, int level, double alpha) {
  Approximation worst{.value = 0, .radius = 0};
  for (const ParameterTriangle& each : symmetric_elements(surface, level)) {
    const auto holds_one = [&](const std::pair<double, double>& at) {
      return contains(each.vertices, {at.first, at.second});
    };
    constexpr std::array<std::pair<double, double>, 2> points{
        {{0.25 + 1e-9, 0.25 + 1e-9}, {0.5 + 1e-9, 0.25 + 1e-9}}};
    if (each.chart != 0 || std::none_of(points.begin(), points.end(), holds_one)) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      ParameterPoint<double> node{0, 0};
      for (std::size_t i = 0; i < 3; ++i)
        node = node + (i == j ? 1 - 2 * alpha : alpha) * each.vertices.at(i);
      const Approximation here = error_seen_from(surface, {0, node}, {each}, alpha);
      worst.value = std::max(worst.value, std::abs(here.value));
      worst.radius = std::max(worst.radius, here.radius);
    }
  }
  return worst;
}

/// E on the unit sphere, and its mean.
struct Emission {
  SphereCollocation::Function at;
  Ball mean;
};
Emission exponential_in_z() {
  return {.at = [](const Vector<Ball>& q) { return exp(Ball(2) * q.z); },
          .mean = (exp(Ball(2)) - exp(Ball(-2))) / Ball(4)};
}
Emission product_of_squares() {
  return {.at = [](const Vector<Ball>& q) { return power(q.x * q.y * q.z, 2); },
          .mean = Ball(Rational(1, 105))};
}

// |M E - M_n E|, which is max |u - hat u_n| for rho = 1/2.
Approximation error_on_the_sphere(const std::vector<OctantTriangle>& triangles, const Rational& alpha,
                                  const Emission& emission) {
  return proved(abs(emission.mean - SphereCollocation(triangles, alpha).mean(emission.at)));
}

// At level 2 those errors still have the other sign, or are far from their power.
const std::vector<int> on_one_side = levels_from(3, 5);

// Int G (u - P_n u)/h^4 seen from the centroid of the first octant, which is the centroid of its triangle at
// every level, levels 1, 2, ...
std::vector<Approximation> scaled_errors_at_centroids(int last) {
  const Surface surface = test_ellipsoid();
  constexpr double third = 1.0 / 3;
  std::vector<Approximation> result;
  for (int level = 1; level <= last; ++level) {
    const Approximation error =
        error_seen_from(surface, {0, {third, third}}, symmetric_elements(surface, level), 1.0 / 6);
    const double scale = std::pow(16.0, level) / 4;  // h = 2^(1/2) 2^-level
    result.push_back({.value = scale * error.value, .radius = scale * error.radius});
  }
  return result;
}

}  // namespace

Finding theorem_3_6(const Bench& bench) {
  const BallPrecision precision(192);
  const Order three = Order::at_least(3);
  Finding finding;
  const Rational sixth(1, 6);
  const Rational tenth(1, 10);
  const auto on_the_sphere = [](const Rational& alpha) {
    return observed_order(over_levels(on_one_side, [&](int level) {
      return error_on_the_sphere(upright_divided_octant(level), alpha, product_of_squares());
    }));
  };
  const ObservedOrder sphere_order = on_the_sphere(sixth);
  finding.require(
      "order of max |u - hat u_n|, sphere, E = x^2 y^2 z^2, upright triangles divided, levels 3 to 5", three,
      sphere_order);
  finding.require("that it is not 4", Order::is(3), sphere_order);
  finding.control("the same, alpha = 1/10", three, on_the_sphere(tenth));
  finding.control("that it is not 4: symmetric triangulation, E = exp(2 z)", Order::is(3),
                  observed_order(over_levels(on_one_side, [&](int level) {
                    return error_on_the_sphere(symmetric_octant(level), sixth, exponential_in_z());
                  })));
  const Surface surface = test_ellipsoid();
  const int last = bench.budget == Budget::quick ? 4 : 5;
  const auto on_the_ellipsoid = [&](double alpha) {
    return observed_order(over_levels(levels_from(2, last), [&](int level) {
      return largest_over_points(surface, upright_divided_elements(surface, level), alpha);
    }));
  };
  finding.require("order of max |K(I - P_n)u| over points, ellipsoid (1,3/2,2), upright triangles divided",
                  three, on_the_ellipsoid(1.0 / 6));
  finding.control("the same, alpha = 1/10", three, on_the_ellipsoid(0.1));
  finding.show(sphere_order.exponent);
  return finding;
}

Finding theorem_3_7(const Bench& bench) {
  const BallPrecision precision(192);
  const Order four = Order::at_least(4);
  const OrderModel printed{.logarithm = true};
  Finding finding;
  const Rational sixth(1, 6);
  const std::string inverse_distance = "1/sqrt(x^2 + y^2 + (z-1/2)^2)";
  const std::string squares = "x^2 + y^2 + z^2";
  const std::string exponential = "exp(x + y/2 - z/3)";
  struct Case {
    std::string surface;
    std::vector<SurfaceParameter> parameters;
    std::string reflectivity;
    std::string solution;
    int last;
    bool at_quick;
  };
  const std::vector<SurfaceParameter> axes{{"a", 1}, {"b", Rational(3, 2)}, {"c", 2}};
  const std::vector<Case> cases{{"two_piece", {{"p", 2}}, "1", inverse_distance, 4, true},
                                {"two_piece", {{"p", 3}}, "1", squares, 4, true},
                                {"two_piece", {{"p", 3}}, "1", exponential, 4, false},
                                {"two_piece", {{"p", 3}}, "1", inverse_distance, 4, false},
                                {"two_piece", {{"p", 2}}, "1", squares, 4, false},
                                {"ellipsoid", axes, "1/2", squares, 3, true},
                                {"ellipsoid", axes, "1/2", exponential, 3, false}};
  Approximation shown{.value = 0, .radius = 0};
  for (const Case& each : cases) {
    if (!each.at_quick && bench.budget == Budget::quick) continue;
    const Problem problem =
        known_problem(each.surface, each.parameters, each.reflectivity, each.solution, 1, sixth);
    const Surface surface = surface_of(problem);
    const auto over_nodes = [&](bool at_the_border) {
      return node_errors(bench, problem, levels_from(each.last - 2, each.last),
                         [&](const NodeValue&, const ParameterTriangle& element) {
                           return touches_the_border(surface, element) == at_the_border;
                         });
    };
    const std::string at =
        ", " + each.surface +
        (each.surface == "two_piece" ? "(" + each.parameters[0].value.to_text() + ")" : "") + ", " +
        each.solution;
    const LevelErrors errors = node_errors(bench, problem, levels_from(each.last - 2, each.last));
    const ObservedOrder order = observed_order(errors, printed);
    shown = order.exponent;
    finding.remark("max |u(v_i) - hat u_n(v_i)|, level " + std::to_string(each.last) + at,
                   errors.errors.back());
    finding.remark("its exponent from the last level but one",
                   exponent_between(*(errors.errors.end() - 2), errors.errors.back()));
    finding.require("order of max |u(v_i) - hat u_n(v_i)|" + at, four, order);
    if (each.last < 4) continue;  // too few elements lie inside their charts
    finding.require("the same over the nodes at the borders of charts" + at, four,
                    observed_order(over_nodes(true), printed));
    finding.require("the same over the other nodes" + at, four, observed_order(over_nodes(false), printed));
  }
  const Problem tenth = known_problem("two_piece", {{"p", 2}}, "1", inverse_distance, 1, Rational(1, 10));
  finding.control("the same, alpha = 1/10, two_piece(2), " + inverse_distance, four,
                  observed_order(node_errors(bench, tenth, levels_from(2, 4)), printed));
  const auto on_the_sphere = [&](const auto& triangulation) {
    return observed_order(
        over_levels(
            on_one_side,
            [&](int level) { return error_on_the_sphere(triangulation(level), sixth, exponential_in_z()); }),
        printed);
  };
  finding.require("sphere, E = exp(2 z): the same in balls, levels 3 to 5", four,
                  on_the_sphere(symmetric_octant));
  const std::vector<Approximation> scaled = scaled_errors_at_centroids(bench.budget == Budget::quick ? 5 : 6);
  for (std::size_t i = 0; i < scaled.size(); ++i)
    finding.remark(
        "ellipsoid, Int G (u - P_n u) over h^4, P the centroid of an octant, level " + std::to_string(i + 1),
        scaled[i]);
  finding.control("sphere, E = exp(2 z): upright triangles divided", four,
                  on_the_sphere(upright_divided_octant));
  finding.show(shown);
  return finding;
}

Finding theorem_3_7_own_element(const Bench& bench) {
  const Order four = Order::at_least(4);
  const int last = bench.budget == Budget::quick ? 5 : 6;
  const Surface surface = test_ellipsoid();
  Finding finding;
  Approximation shown{.value = 0, .radius = 0};
  for (const double alpha : {1.0 / 6, 0.1}) {
    const LevelErrors errors =
        over_levels(levels_from(2, last), [&](int level) { return own_element(surface, level, alpha); });
    const Approximation fine = errors.errors.back();
    const std::string at = ", ellipsoid (1,3/2,2), alpha = " + std::string(alpha == 0.1 ? "1/10" : "1/6");
    const ObservedOrder order = observed_order(errors);
    shown = order.exponent;
    finding.require("order of the integral over the triangle of v_i" + at, four, order);
    finding.remark(
        "largest such integral over h^4, finest level" + at,
        {.value = fine.value * std::pow(16.0, last) / 4, .radius = fine.radius * std::pow(16.0, last) / 4});
  }
  finding.control("the same over all triangles, alpha = 1/10, levels 1 to 3", four,
                  observed_order(over_levels(levels_from(1, 3), [&](int level) {
                    return largest_over_points(surface, symmetric_elements(surface, level), 0.1);
                  })));
  finding.show(shown);
  return finding;
}

}  // namespace radcert::verification::ac98
