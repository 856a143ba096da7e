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

/// The pairs of the children of two clusters, each once.
void append_children(const NearPair& pair, std::vector<NearPair>& finer) {
  for (std::uint32_t i = 0; i < 4; ++i)
    for (std::uint32_t j = pair.a == pair.b ? i : 0; j < 4; ++j)
      finer.push_back({4 * pair.a + i, 4 * pair.b + j});
}

}  // namespace

std::vector<double> truncation_of_leaves(const ClusterTree& tree,
                                         const std::vector<std::vector<FarPair>>& pairs) {
  std::vector<double> left_out;
  for (std::size_t l = 0; l < tree.levels(); ++l) {
    std::vector<double> finer(tree.level(l).size(), 0.0);
    for (std::size_t i = 0; i < finer.size(); ++i)
      if (l > 0) finer[i] = left_out[i / 4];
    for (const FarPair& pair : pairs[l]) {
      finer[pair.a] += pair.coupling.error_a;
      finer[pair.b] += pair.coupling.error_b;
    }
    left_out = std::move(finer);
  }
  return left_out;
}

ModeSizes sizes_at_nodes(const CouplingDemand& demand, const ClusterTree& tree, std::size_t level) {
  constexpr int most_refinements = 4;
  const int refinements = tree.refinements() + static_cast<int>(tree.levels() - 1 - level);
  if (demand.nodes.empty() || refinements > most_refinements) return ModeSizes();
  return ModeSizes(points_of_parts(refinements, demand.nodes));
}

ClusterPairs divide_pairs(const ClusterTree& tree,
                          const std::function<LevelDecisions(std::size_t level)>& decisions,
                          const std::function<bool(std::size_t, std::size_t)>& in_plane) {
  expects(tree.leaves().size() < std::numeric_limits<std::uint32_t>::max(), "fewer than 2^32 leaves",
          named("leaves", tree.leaves().size()));
  ClusterPairs pairs;
  pairs.far.resize(tree.levels());
  std::vector<NearPair> now;
  const std::vector<ParameterTriangle>& roots = tree.level(0);
  for (std::uint32_t a = 0; a < roots.size(); ++a)
    for (std::uint32_t b = a; b < roots.size(); ++b)
      if (!in_plane(roots[a].chart, roots[b].chart)) now.push_back({a, b});
  for (std::size_t l = 0; l < tree.levels(); ++l) {
    const LevelDecisions of_level = decisions(l);
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
        append_children(now[i], left);
    }
    now = std::move(left);
  }
  return pairs;
}

ClusterPairs divide_pairs(const std::vector<Chart>& charts, const ClusterTree& tree,
                          const CouplingDemand& demand,
                          const std::function<bool(std::size_t, std::size_t)>& in_plane) {
  struct Seen {
    ClusterOutlines outlines;
    ModeSizes sizes;
  };
  return divide_pairs(
      tree,
      [&](std::size_t l) -> LevelDecisions {
        const auto seen = std::make_shared<const Seen>(
            Seen{ClusterOutlines(charts, tree.level(l)), sizes_at_nodes(demand, tree, l)});
        return [seen, &demand] {
          const auto look = std::make_shared<CouplingLook>(seen->outlines, demand, seen->sizes);
          return [look, seen](std::size_t a, std::size_t b) { return (*look)(a, b); };
        };
      },
      in_plane);
}

}  // namespace radcert
