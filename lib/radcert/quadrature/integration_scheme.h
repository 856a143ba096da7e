// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/samples.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The rules for an element or a piece of one, seen from a distance.
struct FarRule {
  int order;  ///< of the conical rule that counts
  /// Of the coarser one that it is compared with; none where a bound is known
  std::optional<int> compared_with;
};

/// The data that all elements of one assembly share: surface, basis, tolerance, and what follows from them.
/// Maths     largest_value(j) >= max |l_j|: see largest_values;
///           flat_truncation() = Tolerance::converged min_j (mean |l_j|) / (max |l_j|), both over a lattice
///           of the element: what a rule may leave out, relative to largest_value(j) times a solid angle, and
///           still be small beside Int |G l_j|; a conical rule of n x n points leaves out about rho^(-2n),
///           rho = eta + sqrt(eta^2 - 1), seen from eta radii
/// Source    see flat_rule_bound
/// Requires  the surface outlives this
/// Result    immutable; safe to share between threads
template <Real R>
class IntegrationScheme {
public:
  IntegrationScheme(const Surface& surface, const TriangleBasis<R>& basis, const Tolerance& tolerance);

  const Surface& surface() const { return surface_; }
  const TriangleBasis<R>& basis() const { return basis_; }
  const Tolerance& tolerance() const { return tolerance_; }
  const R& largest_value(std::size_t j) const { return largest_values_[j]; }

  double flat_truncation() const { return flat_truncation_; }
  /// By how much the rounding of a chart's normal exceeds that of its tangents: the largest |D_s F| |D_t F| /
  /// |D_s F x D_t F| found.
  const R& normal_loss(std::size_t chart) const { return normal_loss_[chart]; }

  /// Whether G vanishes between two charts because both lie in one plane.
  bool in_plane(std::size_t a, std::size_t b) const {
    return plane_[a] != no_plane && plane_[a] == plane_[b];
  }

  /// The rules for an element seen from eta radii: one whose bound is within flat_truncation() if the element
  /// is plane and that takes fewer points than two rules of the orders that the error model asks for.
  FarRule far_rule(const ChartFacts& chart, double eta, double unevenness) const;

  /// The least order for which the error model reaches Tolerance::intended_truncation, so that a finer rule
  /// exists.
  int order_by_model(double eta) const;
  /// How much finer the rule is with which a rule is compared; more where rules may converge slowly: on
  /// singular charts, and on elements on which the chart does not change evenly.
  static int check_step(const ChartFacts& chart, double unevenness);

private:
  static constexpr std::size_t no_plane = static_cast<std::size_t>(-1);

  const Surface& surface_;
  TriangleBasis<R> basis_;
  Tolerance tolerance_;
  std::vector<R> largest_values_;
  double flat_truncation_;
  std::vector<R> normal_loss_;      ///< by chart
  std::vector<std::size_t> plane_;  ///< by chart: the first chart in the same plane
  /// By order: the eta from which flat_rule_bound is small enough
  std::vector<double> least_distance_by_bound_;
  std::vector<double> least_distance_by_model_;
};

extern template class IntegrationScheme<double>;
extern template class IntegrationScheme<Mpfr<50>>;

}  // namespace radcert
