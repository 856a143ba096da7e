// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/collocation/assembly.h"
#include "radcert/core/checked.h"
#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/text.h"
#include "radcert/polynomial/largest_values.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/contraction.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/solve/system_matrix.h"
#include "radcert/study/collocation/coarser_inverses.h"
#include "radcert/study/collocation/iterated_solution.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/matrix_form.h"
#include "radcert/study/collocation/nodal_description.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/collocation/verified_level.h"
#include "radcert/study/computed_function.h"
#include "radcert/study/operator_at_nodes.h"
#include "radcert/study/stopwatch.h"
#include "radcert/study/study.h"
#include "radcert/surface/own_surface.h"

namespace radcert {
namespace {

double largest(std::span<const double> values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double max_abs(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// A number with what is estimated of it, if anything is.
Approximation within(double value, std::optional<double> radius) {
  return radius ? Approximation::estimated(value, *radius) : Approximation::without_radius(value);
}

/// A bound of sum |l_j| on the element.
double sum_of_largest(const TriangleBasis<double>& basis) {
  const std::vector<double> largest = largest_values(basis);
  return std::accumulate(largest.begin(), largest.end(), 0.0);
}

/// Whether the functions of a basis have the sum 1.
bool sum_to_one(const TriangleBasisChoice& basis) {
  return !basis.functions || basis.functions->reproduced_degree() >= 0;
}

/// The finished pieces of one level, in the order in which they are computed: of a rank's part of the nodes
/// where several share the level.
class Level {
public:
  Level(const Problem& problem, int level, std::optional<LevelClusters> tree, const LevelSharing& sharing,
        KeptNumbers* kept)
      : problem_(problem),
        ranks_(sharing.ranks),
        fields_(sharing.fields || problem.iterated),
        kept_(tree ? kept : nullptr),
        tree_(std::move(tree)),
        choice_(triangle_basis_of(problem.method)),
        solver_(find_linear_solver(problem.solver.name)),
        basis_(triangle_basis(choice_)),
        geometry_(problem, level, basis_, is_shared() ? std::optional(tree_->elements()) : std::nullopt),
        first_node_(is_shared() ? tree_->elements().begin * basis_.size() : 0),
        rho_(reflectivity_at_nodes(problem.reflectivity, surface_, nodes_, first_node_)) {
    const std::size_t elements = tree_ ? tree_->tree.leaves().size() * tree_->tree.elements_of_leaf()
                                       : triangulation_.triangles.size();
    take_engine();
    outcome_.result = level_header(problem, level,
                                   {.elements = elements,
                                    .unknowns = elements * basis_.size(),
                                    .mesh_size = ranks_.largest(geometry_.mesh_size())});
  }

  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

  LevelOutcome compute(const OperatorRoute& route) && {
    if (surface_.closed) refuse_norm_from_one(norm_of_K(surface_, problem_.reflectivity, rho_, {}));
    if (problem_.solution)
      u_ = values_at_nodes(*problem_.solution, "/solution", surface_, nodes_, first_node_);
    if (problem_.emission)
      emission_ = values_at_nodes(*problem_.emission, "/emission", surface_, nodes_, first_node_);
    find_radii_of_data();
    assemble_matrix();
    require_rows_of_pi();
    find_weights();
    if (problem_.solution) manufacture_emission(route);
    solve();
    describe_numbers(problem_, NodalFunction(surface_, triangulation_, basis_, u_n_, ranks_),
                     solution_radius_, outcome_.result);
    require_finite();
    if (is_shared())
      outcome_.shared = SharedWork{.ranks = ranks_.count(),
                                   .operator_bytes = largest_count(clusters_->memory().total()),
                                   .bytes_sent = largest_count(clusters_->bytes_sent())};
    if (fields_ || !is_shared()) find_fields(route);
    if (!ranks_.is_first()) return {};
    return std::move(outcome_);
  }

private:
  /// Whether several ranks have parts of the level.
  [[nodiscard]] bool is_shared() const { return tree_ && ranks_.count() > 1; }

  /// The largest of the ranks' numbers, which are below 2^53.
  [[nodiscard]] std::uint64_t largest_count(std::uint64_t own) const {
    return static_cast<std::uint64_t>(ranks_.largest(static_cast<double>(own)));
  }

  /// The Krylov methods of the ranks serve a level that they share; gmres any other of the problem.
  void take_engine() {
    if (solver_->on_ranks && ranks_.krylov_engine() == nullptr) solver_ = find_linear_solver("gmres");
  }

  /// The values at the nodes and what follows from them; of all ranks on the first, which has all of the
  /// geometry then.
  void find_fields(const OperatorRoute& route) {
    std::optional<LevelGeometry> whole;
    if (is_shared()) {
      for (std::vector<double>* each : {&u_n_, &emission_, &emission_radius_, &u_})
        *each = ranks_.gather_numbers_at_first(*each);
      if (!ranks_.is_first()) return;
      whole.emplace(problem_, outcome_.result.level, basis_);
    }
    const NodedSurface& data = whole ? whole->data() : geometry_.data();
    describe_fields(data, basis_,
                    {.u_n = with_radius(u_n_, solution_radius_), .emission = emission_, .u = u_}, outcome_);
    if (problem_.iterated) iterate(data, route);
  }

  void assemble_matrix() {
    const Stopwatch watch;
    const NodedSurface& integrals = geometry_.integrals();
    const Tolerance tolerance(problem_.quadrature.tolerance.to_double());
    if (outcome_.result.matrix_form == "h2") {
      clusters_ = std::make_unique<ClusterOperator>(
          ClusterOperator::Setting{.surface = surface_,
                                   .tree = tree_->tree,
                                   .part = tree_->part,
                                   .basis = basis_,
                                   .nodes = nodes_,
                                   .reflectivity = rho_,
                                   .integrals = tolerance,
                                   .far = ClusterTolerance(problem_.matrix.tolerance.to_double()),
                                   .memory_limit = available_memory()});
      matrix_.kernel_integral = clusters_->kernel_integral();
      matrix_.row_radius = clusters_->row_radius();
    } else {
      matrix_ = assemble<double>(integrals.surface, integrals.triangulation, basis_, integrals.nodes, rho_,
                                 tolerance);
    }
    outcome_.timing.assembly_seconds += watch.seconds();
    outcome_.result.norm_K = problem_.geometry
                                 ? largest_row(rho_, matrix_.kernel_integral)
                                 : norm_of_K(surface_, problem_.reflectivity, rho_, matrix_.kernel_integral);
    if (!outcome_.result.norm_K.has_radius())
      outcome_.result.norm_K = Approximation::without_radius(ranks_.largest(outcome_.result.norm_K.value));
    refuse_norm_from_one(outcome_.result.norm_K);
    if (!all_finite(matrix_.kernel_integral) || !all_finite(matrix_.row_radius))
      refuse("the collocation integrals are not found: numbers run over the range of double");
    if (rho_radius_)
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        matrix_.row_radius[i] += (*rho_radius_)[i] / pi<double>() * matrix_.kernel_integral[i] * largest_sum_;
  }

  [[nodiscard]] SystemMatrix matrix() const {
    if (clusters_) return *clusters_;
    return matrix_.entries;
  }

  /// What rounding may have done to rho, u and E at the nodes.
  void find_radii_of_data() {
    rho_radius_ = value_radii(problem_.reflectivity, surface_, nodes_, rho_);
    const std::vector<double>& data = problem_.solution ? u_ : emission_;
    data_radius_ =
        value_radii(problem_.solution ? *problem_.solution : *problem_.emission, surface_, nodes_, data);
    // What is off in charts that are known by their values alone is not in any radius.
    data_are_known_ = ranks_.all(rho_radius_ && data_radius_ && is_known_in_balls(surface_));
    if (!data_radius_) data_radius_.emplace(nodes_.size());
    if (problem_.emission) emission_radius_ = *data_radius_;
  }

  /// Int_S G dS = pi at every point of a closed surface that hides nothing of itself [ac98, section 2]; where
  /// the functions have the sum 1 it is also the sum of a row's integrals, whose radii are known. A row that
  /// tells otherwise is wrong, or a normal points outwards.
  void require_rows_of_pi() const {
    if (!surface_.closed || !surface_.unoccluded || problem_.geometry || !sum_to_one(choice_)) return;
    std::vector<double> sums(nodes_.size());
    matrix().accurate_product(std::vector<double>(nodes_.size(), 1.0), sums);
    const double rounding = unit * static_cast<double>(outcome_.result.elements + 64);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (rho_[i] == 0) continue;
      const double integral_of_g = pi<double>() * sums[i] / rho_[i];
      const double radius = pi<double>() * (matrix_.row_radius[i] / rho_[i] + rounding);
      if (std::abs(integral_of_g - pi<double>()) <= radius) continue;
      const Vector<double>& at = nodes_[i].point;
      const EnclosingText integral = enclosing_text(integral_of_g, radius, DecimalForm::general(17));
      refuse("the integral of G over the closed surface is " + integral.value + " +- " + integral.radius +
             " at node " + std::to_string(first_node_ + i) + " (" + shortest(at.x) + ", " + shortest(at.y) +
             ", " + shortest(at.z) + "), and not pi");
    }
  }

  void require_finite() const {
    const auto is_finite = [this](const std::optional<Approximation>& error) {
      return !error || (std::isfinite(error->value) && (error->has_radius() || !data_are_known_));
    };
    const LevelResult& result = outcome_.result;
    if (all_finite(u_n_) && all_finite(emission_) && is_finite(result.discretisation_error) &&
        is_finite(result.node_error) && std::isfinite(solution_radius_.value_or(0)) &&
        std::all_of(result.piece_means.begin(), result.piece_means.end(), [&](const auto& mean) {
          return std::isfinite(mean.second.value) && (mean.second.has_radius() || !solution_radius_);
        }))
      return;
    refuse("u_n or its radius runs over the range of double");
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw AccuracyNotReached("level " + std::to_string(outcome_.result.level) + ", solver " + solver_->name,
                             reason);
  }

  /// Ku by the second route, computed once.
  OperatorAtNodes operator_at_nodes(const OperatorRoute& route) {
    constexpr const char* values = "operator at nodes: values";
    constexpr const char* radii = "operator at nodes: radii";
    const VectorParts parts = matrix().parts();
    const auto kept = [&](const char* name) {
      std::optional<std::vector<double>> all;
      if (kept_ != nullptr && ranks_.is_first()) all = kept_->find(name);
      return parts.from_first(all ? std::span<const double>(*all) : std::span<const double>());
    };
    if (kept_ != nullptr) {
      auto value = kept(values);
      auto radius = kept(radii);
      if (value && radius) return {*std::move(value), *std::move(radius)};
    }
    OperatorAtNodes found = apply_operator(problem_, surface_, route, nodes_, rho_);
    if (kept_ == nullptr) return found;
    const std::vector<double> all_values = parts.at_first(found.value);
    const std::vector<double> all_radii = parts.at_first(found.radius);
    if (ranks_.is_first()) {
      kept_->keep(values, all_values);
      kept_->keep(radii, all_radii);
    }
    return found;
  }

  /// E = u - Ku by the second route; K(I-P_n)u is the difference of the two.
  void manufacture_emission(const OperatorRoute& route) {
    const Stopwatch watch;
    OperatorAtNodes ku = operator_at_nodes(route);
    outcome_.timing.operator_seconds = watch.seconds();
    if (!ranks_.all(all_finite(ku.radius))) {
      data_are_known_ = false;
      ku.radius.assign(nodes_.size(), 0);
    }
    std::vector<double> k_pn_u(nodes_.size());
    matrix().accurate_product(u_, k_pn_u);
    const double u_size = ranks_.largest(max_abs(u_));
    const double data_radius = ranks_.largest(largest(*data_radius_));
    double radius = 0;
    emission_.resize(nodes_.size());
    emission_radius_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double rho_moved =
          rho_radius_ && rho_[i] > 0 ? (*rho_radius_)[i] / rho_[i] * std::abs(ku.value[i]) : 0;
      const double rounded = unit * (std::abs(u_[i]) + 4 * std::abs(ku.value[i]));
      // sum_j |k_ij| |u_j's radius|, the largest of these.
      const double u_moved = outcome_.result.norm_K.value * largest_sum_ * data_radius;
      radius =
          std::max(radius, ku.radius[i] + matrix_.row_radius[i] * u_size + rounded + rho_moved + u_moved);
      emission_[i] = u_[i] - ku.value[i];
      emission_radius_[i] = ku.radius[i] + rounded + rho_moved + (*data_radius_)[i];
    }
    outcome_.result.discretisation_error =
        within(ranks_.largest(largest_difference(ku.value, k_pn_u)),
               data_are_known_ ? std::optional(ranks_.largest(radius)) : std::nullopt);
  }

  /// The norm in which the matrix contracts, whatever its entries are within their radii: without one an
  /// iteration has no error bound, and that is known before the second route to Ku is taken.
  void find_weights() {
    const Stopwatch watch;
    Outcome<Contraction, NoContraction> found = find_contraction(matrix(), matrix_.row_radius);
    if (!found && clusters_ && !is_shared() && solver_->choose && !solver_->iterates()) {
      hold_entries(found.reason().theta);
      found = find_contraction(matrix(), matrix_.row_radius);
    }
    if (found) contraction_ = std::move(found).value();
    solver_ = &chosen(*solver_, contraction_.has_value());
    outcome_.result.solver = solver_->name;
    if (!found && solver_->name == gmres_by_estimate) estimate_inverse(found.reason().theta);
    const double radius = ranks_.largest(largest(matrix_.row_radius));
    if (!contraction_ && (solver_->iterates() || clusters_))
      throw InputError(
          {.pointer = "/solver/name",
           .value = problem_.solver.name,
           .problem = "has no error bound at level " + std::to_string(outcome_.result.level) +
                      ": the collocation matrix, known within " + upper_text(radius) +
                      " a row, contracts by " + upper_text(found.reason().theta, DecimalForm::general(6)) +
                      " at best, which is not below 1",
           .allowed = is_shared() ? "one process, which may take the dense operator and direct"
                      : clusters_ ? "direct, with the operator dense, or " + std::string(gmres_by_estimate) +
                                        ", whose error bound is an estimate"
                                  : std::string("direct")});
    if (solver_->name != problem_.solver.name && !solver_->iterates()) {
      MemoryPlan more;
      solver_->plan(more, nodes_.size());
      more.require(available_memory());
    }
    outcome_.timing.solve_seconds += watch.seconds();
  }

  /// Takes the matrix with all its entries in place of clusters that are not shown to contract, for a solver
  /// that leaves the choice open: elimination needs no contraction, and the entries' own sizes are smaller
  /// than what stands for them between clusters.
  void hold_entries(double theta) {
    clusters_.reset();
    MemoryPlan more;
    const std::uint64_t unknowns = nodes_.size();
    more.add("collocation matrix", saturated_product(unknowns, unknowns), sizeof(double));
    chosen(*solver_, false).plan(more, unknowns);
    const std::uint64_t available = available_memory();
    if (more.total() > available)
      throw InputError({.pointer = "/operator/name",
                        .value = problem_.matrix.name,
                        .problem = "is not shown to contract at level " +
                                   std::to_string(outcome_.result.level) + " as h2, by " +
                                   upper_text(theta, DecimalForm::general(6)) +
                                   " at best, and dense with direct takes " + std::to_string(more.total()) +
                                   " bytes of the " + std::to_string(available) + " that are available",
                        .allowed = "a lower level, a smaller reflectivity, functions whose sizes have a "
                                   "smaller sum, or the solver " +
                                   std::string(gmres_by_estimate) + ", whose error bound is an estimate"});
    outcome_.result.matrix_form = "dense";
    assemble_matrix();
    require_rows_of_pi();
  }

  /// Where nothing is shown to contract, and the solver goes on by an estimate: what the inverses of coarser
  /// levels say of that of this one.
  void estimate_inverse(double theta) {
    const Outcome<double> norm =
        estimated_inverse_norm(inverse_norms_of_coarser_levels(problem_, outcome_.result.level, basis_));
    const auto refused = [&](const std::string& why) {
      return InputError({.pointer = "/solver/name",
                         .value = problem_.solver.name,
                         .problem = "has no error bound at level " + std::to_string(outcome_.result.level) +
                                    ": the matrix contracts by " +
                                    upper_text(theta, DecimalForm::general(6)) +
                                    " at best, and the norm of its inverse cannot be estimated: " + why,
                         .allowed = "direct, or two coarser levels of at most " +
                                    std::to_string(most_unknowns_of_inverses) + " unknowns"});
    };
    if (!norm) throw refused(norm.reason());
    const double radius = ranks_.largest(largest(matrix_.row_radius));
    // Matrices that are known so badly may not be regular, however good the estimate.
    if (!(*norm * radius < 0.5))
      throw refused("its rows are known within " + upper_text(radius) + ", and the inverse is about " +
                    nearest_text(*norm, DecimalForm::general(4)));
    // The inverse takes (I - K) 1 to 1: where all reflect nearly everything, it is large.
    std::vector<double> of_one(nodes_.size());
    matrix().accurate_product(std::vector<double>(nodes_.size(), 1.0), of_one);
    for (double& x : of_one) x = 1 - x;
    if (!(*norm * ranks_.largest(max_abs(of_one)) >= 1))
      throw refused("coarser levels let it be " + nearest_text(*norm, DecimalForm::general(4)) +
                    ", and here K 1 shows that it is more");
    contraction_ = contraction_by_estimate(matrix().parts(), *norm, radius);
    estimated_inverse_ = *norm;
  }

  /// What would show that the inverse is larger than was estimated: |u_n| is at most its norm times |E|.
  void require_estimate_holds() const {
    if (!estimated_inverse_ ||
        ranks_.largest(max_abs(u_n_)) <= *estimated_inverse_ * ranks_.largest(max_abs(emission_)))
      return;
    refuse("the inverse is larger than the estimate " +
           nearest_text(*estimated_inverse_, DecimalForm::general(4)) + " by which the solution was bounded");
  }

  void solve() {
    const Stopwatch watch;
    const std::optional<double> tolerance =
        problem_.solver.tolerance ? std::optional(problem_.solver.tolerance->to_double()) : std::nullopt;
    Outcome<LinearSolution> found = solution_of({.k = matrix(),
                                                 .row_radius = matrix_.row_radius,
                                                 .e = emission_,
                                                 .e_radius = emission_radius_,
                                                 .contraction = contraction_ ? &*contraction_ : nullptr},
                                                *solver_, tolerance, clusters_ ? kept_ : nullptr);
    if (!found) refuse(found.reason());
    u_n_ = std::move(found->values);
    require_estimate_holds();
    outcome_.result.iteration = found->iteration;
    if (data_are_known_) solution_radius_ = found->radius;
    if (problem_.solution)
      outcome_.result.node_error =
          within(ranks_.largest(largest_difference(u_, u_n_)),
                 data_are_known_ ? std::optional(found->radius + ranks_.largest(largest(*data_radius_)))
                                 : std::nullopt);
    outcome_.timing.solve_seconds += watch.seconds();
  }

  void iterate(const NodedSurface& data, const OperatorRoute& route) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const EmissionAtPoints at_nodes{
        .values = emission_,
        .radii = data_are_known_ ? emission_radius_ : std::vector<double>(data.nodes.size(), unknown)};
    describe_iterated(problem_, data, basis_, at_nodes, route, outcome_);
  }

