// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "radcert/clusters/cluster_tree.h"
#include "radcert/clusters/coupling_degree.h"

namespace radcert {

/// Two clusters of one level that couple by polynomials, in both directions.
struct FarPair {
  std::uint32_t a;
  std::uint32_t b;
  CouplingDegree coupling;
};

/// Two leaves whose matrix entries are stored, in both directions; a <= b.
struct NearPair {
  std::uint32_t a;
  std::uint32_t b;
};

/// How the pairs of elements are divided among couplings and stored entries.
/// Maths     every pair of elements on charts that are not in one plane lies in exactly one far pair of one
///           level or in one near pair: a pair of clusters that does not couple is divided into the pairs of
///           their children, at the leaves it is near
/// Result    far pairs by level; both lists in the order of the division, the same for any number of threads
struct ClusterPairs {
  std::vector<std::vector<FarPair>> far;
  std::vector<NearPair> near;
};

/// Divides the pairs of a tree's clusters.
/// Maths     see ClusterPairs, CouplingLook
/// Requires  fewer than 2^32 clusters a level; in_plane(i, j): whether G vanishes between two charts
/// Result    degrees and errors are estimated; Interrupted when asked to stop
[[nodiscard]] ClusterPairs divide_pairs(const std::vector<Chart>& charts, const ClusterTree& tree,
                                        const CouplingDemand& demand,
                                        const std::function<bool(std::size_t, std::size_t)>& in_plane);

}  // namespace radcert
