// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/light_solution.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
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

std::string text_of(const SiteChoice& sites) {
  if (const auto* poisson = std::get_if<PoissonDiskSites>(&sites))
    return "poisson_disk " + shortest(poisson->separation) + " seed " + std::to_string(poisson->seed);
  const auto& uniform = *std::get_if<UniformSites>(&sites);
  return "uniform " + std::to_string(uniform.count) + " seed " + std::to_string(uniform.seed);
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

std::string to_text(const TransferChoice& choice) {
  const RadialBasisChoice& basis = choice.meshless.basis;
  std::string text = "mother " + quotation(basis.mother.to_text(), basis.mother.to_text().size());
  if (basis.mother.support) text += " support " + basis.mother.support->to_text();
  text.append(", ").append(name(basis.distance));
  if (basis.radius.neighbour)
    text.append(", neighbour ")
        .append(std::to_string(*basis.radius.neighbour))
        .append(" ")
        .append(name(basis.radius.too_few));
  text.append(", ").append(name(basis.normalise));
  text.append(", sites ").append(text_of(choice.meshless.sites));
  text.append(", weights ").append(name(choice.weights));
  if (choice.weights == WeightRule::integrated)
    text.append(" ")
        .append(shortest(choice.integration.relative_error))
        .append(" ")
        .append(std::to_string(choice.integration.most_points));
  text.append(", coefficients ").append(name(choice.coefficients));
  text.append(", factor ").append(name(choice.factor));
  return text;
}

struct LightTransfer::Parts {
  Parts(LightScene lit, RadialBasis of, TransferChoice made_by)
      : scene(std::move(lit)), basis(std::move(of)), choice(std::move(made_by)) {}

  LightScene scene;
  RadialBasis basis;
  TransferChoice choice;
  std::optional<InterpolationSystem> system;  ///< where coefficients are not the values
  std::vector<double> weights;
  TransferSums sums;
  std::optional<NeumannSeries> series;  ///< of R

  static Outcome<std::shared_ptr<Parts>> make(const LightScene& scene, const TransferChoice& choice) {
    Outcome<SiteSet> sites = make_sites(scene.surface(), choice.meshless.sites);
    if (!sites) return because(sites.reason());
    Outcome<RadialBasis> basis = RadialBasis::make(std::move(*sites), choice.meshless.basis);
    if (!basis) return because(basis.reason());
    auto parts = std::make_shared<Parts>(scene, *std::move(basis), choice);
    if (choice.coefficients == CoefficientRule::interpolated && !parts->basis.interpolates()) {
      Outcome<InterpolationSystem> system = InterpolationSystem::make(parts->basis);
      if (!system) return because(system.reason());
      parts->system = std::move(system).value();
    }
    return parts;
  }

  [[nodiscard]] TransferKey key() const {
    return {.scene = scene.digest(), .sites = digest(basis.sites()), .choice = to_text(choice)};
  }

  [[nodiscard]] std::vector<double> coefficients(std::span<const double> values) const {
    return system ? system->solve(values) : std::vector<double>(values.begin(), values.end());
  }
};

LightTransfer::LightTransfer(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

Outcome<LightTransfer> LightTransfer::complete(std::shared_ptr<Parts> parts, Matrix<double> matrix) {
  Outcome<TransferSeries> made = transfer_series(std::move(matrix));
  if (!made) return because(made.reason());
  parts->series = std::move(made->series);
  parts->sums = made->sums;
  return LightTransfer(std::move(parts));
}

Outcome<LightTransfer> LightTransfer::make(const LightScene& scene, const TransferChoice& choice) {
  Outcome<std::shared_ptr<Parts>> made = Parts::make(scene, choice);
  if (!made) return because(made.reason());
  const std::shared_ptr<Parts> parts = *std::move(made);
  transfer_memory(parts->basis.size(), 1).require(available_memory());
  Outcome<LightWeights> weights =
      light_weights(parts->basis, scene.surface(), choice.weights, choice.integration);
  if (!weights) return because(weights.reason());
  parts->weights = std::move(weights->weights);
  Matrix<double> matrix = point_light_transfer(scene, parts->basis.sites(), parts->weights, choice.factor);
  if (parts->system) parts->system->solve_columns(matrix);
  return complete(parts, std::move(matrix));
}

Outcome<LightTransfer> LightTransfer::read(const LightScene& scene, const TransferChoice& choice,
                                           const std::filesystem::path& path) {
  Outcome<std::shared_ptr<Parts>> made = Parts::make(scene, choice);
  if (!made) return because(made.reason());
  const std::shared_ptr<Parts> parts = *std::move(made);
  return complete(parts, read_transfer(path, parts->key()));
}

void LightTransfer::write(const std::filesystem::path& path) const {
  write_transfer(path, parts_->key(), matrix());
}

const LightScene& LightTransfer::scene() const { return parts_->scene; }
const RadialBasis& LightTransfer::basis() const { return parts_->basis; }
const Matrix<double>& LightTransfer::matrix() const { return parts_->series->matrix(); }
std::span<const double> LightTransfer::weights() const { return parts_->weights; }
const TransferSums& LightTransfer::sums() const { return parts_->sums; }
const NeumannSeries& LightTransfer::series() const { return *parts_->series; }
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
  Outcome<IterativeSolution, NotReached> series = parts_->series->solve(solution.emission, tolerance);
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
