// SPDX-License-Identifier: GPL-3.0-or-later

// The rates at the nodes, Theorems 7 and 9, and (24), (26) on the way to them.
//
// Checked      max |u - u_n| over the nodes, rho = 1/2, symmetric triangulations, levels from 1 on: r = 1 and
//              3 at alpha_0 and at 1/10, where (36) must fail, r = 0, 2, 4 at 1/10; on two_piece(2), two
//              smooth pieces that do not meet, and the ellipsoid (1, 5/4, 3/2) for u = exp(x/2 + y/3 - z/4),
//              on the sphere, without a matrix, for u = x^4. On the ellipsoid beyond quick also over those
//              nodes alone whose element has a vertex on the side of a chart; for r = 3 and 4 |K(I - P_n)u|
//              at the nodes of two of its elements, one amid a chart and one at a seam, up to 8192 elements;
//              without a matrix, which at level 2 gives what the study has. (24): the quotient falls like a
//              power of h for these methods, and not for r = 1 and 3 at alpha = 1/10. (26): the quotient of
//              the two sides is at most 1/(1 - norm of K_n). At full, by an operator of clusters, up to
//              196,608 unknowns for r = 1 and 98,304 for r = 2: orders without a logarithm, told from one
//              that is less by 1/25 to 1/5 (fine_orders).
// Not checked  the logarithm apart from its power. That fewer derivatives suffice: theorem_7_smoothness. The
//              integrals over the node's own element are evaluated as well as all others, so that the
//              assumption on them is met; for the collocation method itself that error is O(h^(r+3)) in any
//              case, as G is bounded.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/claims/m06/fine_orders.h"
#include "verification/claims/m06/kernel_error.h"
#include "verification/claims/m06/named_problems.h"
#include "verification/claims/m06/sphere_errors.h"
#include "verification/framework/level_errors.h"

