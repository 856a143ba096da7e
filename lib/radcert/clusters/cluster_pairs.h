// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_part.h"
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
///           their children, at the leaves it is near. A rank has those of these pairs in which one cluster
///           is of its part
/// Result    far pairs by level; both lists in the order of the division, the same for any number of threads
struct ClusterPairs {
  std::vector<std::vector<FarPair>> far;
  std::vector<NearPair> near;
};

/// Whether two clusters of one level couple, and how; for one thread.
using PairDecision = std::function<std::optional<CouplingDegree>(std::size_t a, std::size_t b)>;
/// What decides the pairs of one level: one for each thread.
using LevelDecisions = std::function<PairDecision()>;
/// What decides the pairs of each level, told of those that there are.
using Decisions = std::function<LevelDecisions(std::size_t level, std::span<const NearPair> pairs)>;

/// Divides the pairs of a tree's clusters.
/// Maths     see ClusterPairs
/// Requires  fewer than 2^32 clusters a level; a part of this tree; decisions(l, pairs): those of level l,
///           used before those of the next are asked for; in_plane(i, j): whether G vanishes between two
///           charts
/// Result    as the decisions are; Interrupted when asked to stop
[[nodiscard]] ClusterPairs divide_pairs(const ClusterTree& tree, const ClusterPart& part,
                                        const Decisions& decisions,
                                        const std::function<bool(std::size_t, std::size_t)>& in_plane);

/// What couplings leave out of the rows of each leaf of a part, pushed from clusters to the leaves below
/// them.
/// Maths     the sum of error_a and error_b over the pairs of the leaf and of the clusters that contain it
[[nodiscard]] std::vector<double> truncation_of_leaves(const ClusterPart& part,
                                                       const std::vector<std::vector<FarPair>>& pairs);

/// How large the modes are at the nodes of all elements of a cluster of one level of a tree.
/// Result    of the nodes of the demand; over the whole triangle where these are many, or none, and of graded
///           trees
[[nodiscard]] ModeSizes sizes_at_nodes(const CouplingDemand& demand, const ClusterTree& tree,
                                       std::size_t level);

/// Divides them by the looks of CouplingLook.
/// Result    degrees and errors are estimated
[[nodiscard]] ClusterPairs divide_pairs(const std::vector<Chart>& charts, const ClusterTree& tree,
                                        const ClusterPart& part, const CouplingDemand& demand,
                                        const std::function<bool(std::size_t, std::size_t)>& in_plane);

}  // namespace radcert
