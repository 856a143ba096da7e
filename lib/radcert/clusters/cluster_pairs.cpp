// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_pairs.h"

#include <limits>
#include <memory>
#include <optional>

#include "radcert/clusters/mode_tables.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

/// The pairs of the children of two clusters, each once, as far as they concern the clusters of a range.
void append_children(const NearPair& pair, const ClusterRange& here, std::vector<NearPair>& finer) {
  for (std::uint32_t i = 0; i < 4; ++i)
    for (std::uint32_t j = pair.a == pair.b ? i : 0; j < 4; ++j) {
      const NearPair children{4 * pair.a + i, 4 * pair.b + j};
      if (here.contains(children.a) || here.contains(children.b)) finer.push_back(children);
    }
}

/// The clusters of pairs, ascending.
std::vector<std::uint32_t> clusters_of(std::span<const NearPair> pairs, std::size_t count) {
  std::vector<bool> seen(count);
  for (const NearPair& pair : pairs) seen[pair.a] = seen[pair.b] = true;
  std::vector<std::uint32_t> clusters;
  for (std::size_t i = 0; i < count; ++i)
    if (seen[i]) clusters.push_back(static_cast<std::uint32_t>(i));
  return clusters;
}

}  // namespace

std::vector<double> truncation_of_leaves(const ClusterPart& part,
                                         const std::vector<std::vector<FarPair>>& pairs) {
  std::vector<double> left_out;
  for (std::size_t l = 0; l <= part.leaf_level(); ++l) {
    const ClusterRange now = part.range(l);
    std::vector<double> finer(now.size(), 0.0);
    if (l > 0)
      for (std::size_t i = now.begin; i < now.end; ++i)
        finer[i - now.begin] = left_out[i / 4 - part.range(l - 1).begin];
    for (const FarPair& pair : pairs[l]) {
      if (now.contains(pair.a)) finer[pair.a - now.begin] += pair.coupling.error_a;
      if (now.contains(pair.b)) finer[pair.b - now.begin] += pair.coupling.error_b;
    }
    left_out = std::move(finer);
  }
  return left_out;
}

ModeSizes sizes_at_nodes(const CouplingDemand& demand, const ClusterTree& tree, std::size_t level) {
  constexpr int most_refinements = 4;
  const int refinements = tree.refinements() + static_cast<int>(tree.levels() - 1 - level);
  if (demand.nodes.empty() || refinements > most_refinements || !tree.is_uniform()) return ModeSizes();
  return ModeSizes(points_of_parts(refinements, demand.nodes));
}

ClusterPairs divide_pairs(const ClusterTree& tree, const ClusterPart& part, const Decisions& decisions,
                          const std::function<bool(std::size_t, std::size_t)>& in_plane) {
  expects(tree.leaves().size() < std::numeric_limits<std::uint32_t>::max(), "fewer than 2^32 leaves",
          named("leaves", tree.leaves().size()));
  ClusterPairs pairs;
  pairs.far.resize(tree.levels());
  std::vector<NearPair> now;
  const std::vector<ParameterTriangle>& roots = tree.level(0);
  for (std::uint32_t a = 0; a < roots.size(); ++a)
    for (std::uint32_t b = a; b < roots.size(); ++b)
      if ((part.range(0).contains(a) || part.range(0).contains(b)) &&
          !in_plane(roots[a].chart, roots[b].chart))
        now.push_back({a, b});
  for (std::size_t l = 0; l < tree.levels(); ++l) {
    const LevelDecisions of_level = decisions(l, now);
    std::vector<std::optional<CouplingDegree>> found(now.size());
    constexpr std::size_t pairs_at_a_time = 16;
    parallel_for(now.size(), pairs_at_a_time, [&](std::size_t begin, std::size_t end) {
      const PairDecision decide = of_level();
      for (std::size_t i = begin; i < end; ++i)
        if (now[i].a != now[i].b) found[i] = decide(now[i].a, now[i].b);
    });
    std::vector<NearPair> left;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (found[i])
        pairs.far[l].push_back({now[i].a, now[i].b, *found[i]});
      else if (l + 1 == tree.levels())
        pairs.near.push_back(now[i]);
      else
        append_children(now[i], part.range(l + 1), left);
    }
    now = std::move(left);
  }
  return pairs;
}

ClusterPairs divide_pairs(const std::vector<Chart>& charts, const ClusterTree& tree, const ClusterPart& part,
                          const CouplingDemand& demand,
                          const std::function<bool(std::size_t, std::size_t)>& in_plane) {
  struct Seen {
    ClusterOutlines outlines;
    ModeSizes sizes;
  };
  return divide_pairs(
      tree, part,
      [&](std::size_t l, std::span<const NearPair> pairs) -> LevelDecisions {
        const std::vector<ParameterTriangle>& clusters = tree.level(l);
        const auto seen = std::make_shared<const Seen>(
            Seen{ClusterOutlines(charts, clusters, clusters_of(pairs, clusters.size())),
                 sizes_at_nodes(demand, tree, l)});
        return [seen, &demand] {
          const auto look = std::make_shared<CouplingLook>(seen->outlines, demand, seen->sizes);
          return [look, seen](std::size_t a, std::size_t b) { return (*look)(a, b); };
        };
      },
      in_plane);
}

}  // namespace radcert