namespace radcert::verification::m06 {
namespace {

// (36) of Theorem 7 has |log h|, (37) of Theorem 9 has not.
struct Rate {
  int gained;  ///< beyond r
  OrderModel model;
};
constexpr Rate of_theorem_7{.gained = 3, .model = {.logarithm = true}};
constexpr Rate of_theorem_9{.gained = 2, .model = {}};

int degree_of(const Problem& problem) { return triangle_basis_of(problem.method).degree; }

ObservedOrder order_at_nodes(const Bench& bench, const std::string& name, const Rate& rate) {
  const Problem problem = problem_named(name);
  return observed_order(node_errors(bench, problem, levels_of_an_order(problem, bench.budget)), rate.model);
}

void require_orders(Finding& finding, const Bench& bench, const std::vector<std::string>& names,
                    const Rate& rate) {
  for (const std::string& name : names)
    finding.require("order of max |u - u_n| over the nodes, " + name,
                    Order::at_least(degree_of(problem_named(name)) + rate.gained),
                    order_at_nodes(bench, name, rate));
}

void control_orders(Finding& finding, const Bench& bench, const std::vector<std::string>& names,
                    const Rate& rate) {
  for (const std::string& name : names)
    finding.control("order of max |u - u_n| over the nodes, " + name,
                    Order::at_least(degree_of(problem_named(name)) + rate.gained),
                    order_at_nodes(bench, name, rate));
}

const std::vector<int> levels_on_the_sphere = levels_from(3, 6);

ObservedOrder order_on_the_sphere(const TriangleBasis<double>& basis, const Rate& rate) {
  return observed_order(errors_on_the_sphere(basis, fourth_power, levels_on_the_sphere).nodes, rate.model);
}

// The orders over elements at the seams and over the others, from level 1 and from 2 on.
void require_seams_apart(Finding& finding, const Bench& bench, const std::string& name, const Rate& rate) {
  const Problem problem = problem_named(name);
  const Surface surface = surface_of(problem);
  finding.require("order over the nodes of the elements that touch a seam, " + name,
                  Order::at_least(degree_of(problem) + rate.gained),
                  observed_order(node_errors(bench, problem, levels_of_an_order(problem, bench.budget),
                                             [&](const NodeValue&, const ParameterTriangle& element) {
                                               return touches_the_border(surface, element);
                                             }),
                                 rate.model));
}

// Over the nodes of two elements alone no matrix is needed, and finer levels than those of a solution come
// into reach.
double on_the_ellipsoid(const Vector<double>& q) { return std::exp(q.x / 2 + q.y / 3 - q.z / 4); }

/// A vertex of the first octant's unit triangle at level 2.
struct Spot {
  std::string name;
  ParameterPoint<double> at;
};

// The element of the first chart that has its right angle at the spot: of one shape at every level.
const ParameterTriangle& element_at(const std::vector<ParameterTriangle>& elements, const Spot& spot) {
  return *std::find_if(elements.begin(), elements.end(), [&](const ParameterTriangle& t) {
    const ParameterPoint<double> middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
    const auto is_at = [&](const ParameterPoint<double>& v) { return v.s == spot.at.s && v.t == spot.at.t; };
    return t.chart == 0 && middle.s > spot.at.s && middle.t > spot.at.t &&
           std::any_of(t.vertices.begin(), t.vertices.end(), is_at);
  });
}

LevelErrors errors_at(const Spot& spot, const TriangleBasis<double>& basis, int last) {
  const Surface surface = ellipsoid(1, Rational(5, 4), Rational(3, 2));
  return over_levels(levels_from(last - 2, last), [&](int level) {
    const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    return kernel_error_at_nodes(surface, elements, element_at(elements, spot), basis, on_the_ellipsoid);
  });
}

// The same by the collocation matrix and the second route to Ku: both over all nodes of a coarse level.
void require_agreement(Finding& finding, const Bench& bench, const std::string& name, int level) {
  const Problem problem = problem_named(name);
  const Surface surface = surface_of(problem);
  const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
  const auto largest_of = [&](const TriangleBasis<double>& basis) {
    std::vector<double> of_element(elements.size());
    parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        of_element[k] = kernel_error_at_nodes(surface, elements, elements[k], basis, on_the_ellipsoid).value;
    });
    constexpr double rho = 0.5;
    return rho / std::numbers::pi * *std::max_element(of_element.begin(), of_element.end());
  };
  const Approximation study = bench.levels.level(problem, level).result.discretisation_error.value();
  const Equals one{.value = 1, .slack = 0.001, .why = "rules of order 14 beside the nodes"};
  const std::string what = "largest |K(I - P_n)u| without a matrix over that of the study, " + name +
                           ", level " + std::to_string(level);
  finding.require(
      what, one,
      Approximation{.value = largest_of(triangle_basis(triangle_basis_of(problem.method))) / study.value,
                    .radius = 0});
  finding.control(what + ", nodes (13) of degree 1", one,
                  Approximation{.value = largest_of(nodes_at_a_tenth(1)) / study.value, .radius = 0});
}

// Order r + gained for the chosen nodes of degree r; nodes of another degree at alpha = 1/10 do not have it.
void require_rate_at_spots(Finding& finding, const Bench& bench, int r, const Rate& rate, int other) {
  const int last = bench.budget == Budget::quick ? 4 : 5;
  const Order order = Order::at_least(r + rate.gained);
  for (const Spot& spot : {Spot{"amid a chart", {0.25, 0.25}}, {"at a seam", {0.0, 0.5}}}) {
    const std::string of = ", ellipsoid, r = " + std::to_string(r) + ", an element " + spot.name;
    finding.require("order of |K(I - P_n)u|" + of + ", levels " + std::to_string(last - 2) + " to " +
                        std::to_string(last),
                    order, observed_order(errors_at(spot, chosen_nodes(r), last), rate.model));
    if (spot.at.s == 0) continue;
    finding.control("the same, nodes (13) of degree " + std::to_string(other) + ", alpha = 1/10" + of, order,
                    observed_order(errors_at(spot, nodes_at_a_tenth(other), last), rate.model));
  }
}