  static constexpr double unit = unit_roundoff<double>();
  const Problem& problem_;
  const Ranks& ranks_;
  bool fields_;                        ///< whether they are wanted
  KeptNumbers* kept_;                  ///< or null
  std::optional<LevelClusters> tree_;  ///< where the operator may be one of clusters
  const TriangleBasisChoice& choice_;
  const LinearSolver* solver_;  ///< the one asked for, until the one that is taken is known
  TriangleBasis<double> basis_;
  double largest_sum_ = sum_of_largest(basis_);
  LevelGeometry geometry_;
  const Surface& surface_ = geometry_.data().surface;
  const Triangulation& triangulation_ = geometry_.data().triangulation;
  const std::vector<CollocationPoint<double>>& nodes_ = geometry_.data().nodes;  ///< here
  std::size_t first_node_;                                                       ///< those of ranks before
  std::vector<double> rho_;
  std::vector<double> u_;
  std::vector<double> emission_;
  std::vector<double> emission_radius_ = std::vector<double>(nodes_.size());
  std::optional<std::vector<double>> rho_radius_;
  std::optional<std::vector<double>> data_radius_;  ///< of u_, or of emission_ where that is given
  bool data_are_known_ = false;                     ///< whether both are known; 0 stands for the others
  std::optional<double> solution_radius_;
  CollocationMatrix<double> matrix_;           ///< without entries where there are clusters
  std::unique_ptr<ClusterOperator> clusters_;  ///< or none
  std::optional<Contraction> contraction_;
  std::optional<double> estimated_inverse_;  ///< its norm, where that stands for a contraction
  std::vector<double> u_n_;
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome solve(const Problem& problem, const Collocation&, int level, const OperatorRoute& route,
                   const LevelSharing& sharing, KeptNumbers* kept) {
  const Ranks& ranks = sharing.ranks;
  const LinearSolver& solver = *find_linear_solver(problem.solver.name);
  const bool proves = solver.proves();
  if (solver.on_ranks && ranks.krylov_engine() == nullptr)
    refuse_input("/solver/name", solver.name, "is for radcert with PETSc under mpirun", "gmres");
  std::optional<LevelClusters> clusters;
  // A graded triangulation is not made in parts.
  const bool is_whole = problem.triangulation.grading != Rational(1);
  if (is_whole && !ranks.is_first()) return {};
  if (!proves) clusters = clusters_of_level(problem, level, is_whole ? one_rank() : ranks);
  if (!clusters && !ranks.is_first()) return {};
  if (proves) return verified_level(problem, level, route);
  return Level(problem, level, std::move(clusters), clusters && !is_whole ? sharing : LevelSharing(), kept)
      .compute(route);
}

}  // namespace radcert
