// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_pairs.h"

#include <limits>
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

/// The sizes of modes at the nodes of all elements of a cluster; over the whole triangle where these are
/// many.
ModeSizes sizes_at_nodes(const std::vector<Barycentric<double>>& nodes, int refinements) {
  constexpr int most_refinements = 4;
  if (nodes.empty() || refinements > most_refinements) return ModeSizes();
  return ModeSizes(points_of_parts(refinements, nodes));
}

}  // namespace

ClusterPairs divide_pairs(const std::vector<Chart>& charts, const ClusterTree& tree,
                          const CouplingDemand& demand,
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
    const ClusterOutlines outlines(charts, tree.level(l));
    const ModeSizes sizes =
        sizes_at_nodes(demand.nodes, tree.refinements() + static_cast<int>(tree.levels() - 1 - l));
    std::vector<std::optional<CouplingDegree>> found(now.size());
    constexpr std::size_t pairs_at_a_time = 16;
    parallel_for(now.size(), pairs_at_a_time, [&](std::size_t begin, std::size_t end) {
      CouplingLook look(outlines, demand, sizes);
      for (std::size_t i = begin; i < end; ++i)
        if (now[i].a != now[i].b) found[i] = look(now[i].a, now[i].b);
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

}  // namespace radcert
