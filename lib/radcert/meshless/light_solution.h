// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/core/matrix.h"
#include "radcert/core/outcome.h"
#include "radcert/meshless/light_scene.h"
#include "radcert/meshless/light_source.h"
#include "radcert/meshless/radial_basis.h"
#include "radcert/meshless/transfer_matrix.h"
#include "radcert/meshless/weights.h"
#include "radcert/solve/power_series.h"

namespace radcert {

/// How the intensity w_j of a point light is found: see weights.h.
enum class WeightRule : std::uint8_t { integrated, plane, neighbours, mean_density };

/// How values at the sites become coefficients.
/// Maths     as_values: lambda_i = f(p_i), so that R = N; interpolated: A lambda = f, a_ij = phi_j(p_i), so
///           that R = A^-1 N
/// Source    [psg10, section VII] takes the values, which is the interpolant only where A = I
/// Limits    as_values smooths with a partition of unity, and multiplies by sum_j phi_j where that is not 1
enum class CoefficientRule : std::uint8_t { as_values, interpolated };

/// The words of the file formats.
[[nodiscard]] std::string_view name(WeightRule rule);
[[nodiscard]] std::string_view name(CoefficientRule rule);

/// The intensities w_j of the point lights by a rule.
/// Maths     w_j = int phi_j dS, or an estimate of it
/// Source    [psg10, section VII]; see weights.h
/// Requires  the sites belong to the surface
/// Result    weights, and an estimate of the error of each where the rule is `integrated`. Those of
///           `mean_density` err together, by the error of the area: sqrt(n) times that of each, so that the
///           root of a sum of squares bounds what all do at once. None for the others. Refused: what the rule
///           refuses
/// Limits    what an estimate of w_j by its sites alone leaves out is not estimated
struct LightWeights {
  std::vector<double> weights;
  std::vector<double> errors;
};
[[nodiscard]] Outcome<LightWeights> light_weights(const RadialBasis& basis, const Surface& surface,
                                                  WeightRule rule, const IntegrationDemand& demand = {});

/// A transfer matrix that may be iterated.
/// Maths     (I - R)^-1 = I + R + R^2 + ...
/// Source    [psg10, (6)]; solve/power_series.h
/// Requires  a square matrix, not empty
/// Result    the series and what R does to constants. Refused: an R of which no power up to the sixteenth
///           contracts, with its spectral radius, its largest row sum and its largest entry
struct TransferSeries {
  NeumannSeries series;
  TransferSums sums;
};
[[nodiscard]] Outcome<TransferSeries> transfer_series(Matrix<double> r);

/// All that a transfer matrix is made of, but the scene.
struct TransferChoice {
  MeshlessChoice meshless{};
  WeightRule weights = WeightRule::integrated;
  CoefficientRule coefficients = CoefficientRule::as_values;
  IntegrationDemand integration{};  ///< of integrated weights
};

/// The coefficients of the radiance in the basis.
struct LightSolution {
  std::vector<double> total;     ///< lambda
  std::vector<double> emission;  ///< epsilon, of light scattered once
  std::vector<double> indirect;  ///< lambda - epsilon
  std::size_t reflections = 0;   ///< steps of the Neumann series
  double error_bound = 0;        ///< >= max_i |lambda_i - exact solution of the system|, proved
};

/// A scene whose transfer matrix is known: ready for any light.
/// Maths     (I - R) lambda = epsilon, R = N or A^-1 N
/// Source    [psg10, (19)], precomputed radiance transfer
/// Result    immutable. The Neumann series of an R of which a power contracts in a weighted maximum norm
///           (solve/power_series.h), with its a-posteriori bound
/// Limits    what R leaves out of the integral operator is not bounded
class LightTransfer {
public:
  /// Refused: sites, a basis or weights that are (see there); an R of which no power up to the sixteenth
  /// contracts. InputError where memory does not do.
  [[nodiscard]] static Outcome<LightTransfer> make(const LightScene& scene, const TransferChoice& choice);

  [[nodiscard]] const LightScene& scene() const;
  [[nodiscard]] const RadialBasis& basis() const;
  [[nodiscard]] const Matrix<double>& matrix() const;
  /// w_j.
  [[nodiscard]] std::span<const double> weights() const;
  [[nodiscard]] const TransferSums& sums() const;
  /// R with what bounds its spectral radius.
  [[nodiscard]] const NeumannSeries& series() const;
  /// An estimate of the condition of A; 1 where the values are the coefficients.
  [[nodiscard]] double condition() const;

  /// Coefficients for a light. Tolerance: of error_bound against max |lambda|, absent: to machine precision.
  /// Refused: not reached.
  [[nodiscard]] Outcome<LightSolution> solve(const Light& light,
                                             std::optional<double> tolerance = 1e-8) const;
  /// The radiance of a point in the basis, as the paper has it; nothing where the basis has no value.
  [[nodiscard]] std::optional<double> radiance(const LightSolution& solution, const LitPoint& at) const;
  /// The direct light there, exactly, and the rest in the basis: shadows keep their edges.
  [[nodiscard]] std::optional<double> radiance(const LightSolution& solution, const Light& light,
                                               const LitPoint& at) const;
  /// The emittance at the sites.
  [[nodiscard]] std::vector<double> emission_at_sites(const Light& light) const;

private:
  struct Parts;
  explicit LightTransfer(std::shared_ptr<const Parts> parts);
  std::shared_ptr<const Parts> parts_;
};

}  // namespace radcert
