// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// The clusters of a triangulation: of a uniform one the triangles of the coarser ones.
/// Maths     cluster i of level l is triangle i of level l; its children are the clusters 4i, ..., 4i+3 of
///           level l+1, its elements those from i 4^(L-l) on, L the level of the triangulation.  Leaves are
///           the clusters of level L - refinements.  Graded: coordinates of the unit square were moved alike,
///           s -> g(s) and t -> g(t), g monotone, so that two sides of a triangle, along the axes, are still
///           made of its elements' sides, and the third is not. The cluster is the least triangle with sides
///           parallel to those of triangle i in which its elements lie
/// Source    ours; the order of Triangulation makes a cluster's elements follow each other
/// Result    the triangles of each level, exact as the elements are; of a graded one rounded, and a cluster
///           need not lie in that of its parent
class ClusterTree {
public:
  /// Refused in words where the triangles are not those of symmetric refinement: a graded triangulation, or a
  /// count that 4^level does not divide. Requires 0 <= refinements, 0 <= level, else ContractViolation;
  /// leaves are whole trees where `level` is below `refinements`.
  static Outcome<ClusterTree> make(const Triangulation& triangulation, int level, int refinements);
  /// Those of a graded triangulation. Refused in words where the triangles are none of that kind: right ones
  /// along the axes, four of them about the vertices of each coarser one.
  static Outcome<ClusterTree> graded(const Triangulation& triangulation, int level, int refinements);
  /// From the triangulation whose triangles are the leaves, of that level; each leaf has 4^refinements
  /// elements.
  static Outcome<ClusterTree> above(const Triangulation& leaves, int level, int refinements);

  /// Whether clusters are triangles of coarser triangulations.
  [[nodiscard]] bool is_uniform() const { return elements_.empty(); }
  /// The number of levels of clusters, leaves included.
  [[nodiscard]] std::size_t levels() const { return clusters_.size(); }
  [[nodiscard]] const std::vector<ParameterTriangle>& level(std::size_t l) const { return clusters_[l]; }
  [[nodiscard]] const std::vector<ParameterTriangle>& leaves() const { return clusters_.back(); }
  /// The number of symmetric refinements from a leaf to its elements.
  [[nodiscard]] int refinements() const { return refinements_; }
  [[nodiscard]] std::size_t elements_of_leaf() const { return std::size_t{1} << 2 * refinements_; }
  /// An element of the triangulation.
  [[nodiscard]] ParameterTriangle element(std::size_t number) const;

private:
  std::vector<std::vector<ParameterTriangle>> clusters_;
  std::vector<ParameterTriangle> elements_;  ///< of a graded triangulation
  int refinements_ = 0;
};

/// The number of symmetric refinements from a leaf to its elements, of `functions` unknowns each: the largest
/// with at most 180 unknowns a leaf.
/// Requires  1 <= functions <= 66
[[nodiscard]] int leaf_refinements(std::size_t functions);

}  // namespace radcert