// The quotient of (24) level by level.
LevelErrors quotients(const LevelErrors& nodes, const LevelErrors& everywhere) {
  LevelErrors quotients{.mesh_sizes = nodes.mesh_sizes, .errors = {}};
  for (std::size_t k = 0; k < nodes.errors.size(); ++k)
    quotients.errors.push_back({.value = nodes.errors[k].value / everywhere.errors[k].value,
                                .radius = nodes.errors[k].radius / everywhere.errors[k].value});
  return quotients;
}

LevelErrors quotients(const Bench& bench, const std::string& name) {
  const Problem problem = problem_named(name);
  const std::vector<int> levels = levels_of_an_order(problem, bench.budget);
  return quotients(node_errors(bench, problem, levels), uniform_errors(bench, problem, levels));
}

LevelErrors quotients_on_the_sphere(const TriangleBasis<double>& basis) {
  const SphereErrors errors = errors_on_the_sphere(basis, fourth_power, levels_on_the_sphere);
  return quotients(errors.nodes, errors.uniform);
}

}  // namespace

Finding theorem_7(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  Finding finding;
  require_orders(finding, bench, {"two_piece_r1", "ellipsoid_r1"}, of_theorem_7);
  control_orders(finding, bench, {"two_piece_r1_other"}, of_theorem_7);
  if (!quick) {
    require_orders(finding, bench, {"two_piece_r3"}, of_theorem_7);
    control_orders(finding, bench, {"two_piece_r3_other", "ellipsoid_r1_other"}, of_theorem_7);
    require_seams_apart(finding, bench, "ellipsoid_r1", of_theorem_7);
  }
  for (const int r : {1, 3}) {
    const std::string of = "order of max |u - u_n| over the nodes, sphere, r = " + std::to_string(r);
    const Order order = Order::at_least(r + of_theorem_7.gained);
    finding.require(of, order, order_on_the_sphere(chosen_nodes(r), of_theorem_7));
    finding.control(of + ", nodes of degree r - 1", order,
                    order_on_the_sphere(chosen_nodes(r - 1), of_theorem_7));
  }
  require_rate_at_spots(finding, bench, 3, of_theorem_7, 3);
  if (bench.budget == Budget::full) require_fine_orders_of_theorem_7(finding, bench);
  return finding;
}

Finding theorem_9(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  Finding finding;
  require_orders(finding, bench, {"two_piece_r0", "ellipsoid_r0", "two_piece_r2"}, of_theorem_9);
  if (!quick) {
    require_orders(finding, bench, {"ellipsoid_r2", "two_piece_r4"}, of_theorem_9);
    require_seams_apart(finding, bench, "ellipsoid_r2", of_theorem_9);
  }
  for (const int r : {0, 2, 4})
    finding.require("order of max |u - u_n| over the nodes, sphere, r = " + std::to_string(r),
                    Order::at_least(r + of_theorem_9.gained),
                    order_on_the_sphere(chosen_nodes(r), of_theorem_9));
  // Odd degrees at alpha = 1/10 have r + 1 alone.
  control_orders(finding, bench, {"two_piece_r1_other"}, of_theorem_9);
  if (!quick) control_orders(finding, bench, {"two_piece_r3_other"}, of_theorem_9);
  require_agreement(finding, bench, "ellipsoid_r2", 2);
  require_rate_at_spots(finding, bench, 2, of_theorem_9, 1);
  if (!quick) require_rate_at_spots(finding, bench, 4, of_theorem_9, 3);
  if (bench.budget == Budget::full) require_fine_orders_of_theorem_9(finding, bench);
  return finding;
}

