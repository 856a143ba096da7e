// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "radcert/collocation/assembly.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/accurate_dot.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/neumann.h"
#include "radcert/study/level_description.h"
#include "radcert/study/level_geometry.h"
#include "radcert/study/meshless_level.h"
#include "radcert/study/node_data.h"
#include "radcert/study/operator_at_nodes.h"
#include "radcert/study/operator_norm.h"
#include "radcert/study/plan.h"
#include "radcert/study/stopwatch.h"
#include "radcert/study/study.h"
#include "radcert/study/verified_level.h"

namespace radcert {
namespace {

double largest(std::span<const double> values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double largest_size(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// max_i |a_i - b_i| with what is known of each difference.
Figure largest_difference(std::span<const double> a, std::span<const double> b,
                          std::span<const double> radius) {
  Figure figure{.value = 0, .radius = 0.0, .guaranteed = false};
  for (std::size_t i = 0; i < a.size(); ++i) {
    figure.value = std::max(figure.value, std::abs(a[i] - b[i]));
    figure.radius = std::max(*figure.radius, radius[i]);
  }
  return figure;
}

/// The finished pieces of one level, in the order in which they are computed.
class Level {
public:
  Level(const Problem& problem, int level)
      : problem_(problem),
        basis_(triangle_basis(problem.basis)),
        geometry_(problem, level, basis_),
        rho_(reflectivity_at_nodes(problem.reflectivity, surface_, nodes_)) {
    outcome_.result.level = level;
    outcome_.result.elements = triangulation_.triangles.size();
    outcome_.result.unknowns = nodes_.size();
    outcome_.result.mesh_size = geometry_.mesh_size();
    outcome_.result.planned_bytes =
        level_plan(triangulation_.triangles.size(), basis_.size(), problem.solver.name, problem.geometry)
            .total();
  }

  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

  LevelOutcome compute(const OperatorRoute& route) && {
    if (surface_.closed) refuse_norm_from_one(norm_of_K(surface_, problem_.reflectivity, rho_, {}));
    if (problem_.solution) u_ = values_at_nodes(*problem_.solution, "/solution", surface_, nodes_);
    if (problem_.emission) emission_ = values_at_nodes(*problem_.emission, "/emission", surface_, nodes_);
    assemble_matrix();
    if (problem_.solver.name != SolverName::direct) find_weights();
    if (problem_.solution) manufacture_emission(route);
    solve();
    describe_level(problem_, geometry_.data(), basis_,
                   {.u_n = u_n_, .radius = {}, .emission = emission_, .u = u_}, outcome_);
    return std::move(outcome_);
  }

private:
  void assemble_matrix() {
    const Stopwatch watch;
    const NodedSurface& integrals = geometry_.integrals();
    matrix_ = assemble<double>(integrals.surface, integrals.triangulation, basis_, integrals.nodes, rho_,
                               Tolerance(problem_.quadrature.tolerance.to_double()));
    outcome_.timing.assembly_seconds = watch.seconds();
    outcome_.result.norm_K = problem_.geometry
                                 ? largest_row(rho_, matrix_.kernel_integral)
                                 : norm_of_K(surface_, problem_.reflectivity, rho_, matrix_.kernel_integral);
    refuse_norm_from_one(outcome_.result.norm_K);
  }

  /// E = u - Ku by the second route; K(I-P_n)u is the difference of the two.
  void manufacture_emission(const OperatorRoute& route) {
    const Stopwatch watch;
    const OperatorAtNodes ku = apply_operator(problem_, surface_, route, nodes_, rho_);
    outcome_.timing.operator_seconds = watch.seconds();
    const std::vector<double> k_pn_u = accurate_product(matrix_.entries, u_);
    const double u_size = largest_size(u_);
    std::vector<double> radius(nodes_.size());
    emission_.resize(nodes_.size());
    emission_radius_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double rounded = unit * (std::abs(u_[i]) + 4 * std::abs(ku.value[i]));
      radius[i] = ku.radius[i] + matrix_.row_radius[i] * u_size + rounded;
      emission_[i] = u_[i] - ku.value[i];
      emission_radius_[i] = ku.radius[i] + rounded;
    }
    outcome_.result.discretisation_error = largest_difference(ku.value, k_pn_u, radius);
  }

  /// The norm in which the matrix contracts, whatever its entries are within their radii: without one an iteration has
  /// no error bound, and that is known before the second route to Ku is taken.
  void find_weights() {
    const Stopwatch watch;
    Outcome<Contraction, NoContraction> found = find_contraction(matrix_.entries, matrix_.row_radius);
    if (!found)
      throw InputError({.pointer = "/solver/name",
                        .value = solver_name(problem_.solver.name),
                        .problem = "has no error bound at level " + std::to_string(outcome_.result.level) +
                                   ": the collocation matrix contracts by " +
                                   upper_text(found.reason().theta, DecimalForm::general(6)) +
                                   " at best, which is not below 1",
                        .allowed = "direct"});
    contraction_ = std::move(found).value();
    outcome_.timing.solve_seconds += watch.seconds();
  }

  void solve() {
    const Stopwatch watch;
    const double node_radius = contraction_ ? iterate() : eliminate();
    if (problem_.solution)
      outcome_.result.node_error = largest_difference(u_, u_n_, std::vector<double>(u_.size(), node_radius));
    outcome_.timing.solve_seconds += watch.seconds();
  }

  double eliminate() {
    const DirectSolver solver(matrix_.entries);
    u_n_ = solver.solve(emission_);
    if (!problem_.solution) return 0;
    const std::vector<double> k_u_n = accurate_product(matrix_.entries, u_n_);
    std::vector<double> residual(u_n_.size());
    for (std::size_t i = 0; i < u_n_.size(); ++i)
      residual[i] =
          std::abs(emission_[i] - (u_n_[i] - k_u_n[i])) + unit * (std::abs(u_n_[i]) + 4 * std::abs(k_u_n[i]));
    return solver.inverse_norm_estimate() * largest(defects(std::move(residual)));
  }

  double iterate() {
    const std::optional<double> tolerance =
        problem_.solver.tolerance ? std::optional(problem_.solver.tolerance->to_double()) : std::nullopt;
    const auto solve_by = problem_.solver.name == SolverName::gmres ? solve_by_gmres : solve_by_neumann;
    Outcome<IterativeSolution, NotReached> solution =
        solve_by(matrix_.entries, *contraction_, emission_, tolerance);
    if (!solution) refuse_accuracy(solution.reason());
    outcome_.result.iteration = {.iterations = solution->iterations,
                                 .contraction = contraction_->theta(),
                                 .error_bound = solution->error_bound};
    u_n_ = std::move(solution->values);
    if (!problem_.solution) return 0;
    std::vector<double> residual(u_n_.size());
    accurate_residual(matrix_.entries, u_n_, emission_, residual);
    const std::vector<double> bounds = residual_bounds(*contraction_, u_n_, emission_, residual);
    return contraction_->inverse_bound(contraction_->norm(defects(bounds)));
  }

  [[noreturn]] void refuse_accuracy(const NotReached& best) const {
    const std::string demanded = problem_.solver.tolerance
                                     ? "the tolerance " + shortest(problem_.solver.tolerance->to_double())
                                     : "an error bound as small as double holds";
    throw AccuracyNotReached(
        "level " + std::to_string(outcome_.result.level) + ", solver " + solver_name(problem_.solver.name),
        demanded + " is not reached: after " + std::to_string(best.iterations) +
            " iterations the error bound is " + upper_text(best.error_bound) +
            " where |u_n| <= " + upper_text(best.size));
  }

  /// Bounds of the sizes of (I - K_n)(u_n - exact u_n): residual, errors of matrix and right-hand side.
  std::vector<double> defects(std::vector<double> residual_sizes) const {
    const double u_n_size = largest_size(u_n_);
    for (std::size_t i = 0; i < u_n_.size(); ++i)
      residual_sizes[i] = residual_sizes[i] + matrix_.row_radius[i] * u_n_size + emission_radius_[i];
    return residual_sizes;
  }

  static constexpr double unit = unit_roundoff<double>();
  const Problem& problem_;
  TriangleBasis<double> basis_;
  LevelGeometry geometry_;
  const Surface& surface_ = geometry_.data().surface;
  const Triangulation& triangulation_ = geometry_.data().triangulation;
  const std::vector<Observer<double>>& nodes_ = geometry_.data().nodes;
  std::vector<double> rho_;
  std::vector<double> u_;
  std::vector<double> emission_;
  std::vector<double> emission_radius_ = std::vector<double>(nodes_.size());
  CollocationMatrix<double> matrix_;
  std::optional<Contraction> contraction_;
  std::vector<double> u_n_;
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome solve_level(const Problem& problem, int level, const OperatorRoute& route) {
  if (problem.basis.meshless) return meshless_level(problem, level, route);
  if (problem.solver.name == SolverName::verified) return verified_level(problem, level);
  return Level(problem, level).compute(route);
}

}  // namespace radcert
