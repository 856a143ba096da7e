// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_tree.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/polynomial/basis_limits.h"

namespace radcert {
namespace {

bool same(const ParameterPoint<double>& a, const ParameterPoint<double>& b) {
  return a.s == b.s && a.t == b.t;
}

/// Whether the parent of four triangles has been divided into them by the midpoints of its sides.
bool are_children(const ParameterTriangle& parent, const ParameterTriangle* child) {
  for (std::size_t c = 0; c < 4; ++c) {
    if (child[c].chart != parent.chart) return false;
    const ParameterTriangle expected = child_of(parent, c);
    for (std::size_t i = 0; i < 3; ++i)
      if (!same(child[c].vertices[i], expected.vertices[i])) return false;
  }
  return true;
}

}  // namespace

Outcome<ClusterTree> ClusterTree::make(const Triangulation& triangulation, int level, int refinements) {
  expects(level >= 0 && refinements >= 0, "levels >= 0", named("level", level),
          named("refinements", refinements));
  ClusterTree tree;
  tree.refinements_ = std::min(level, refinements);
  std::vector<ParameterTriangle> now = triangulation.triangles;
  for (int l = level;; --l) {
    if (l <= level - tree.refinements_) tree.clusters_.push_back(now);
    if (l == 0) break;
    if (now.size() % 4 != 0) return because("triangles that no symmetric refinement made");
    std::vector<ParameterTriangle> parents(now.size() / 4);
    for (std::size_t i = 0; i < parents.size(); ++i) {
      const ParameterTriangle* child = &now[4 * i];
      parents[i] = {child->chart, {child[0].vertices[0], child[1].vertices[1], child[2].vertices[2]}};
      if (!are_children(parents[i], child)) return because("triangles that no symmetric refinement made");
    }
    now = std::move(parents);
  }
  std::reverse(tree.clusters_.begin(), tree.clusters_.end());
  return tree;
}

Outcome<ClusterTree> ClusterTree::above(const Triangulation& leaves, int level, int refinements) {
  expects(refinements >= 0, "refinements >= 0", named("refinements", refinements));
  Outcome<ClusterTree> tree = make(leaves, level, 0);
  if (tree) tree->refinements_ = refinements;
  return tree;
}

ParameterTriangle ClusterTree::element(std::size_t number) const {
  return descendant_of(leaves()[number / elements_of_leaf()], refinements_, number % elements_of_leaf());
}

int leaf_refinements(std::size_t functions) {
  expects(functions >= 1 && functions <= most_basis_functions, "1 to 66 functions",
          named("functions", functions));
  constexpr std::size_t most_unknowns = 180;
  int refinements = 0;
  for (std::size_t unknowns = functions; 4 * unknowns <= most_unknowns; unknowns *= 4) ++refinements;
  return refinements;
}

}  // namespace radcert