Finding equation_24(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  // The quotient falls like a power of h, and not like none.
  const Order falls = Order::at_least(1, 0);
  Finding finding;
  const std::string of = "order of the quotient of (24), ";
  std::vector<std::string> names{"two_piece_r0", "two_piece_r1", "two_piece_r2", "ellipsoid_r1"};
  std::vector<std::string> others{"two_piece_r1_other"};
  if (!quick) names.insert(names.end(), {"two_piece_r3", "two_piece_r4"});
  if (!quick) others.insert(others.end(), {"two_piece_r3_other", "ellipsoid_r1_other"});
  for (const std::string& name : names)
    finding.require(of + name, falls, observed_order(quotients(bench, name)));
  for (const std::string& name : others)
    finding.control(of + name, falls, observed_order(quotients(bench, name)));
  for (const int r : {1, 3}) {
    const std::string sphere = of + "sphere, r = " + std::to_string(r);
    finding.require(sphere, falls, observed_order(quotients_on_the_sphere(chosen_nodes(r))));
  }
  finding.control(of + "sphere, r = 1, alpha = 1/10", falls,
                  observed_order(quotients_on_the_sphere(nodes_at_a_tenth(1))));
  return finding;
}

Finding equation_26_constant(const Bench& bench) {
  Finding finding;
  for (const char* name : {"two_piece_r0", "two_piece_r1", "two_piece_r1_other", "two_piece_r2",
                           "two_piece_r3", "two_piece_r4", "sphere_r1", "ellipsoid_r1", "ellipsoid_r2"}) {
    const Problem problem = problem_named(name);
    for (const int level : levels_for(problem, Budget::quick)) {
      const LevelResult result = bench.levels.level(problem, level).result;
      const Approximation nodes = result.node_error.value();
      const Approximation source = result.discretisation_error.value();
      // (I - K_n)(u - u_n) = K(I - P_n)u at the nodes.
      const AtMost bound{.value = 1 / (1 - result.norm_K.value),
                         .slack = 0.01,
                         .why = "norm of K_n and both errors are rounded and integrated"};
      const std::string of = ", " + std::string(name) + ", level " + std::to_string(level);
      finding.require("max |u - u_n|/max |K(I - P_n)u| over the nodes" + of, bound,
                      Approximation{.value = nodes.value / source.value, .radius = 0});
      if (level > 0)
        finding.control(
            "the same with |u - u_n| everywhere in the place of the nodes" + of, bound,
            Approximation{.value = result.uniform_error.value().value / source.value, .radius = 0});
    }
  }
  return finding;
}

Finding abstract(const Bench& bench) {
  Finding finding;
  const auto both = [&](const std::string& of, int r, const LevelErrors& everywhere,
                        const LevelErrors& nodes) {
    finding.require("order of |u - u_n| over the sample, " + of, Order::at_least(r + 1),
                    observed_order(everywhere));
    finding.require("order of max |u - u_n| over the nodes, " + of, Order::at_least(r + 2),
                    observed_order(nodes));
  };
  for (const std::string name : {"ellipsoid_r0", "ellipsoid_r1"}) {
    const Problem problem = problem_named(name);
    const std::vector<int> levels = levels_of_an_order(problem, bench.budget);
    both(name, degree_of(problem), uniform_errors(bench, problem, levels),
         node_errors(bench, problem, levels));
  }
  for (int r = 0; r <= 4; ++r) {
    const SphereErrors errors = errors_on_the_sphere(chosen_nodes(r), fourth_power, levels_on_the_sphere);
    both("sphere, r = " + std::to_string(r), r, errors.uniform, errors.nodes);
  }
  // Nodes that are not chosen: alpha = 1/10 for r = 1.
  finding.control("order of max |u - u_n| over the nodes, sphere, alpha = 1/10, r = 1", Order::at_least(3),
                  order_on_the_sphere(nodes_at_a_tenth(1), of_theorem_9));
  return finding;
}

}  // namespace radcert::verification::m06
