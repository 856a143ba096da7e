// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_part.h"

#include "radcert/core/contract.h"

namespace radcert {
namespace {

std::size_t cut_of(const ClusterTree& tree) {
  const std::size_t leaves = tree.leaves().size();
  for (std::size_t l = 0; l + 1 < tree.levels(); ++l)
    if (tree.level(l).size() >= leaves / tree.level(l).size()) return l;
  return tree.levels() - 1;
}

}  // namespace

std::size_t ClusterPart::most_ranks(const ClusterTree& tree) { return tree.level(cut_of(tree)).size(); }

ClusterPart::ClusterPart(const ClusterTree& tree, const Ranks& ranks) : ranks_(&ranks), cut_(cut_of(tree)) {
  for (std::size_t l = 0; l < tree.levels(); ++l) counts_.push_back(tree.level(l).size());
  expects(ranks.count() <= counts_[cut_], "no more ranks than subtrees", named("ranks", ranks.count()),
          named("subtrees", counts_[cut_]));
}

std::size_t ClusterPart::first_subtree(std::size_t rank) const {
  return rank * counts_[cut_] / ranks_->count();
}

ClusterRange ClusterPart::range(std::size_t level, std::size_t rank) const {
  const std::size_t begin = first_subtree(rank);
  const std::size_t end = first_subtree(rank + 1);
  if (level >= cut_) return {begin << 2 * (level - cut_), end << 2 * (level - cut_)};
  return {begin >> 2 * (cut_ - level), ((end - 1) >> 2 * (cut_ - level)) + 1};
}

std::size_t ClusterPart::owner(std::size_t level, std::size_t cluster) const {
  expects(level >= cut_ && cluster < counts_[level], "a cluster that one rank has", named("level", level),
          named("cluster", cluster));
  const std::size_t subtree = cluster >> 2 * (level - cut_);
  std::size_t rank = subtree * ranks_->count() / counts_[cut_];
  while (subtree >= first_subtree(rank + 1)) ++rank;
  return rank;
}

}  // namespace radcert
