// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/ranks/ranks.h"

namespace radcert {

/// Clusters of one level that follow each other.
struct ClusterRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] bool contains(std::size_t cluster) const { return begin <= cluster && cluster < end; }
  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Which clusters a rank computes for.
/// Maths     the tree is cut at the coarsest level c with at least the root of the number of leaves as
///           clusters, or at the leaves. Of its s clusters, rank r of n has those from floor(r s / n) to
///           floor((r + 1) s / n), with all below them. Above the cut a rank has those that have leaves of
///           its own: several ranks have them
/// Source    the cut follows from the tree alone, so that sums over it are the same for every number of ranks
/// Requires  no more ranks than most_ranks, else ContractViolation; the ranks outlive this
class ClusterPart {
public:
  explicit ClusterPart(const ClusterTree& tree, const Ranks& ranks = one_rank());

  /// The number of ranks that have something to do: s.
  [[nodiscard]] static std::size_t most_ranks(const ClusterTree& tree);

  [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
  [[nodiscard]] std::size_t cut() const { return cut_; }
  [[nodiscard]] std::size_t leaf_level() const { return counts_.size() - 1; }
  /// All clusters of a level.
  [[nodiscard]] std::size_t count(std::size_t level) const { return counts_[level]; }
  /// Those of this rank, and of another.
  [[nodiscard]] ClusterRange range(std::size_t level) const { return range(level, ranks_->here()); }
  [[nodiscard]] ClusterRange range(std::size_t level, std::size_t rank) const;
  [[nodiscard]] ClusterRange leaves() const { return range(leaf_level()); }
  /// Who has a cluster of a level that is not above the cut.
  [[nodiscard]] std::size_t owner(std::size_t level, std::size_t cluster) const;

private:
  [[nodiscard]] std::size_t first_subtree(std::size_t rank) const;

  const Ranks* ranks_;
  std::size_t cut_;
  std::vector<std::size_t> counts_;
};

}  // namespace radcert
