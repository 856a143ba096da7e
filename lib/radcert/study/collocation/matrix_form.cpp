// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/matrix_form.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "radcert/clusters/certified/enclosed_clusters.h"
#include "radcert/clusters/cluster_operator.h"
#include "radcert/core/checked.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/study/collocation/collocation.h"

namespace radcert {
namespace {

/// What keeps a problem from being solved with clusters.
struct Obstacle {
  std::string what;
  std::string allowed;
};

bool has_plane_charts(const Surface& surface) {
  return std::all_of(surface.charts.begin(), surface.charts.end(),
                     [](const Chart& chart) { return chart.facts().plane.has_value(); });
}

std::optional<Obstacle> obstacle(const Problem& problem, const Surface& surface) {
  const auto dense_for = [](const std::string& what) {
    return std::optional(Obstacle{"is not for " + what, "dense"});
  };
  if (std::holds_alternative<Galerkin>(problem.method)) return dense_for("Galerkin's method");
  if (!std::holds_alternative<Collocation>(problem.method)) return dense_for("a meshless basis");
  if (problem.geometry) return dense_for("interpolated geometry, where each element is a chart of its own");
  const bool is_graded = problem.triangulation.grading != Rational(1);
  if (problem.triangulation.events) return dense_for("a triangulation that is cut along events");
  if (const auto on_surface = obstacle_to_clusters(surface))
    return dense_for("the surface " + surface.name + ": " + *on_surface);
  const LinearSolver* solver = find_linear_solver(problem.solver.name);
  if (solver != nullptr && solver->proves()) {
    if (is_graded) return dense_for("a proof on a graded triangulation");
    return std::nullopt;
  }
  if (solver != nullptr && !solver->takes_products())
    return Obstacle{"has no entries for the solver " + problem.solver.name,
                    "dense, or a solver that needs none: " +
                        listed(solver_names([](const LinearSolver& each) { return each.takes_products(); }))};
  return std::nullopt;
}

/// How many leaves are near each of so many.
std::uint64_t near_leaves(const Surface& surface, bool is_graded, std::uint64_t leaves) {
  constexpr std::uint64_t most = 64;
  constexpr double at_edges = 600;
  constexpr std::uint64_t least_at_edges = 4;
  constexpr std::uint64_t most_graded = 96;
  if (is_graded) return most_graded;
  if (!has_plane_charts(surface)) return most;
  const double near = at_edges / std::sqrt(static_cast<double>(std::max<std::uint64_t>(leaves, 1)));
  return std::clamp(static_cast<std::uint64_t>(near), least_at_edges, most);
}

}  // namespace

std::vector<std::string> operator_names() { return {"dense", "h2", "auto"}; }

void check_operator(const Problem& problem, const Surface& surface) {
  const std::vector<std::string> names = operator_names();
  const OperatorChoice& choice = problem.matrix;
  if (std::find(names.begin(), names.end(), choice.name) == names.end())
    refuse_input("/operator/name", choice.name, "is not a known operator", listed(names));
  const double tolerance = choice.tolerance.to_double();
  if (!(ClusterTolerance::finest <= tolerance && tolerance <= ClusterTolerance::coarsest))
    refuse_input("/operator/tolerance", choice.tolerance.to_text(), "is not allowed",
                 "a number from " + shortest(ClusterTolerance::finest) + ", what double can hold, to " +
                     shortest(ClusterTolerance::coarsest));
  if (choice.name != "h2") return;
  if (const auto found = obstacle(problem, surface))
    refuse_input("/operator/name", choice.name, found->what, found->allowed);
}

bool takes_clusters(const Problem& problem, std::uint64_t unknowns) {
  if (problem.matrix.name == "h2") return true;
  const LinearSolver* solver = find_linear_solver(problem.solver.name);
  const bool proves = solver != nullptr && solver->proves();
  return problem.matrix.name == "auto" && !proves && unknowns > most_dense_unknowns &&
         !obstacle(problem, surface_of(problem));
}

void plan_proved_clusters(MemoryPlan& plan, const Surface& surface, std::uint64_t unknowns,
                          std::uint64_t functions) {
  plan_clusters(plan, surface, false, unknowns, functions);
  constexpr std::uint64_t near_leaves = 96;
  constexpr std::uint64_t node_bytes = 8192;
  const std::uint64_t leaf =
      functions << static_cast<unsigned>(2 * leaf_refinements(static_cast<std::size_t>(functions)));
  plan.add("enclosed near entries", unknowns, saturated_product(near_leaves * leaf, 2 * sizeof(double)));
  plan.add("enclosed couplings of clusters", unknowns, node_bytes);
}

void plan_clusters(MemoryPlan& plan, const Surface& surface, bool is_graded, std::uint64_t unknowns,
                   std::uint64_t functions) {
  constexpr std::uint64_t node_bytes = 4096;
  constexpr std::uint64_t matrix_bytes = 12288;
  const std::uint64_t leaf =
      functions << static_cast<unsigned>(2 * leaf_refinements(static_cast<std::size_t>(functions)));
  plan.add("near entries", unknowns,
           saturated_product(near_leaves(surface, is_graded, unknowns / leaf) * leaf, sizeof(double)));
  plan.add("couplings of clusters", unknowns, node_bytes);
  if (is_graded) plan.add("matrices between clusters", unknowns, matrix_bytes);
}

}  // namespace radcert
