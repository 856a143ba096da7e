// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>

#include "radcert/collocation/assembly.h"
#include "radcert/core/errors.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/solve/accurate_dot.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/gmres.h"
#include "radcert/solve/neumann.h"
#include "radcert/study/level_errors.h"
#include "radcert/study/level_geometry.h"
#include "radcert/study/node_data.h"
#include "radcert/study/plan.h"
#include "radcert/study/study.h"
#include "radcert/study/surface_function.h"

namespace radcert {
namespace {

class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

double largest(std::span<const double> values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double largest_size(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// sup rho where it is a constant on every piece.
std::optional<Rational> constant_bound(const PiecewiseExpression& reflectivity, const Surface& surface) {
  Rational bound = 0;
  for (const std::string& piece : surface.piece_names()) {
    const std::optional<Rational> value = reflectivity.on(piece).is_constant();
    if (!value) return std::nullopt;
    bound = std::max(bound, *value);
  }
  return bound;
}

/// The largest rho/pi Int |G| seen at the nodes: an estimate of ||K|| from below.
NormOfK largest_row(std::span<const double> rho_at_nodes, std::span<const double> kernel_integral) {
  double norm = 0;
  for (std::size_t i = 0; i < rho_at_nodes.size(); ++i)
    norm = std::max(norm, rho_at_nodes[i] * kernel_integral[i] / pi<double>());
  return {.value = norm, .guaranteed = false};
}

/// ||K|| on C(S) or L^infinity(S): on a closed unoccluded surface Int G = pi makes it sup rho exactly; on an open one the
/// largest rho/pi Int G seen at the nodes estimates it from below.
NormOfK norm_of_K(const Surface& surface, const PiecewiseExpression& reflectivity,
                  std::span<const double> rho_at_nodes, std::span<const double> kernel_integral) {
  if (surface.closed) {
    const std::optional<Rational> bound = constant_bound(reflectivity, surface);
    if (bound) return {.value = bound->to_double(), .guaranteed = true};
    return {.value = largest(rho_at_nodes), .guaranteed = false};
  }
  return largest_row(rho_at_nodes, kernel_integral);
}

void refuse_norm_from_one(const NormOfK& norm) {
  if (norm.value < 1) return;
  throw InputError({.pointer = "/reflectivity",
                    .value = shortest(norm.value),
                    .problem = "is the norm of K: the equation need not have one solution",
                    .allowed = "reflectivities for which the norm of K is below 1"});
}

/// rho/pi Int G u at the nodes by the second route, and its radius.
struct OperatorAtNodes {
  std::vector<double> value;
  std::vector<double> radius;
};

OperatorAtNodes apply_operator(const Problem& problem, const Surface& surface, const OperatorRoute& route,
                               std::span<const Observer<double>> nodes, std::span<const double> rho) {
  const SurfaceFunction u(*problem.solution, surface);
  const AppliedOperator integral_at = route(surface, u);
  OperatorAtNodes result{std::vector<double>(nodes.size()), std::vector<double>(nodes.size())};
  constexpr std::size_t grain = 8;
  parallel_for(nodes.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const OperatorValue integral = integral_at(nodes[i].at);
      result.value[i] = rho[i] / pi<double>() * integral.value;
      result.radius[i] = rho[i] / pi<double>() * integral.radius;
    }
  });
  return result;
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
    describe();
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
                                   ": the collocation matrix contracts by " + shortest(found.reason().theta) +
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
            " iterations the error bound is " + shortest(best.error_bound) +
            " where |u_n| <= " + shortest(best.size));
  }

  /// Bounds of the sizes of (I - K_n)(u_n - exact u_n): residual, errors of matrix and right-hand side.
  std::vector<double> defects(std::vector<double> residual_sizes) const {
    const double u_n_size = largest_size(u_n_);
    for (std::size_t i = 0; i < u_n_.size(); ++i)
      residual_sizes[i] = residual_sizes[i] + matrix_.row_radius[i] * u_n_size + emission_radius_[i];
    return residual_sizes;
  }

  void describe() {
    const NodalFunction function(surface_, triangulation_, basis_, u_n_);
    if (problem_.solution) outcome_.result.uniform_error = uniform_error(function, *problem_.solution);
    outcome_.result.piece_means = piece_means(function);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      outcome_.nodes.push_back({.piece = surface_.charts[nodes_[i].at.chart].facts().piece,
                                .element = i / basis_.size(),
                                .index_in_element = i % basis_.size(),
                                .point = nodes_[i].point,
                                .normal = nodes_[i].normal,
                                .u_n = u_n_[i],
                                .emission = emission_[i],
                                .u = problem_.solution ? std::optional(u_[i]) : std::nullopt});
    for (std::size_t k = 0; k < triangulation_.triangles.size(); ++k) {
      const ParameterTriangle& triangle = triangulation_.triangles[k];
      const Chart& chart = surface_.charts[triangle.chart];
      ElementValue element{.piece = chart.facts().piece, .corners = {}, .corner_values = {}};
      for (std::size_t c = 0; c < 3; ++c) {
        Barycentric<double> corner{{0, 0, 0}};
        corner.x[c] = 1;
        element.corners[c] = chart.in<double>().frame(triangle.vertices[c]).point;
        element.corner_values[c] = function.at(k, corner);
      }
      outcome_.elements.push_back(std::move(element));
    }
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
  return Level(problem, level).compute(route);
}

}  // namespace radcert
