// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_pairs.h"
#include "radcert/clusters/cluster_part.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/matrix.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/quadrature/integration_scheme.h"

namespace radcert {

/// The entries of the collocation matrix between leaves that are near each other.
/// Maths     entries(i, k p + j) = factor_i Int_{Delta_k} G(v_i,Q) l_j(Q) dS_Q for v_i and Delta_k in near
///           leaves
/// Source    [ac98, (40)]; ElementIntegrator, as in the dense assembly
/// Requires  as many nodes as elements of the part's leaves times functions; near pairs of leaves of
///           `unknowns` each; products are called by all ranks together
/// Result    the rows of the part's leaves: a dense block a pair of leaves, by columns, its rows padded; each
///           entry to the tolerance of its row's scheme. The same bits for any number of ranks and threads;
///           Interrupted when asked to stop
class NearEntries {
public:
  /// What a row's near entries sum to beside themselves.
  struct RowSums {
    std::vector<double> kernel_integral;  ///< Int |G| dS over the near elements
    std::vector<double> radius;           ///< sum of the entries' radii
  };

  NearEntries(const ClusterPart& part, const std::vector<NearPair>& pairs, std::size_t unknowns_of_leaf);

  /// Schemes of one surface and basis with tolerances of their own, and which of them the rows of each leaf
  /// here take.
  struct Schemes {
    std::vector<std::shared_ptr<const IntegrationScheme<double>>> schemes;
    std::vector<std::size_t> of_leaf;
  };
  /// Integrates all entries over the elements of a tree.
  RowSums fill(const Schemes& schemes, const ClusterTree& tree,
               std::span<const CollocationPoint<double>> nodes, std::span<const double> factors);

  /// y_i += sum_j entries(i, j) x_j; for each row in a fixed order.
  void add_product(std::span<const double> x, std::span<double> y) const;
  /// y_i += sum_j |entries(i, j)| x_j.
  void add_sizes(std::span<const double> x, std::span<double> y) const;
  /// The same sum as if in twice the precision: |error_i| <= u |y_i| + (n u)^2 of the sum of sizes, n terms.
  void add_accurately(std::span<const double> x, std::span<double> y) const;
  /// The entry of row i and column j, 0 where the two are not near. Of one rank.
  [[nodiscard]] double entry(std::size_t i, std::size_t j) const;

  /// The number of stored entries, and the largest number in a row.
  [[nodiscard]] std::size_t size() const { return sources_.size() * rows_ * unknowns_; }
  [[nodiscard]] std::size_t longest_row() const;
  void count(MemoryPlan& plan) const;
  /// The bytes that this rank sends for a product.
  [[nodiscard]] std::uint64_t bytes_sent() const { return exchange_->bytes_sent(); }

private:
  [[nodiscard]] const double* block(std::size_t number) const {
    return entries_.data() + number * rows_ * unknowns_;
  }
  /// y_i = start_i + the row's sum.
  template <class Sums>
  void sum_rows(std::span<const double> x, std::span<const double> start, std::span<double> y) const;

  ClusterPart part_;
  std::size_t leaves_;  ///< here
  std::size_t unknowns_;
  std::size_t rows_;                    ///< of a block: unknowns_ padded
  std::vector<std::uint32_t> foreign_;  ///< leaves of other ranks that are near leaves here, ascending
  std::vector<std::size_t> first_;      ///< by target leaf: the place of its first source
  /// By target leaf, in the order of the tree: the leaves near it, first those here by their number, then
  /// foreign_ by its; one block each.
  std::vector<std::uint32_t> sources_;
  std::unique_ptr<const Exchange> exchange_;  ///< of the entries of vectors at the foreign leaves
  std::vector<double, UninitialisedAllocator<double>> entries_;
};

}  // namespace radcert
