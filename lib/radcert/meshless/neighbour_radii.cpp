// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/geometry/neighbour_tree.h"
#include "radcert/meshless/radial_basis.h"

namespace radcert {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The order of the tree is right up to a factor 1 +- 2^-40.
constexpr double order_slack = 1 - 0x1p-30;

/// The m-th smallest distance from site i, or infinity, or the largest finite one.
double neighbour_distance(const NeighbourTree& tree, const SiteSet& sites, SiteDistance distance,
                          std::size_t m, TooFewNeighbours too_few, std::size_t i) {
  std::priority_queue<double> nearest;  // the m smallest so far, the largest of them on top
  tree.visit_by_distance(sites.points[i], [&](std::size_t j, double squared) {
    if (nearest.size() == m && squared * order_slack > nearest.top() * nearest.top()) return false;
    if (j == i) return true;
    double here = norm(sites.points[i] - sites.points[j]);
    if (distance == SiteDistance::normal_sensitive) {
      const double cosine = dot(sites.normals[i], sites.normals[j]);
      here = cosine > 0 ? here / cosine : infinite;
    }
    if (here < infinite) nearest.push(here);
    if (nearest.size() > m) nearest.pop();
    return true;
  });
  const std::size_t enough = too_few == TooFewNeighbours::farthest ? 1 : m;
  return nearest.size() < enough ? infinite : nearest.top();
}

}  // namespace

Outcome<std::vector<double>> neighbour_radii(const SiteSet& sites, SiteDistance distance, std::size_t m,
                                             TooFewNeighbours too_few) {
  if (m == 0) return because("the neighbour that gives the radius must be at least 1");
  if (sites.size() < m + 1)
    return because("a radius by neighbour " + std::to_string(m) + " needs at least " + std::to_string(m + 1) +
                   " sites; there are " + std::to_string(sites.size()));
  const NeighbourTree tree(sites.points);
  std::vector<double> radii(sites.size());
  parallel_for(sites.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      radii[i] = neighbour_distance(tree, sites, distance, m, too_few, i);
  });
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (radii[i] == infinite)
      return because("site " + std::to_string(i) +
                     (too_few == TooFewNeighbours::farthest
                          ? " has no other"
                          : " has fewer than " + std::to_string(m) + " others") +
                     " at a finite distance: too few have a normal within 90 degrees of its own");
    if (!(radii[i] > 0))
      return because("site " + std::to_string(i) + " has " + std::to_string(m) +
                     " others at the same place: its radius would be 0");
  }
  return radii;
}

}  // namespace radcert
