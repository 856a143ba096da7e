// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/collocation.h"

#include <algorithm>
#include <string>

#include "radcert/closed_form/plane_element.h"
#include "radcert/core/checked.h"
#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/polynomial/basis_limits.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/study/collocation/graded_levels.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/levels_within_memory.h"
#include "radcert/study/problem.h"
#include "radcert/surface/interpolated_chart.h"

namespace radcert {
namespace {

std::uint64_t unknowns_of(const Problem& problem, std::uint64_t elements) {
  return saturated_product(elements, function_count(triangle_basis_of(problem.method)));
}

void check_geometry(const Problem& problem, const Surface& surface) {
  if (!problem.geometry) return;
  if (!surface.unoccluded)
    refuse_input("/geometry/interpolated", std::to_string(problem.geometry->degree),
                 "asks for an interpolant of a mesh whose parts hide each other",
                 "\"exact\", which a mesh is");
  constexpr int smallest = LatticePolynomial<double>::smallest_degree;
  constexpr int largest = LatticePolynomial<double>::largest_degree;
  if (problem.geometry->degree < smallest || problem.geometry->degree > largest)
    refuse_input("/geometry/interpolated", std::to_string(problem.geometry->degree), "is not allowed",
                 "a whole number from " + std::to_string(smallest) + " to " + std::to_string(largest));
}

/// The least barycentric coordinate of a node.
Rational least_coordinate(const LagrangeFunctions& functions) {
  Rational least = 1;
  for (const Barycentric<Rational>& node : functions.nodes())
    for (const Rational& x : node.x) least = std::min(least, x);
  return least;
}

void check_degree(const Problem& problem, const TriangleBasisChoice& basis) {
  const LinearSolver* solver = find_linear_solver(problem.solver.name);
  if (solver != nullptr && solver->proves() && basis.degree > PlaneElement::largest_degree)
    refuse_input(
        "/basis/degree", std::to_string(basis.degree),
        "is not for the solver " + problem.solver.name +
            ": the closed forms and rules that prove entries stop below",
        "a degree up to " + std::to_string(PlaneElement::largest_degree) + ", or a solver that estimates");
  if (basis.degree < 0 || basis.degree > largest_basis_degree)
    refuse_input("/basis/degree", std::to_string(basis.degree), "is not allowed",
                 "a whole number from 0 to " + std::to_string(largest_basis_degree));
}

void check_nodes(const Problem& problem, const TriangleBasisChoice& basis, const Surface& surface) {
  if (basis.degree == 0) return;
  if (!basis.functions && !basis.alpha)
    refuse_input("/basis/alpha", "", "is missing", "a number in [0, 1/3)");
  const Rational alpha = basis.functions ? least_coordinate(*basis.functions) : *basis.alpha;
  if (alpha < Rational(0) || alpha >= Rational(1, 3))
    refuse_input("/basis/alpha", alpha.to_text(), "is not allowed", "a number in [0, 1/3)");
  // Below this the nodes of the finest level keep less than half of a double's digits of their distance from
  // an edge.
  const int finest = problem.triangulation.levels.back();
  const Rational least = Rational(1) / power(Rational(2), 26 - std::min(finest, 26));
  const bool interpolants_meet =
      problem.geometry && std::any_of(surface.charts.begin(), surface.charts.end(),
                                      [](const Chart& chart) { return !chart.facts().plane; });
  if ((surface.pieces_meet_at_angle || interpolants_meet) && alpha < least) {
    const std::string where = surface.pieces_meet_at_angle
                                  ? "edges where pieces of the surface meet at an angle"
                                  : "sides where interpolated elements meet at an angle";
    if (basis.functions)
      refuse_input("/basis", alpha.to_text(), "puts nodes on or too close to " + where,
                   "least barycentric coordinates of at least " + least.to_text() +
                       " on this surface at these levels");
    refuse_input("/basis/alpha", alpha.to_text(),
                 alpha == Rational(0) ? "puts nodes on " + where + ", and there the kernel has no value"
                                      : "puts nodes too close to " + where,
                 "a number in [" + least.to_text() + ", 1/3) on this surface at these levels");
  }
  if (!basis.functions && alpha > Rational(333333, 1000000))
    refuse_input("/basis/alpha", alpha.to_text(),
                 "is too close to 1/3: the nodes of an element coincide in double precision",
                 "a number in [0, 0.333333]");
}

}  // namespace

void check(const Problem& problem, const Collocation& method, const Surface& surface,
           std::uint64_t memory_limit) {
  check_geometry(problem, surface);
  if (problem.iterated && problem.geometry)
    refuse_input("/iterated", "true", "is not for an interpolated geometry", "\"geometry\": \"exact\"");
  // A plan is made for a basis that there is, and inset nodes are looked at on levels that there are.
  check_degree(problem, method.basis);
  check_levels(problem, surface, memory_limit, [&](int, std::uint64_t triangles) {
    return LevelSize{.count = triangles, .counted = "triangles", .memory = level_plan(problem, triangles)};
  });
  if (find_linear_solver(problem.solver.name)->proves())
    for (const int level : problem.triangulation.levels) require_known_layers(problem, surface, level);
  check_nodes(problem, method.basis, surface);
}

MemoryPlan level_plan(const Problem& problem, std::uint64_t elements) {
  const LinearSolver* solver = find_linear_solver(problem.solver.name);
  expects(solver != nullptr, "a solver of linear_solvers()", named("name", problem.solver.name));
  const std::uint64_t unknowns = unknowns_of(problem, elements);
  constexpr std::uint64_t chunks = 64;
  constexpr std::uint64_t vectors = 32;
  constexpr std::uint64_t vectors_of_rows = 2 * chunks + 16;
  const bool clusters = takes_clusters(problem, unknowns);
  constexpr std::uint64_t bytes_per_node_record = 256;
  MemoryPlan plan;
  const std::uint64_t functions = function_count(triangle_basis_of(problem.method));
  if (clusters && solver->proves()) {
    plan_proved_clusters(plan, surface_of(problem), unknowns, functions);
    find_linear_solver("gmres")->plan(plan, unknowns);
  } else {
    if (clusters)
      plan_clusters(plan, surface_of(problem), problem.triangulation.grading != Rational(1), unknowns,
                    functions);
    else
      plan.add("collocation matrix", saturated_product(unknowns, unknowns), sizeof(double));
    solver->plan(plan, unknowns);
  }
  plan.add("row sums and vectors", unknowns, (clusters ? vectors : vectors_of_rows) * sizeof(double));
  plan.add("nodes", unknowns, bytes_per_node_record);
  plan.add("triangles", elements, bytes_per_node_record);
  if (problem.iterated) {
    constexpr std::uint64_t points_an_element = 6;
    plan.add("points of the iterated solution", saturated_product(elements, points_an_element),
             2 * bytes_per_node_record);
  }
  if (problem.geometry) {
    // The coefficients of degree 6, names, expressions.
    constexpr std::uint64_t bytes_per_interpolated_chart = 8192;
    plan.add("interpolated charts", elements, bytes_per_interpolated_chart);
    plan.add("interpolated nodes", unknowns, bytes_per_node_record);
  }
  return plan;
}

}  // namespace radcert
