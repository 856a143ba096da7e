// SPDX-License-Identifier: GPL-3.0-or-later

// The rates at the nodes, Theorems 7 and 9, and (24), (26) on the way to them.
//
// Checked      max |u - u_n| over the nodes, rho = 1/2, symmetric triangulations: r = 1 and 3 at alpha_0 and
//              at 1/10, where (36) must fail, r = 0, 2, 4 at 1/10; on two_piece(2), two smooth pieces that do
//              not meet, and the ellipsoid (1, 5/4, 3/2) for u = exp(x/2 + y/3 - z/4), on the sphere for u =
//              x^4: its triangulation has the symmetry of the octahedron, so that only the part of u with
//              that symmetry leaves an error, of exp(...) next to nothing. On the ellipsoid beyond quick also
//              over those nodes alone whose element has no vertex on the side of a chart, and over the
//              others; for r = 3 and 4 |K(I - P_n)u| at the nodes of two of its elements, one amid a chart
//              and one at a seam, up to 8192 elements; without a matrix, which at level 2 gives what the
//              study has. The estimated noise of each last error is below a twentieth of it. (24): the
//              quotient over that of the level before is near 1/2 or less for these methods, and not for r =
//              1 and 3 at alpha = 1/10. (26): the quotient of the two sides is at most 1/(1 - norm of K_n).
// Not checked  the logarithm apart from its power: between the last levels it costs at most the slack. That
// fewer derivatives suffice:
//              theorem_7_smoothness. The integrals over the node's own element are evaluated as well as all
//              others, so that the assumption on them is met; for the collocation method itself that error is
//              O(h^(r+3)) in any case, as G is bounded.

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
#include "verification/claims/m06/kernel_error.h"
#include "verification/claims/m06/rates.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

struct Case {
  std::string name;
  double slack;
};

constexpr AtMost below_the_error{.value = 0.05, .slack = 0, .why = ""};

void require_order(Finding& finding, const Bench& bench, const Case& each, int gained) {
  const Problem problem = problem_named(each.name);
  const Errors errors = node_errors(problem, levels_for(problem, bench.budget), bench);
  const Bound bound{.order = static_cast<double>(triangle_basis_of(problem.method).degree + gained),
                    .slack = each.slack,
                    .why = "the levels are coarse, and |log h| is still seen"};
  finding.require("order of max |u - u_n| over the nodes, " + each.name, bound, last_order(errors));
  finding.require("estimated noise of the last error, as a part of it, " + each.name, below_the_error,
                  noise(errors));
}

void control_order(Finding& finding, const Bench& bench, const std::string& name, int gained, double slack) {
  const Problem problem = problem_named(name);
  const Bound bound{.order = static_cast<double>(triangle_basis_of(problem.method).degree + gained),
                    .slack = slack,
                    .why = ""};
  finding.control("order of max |u - u_n| over the nodes, " + name, bound,
                  last_order(node_errors(problem, levels_for(problem, bench.budget), bench)));
}

// By level and element: whether the element has a vertex on the border of its chart's unit triangle.
bool is_at_a_seam(const ParameterTriangle& t) {
  return std::any_of(t.vertices.begin(), t.vertices.end(),
                     [](const ParameterPoint<double>& v) { return v.s == 0 || v.t == 0 || v.s + v.t == 1; });
}

// The orders over elements at the seams and over the others, from level 2 on, where there are others.
void require_seams_apart(Finding& finding, const Bench& bench, const std::string& name, int gained,
                         double slack) {
  const Problem problem = problem_named(name);
  const Surface surface = surface_of(problem);
  const Bound bound{.order = static_cast<double>(triangle_basis_of(problem.method).degree + gained),
                    .slack = slack,
                    .why = "two coarse levels, and the place of the largest error moves"};
  for (const bool at_seams : {true, false}) {
    Errors errors;
    for (const int level : {2, 3}) {
      const std::vector<ParameterTriangle> triangles = triangulate(surface, level).triangles;
      const Errors here = node_errors(problem, {level}, bench, [&](const NodeValue& node) {
        return is_at_a_seam(triangles.at(node.element)) == at_seams;
      });
      errors.mesh_sizes.push_back(here.mesh_sizes.front());
      errors.errors.push_back(here.errors.front());
    }
    finding.require("order over the nodes of the elements that " +
                        std::string(at_seams ? "touch" : "do not touch") + " a seam, " + name,
                    bound, last_order(errors));
  }
}

