// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_operator.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/surface/own_surface.h"

namespace radcert {
namespace {

/// The schemes of the near entries, coarser by powers of ten where little of a row is near.
/// Maths     an entry is wanted to the tolerance relative to its row's Int |G|, an integrator gives it
///           relative to the element's. On surfaces that hide nothing Int |G| <= pi, so that no more than
///           pi - Int_far G is left for the near elements of a row: with ten times the tolerance where that
///           is a tenth of pi, the errors of all of them stay within the tolerance of the row
NearEntries::Schemes near_schemes(const ClusterOperator::Setting& setting,
                                  const std::shared_ptr<const IntegrationScheme<double>>& finest,
                                  std::span<const double> far, std::size_t unknowns_of_leaf) {
  constexpr std::size_t most = 3;
  NearEntries::Schemes schemes{.schemes = {finest},
                               .of_leaf = std::vector<std::size_t>(far.size() / unknowns_of_leaf)};
  for (double coarser = 10; schemes.schemes.size() <= most; coarser *= 10) {
    const double tolerance = coarser * setting.integrals.entry();
    if (tolerance > Tolerance::coarsest) break;
    schemes.schemes.push_back(std::make_shared<const IntegrationScheme<double>>(
        setting.surface, setting.basis, Tolerance(tolerance)));
  }
  for (std::size_t leaf = 0; leaf < schemes.of_leaf.size(); ++leaf) {
    const auto rows = far.subspan(leaf * unknowns_of_leaf, unknowns_of_leaf);
    // As far as `far` is known: within the couplings' tolerance.
    const double near = 1 - *std::min_element(rows.begin(), rows.end()) / pi<double>() + setting.far.row();
    std::size_t& which = schemes.of_leaf[leaf];
    for (double share = near * 10; share <= 1 && which + 1 < schemes.schemes.size(); share *= 10) ++which;
  }
  return schemes;
}

}  // namespace

ClusterTolerance::ClusterTolerance(double row) : row_(row) {
  expects(finest <= row && row <= coarsest, "1e-13 <= tolerance <= 1e-3", named("tolerance", row));
}

int ClusterTolerance::largest_degree() const {
  constexpr double degrees_a_digit = 5.0 / 3;
  constexpr int most = 20;
  return std::min(most, static_cast<int>(std::lround(-std::log10(row_) * degrees_a_digit)));
}

double ClusterTolerance::share(std::size_t levels) const {
  constexpr double couplings_a_level = 30;
  return row_ / (couplings_a_level * static_cast<double>(std::max<std::size_t>(levels, 2) - 1));
}

std::optional<std::string> obstacle_to_clusters(const Surface& surface) {
  if (surface.mesh != nullptr) return "a mesh, whose triangles are charts of their own";
  if (!surface.unoccluded) return "parts of the surface hide others";
  if (!is_known_in_balls(surface)) return "its charts are known by their values alone";
  if (!surface.charts_join_smoothly) return "an interpolated surface, on which each element is a chart";
  for (const Chart& chart : surface.charts)
    if (chart.facts().singular != SingularLine::none)
      return "the chart " + chart.facts().name + " is not analytic up to its border";
  return std::nullopt;
}

ClusterOperator::ClusterOperator(const Setting& setting) {
  const std::optional<std::string> obstacle = obstacle_to_clusters(setting.surface);
  expects(!obstacle, "a surface of analytic charts that hides nothing",
          named("surface", setting.surface.name), named("obstacle", obstacle.value_or("")));
  const ClusterTree& tree = setting.tree;
  const ClusterPart& part = setting.part;
  const std::size_t unknowns_of_leaf = tree.elements_of_leaf() * setting.basis.size();
  const std::size_t unknowns = part.leaves().size() * unknowns_of_leaf;
  expects(setting.nodes.size() == unknowns && setting.reflectivity.size() == unknowns,
          "a node and a reflectivity a function and element", named("nodes", setting.nodes.size()),
          named("values", setting.reflectivity.size()));
  const std::size_t subtrees = part.range(part.cut()).size();
  parts_ = VectorParts(part.ranks(), subtrees, unknowns / subtrees);
  const auto scheme =
      std::make_shared<const IntegrationScheme<double>>(setting.surface, setting.basis, setting.integrals);
  const std::vector<Chart>& charts = setting.surface.charts;
  CouplingDemand demand{.share = setting.far.share(tree.levels()),
                        .functions_size = size_of_functions(setting.basis),
                        .largest_degree = setting.far.largest_degree(),
                        .nodes = setting.basis.nodes()};
  ClusterPairs pairs;
  std::vector<double> left_out;
  for (double largest = 0;;) {
    pairs = divide_pairs(charts, tree, part, demand,
                         [&](std::size_t a, std::size_t b) { return scheme->in_plane(a, b); });
    left_out = truncation_of_leaves(part, pairs.far);
    largest = part.ranks().largest(*std::max_element(left_out.begin(), left_out.end()));
    if (largest <= setting.far.row()) break;
    // The sum shrinks with the share, to nothing where all pairs are near.
    constexpr double reserve = 0.8;
    demand.share *= reserve * setting.far.row() / largest;
  }
  couplings_ = std::make_unique<ClusterCouplings>(charts, tree, part, pairs.far, setting.basis);
  near_ = std::make_unique<NearEntries>(part, pairs.near, unknowns_of_leaf);
  memory().require(setting.memory_limit);

  factors_.reserve(unknowns);
  for (const double rho : setting.reflectivity) factors_.push_back(rho / pi<double>());
  std::vector<double> far(unknowns);
  couplings_->multiply(ClusterDensity::one, {}, far);
  NearEntries::RowSums near =
      near_->fill(near_schemes(setting, scheme, far, unknowns_of_leaf), tree, setting.nodes, factors_);
  row_radius_ = std::move(near.radius);
  // Values at nodes, transfers and sums amplify a rounding by less than this: Lebesgue constants up to 66,
  // and G from rounded points.
  constexpr double amplification = 256;
  rounding_ = amplification * unit_roundoff<double>() * demand.functions_size;
  kernel_integral_ = std::move(near.kernel_integral);
  for (std::size_t i = 0; i < unknowns; ++i) {
    kernel_integral_[i] += far[i];
    row_radius_[i] += setting.reflectivity[i] * (left_out[i / unknowns_of_leaf] + rounding_);
  }
}

void ClusterOperator::far_product(ClusterDensity density, std::span<const double> x,
                                  std::span<double> y) const {
  couplings_->multiply(density, x, y);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] *= factors_[i];
}

void ClusterOperator::multiply(std::span<const double> x, std::span<double> y) const {
  far_product(ClusterDensity::functions, x, y);
  near_->add_product(x, y);
}

void ClusterOperator::multiply_sizes(std::span<const double> x, std::span<double> y) const {
  far_product(ClusterDensity::absolute_functions, x, y);
  // The moments of |l_j| come from a rule on small parts of an element.
  constexpr double upward = 1 + 0x1p-8;
  for (double& each : y) each *= upward;
  near_->add_sizes(x, y);
}

void ClusterOperator::multiply_accurately(std::span<const double> x, std::span<double> y) const {
  far_product(ClusterDensity::functions, x, y);
  near_->add_accurately(x, y);
}

MemoryPlan ClusterOperator::memory() const {
  MemoryPlan plan;
  near_->count(plan);
  couplings_->count(plan);
  return plan;
}

}  // namespace radcert
