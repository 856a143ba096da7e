// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "radcert/clusters/certified/enclosed_tables.h"
#include "radcert/clusters/cluster_pairs.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/memory_plan.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/surface/chart.h"

namespace radcert {

/// Products of the couplings of far clusters, enclosed.
/// Maths     y_i = sum over the far pairs (a, b), v_i in a, of the mean over b of c(x_i, y) f(y), c the
///           coupling of CertifiedLook, f = sum_j x_j l_j or sum_j x_j q_j: moments, weights of nodes, G
///           between nodes, modes and values as in ClusterCouplings, with exact constants instead of rounded
///           ones
/// Source    ClusterCouplings. Linear maps in balls; G and the sums over nodes in doubles with running
///           errors. The values at the nodes of a cluster that are off by at most d change y_i by at most d
///           sup_x sum_a |(W^T D)_a(x)|, which is InterpolationBounds::stored: so the midpoints pass on as
///           exact numbers, and the errors beside them
/// Requires  pairs of this tree; tables of its leaves, up to the degrees of the pairs; charts with formulas
///           in balls; what is passed outlives this
/// Result    |exact - value| <= error, proved; the same bits for any number of threads; Interrupted when
///           asked to stop
class EnclosedCouplings {
public:
  EnclosedCouplings(const std::vector<Chart>& charts, const ClusterTree& tree,
                    const std::vector<std::vector<FarPair>>& pairs, const EnclosedTables& tables);

  enum class Density { functions, step_functions };
  [[nodiscard]] std::vector<BoundedDouble> product(Density density, std::span<const double> x) const;
  /// Adds what it holds.
  void count(MemoryPlan& plan) const;

private:
  struct Level {
    std::size_t clusters = 0;
    int degree = -1;  ///< none below zero
  };
  /// The nodes of one degree in one cluster, and the node sets that they couple with.
  struct NodeSet {
    std::size_t level;
    std::uint32_t cluster;
    int degree;
    std::size_t first;  ///< place among the points
    std::vector<std::uint32_t> others = {};
  };
  struct Point {
    Vector<BoundedDouble> at;
    Vector<BoundedDouble> normal;
    Ball weight;
  };
  using Modes = std::vector<std::vector<Ball>>;  ///< by cluster

  void place(NodeSet& set, const Chart& chart, const ParameterTriangle& triangle);
  [[nodiscard]] std::vector<Modes> moments(Density density, std::span<const double> x) const;
  [[nodiscard]] std::vector<BoundedDouble> weights(const std::vector<Modes>& moments) const;
  [[nodiscard]] std::vector<BoundedDouble> couple(const std::vector<BoundedDouble>& weights) const;

  const EnclosedTables& tables_;
  std::vector<Level> levels_;
  std::vector<NodeSet> sets_;
  std::vector<Point> points_;
};

}  // namespace radcert
