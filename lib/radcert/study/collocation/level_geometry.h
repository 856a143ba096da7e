// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "radcert/clusters/cluster_part.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/ranks/ranks.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/quadrature/collocation_point.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A triangulated surface with the collocation nodes on it.
struct NodedSurface {
  Surface surface;
  Triangulation triangulation;
  std::vector<CollocationPoint<double>> nodes;
};

/// The clusters of a level, and the part of them that is computed here.
struct LevelClusters {
  ClusterTree tree;
  ClusterPart part;
  [[nodiscard]] ElementRange elements() const {
    return {part.leaves().begin * tree.elements_of_leaf(), part.leaves().end * tree.elements_of_leaf()};
  }
};

/// The clusters of a level that takes_clusters, else nothing. Those of a graded one are not shared.
/// Requires  a checked problem; ranks outlive what is given
/// Result    InputError where there are more ranks than subtrees
[[nodiscard]] std::optional<LevelClusters> clusters_of_level(const Problem& problem, int level,
                                                             const Ranks& ranks);

/// The geometry of one level: where its data live, and where its collocation integrals are taken.
/// Maths     data: the points v_i at which rho, E and u are taken, and the surface of Ku. integrals: Int
///           G(v~_i,Q) l_j(Q) dS_Q with P, n_P, Q, n_Q and the area element on it. Both have the same
///           elements and nodes in the same order. With exact geometry they are one; else integrals is the
///           interpolant, and data is S or, if so chosen, the interpolant too
/// Source    [ac98, (40), (91)]
/// Requires  a checked problem; a part of the elements only where the level takes_clusters
/// Result    all elements, or those of the part; mesh_size is that of their triangulation of S
class LevelGeometry {
public:
  LevelGeometry(const Problem& problem, int level, const TriangleBasis<double>& basis,
                const std::optional<ElementRange>& part = std::nullopt);

  const NodedSurface& data() const { return data_; }
  const NodedSurface& integrals() const { return interpolant_ ? *interpolant_ : data_; }
  double mesh_size() const { return mesh_size_; }

private:
  NodedSurface data_;
  std::optional<NodedSurface> interpolant_;  ///< absent where data and integrals are one
  double mesh_size_;
};

/// The sizes of a level on all ranks.
struct LevelSizes {
  std::size_t elements = 0;
  std::size_t unknowns = 0;
  double mesh_size = 0;
};

/// The number of a level, its sizes and the memory that was planned: all that is known before it is solved.
[[nodiscard]] LevelResult level_header(const Problem& problem, int level, const LevelSizes& sizes);

}  // namespace radcert
