// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/neighbour_tree.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Item = std::pair<Kernel::Point_3, std::size_t>;
using Traits =
    CGAL::Search_traits_adapter<Item, CGAL::First_of_pair_property_map<Item>, CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_incremental_neighbor_search<Traits>;

std::vector<Item> items(std::span<const Vector<double>> points) {
  std::vector<Item> all;
  all.reserve(points.size());
  for (const Vector<double>& p : points) {
    expects(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite coordinates",
            named("point", all.size()));
    all.emplace_back(Kernel::Point_3(p.x, p.y, p.z), all.size());
  }
  return all;
}

}  // namespace

struct NeighbourTree::Tree {
  // Built at once: the first query would build it otherwise, in one thread of several. CGAL builds none of no
  // points.
  explicit Tree(const std::vector<Item>& all) : search(all.begin(), all.end()) {
    if (!all.empty()) search.build();
  }
  Search::Tree search;
};

NeighbourTree::NeighbourTree(std::span<const Vector<double>> points)
    : tree_(std::make_unique<const Tree>(items(points))) {}
NeighbourTree::~NeighbourTree() = default;
NeighbourTree::NeighbourTree(NeighbourTree&&) noexcept = default;
NeighbourTree& NeighbourTree::operator=(NeighbourTree&&) noexcept = default;

std::size_t NeighbourTree::size() const { return tree_->search.size(); }

void NeighbourTree::visit_by_distance(const Vector<double>& from, const Visit& visit) const {
  if (size() == 0) return;
  const Search search(tree_->search, Kernel::Point_3(from.x, from.y, from.z));
  for (auto found = search.begin(); found != search.end(); ++found)
    if (!visit(found->first.second, found->second)) return;
}

}  // namespace radcert
