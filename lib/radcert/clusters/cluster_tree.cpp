// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_tree.h"

#include <algorithm>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

bool same(const ParameterPoint<double>& a, const ParameterPoint<double>& b) {
  return a.s == b.s && a.t == b.t;
}

/// Whether the parent of four triangles has been divided into them by the midpoints of its sides.
bool are_children(const ParameterTriangle& parent, const ParameterTriangle* child) {
  const auto& [v1, v2, v3] = parent.vertices;
  const ParameterPoint<double> m12 = 0.5 * (v1 + v2);
  const ParameterPoint<double> m23 = 0.5 * (v2 + v3);
  const ParameterPoint<double> m31 = 0.5 * (v3 + v1);
  const std::array<std::array<ParameterPoint<double>, 3>, 4> expected{
      {{v1, m12, m31}, {m12, v2, m23}, {m31, m23, v3}, {m23, m31, m12}}};
  for (std::size_t c = 0; c < 4; ++c) {
    if (child[c].chart != parent.chart) return false;
    for (std::size_t i = 0; i < 3; ++i)
      if (!same(child[c].vertices[i], expected[c][i])) return false;
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

int leaf_refinements(std::size_t functions) {
  expects(functions >= 1 && functions <= 45, "1 to 45 functions", named("functions", functions));
  constexpr std::size_t most_unknowns = 180;
  int refinements = 0;
  for (std::size_t unknowns = functions; 4 * unknowns <= most_unknowns; unknowns *= 4) ++refinements;
  return refinements;
}

}  // namespace radcert
