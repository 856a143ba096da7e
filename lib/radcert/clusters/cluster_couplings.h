// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_pairs.h"
#include "radcert/clusters/cluster_part.h"
#include "radcert/clusters/cluster_points.h"
#include "radcert/clusters/cluster_transfers.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/memory_plan.h"

namespace radcert {

/// What the numbers of a vector stand for where far clusters see them.
enum class ClusterDensity {
  functions,           ///< sum_j x_j l_j
  absolute_functions,  ///< sum_j x_j |l_j|
  one,                 ///< 1, whatever the numbers
};

/// The part of the collocation operator between clusters that couple by polynomials.
/// Maths     y_i = sum over the far pairs (a, b), v_i in a, of Int_b I_p G(v_i, Q) f(Q) dS_Q, I_p the
///           interpolation of degree p at the nodes of both clusters.  Upwards: moments M_n = mean of f D_n,
///           of the leaves from the numbers, of parents from their children; to weights of the nodes, V^-T M
///           times the area element.  Couplings: G between the nodes of a and b, evaluated in every product,
///           once for both directions.  Downwards: modes V^-1 of the values at the nodes, from parents to
///           children, and at the leaves to the collocation nodes.  Ranks: moments at the cut of the parts
///           are gathered, and all ranks go on upwards from there; those of other ranks' clusters below the
///           cut are brought as far as couplings ask for them. A coupling of clusters of two ranks is
///           evaluated by both, each for its own
/// Source    ours: an H2 matrix (Hackbusch, Khoromskij, Sauter, 2000) on the triangles of a triangulation;
///           where it is uniform transfer matrices are constants, because the area element stays with G
/// Requires  pairs of this tree that concern the part; leaves of the basis's unknowns; called by all ranks
///           together
/// Result    the same bits for any number of ranks and threads: what a coupling gives is added in the order
///           of the list, and everything else is added by one task
/// Limits    rounded; its truncation is that of CouplingDegree
class ClusterCouplings {
public:
  ClusterCouplings(const std::vector<Chart>& charts, const ClusterTree& tree, const ClusterPart& part,
                   const std::vector<std::vector<FarPair>>& pairs, const TriangleBasis<double>& basis);

  /// Requires as many entries of x and y as there are unknowns here, none shared; ClusterDensity::one takes
  ///          no x.
  void multiply(ClusterDensity density, std::span<const double> x, std::span<double> y) const;

  /// The number of evaluations of G in a product with a vector that vanishes on no cluster.
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  /// Adds what it holds, and what a product takes.
  void count(MemoryPlan& plan) const;
  /// The bytes that this rank sends for a product: to others their clusters' moments, and at the cut.
  [[nodiscard]] std::uint64_t bytes_sent() const;

private:
  /// The moments or modes of the clusters of one level, up to a degree: of those of the part, and of all that
  /// are not below the cut.
  struct Level {
    ClusterRange held;
    int degree = -1;  ///< none below zero
    std::size_t stride = 0;
    std::size_t first = 0;  ///< place of the first cluster's modes
    [[nodiscard]] std::size_t place(std::size_t cluster) const {
      return first + (cluster - held.begin) * stride;
    }
  };
  /// The interpolation nodes of one degree in one cluster.
  struct NodeSet {
    std::uint32_t cluster;
    bool is_held;         ///< whether the cluster's moments are among those held, or brought
    bool is_here;         ///< whether values at the nodes are wanted: clusters of the part
    std::size_t first;    ///< place among the points
    std::size_t moments;  ///< place of the cluster's moments
  };
  /// The node sets of one level and degree follow each other.
  struct NodeGroup {
    std::size_t level;
    int degree;
    std::size_t begin;
    std::size_t end;
  };
  struct Coupling {
    std::uint32_t a;  ///< node sets
    std::uint32_t b;
    std::uint32_t slot;  ///< in the batch: first the values at a, then those at b
    std::uint32_t nodes;
  };
  /// Couplings whose values are held before they are added.
  struct Batch {
    std::size_t begin;
    std::size_t end;
    std::size_t slots;
    std::size_t first_target;
    std::size_t last_target;
  };
  /// A node set and the slots that are added to it, in the order of the couplings.
  struct Target {
    std::uint32_t set;
    std::uint32_t nodes;
    std::size_t first_slot;
    std::size_t last_slot;
  };

  static std::vector<int> degrees_of(const std::vector<Level>& levels);
  static std::vector<Level> placed_levels(const ClusterPart& part, const std::vector<int>& degrees);
  void place_node_sets(const std::vector<Chart>& charts, const ClusterTree& tree,
                       const std::vector<std::vector<FarPair>>& pairs);
  void list_foreign_moments();
  void list_batches();
  void close_batch(std::size_t end, std::size_t slots);
  void moments_of_leaves(ClusterDensity density, std::span<const double> x, std::span<double> moments) const;
  void moments_of_parents(std::span<double> moments) const;
  void moments_of_level(std::size_t level, std::span<double> moments) const;
  void gather_at_cut(std::span<double> moments) const;
  void weights_of_nodes(std::span<const double> moments, std::span<const double> brought,
                        std::span<double> weights) const;
  void couple(std::span<const double> weights, std::span<double> values) const;
  void modes_of_values(std::span<const double> values, std::span<double> modes) const;
  void modes_of_children(std::span<double> modes) const;
  void values_at_leaves(std::span<const double> modes, std::span<double> y) const;
  template <bool at_a, bool at_b>
  void evaluate(const Coupling& coupling, std::span<const double> weights, double* values,
                std::vector<double>& scratch) const;

  ClusterPart part_;
  std::vector<Level> levels_;
  std::size_t modes_;
  std::size_t brought_ = 0;                   ///< moments of other ranks' clusters
  std::unique_ptr<const Exchange> exchange_;  ///< of these
  ClusterTransfers transfers_;
  std::size_t unknowns_;  ///< of a leaf
  ClusterPoints points_;
  std::vector<NodeSet> sets_;
  std::vector<NodeGroup> groups_;
  std::vector<Coupling> couplings_;
  std::vector<Batch> batches_;
  std::vector<Target> targets_;
  std::vector<std::uint32_t> slots_;
  std::size_t evaluations_ = 0;
};

}  // namespace radcert
