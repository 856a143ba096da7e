// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_clusters.h"

#include <algorithm>
#include <cmath>

#include "radcert/clusters/certified/certified_coupling.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/core/contract.h"
#include "radcert/core/memory_plan.h"

namespace radcert {
namespace {

/// More than the roundings of the few operations that follow a bound.
constexpr double up = 1 + 0x1p-40;

/// What the decisions on one level need.
struct SeenLevel {
  SeenLevel(const std::vector<Chart>& charts, const ClusterTree& tree, const CouplingDemand& demand,
            std::size_t level)
      : certified(charts, tree.level(level)),
        estimated(charts, tree.level(level)),
        sizes(sizes_at_nodes(demand, tree, level)) {}
  CertifiedOutlines certified;
  ClusterOutlines estimated;
  ModeSizes sizes;
};

ClusterPairs certified_pairs(const Surface& surface, const ClusterTree& tree, const CouplingDemand& demand) {
  return divide_pairs(
      tree, ClusterPart(tree),
      [&](std::size_t l, std::span<const NearPair>) -> LevelDecisions {
        const auto seen = std::make_shared<const SeenLevel>(surface.charts, tree, demand, l);
        return [seen, &demand] {
          const auto look =
              std::make_shared<CertifiedLook>(seen->certified, seen->estimated, demand, seen->sizes);
          return [look, seen](std::size_t a, std::size_t b) { return (*look)(a, b); };
        };
      },
      [&surface](std::size_t a, std::size_t b) {
        return a == b ? surface.charts[a].facts().flat_in().has_value()
                      : in_one_plane(surface.charts[a], surface.charts[b]);
      });
}

int largest_degree(const ClusterPairs& pairs) {
  int degree = 0;
  for (const std::vector<FarPair>& level : pairs.far)
    for (const FarPair& pair : level) degree = std::max(degree, pair.coupling.degree);
  return degree;
}

/// A number that the exact value does not exceed.
double largest_of(const BoundedDouble& x) { return (x.value() + x.error()) * up; }

double largest_size(std::span<const double> x) {
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

/// On curved charts entries take so much longer than couplings that leaves are a level smaller.
int refinements_of_leaves(const EnclosedClusters::Setting& setting) {
  const int refinements = leaf_refinements(setting.functions.size());
  const std::vector<Chart>& charts = setting.surface.charts;
  const bool is_plane = std::all_of(charts.begin(), charts.end(),
                                    [](const Chart& chart) { return chart.facts().plane.has_value(); });
  return is_plane ? refinements : std::max(0, refinements - 1);
}

}  // namespace

Outcome<EnclosedClusters> enclosed_clusters(const EnclosedClusters::Setting& setting) {
  const std::optional<std::string> obstacle = obstacle_to_clusters(setting.surface);
  expects(!obstacle, "a surface of analytic charts in balls that hides nothing",
          named("surface", setting.surface.name), named("obstacle", obstacle.value_or("")));
  const int refinements = setting.refinements.value_or(refinements_of_leaves(setting));
  const ClusterTree tree = ClusterTree::make(setting.triangulation, setting.level, refinements).value();
  const StepFunctions steps(setting.functions);
  CouplingDemand demand{.share = setting.far.share(tree.levels()),
                        .functions_size = steps.size,
                        .largest_degree = setting.far.largest_degree(),
                        .nodes = make_triangle_basis<double>(setting.functions).nodes()};
  EnclosedClusters result;
  ClusterPairs pairs;
  std::vector<double> of_leaves;
  for (;;) {
    pairs = certified_pairs(setting.surface, tree, demand);
    of_leaves = truncation_of_leaves(ClusterPart(tree), pairs.far);
    const double largest = *std::max_element(of_leaves.begin(), of_leaves.end());
    if (largest <= setting.far.row()) break;
    constexpr double reserve = 0.8;
    demand.share *= reserve * setting.far.row() / largest;
  }
  const std::size_t unknowns = setting.triangulation.triangles.size() * setting.functions.size();
  const std::size_t of_leaf = unknowns / tree.leaves().size();
  for (std::size_t i = 0; i < unknowns; ++i) result.truncation_.push_back(of_leaves[i / of_leaf] * up);
  for (const std::vector<FarPair>& level : pairs.far) result.far_pairs_ += level.size();

  Outcome<EnclosedNearEntries> near =
      enclosed_near_entries(setting.surface, setting.triangulation, setting.functions, pairs.near, of_leaf,
                            setting.near.entry(), setting.memory_limit);
  if (!near) return because(near.reason());
  result.near_ = std::make_unique<const EnclosedNearEntries>(std::move(near).value());
  result.tables_ = std::make_unique<const EnclosedTables>(setting.functions, steps, tree.refinements(),
                                                          largest_degree(pairs));
  result.couplings_ =
      std::make_unique<const EnclosedCouplings>(setting.surface.charts, tree, pairs.far, *result.tables_);
  return result;
}

std::vector<BoundedDouble> EnclosedClusters::product(std::span<const double> x) const {
  std::vector<BoundedDouble> y = couplings_->product(EnclosedCouplings::Density::functions, x);
  const BoundedDouble inverse_pi = BoundedDouble(1) / Constants<BoundedDouble>::pi();
  const double size = largest_size(x);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const BoundedDouble far = y[i] * inverse_pi;
    y[i] = {far.value(), (far.error() + truncation_[i] * size) * up};
  }
  near_->add(EnclosedNearEntries::Part::entries, x, y);
  return y;
}

std::vector<double> EnclosedClusters::sizes(std::span<const double> x) const {
  expects(std::all_of(x.begin(), x.end(), [](double value) { return value >= 0; }),
          "numbers that are not negative");
  std::vector<BoundedDouble> y = couplings_->product(EnclosedCouplings::Density::step_functions, x);
  const BoundedDouble inverse_pi = BoundedDouble(1) / Constants<BoundedDouble>::pi();
  const double size = largest_size(x);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const BoundedDouble far = y[i] * inverse_pi;
    y[i] = {far.value(), (far.error() + truncation_[i] * size) * up};
  }
  near_->add(EnclosedNearEntries::Part::sizes, x, y);
  std::vector<double> result;
  for (const BoundedDouble& value : y) result.push_back(largest_of(value));
  return result;
}

}  // namespace radcert
