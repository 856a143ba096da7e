// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/light_solution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"
#include "radcert/meshless/interpolation_system.h"
#include "radcert/meshless/sampling.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/solve/power_series.h"

namespace radcert {
namespace {

const WorkLimit points_for_areas(
    "meshless/light_solution: points for an area", 200'000, 1000,
    "errors of the weights as large as the last cells tell, infinite where none were compared");

bool is_finite(const Matrix<double>& matrix) {
  for (std::size_t j = 0; j < matrix.columns(); ++j)
    for (const double entry : matrix.column(j))
      if (!std::isfinite(entry)) return false;
  return true;
}

}  // namespace

Outcome<LightWeights> light_weights(const RadialBasis& basis, const Surface& surface, WeightRule rule,
                                    const IntegrationDemand& demand) {
  const auto estimated = [](Outcome<std::vector<double>> weights) -> Outcome<LightWeights> {
    if (!weights) return because(weights.reason());
    return LightWeights{.weights = *std::move(weights), .errors = {}};
  };
  switch (rule) {
    case WeightRule::plane: return estimated(plane_weights(basis));
    case WeightRule::neighbours: return estimated(neighbour_weights(basis));
    case WeightRule::mean_density: {
      // The area of smooth charts converges with the fourth power of the cells' size, whatever the elements
      // do on them.
      IntegrationDemand of_area = demand;
      of_area.most_points = std::min(of_area.most_points, points_for_areas.count());
      const BasisIntegrals integrals = integrate_basis(basis, surface, of_area);
      const double each = integrals.area_error / std::sqrt(static_cast<double>(basis.size()));
      return LightWeights{.weights = mean_density_weights(basis, integrals.area),
                          .errors = std::vector<double>(basis.size(), each)};
    }
    case WeightRule::integrated: break;
  }
  BasisIntegrals integrals = integrate_basis(basis, surface, demand);
  return LightWeights{.weights = std::move(integrals.weights), .errors = std::move(integrals.errors)};
}

Outcome<TransferSeries> transfer_series(Matrix<double> r) {
  TransferSums sums;
  if (is_finite(r)) sums = transfer_sums(r);
  Outcome<NeumannSeries, NoPowerContracts> series = NeumannSeries::make(std::move(r));
  if (series) return TransferSeries{.series = *std::move(series), .sums = sums};
  const NoPowerContracts& why = series.reason();
  const DecimalForm form = DecimalForm::general(6);
  return because(std::string(why.diverges ? "the iteration diverges" : "the iteration may diverge") +
                 ": the spectral radius of the transfer matrix is about " +
                 nearest_text(sums.spectral_radius, form) + ", and no bound below " +
                 lower_text(why.theta, form) + " was found up to its power " + std::to_string(why.power) +
                 "; the largest row sum is about " + nearest_text(sums.largest_row_sum, form) + ", at site " +
                 std::to_string(sums.row) + ", the largest entry about " +
                 nearest_text(sums.largest_entry, form));
}

std::string_view name(WeightRule rule) {
  switch (rule) {
    case WeightRule::plane: return "plane";
    case WeightRule::neighbours: return "neighbours";
    case WeightRule::mean_density: return "mean_density";
    case WeightRule::integrated: break;
  }
  return "integrated";
}

std::string_view name(CoefficientRule rule) {
  return rule == CoefficientRule::as_values ? "as_values" : "interpolated";
}

struct LightTransfer::Parts {
  LightScene scene;
  RadialBasis basis;
  std::optional<InterpolationSystem> system;  ///< where coefficients are not the values
  std::vector<double> weights;
  TransferSums sums;
  NeumannSeries series;  ///< of R

  [[nodiscard]] std::vector<double> coefficients(std::span<const double> values) const {
    return system ? system->solve(values) : std::vector<double>(values.begin(), values.end());
  }
};

LightTransfer::LightTransfer(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

Outcome<LightTransfer> LightTransfer::make(const LightScene& scene, const TransferChoice& choice) {
  Outcome<SiteSet> sites = make_sites(scene.surface(), choice.meshless.sites);
  if (!sites) return because(sites.reason());
  Outcome<RadialBasis> basis = RadialBasis::make(std::move(*sites), choice.meshless.basis);
  if (!basis) return because(basis.reason());
  std::optional<InterpolationSystem> system;
  if (choice.coefficients == CoefficientRule::interpolated && !basis->interpolates()) {
    Outcome<InterpolationSystem> made = InterpolationSystem::make(*basis);
    if (!made) return because(made.reason());
    system = std::move(made).value();
  }
  transfer_memory(basis->size(), 1).require(available_memory());
  Outcome<LightWeights> weights = light_weights(*basis, scene.surface(), choice.weights, choice.integration);
  if (!weights) return because(weights.reason());
  Matrix<double> matrix = point_light_transfer(scene, basis->sites(), weights->weights);
  if (system) system->solve_columns(matrix);
  Outcome<TransferSeries> series = transfer_series(std::move(matrix));
  if (!series) return because(series.reason());
  return LightTransfer(std::make_shared<const Parts>(Parts{.scene = scene,
                                                           .basis = *std::move(basis),
                                                           .system = std::move(system),
                                                           .weights = std::move(weights->weights),
                                                           .sums = series->sums,
                                                           .series = std::move(series->series)}));
}

const LightScene& LightTransfer::scene() const { return parts_->scene; }
const RadialBasis& LightTransfer::basis() const { return parts_->basis; }
const Matrix<double>& LightTransfer::matrix() const { return parts_->series.matrix(); }
std::span<const double> LightTransfer::weights() const { return parts_->weights; }
const TransferSums& LightTransfer::sums() const { return parts_->sums; }
const NeumannSeries& LightTransfer::series() const { return parts_->series; }
double LightTransfer::condition() const { return parts_->system ? parts_->system->condition() : 1; }

std::vector<double> LightTransfer::emission_at_sites(const Light& light) const {
  const SiteSet& sites = parts_->basis.sites();
  std::vector<double> emission(sites.size());
  parallel_for(sites.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      emission[i] = direct_radiance(parts_->scene, light, {.site = sites[i], .chart = sites.at[i].chart});
  });
  return emission;
}

std::optional<double> LightTransfer::radiance(const LightSolution& solution, const LitPoint& at) const {
  return parts_->basis.at(at.site, solution.total);
}

std::optional<double> LightTransfer::radiance(const LightSolution& solution, const Light& light,
                                              const LitPoint& at) const {
  std::optional<double> radiance = parts_->basis.at(at.site, solution.indirect);
  if (radiance) *radiance += direct_radiance(parts_->scene, light, at);
  return radiance;
}

Outcome<LightSolution> LightTransfer::solve(const Light& light, std::optional<double> tolerance) const {
  LightSolution solution;
  solution.emission = parts_->coefficients(emission_at_sites(light));
  Outcome<IterativeSolution, NotReached> series = parts_->series.solve(solution.emission, tolerance);
  if (!series)
    return because("the Neumann series came within " + upper_text(series.reason().error_bound) + " after " +
                   std::to_string(series.reason().iterations) + " reflections, no further");
  solution.reflections = series->iterations;
  solution.error_bound = series->error_bound;
  solution.total = std::move(series->values);
  solution.indirect.resize(solution.total.size());
  for (std::size_t i = 0; i < solution.total.size(); ++i)
    solution.indirect[i] = solution.total[i] - solution.emission[i];
  return solution;
}

}  // namespace radcert
