// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/core/work_limit.h"
#include "radcert/meshless/interpolation_system.h"
#include "radcert/meshless/sampling.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/direct.h"
#include "radcert/solve/product.h"
#include "radcert/solve/rounding/accurate_dot.h"
#include "radcert/solve/rounding/rounding.h"
#include "radcert/study/collocation/level_geometry.h"
#include "radcert/study/collocation/node_data.h"
#include "radcert/study/collocation/operator_norm.h"
#include "radcert/study/computed_function.h"
#include "radcert/study/operator_at_nodes.h"
#include "radcert/study/stopwatch.h"
#include "radcert/study/study.h"

namespace radcert {
namespace {

/// Elements may change from one site to the next: a low order, on triangles about as small.
constexpr int mean_order = 4;
const WorkLimit points_of_weights("study/meshless_level: points of the weights' integrals", 1'000'000, 1000,
                                  "the errors reached go into the radius; refused where none were");

template <class T>
T admitted(Outcome<T> outcome, const std::string& pointer, const std::string& value,
           const std::string& allowed) {
  if (!outcome) refuse_input(pointer, value, "gives no basis: " + outcome.reason(), allowed);
  return *std::move(outcome);
}

double largest(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

std::vector<double> sizes(std::span<const double> values) {
  std::vector<double> out;
  for (const double value : values) out.push_back(std::abs(value));
  return out;
}

std::string text_of(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

std::string text_of(const SiteChoice& sites) {
  if (const auto* apart = std::get_if<PoissonDiskSites>(&sites))
    return "separation " + shortest(apart->separation);
  return std::to_string(std::get_if<UniformSites>(&sites)->count) + " sites";
}

/// What the errors of the weights may do to a value at a site, as if they were independent.
double effect_of_weights(const Matrix<double>& n, const LightWeights& weights) {
  if (weights.errors.empty()) return 0;
  std::vector<double> squares(n.rows());
  for (std::size_t j = 0; j < n.columns(); ++j) {
    if (weights.weights[j] == 0) continue;
    const double relative = weights.errors[j] / weights.weights[j];
    const std::span<const double> column = n.column(j);
    // An error that is not known has no effect where nothing is sent.
    for (std::size_t i = 0; i < column.size(); ++i)
      if (column[i] != 0) squares[i] += column[i] * relative * (column[i] * relative);
  }
  return std::sqrt(largest(squares));
}

/// The finished pieces of one level, in the order in which they are computed.
class MeshlessLevel {
public:
  MeshlessLevel(const Problem& problem, const Meshless& method, int level)
      : problem_(problem),
        choice_(method),
        geometry_(problem, level, InsetBasis<double>(0, 0)),
        sites_(sites_of(level)),
        basis_(make_basis(level)) {
    const SiteSet& sites = basis_.sites();
    for (std::size_t i = 0; i < sites.size(); ++i)
      nodes_.push_back({sites.at[i], sites.points[i], sites.normals[i]});
    rho_ = reflectivity_at_nodes(problem.reflectivity, surface_, nodes_);
    if (const double most = largest(rho_); most >= 1)
      refuse_input("/reflectivity", shortest(most), "is not below 1 at a site",
                   "reflectivities in [0, 1): a meshless basis scatters less than arrives");
    LevelResult& result = outcome_.result;
    result.level = level;
    result.elements = result.unknowns = sites.size();
    result.mesh_size = site_spacing(choice_.sites, level, surface_area(surface_));
    result.planned_bytes = meshless_plan(sites.size(), choice_, problem.solver.name != "neumann").total();
    result.solver = problem.solver.name == "neumann" ? "neumann" : "direct";
  }

  MeshlessLevel(const MeshlessLevel&) = delete;
  MeshlessLevel& operator=(const MeshlessLevel&) = delete;

  LevelOutcome compute(const OperatorRoute& route) && {
    if (problem_.solution) u_ = values_at_nodes(*problem_.solution, "/solution", surface_, nodes_);
    if (problem_.emission) emission_ = values_at_nodes(*problem_.emission, "/emission", surface_, nodes_);
    TransferSeries transfer = make_transfer();
    if (problem_.solution) manufacture_emission(route);
    solve(transfer.series);
    describe();
    return std::move(outcome_);
  }

private:
  [[nodiscard]] std::string subject() const { return "level " + std::to_string(outcome_.result.level); }

  [[nodiscard]] SiteChoice sites_of(int level) const {
    const std::optional<SiteChoice> sites = sites_at_level(choice_.sites, level);
    if (!sites)
      refuse_input("/basis/sites", std::to_string(level), "has more than 2^53 sites at this level",
                   "fewer sites");
    return *sites;
  }

  [[nodiscard]] RadialBasis make_basis(int level) const {
    const std::string at = text_of(sites_) + " at level " + std::to_string(level);
    SiteSet sites = admitted(make_sites(surface_, sites_), "/basis/sites", at,
                             "sites that fit on the surface; each level halves the separation");
    return admitted(RadialBasis::make(std::move(sites), choice_.basis), "/basis", at,
                    "more sites than `neighbour`, no two in one place, each with enough others within 90 "
                    "degrees of its normal; or \"too_few\": \"farthest\"");
  }

  /// R, if its powers tend to zero: that is known before the second route to Ku is taken.
  TransferSeries make_transfer() {
    const Stopwatch watch;
    const LightScene scene = admitted(LightScene::make(surface_, {0.0}), "/surface", problem_.surface.name,
                                      "unoccluded surfaces of the catalogue, and meshes");
    // What point lights leave out is above 1e-3 wherever the matrix fits into memory; each point costs as
    // many elements as are in reach.
    const IntegrationDemand demand{.relative_error = 1e-4, .most_points = points_of_weights.count()};
    const LightWeights weights =
        admitted(light_weights(basis_, surface_, choice_.weights, demand), "/basis/weights",
                 std::string(name(choice_.weights)), "integrated, or another estimate");
    Matrix<double> matrix = point_light_transfer(scene, basis_.sites(), rho_, weights.weights);
    weight_effect_ = effect_of_weights(matrix, weights);
    if (!std::isfinite(weight_effect_))
      throw AccuracyNotReached(subject(), "the weights of the lights are not known within " +
                                              std::to_string(demand.most_points) + " points");
    find_norm(matrix, weights.weights);
    if (choice_.coefficients == CoefficientRule::interpolated && !basis_.interpolates()) {
      system_ = admitted(InterpolationSystem::make(basis_), "/basis/coefficients", "interpolated",
                         "as_values, or a basis that can interpolate at its sites");
      system_->solve_columns(matrix);
    }
    Outcome<TransferSeries> transfer = transfer_series(std::move(matrix));
    if (!transfer)
      throw AccuracyNotReached(subject() + ", basis " + std::string(name(choice_.family)), transfer.reason());
    outcome_.timing.assembly_seconds = watch.seconds();
    return *std::move(transfer);
  }

  void find_norm(const Matrix<double>& n, std::span<const double> weights) {
    Approximation& norm = outcome_.result.norm_K;
    if (surface_.closed) {
      norm = norm_of_K(surface_, problem_.reflectivity, rho_, {});
      return;
    }
    // Row sums with lights that together are as bright as the whole surface.
    std::vector<double> sums(n.rows());
    double light = 0;
    for (std::size_t j = 0; j < n.columns(); ++j) {
      light += weights[j];
      for (std::size_t i = 0; i < n.rows(); ++i) sums[i] += n(i, j);
    }
    const double found = std::min(largest(sums) * surface_area(surface_) / light, largest(rho_));
    norm = Approximation::without_radius(std::isfinite(found) ? found : largest(rho_));
  }

  void manufacture_emission(const OperatorRoute& route) {
    const Stopwatch watch;
    const OperatorAtNodes ku = apply_operator(problem_, surface_, route, nodes_, rho_);
    outcome_.timing.operator_seconds = watch.seconds();
    for (std::size_t i = 0; i < nodes_.size(); ++i) emission_.push_back(u_[i] - ku.value[i]);
    emission_radius_ = largest(ku.radius) + 4 * unit_roundoff<double>() * (largest(u_) + largest(ku.value));
  }

  void solve(const NeumannSeries& series) {
    const Stopwatch watch;
    const std::vector<double> epsilon = system_ ? system_->solve(emission_) : emission_;
    double growth = 0;        // of errors of values at the sites
    double system_error = 0;  // of the coefficients
    if (outcome_.result.solver == "direct") {
      const DirectSolver solver(series.matrix());
      coefficients_ = solver.solve(epsilon);
      growth = solver.inverse_norm();
      std::vector<double> residual(epsilon.size());
      accurate_residual(series.matrix(), coefficients_, epsilon, residual);
      system_error = growth * largest(residual);
    } else {
      const std::optional<double> tolerance =
          problem_.solver.tolerance ? std::optional(problem_.solver.tolerance->to_double()) : std::nullopt;
      Outcome<IterativeSolution, NotReached> solution = series.solve(epsilon, tolerance);
      if (!solution)
        throw AccuracyNotReached(subject() + ", solver neumann",
                                 "the error bound is " + upper_text(solution.reason().error_bound) +
                                     " after " + std::to_string(solution.reason().iterations) +
                                     " reflections");
      outcome_.result.iteration = {.iterations = solution->iterations,
                                   .contraction = series.spectral_radius_bound(),
                                   .error_bound = solution->error_bound};
      coefficients_ = std::move(solution->values);
      growth = 1 / (1 - std::min(series.spectral_radius_bound(), 1 - unit_roundoff<double>()));
      system_error = solution->error_bound;
    }
    outcome_.timing.solve_seconds = watch.seconds();
    look_at_sites(growth, system_error, interpolation_defect(series.matrix(), epsilon));
  }

  /// What interpolation leaves of the values at the sites: of E, for which it is looked at, and of what R
  /// makes of the coefficients, whose columns are solved with the same factors: as much as a sum in double
  /// may.
  [[nodiscard]] double interpolation_defect(const Matrix<double>& r, std::span<const double> epsilon) const {
    if (!system_) return 0;
    std::vector<double> reflected(epsilon.size());
    multiply_sizes(r, sizes(coefficients_), reflected);
    for (std::size_t j = 0; j < reflected.size(); ++j) reflected[j] += std::abs(epsilon[j]);
    return largest(system_->residual(epsilon, emission_)) + static_cast<double>(epsilon.size()) *
                                                                unit_roundoff<double>() *
                                                                largest(system_->term_sizes(reflected));
  }

  /// u_n at the sites, and how far off it is.
  void look_at_sites(double growth, double system_error, double interpolation_defect) {
    double row_sum = 0;
    double evaluation = 0;  // the roundings of the sums below
    BasisValues room;
    for (const CollocationPoint<double>& node : nodes_) {
      u_n_.push_back(value_at(node, room));
      double sum = 0;
      double terms = 0;
      for (std::size_t k = 0; k < room.size(); ++k) {
        sum += std::abs(room.values()[k]);
        terms += std::abs(room.values()[k] * coefficients_[room.sites()[k]]);
      }
      row_sum = std::max(row_sum, sum);
      evaluation = std::max(evaluation, rounding_of_sums(room.size()) * terms);
    }
    if (!problem_.solution) return;
    // Where the coefficients are the values, an error of a value passes through the elements once more.
    const double smoothing = system_ ? 1 : row_sum;
    const double defect = emission_radius_ + weight_effect_ * largest(coefficients_) + interpolation_defect;
    const double radius = smoothing * growth * defect + row_sum * system_error + evaluation;
    double error = 0;
    for (std::size_t i = 0; i < u_.size(); ++i) error = std::max(error, std::abs(u_[i] - u_n_[i]));
    outcome_.result.node_error = Approximation::estimated(error, radius);
  }

  /// u_n at a point of S. InputError where no site is in reach.
  double value_at(const CollocationPoint<double>& p, BasisValues& room) const {
    if (!basis_.evaluate({p.point, p.normal}, room))
      refuse_input("/basis", std::string(name(choice_.family)),
                   "has no value at " + text_of(p.point) + " on piece " +
                       surface_.charts[p.at.chart].facts().piece + ": no site is in reach",
                   "sites so close, or elements so wide, that every point of the surface has one in reach");
    double value = 0;
    for (std::size_t k = 0; k < room.size(); ++k) value += room.values()[k] * coefficients_[room.sites()[k]];
    return value;
  }

  void describe() {
    const ComputedFunction u_n{
        surface_, triangulation_, [this] {
          return [this, room = BasisValues()](std::size_t k, const Barycentric<double>& x) mutable {
            const ParameterTriangle& triangle = triangulation_.triangles[k];
            return value_at(collocation_point<double>(surface_, {triangle.chart, triangle.at(x.x)}), room);
          };
        }};
    if (!problem_.solution) require_values(u_n);
    describe_level(problem_, u_n,
                   {.nodes = nodes_, .u_n = with_radius(u_n_, std::nullopt), .emission = emission_, .u = u_},
                   mean_order, outcome_);
  }

  const Problem& problem_;
  const Meshless& choice_;
  LevelGeometry geometry_;
  const Surface& surface_ = geometry_.data().surface;
  const Triangulation& triangulation_ = geometry_.data().triangulation;
  SiteChoice sites_;
  RadialBasis basis_;
  std::vector<CollocationPoint<double>> nodes_;
  std::vector<double> rho_;
  std::vector<double> u_;
  std::vector<double> emission_;
  double emission_radius_ = 0;
  double weight_effect_ = 0;
  std::optional<InterpolationSystem> system_;  ///< where coefficients are not the values
  std::vector<double> coefficients_;
  std::vector<double> u_n_;
  LevelOutcome outcome_;
};

}  // namespace

LevelOutcome solve(const Problem& problem, const Meshless& method, int level, const OperatorRoute& route) {
  return MeshlessLevel(problem, method, level).compute(route);
}

}  // namespace radcert
