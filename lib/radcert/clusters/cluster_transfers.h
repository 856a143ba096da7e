// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/clusters/cluster_tree.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/matrix.h"
#include "radcert/core/memory_plan.h"
#include "radcert/polynomial/triangle_basis.h"

namespace radcert {

/// The polynomials of one triangle in those of another.
/// Maths     down(m, n): D_n(x) = sum_m down(m, n) D_m(y) up to the degree, x the coordinates of a point in
///           `from`, y those in `to`; up(n, m) = share down(m, n), share the area of `to` over that of
///           `from`: the mean over `from` of f D_n is sum_m up(n, m) times the mean over `to` of f D_m where
///           f vanishes outside of both
/// Source    interpolation at the nodes of `to`, exact for polynomials of the degree
/// Requires  triangles in one parameter plane, 0 <= degree <= largest_mode_degree
/// Result    rows padded by zeros to whole packs; rounded. Where `to` reaches out of `from`, D_n and column n
///           of down grow; so much less of it is in a function that is smooth about both
struct ModeTransfer {
  ModeTransfer(const ParameterTriangle& from, const ParameterTriangle& to, int degree);
  Matrix<double> up;
  Matrix<double> down;
};

/// What takes the modes of clusters to those of their children, and those of leaves to the unknowns.
/// Maths     ModeTransfer from each cluster to its children; LeafTables of each leaf
/// Result    of a uniform tree constants of all clusters, ModeTables; of a graded one matrices of each
class ClusterTransfers {
public:
  /// Up to the largest degree of each level, -1: none.
  ClusterTransfers(const ClusterTree& tree, const TriangleBasis<double>& basis, std::span<const int> degrees);

  /// Whether the matrices are those of all clusters.
  [[nodiscard]] bool is_uniform() const { return is_uniform_; }
  /// From the modes of a cluster of a level to those of its parent, and back; from moments without the factor
  /// share_of_area.
  [[nodiscard]] const Matrix<double>& up(std::size_t level, std::size_t cluster) const {
    return is_uniform_ ? ModeTables::instance().to_parent(cluster % 4) : transfers_[level][cluster].up;
  }
  [[nodiscard]] const Matrix<double>& down(std::size_t level, std::size_t cluster) const {
    return is_uniform_ ? ModeTables::instance().to_child(cluster % 4) : transfers_[level][cluster].down;
  }
  [[nodiscard]] double share_of_area() const { return is_uniform_ ? 0.25 : 1; }
  [[nodiscard]] const LeafTables& leaf(std::size_t leaf) const { return leaves_[is_uniform_ ? 0 : leaf]; }
  void count(MemoryPlan& plan) const;

private:
  bool is_uniform_;
  std::vector<std::vector<ModeTransfer>> transfers_;  ///< by level, cluster
  std::vector<LeafTables> leaves_;
};

}  // namespace radcert