// Over the nodes of two elements alone no matrix is needed, and finer levels than those of a solution come
// into reach.
double on_the_ellipsoid(const Vector<double>& q) { return std::exp(q.x / 2 + q.y / 3 - q.z / 4); }

struct Spot {
  std::string name;
  ParameterPoint<double> at;  ///< in the first octant's unit triangle
};

// The element of the first chart whose middle is nearest to a spot.
const ParameterTriangle& element_at(const std::vector<ParameterTriangle>& elements, const Spot& spot) {
  const auto distance = [&](const ParameterTriangle& t) {
    if (t.chart != 0) return std::numeric_limits<double>::infinity();
    const ParameterPoint<double> middle = t.at({1.0 / 3, 1.0 / 3, 1.0 / 3});
    return std::hypot(middle.s - spot.at.s, middle.t - spot.at.t);
  };
  return *std::min_element(
      elements.begin(), elements.end(),
      [&](const ParameterTriangle& a, const ParameterTriangle& b) { return distance(a) < distance(b); });
}

Errors errors_at(const Spot& spot, const TriangleBasis<double>& basis, int first, int last) {
  const Surface surface = ellipsoid(1, Rational(5, 4), Rational(3, 2));
  Errors errors;
  for (int level = first; level <= last; ++level) {
    const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
    errors.mesh_sizes.push_back(std::ldexp(1.0, -level));
    errors.errors.push_back(
        kernel_error_at_nodes(surface, elements, element_at(elements, spot), basis, on_the_ellipsoid));
  }
  return errors;
}

/// Nodes (13) of a degree, and the order they are to have.
struct Rate {
  int degree;
  double alpha;
  int order;
  double slack;
  std::string why;
  int other_degree;  ///< of nodes at alpha = 1/10 that do not have it
};

// The same by the collocation matrix and the second route to Ku: both over all nodes of a coarse level.
void require_agreement(Finding& finding, const Bench& bench, const std::string& name, int level) {
  const Problem problem = problem_named(name);
  const Surface surface = surface_of(problem);
  const std::vector<ParameterTriangle> elements = triangulate(surface, level).triangles;
  const TriangleBasis<double> basis = triangle_basis(triangle_basis_of(problem.method));
  std::vector<double> of_element(elements.size());
  parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      of_element[k] = kernel_error_at_nodes(surface, elements, elements[k], basis, on_the_ellipsoid).value;
  });
  constexpr double rho = 0.5;
  const double largest = rho / std::numbers::pi * *std::max_element(of_element.begin(), of_element.end());
  const Approximation study = bench.levels.level(problem, level).result.discretisation_error.value();
  finding.require("largest |K(I - P_n)u| without a matrix over that of the study, " + name + ", level " +
                      std::to_string(level),
                  Equals{.value = 1, .slack = 0.001, .why = "rules of order 14 beside the nodes"},
                  Approximation{.value = largest / study.value, .radius = 0});
}

// alpha_0 of degree 3.
double superconvergent_inset_of_degree_3() { return (7 - std::sqrt(34.0)) / 15; }

void require_rate_at_spots(Finding& finding, const Bench& bench, const Rate& rate) {
  const int last = bench.budget == Budget::quick ? 4 : 5;
  const TriangleBasis<double> basis{InsetBasis<double>(rate.degree, rate.alpha)};
  for (const Spot& spot : {Spot{"amid a chart", {0.30, 0.36}}, {"at a seam", {0.0, 0.5}}}) {
    const std::string of = ", ellipsoid, r = " + std::to_string(rate.degree) + ", an element " + spot.name;
    const Errors errors = errors_at(spot, basis, last - 1, last);
    const Bound bound{.order = static_cast<double>(rate.order), .slack = rate.slack, .why = rate.why};
    finding.require(
        "order of |K(I - P_n)u|" + of + ", levels " + std::to_string(last - 1) + ", " + std::to_string(last),
        bound, last_order(errors));
    const TriangleBasis<double> other{InsetBasis<double>(rate.other_degree, 0.1)};
    finding.control(
        "the same, nodes (13) of degree " + std::to_string(rate.other_degree) + ", alpha = 1/10" + of, bound,
        last_order(errors_at(spot, other, last - 1, last)));
  }
}

