// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "radcert/clusters/certified/enclosed_couplings.h"
#include "radcert/clusters/certified/enclosed_near_entries.h"
#include "radcert/clusters/cluster_operator.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The matrix of K P_n at the nodes with the reflectivity 1, by products that enclose.
/// Maths     k_ij = 1/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q at the exact nodes. Far clusters couple as in
///           ClusterOperator, at degrees that CertifiedLook proves: with truncation()[i] >= the sum over the
///           couplings of row i of the mean of |h - c| sum_j q_j / pi, the sums sum_j |x_j| |k_ij - c_ij| are
///           at most truncation()[i] max |x|, since |sum_j x_j l_j| <= max |x| sum_j q_j. Near entries as
///           EnclosedNearEntries
/// Source    ClusterOperator; CertifiedLook, EnclosedCouplings, EnclosedNearEntries, each with its proof
/// Requires  made by enclosed_clusters
/// Result    product: encloses (K x)_i. sizes: upper bounds of sum_j |k_ij| x_j for x >= 0, far entries by
///           the step functions q_j >= |l_j| where G >= 0. Proved; the same bits for any number of threads;
///           Interrupted when asked to stop
/// Limits    V = 1; a product takes some fifty times as long as that of ClusterOperator
class EnclosedClusters {
public:
  struct Setting {
    const Surface& surface;
    const Triangulation& triangulation;
    int level;
    const LagrangeFunctions& functions;
    ClusterTolerance far = ClusterTolerance(1e-9);
    Tolerance near = Tolerance();  ///< of the sum of the near entries' radii in a row, on curved charts
    std::optional<int> refinements = std::nullopt;  ///< as ClusterOperator::Setting
    std::uint64_t memory_limit = static_cast<std::uint64_t>(-1);
  };

  [[nodiscard]] std::size_t size() const { return truncation_.size(); }
  [[nodiscard]] std::vector<BoundedDouble> product(std::span<const double> x) const;
  [[nodiscard]] std::vector<double> sizes(std::span<const double> x) const;
  [[nodiscard]] const std::vector<double>& truncation() const { return truncation_; }
  /// The number of far pairs, and of stored entries.
  [[nodiscard]] std::size_t far_pairs() const { return far_pairs_; }
  [[nodiscard]] std::size_t near_entries() const { return near_->size(); }

private:
  friend Outcome<EnclosedClusters> enclosed_clusters(const Setting& setting);
  EnclosedClusters() = default;

  std::unique_ptr<const EnclosedTables> tables_;
  std::unique_ptr<const EnclosedCouplings> couplings_;
  std::unique_ptr<const EnclosedNearEntries> near_;
  std::vector<double> truncation_;
  std::size_t far_pairs_ = 0;
};

/// Divides the pairs, proves the couplings and integrates the near entries.
/// Requires  a uniform triangulation of this level, a surface without obstacle_to_clusters that lies
///           in the boundary of a convex body; functions of degree at most 8; what is passed outlives it
/// Result    truncation within the tolerance. Refused in words as enclosed_near_entries; InputError where
///           more memory would be taken than the limit
[[nodiscard]] Outcome<EnclosedClusters> enclosed_clusters(const EnclosedClusters::Setting& setting);

}  // namespace radcert
