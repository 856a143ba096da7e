// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace radcert {

/// The cost of a level, in unknowns, seconds or 1/h, and its error.
struct CostPoint {
  double cost = 0;
  double error = 0;
};

/// The exponent of a power law and how far the points are from one.
struct PowerLaw {
  double exponent = 0;
  std::optional<double> halfwidth;  ///< absent with two points, which every power law meets
};

/// The power law through points.
/// Maths     least squares for log error = exponent log cost + c; halfwidth: the largest distance of the
///           slope between two successive points from the exponent
/// Source    as the fitted orders of radcert/solution/1
/// Requires  positive finite costs and errors, else ContractViolation
/// Result    rounded; none for fewer than two different costs
/// Limits    the halfwidth says how steady the slope is, not how near the limit: no guarantee
[[nodiscard]] std::optional<PowerLaw> power_law(std::span<const CostPoint> points);

/// The power law that points follow in the end, and where it begins.
struct AsymptoticLaw {
  std::size_t from = 0;         ///< the points before it are pre-asymptotic
  std::optional<PowerLaw> law;  ///< through the points from there on
};

/// The power law of the finest points, without those whose slopes are not yet steady.
/// Maths     from is the least k such that the power law through the points k, k+1, ... has a halfwidth of at
///           most max(1/2, |exponent|/4), three points at least
/// Source    ours
/// Requires  as power_law, points in the order of refinement
/// Result    at most two points: from = 0, and their power law. No such k: from is the number of points, and
///           there is no law
/// Limits    steady slopes say nothing about the limit: no guarantee
[[nodiscard]] AsymptoticLaw asymptotic_law(std::span<const CostPoint> points);

/// The error of a method at a cost between those of its levels.
/// Maths     log error is linear in log cost between two successive points
/// Requires  positive finite costs and errors, else ContractViolation; costs ascend, as points that do not
///           are passed over
/// Result    rounded; none outside the points: nothing is extrapolated
/// Limits    as good as the power law between two levels
[[nodiscard]] std::optional<double> error_at(std::span<const CostPoint> points, double cost);

/// Methods in the order of their errors at one cost.
struct EqualCost {
  double cost = 0;                            ///< the same for all
  std::vector<std::optional<double>> errors;  ///< a method each; absent where the method has no such cost
  std::vector<std::size_t> order;             ///< the methods by ascending error, those without one last
};

/// Compares methods at equal cost.
/// Maths     cost = the largest that every method pays at some level: min over the methods of their dearest
///           level; errors by error_at
/// Requires  as error_at
/// Result    none without a method that has a point. Equal errors keep the order of the methods
/// Limits    a method all of whose levels are dearer has no error there
[[nodiscard]] std::optional<EqualCost> at_equal_cost(std::span<const std::vector<CostPoint>> methods);

}  // namespace radcert