// node error / uniform error at the last level over the same at the level before.
Approximation fall(const std::string& name, const Bench& bench) {
  const Problem problem = problem_named(name);
  const std::vector<int> levels = levels_for(problem, bench.budget);
  const Errors nodes = node_errors(problem, levels, bench);
  const Errors everywhere = uniform_errors(problem, levels, bench);
  const std::size_t last = levels.size() - 1;
  const auto quotient = [&](std::size_t k) { return nodes.errors[k].value / everywhere.errors[k].value; };
  return {.value = quotient(last) / quotient(last - 1), .radius = 0};
}

}  // namespace

Finding theorem_7(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  Finding finding;
  for (const Case& each :
       {Case{"two_piece_r1", 0.35}, {"sphere_r1", 0.35}, {"ellipsoid_r1", 0.6}, {"two_piece_r3", 0.6}})
    require_order(finding, bench, each, 3);
  control_order(finding, bench, "two_piece_r1_other", 3, 0.35);
  control_order(finding, bench, "two_piece_r3_other", 3, 0.6);
  control_order(finding, bench, "ellipsoid_r1_other", 3, 0.6);
  if (!quick) require_seams_apart(finding, bench, "ellipsoid_r1", 3, 0.6);
  require_rate_at_spots(finding, bench,
                        {.degree = 3,
                         .alpha = superconvergent_inset_of_degree_3(),
                         .order = 6,
                         .slack = 0.6,
                         .why = "|log h| costs 0.4 from level 3 to 4",
                         .other_degree = 3});
  return finding;
}

Finding theorem_9(const Bench& bench) {
  const bool quick = bench.budget == Budget::quick;
  Finding finding;
  for (const Case& each : {Case{"two_piece_r0", 0.25},
                           {"sphere_r0", 0.25},
                           {"ellipsoid_r0", 0.4},
                           {"two_piece_r2", 0.25},
                           {"sphere_r2", 0.25},
                           {"ellipsoid_r2", 0.4},
                           {"two_piece_r4", 0.4}})
    require_order(finding, bench, each, 2);
  control_order(finding, bench, "two_piece_r1_other", 2, 0.4);
  control_order(finding, bench, "two_piece_r3_other", 2, 0.4);
  if (!quick) require_seams_apart(finding, bench, "ellipsoid_r2", 2, 0.5);
  require_agreement(finding, bench, "ellipsoid_r2", 2);
  require_rate_at_spots(finding, bench,
                        {.degree = 4,
                         .alpha = 0.1,
                         .order = 6,
                         .slack = 0.25,
                         .why = "elements of size 1/8 and 1/16",
                         .other_degree = 3});
  return finding;
}

Finding equation_24(const Bench& bench) {
  const AtMost half{.value = 0.5, .slack = 0.15, .why = "the gain is one order at least, with coarse levels"};
  Finding finding;
  for (const char* name : {"two_piece_r0", "two_piece_r1", "two_piece_r2", "two_piece_r3", "two_piece_r4",
                           "sphere_r1", "ellipsoid_r1"})
    finding.require("quotient of (24) over that of the level before, " + std::string(name), half,
                    fall(name, bench));
  for (const char* name : {"two_piece_r1_other", "two_piece_r3_other", "ellipsoid_r1_other"})
    finding.control("quotient of (24) over that of the level before, " + std::string(name), half,
                    fall(name, bench));
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
  for (const char* name : {"two_piece_r0", "two_piece_r1", "two_piece_r2", "two_piece_r3", "two_piece_r4"}) {
    const Problem problem = problem_named(name);
    const std::vector<int> levels = levels_for(problem, bench.budget);
    const int r = triangle_basis_of(problem.method).degree;
    const Bound everywhere{
        .order = static_cast<double>(r + 1), .slack = 0.6, .why = "coarse levels, less than one order"};
    const Bound nodes{
        .order = static_cast<double>(r + 2), .slack = 0.4, .why = "coarse levels, less than one order"};
    finding.require("order of |u - u_n| over the sample, " + std::string(name), everywhere,
                    last_order(uniform_errors(problem, levels, bench)));
    finding.require("order of max |u - u_n| over the nodes, " + std::string(name), nodes,
                    last_order(node_errors(problem, levels, bench)));
  }
  // Nodes that are not chosen: alpha = 1/10 for odd r.
  control_order(finding, bench, "two_piece_r1_other", 2, 0.4);
  control_order(finding, bench, "two_piece_r3_other", 2, 0.4);
  return finding;
}

}  // namespace radcert::verification::m06
