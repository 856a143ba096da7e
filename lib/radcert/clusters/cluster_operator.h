// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "radcert/clusters/cluster_couplings.h"
#include "radcert/clusters/cluster_part.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/clusters/near_entries.h"
#include "radcert/core/outcome.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/tolerance.h"
#include "radcert/solve/system_matrix.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// How far the matrix between distant clusters may be from its entries.
/// Maths     of each row, sum_j |error_ij| <= row() rho(v_i), about that part of the row where S is closed
/// Requires  finest <= row <= coarsest, else ContractViolation
/// Result    largest_degree(): 10, 15, 20 at 1e-6, 1e-9, 1e-12; share(levels) = row()/(30 (levels - 1)): what
///           one coupling may leave out of a row at first: a row has up to 100 couplings a level, most of
///           which leave out much less
class ClusterTolerance {
public:
  static constexpr double finest = 1e-13;
  static constexpr double coarsest = 1e-3;

  explicit ClusterTolerance(double row);
  [[nodiscard]] double row() const { return row_; }
  [[nodiscard]] int largest_degree() const;
  [[nodiscard]] double share(std::size_t levels) const;

private:
  double row_;
};

/// Why couplings between clusters do not serve a surface, if so.
/// Result    nothing where every chart is analytic up to its borders and hides nothing; otherwise what is in
///           the way, in words
[[nodiscard]] std::optional<std::string> obstacle_to_clusters(const Surface& surface);

/// The matrix of K P_n at the nodes, far parts as couplings of clusters, near parts as entries.
/// Maths     k_ij = rho(v_i)/pi Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q, G interpolated in both variables between
///           far clusters; row_radius[i] bounds sum_j |k_ij - exact|: the near entries' radii, what the
///           couplings of the row leave out, and the rounding of a product; kernel_integral[i] = Int_S |G| dS
/// Source    [ac98, (40)]; ClusterCouplings, NearEntries
/// Requires  a surface without obstacle_to_clusters; the nodes of the part's elements, one a function and
///           element, one reflectivity in [0,1] a node; surface and nodes outlive this; called by all ranks
///           of the part together
/// Result    what couplings leave out of a row is within the tolerance: their shares are reduced until it is.
///           Near entries are integrated to the tolerance of their row: coarser where little of it is near.
///           Radii are estimates, as those of CollocationMatrix. The rows of the part's leaves, and the same
///           bits for any number of ranks and threads; Interrupted when asked to stop
/// Limits    couplings in double
class ClusterOperator final : public ProductOperator {
public:
  struct Setting {
    const Surface& surface;
    const ClusterTree& tree;  ///< of a uniform triangulation; see leaf_refinements
    const ClusterPart& part;
    const TriangleBasis<double>& basis;
    std::span<const CollocationPoint<double>> nodes;
    std::span<const double> reflectivity;
    Tolerance integrals = Tolerance();
    ClusterTolerance far = ClusterTolerance(1e-12);
    /// Bytes that the operator may take; more are refused by InputError before the entries are integrated.
    std::uint64_t memory_limit = static_cast<std::uint64_t>(-1);
  };
  explicit ClusterOperator(const Setting& setting);

  [[nodiscard]] std::size_t size() const override { return factors_.size(); }
  /// Blocks are the subtrees of the part.
  [[nodiscard]] VectorParts parts() const override { return parts_; }
  [[nodiscard]] const std::vector<double>& kernel_integral() const { return kernel_integral_; }
  [[nodiscard]] const std::vector<double>& row_radius() const { return row_radius_; }

  /// y = K x.
  void multiply(std::span<const double> x, std::span<double> y) const override;
  /// y_i >= sum_j |k_ij| x_j for x >= 0: between far clusters |Int G l_j| <= Int G |l_j|.
  void multiply_sizes(std::span<const double> x, std::span<double> y) const override;
  /// y = K x with the near part as if in twice the precision.
  void multiply_accurately(std::span<const double> x, std::span<double> y) const override;
  /// What the rounding of couplings may do to a product: |error_i| <= rounding() max|x| rho_i, estimated.
  [[nodiscard]] double rounding() const override { return rounding_; }

  [[nodiscard]] const ClusterCouplings& couplings() const { return *couplings_; }
  [[nodiscard]] const NearEntries& near_entries() const { return *near_; }
  [[nodiscard]] MemoryPlan memory() const;
  /// The bytes that this rank sends for a product.
  [[nodiscard]] std::uint64_t bytes_sent() const { return couplings_->bytes_sent() + near_->bytes_sent(); }

private:
  void far_product(ClusterDensity density, std::span<const double> x, std::span<double> y) const;

  VectorParts parts_;
  std::vector<double> factors_;  ///< rho/pi
  std::unique_ptr<ClusterCouplings> couplings_;
  std::unique_ptr<NearEntries> near_;
  std::vector<double> kernel_integral_;
  std::vector<double> row_radius_;
  double rounding_ = 0;
};

}  // namespace radcert
