// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_tree.h"

#include <algorithm>
#include <optional>

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

/// A triangle with a right angle along the axes of the parameter plane, and points about it.
class RightTriangle {
public:
  static std::optional<RightTriangle> of(const ParameterTriangle& triangle) {
    for (std::size_t r = 0; r < 3; ++r) {
      const ParameterPoint<double>& corner = triangle.vertices[r];
      const ParameterPoint<double> a = triangle.vertices[(r + 1) % 3] - corner;
      const ParameterPoint<double> b = triangle.vertices[(r + 2) % 3] - corner;
      if ((a.t == 0 && b.s == 0) || (a.s == 0 && b.t == 0)) return RightTriangle(corner, a, b, r);
    }
    return std::nullopt;
  }
  void take_in(const ParameterPoint<double>& point) {
    const ParameterPoint<double> d = point - corner_;
    const double area = cross(a_, b_);
    const double along_a = cross(d, b_) / area;
    const double along_b = cross(a_, d) / area;
    least_a_ = std::min(least_a_, along_a);
    least_b_ = std::min(least_b_, along_b);
    largest_sum_ = std::max(largest_sum_, along_a + along_b);
  }
  /// The least one parallel to it with all points that were taken in.
  [[nodiscard]] ParameterTriangle around(std::size_t chart) const {
    const double scale = largest_sum_ - least_a_ - least_b_;
    const ParameterPoint<double> corner = corner_ + least_a_ * a_ + least_b_ * b_;
    ParameterTriangle out{.chart = chart, .vertices = {}};
    out.vertices[number_] = corner;
    out.vertices[(number_ + 1) % 3] = corner + scale * a_;
    out.vertices[(number_ + 2) % 3] = corner + scale * b_;
    return out;
  }

private:
  RightTriangle(const ParameterPoint<double>& corner, const ParameterPoint<double>& a,
                const ParameterPoint<double>& b, std::size_t number)
      : corner_(corner), a_(a), b_(b), number_(number) {}
  ParameterPoint<double> corner_;
  ParameterPoint<double> a_;
  ParameterPoint<double> b_;
  std::size_t number_;  ///< of the right angle's vertex
  double least_a_ = 0;
  double least_b_ = 0;
  double largest_sum_ = 1;
};

/// The triangles of the next coarser level, by their vertices.
std::vector<ParameterTriangle> parents_of(const std::vector<ParameterTriangle>& children) {
  std::vector<ParameterTriangle> parents(children.size() / 4);
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const ParameterTriangle* child = &children[4 * i];
    parents[i] = {child->chart, {child[0].vertices[0], child[1].vertices[1], child[2].vertices[2]}};
  }
  return parents;
}

}  // namespace

Outcome<ClusterTree> ClusterTree::graded(const Triangulation& triangulation, int level, int refinements) {
  expects(level >= 0 && refinements >= 0, "levels >= 0", named("level", level),
          named("refinements", refinements));
  constexpr const char* refused = "triangles that no graded refinement made";
  ClusterTree tree;
  tree.refinements_ = std::min(level, refinements);
  tree.elements_ = triangulation.triangles;
  std::vector<ParameterTriangle> now = triangulation.triangles;
  for (int l = level;; --l) {
    std::vector<ParameterTriangle> clusters;
    const std::size_t elements = tree.elements_.size() / now.size();
    for (std::size_t i = 0; i < now.size(); ++i) {
      std::optional<RightTriangle> around = RightTriangle::of(now[i]);
      if (!around) return because(refused);
      for (std::size_t k = i * elements; k < (i + 1) * elements; ++k) {
        if (tree.elements_[k].chart != now[i].chart) return because(refused);
        for (const ParameterPoint<double>& vertex : tree.elements_[k].vertices) around->take_in(vertex);
      }
      clusters.push_back(around->around(now[i].chart));
    }
    if (l <= level - tree.refinements_) tree.clusters_.push_back(std::move(clusters));
    if (l == 0) break;
    if (now.size() % 4 != 0) return because(refused);
    now = parents_of(now);
  }
  std::reverse(tree.clusters_.begin(), tree.clusters_.end());
  return tree;
}

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
    std::vector<ParameterTriangle> parents = parents_of(now);
    for (std::size_t i = 0; i < parents.size(); ++i)
      if (!are_children(parents[i], &now[4 * i]))
        return because("triangles that no symmetric refinement made");
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
  if (!is_uniform()) return elements_[number];
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
