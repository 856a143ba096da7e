// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_couplings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "radcert/clusters/certified/enclosed_nodes.h"
#include "radcert/clusters/certified/interpolation_bounds.h"
#include "radcert/clusters/mode_tables.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/quadrature/certified/bounded_chart.h"
#include "radcert/scalar/ball_precision.h"

namespace radcert {
namespace {

constexpr double up = 1 + 0x1p-40;
constexpr std::size_t clusters_at_a_time = 4;

Vector<BoundedDouble> bounded(const Vector<Ball>& v) {
  return {radcert::bounded(v.x), radcert::bounded(v.y), radcert::bounded(v.z)};
}

}  // namespace

EnclosedCouplings::EnclosedCouplings(const std::vector<Chart>& charts, const ClusterTree& tree,
                                     const std::vector<std::vector<FarPair>>& pairs,
                                     const EnclosedTables& tables)
    : tables_(tables), levels_(tree.levels()) {
  expects(pairs.size() == tree.levels(), "pairs of each level of the tree", named("levels", pairs.size()));
  std::size_t points = 0;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    levels_[l].clusters = tree.level(l).size();
    if (l > 0) levels_[l].degree = levels_[l - 1].degree;
    std::map<std::pair<int, std::uint32_t>, std::uint32_t> found;
    for (const FarPair& pair : pairs[l]) {
      levels_[l].degree = std::max(levels_[l].degree, pair.coupling.degree);
      for (const std::uint32_t cluster : {pair.a, pair.b}) found[{pair.coupling.degree, cluster}] = 0;
    }
    for (auto& [key, place] : found) {
      place = static_cast<std::uint32_t>(sets_.size());
      sets_.push_back({.level = l, .cluster = key.second, .degree = key.first, .first = points});
      points += mode_count(key.first);
    }
    for (const FarPair& pair : pairs[l]) {
      const std::uint32_t a = found[{pair.coupling.degree, pair.a}];
      const std::uint32_t b = found[{pair.coupling.degree, pair.b}];
      sets_[a].others.push_back(b);
      sets_[b].others.push_back(a);
    }
  }
  points_.resize(points);
  const long bits = BallPrecision::current();
  parallel_for(sets_.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t i = begin; i < end; ++i) {
      const ParameterTriangle& triangle = tree.level(sets_[i].level)[sets_[i].cluster];
      place(sets_[i], charts[triangle.chart], triangle);
    }
  });
}

void EnclosedCouplings::place(NodeSet& set, const Chart& chart, const ParameterTriangle& triangle) {
  std::size_t at = set.first;
  for (const EnclosedNode& node : enclosed_nodes(chart, triangle, set.degree))
    points_[at++] = {
        .at = bounded(node.frame.point), .normal = bounded(unit_normal(node.frame)), .weight = node.weight};
}

std::vector<EnclosedCouplings::Modes> EnclosedCouplings::moments(Density density,
                                                                 std::span<const double> x) const {
  const Matrix<Ball>& table = density == Density::functions ? tables_.moments : tables_.sizes;
  std::vector<Modes> all(levels_.size());
  const long bits = BallPrecision::current();
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const Level& level = levels_[l];
    if (level.degree < 0) break;
    const std::size_t k = mode_count(level.degree);
    all[l].assign(level.clusters, std::vector<Ball>(k));
    parallel_for(level.clusters, clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
      const BallPrecision inside(bits);
      for (std::size_t i = begin; i < end; ++i) {
        std::vector<Ball>& to = all[l][i];
        if (l + 1 == levels_.size()) {
          for (std::size_t j = 0; j < tables_.unknowns; ++j) {
            const Ball value(x[i * tables_.unknowns + j]);
            for (std::size_t n = 0; n < k; ++n) to[n] += table(n, j) * value;
          }
          continue;
        }
        for (std::size_t c = 0; c < 4; ++c) {
          const std::vector<Ball>& of_child = all[l + 1][4 * i + c];
          const Matrix<Ball>& t = tables_.transfer[c];
          for (std::size_t m = 0; m < k; ++m)
            for (std::size_t n = 0; n < k; ++n)
              if (!certainly_zero(t(n, m))) to[n] += t(n, m) * of_child[m];
        }
        for (Ball& moment : to) moment = moment / Ball(4);
      }
    });
  }
  return all;
}

std::vector<BoundedDouble> EnclosedCouplings::weights(const std::vector<Modes>& moments) const {
  std::vector<BoundedDouble> found(points_.size());
  const long bits = BallPrecision::current();
  parallel_for(sets_.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t i = begin; i < end; ++i) {
      const NodeSet& set = sets_[i];
      const Matrix<double>& w = ModeTables::instance().interpolation(set.degree).modes_of_values;
      const std::vector<Ball>& m = moments[set.level][set.cluster];
      const std::size_t k = mode_count(set.degree);
      for (std::size_t a = 0; a < k; ++a) {
        Ball sum = 0;
        for (std::size_t n = 0; n < k; ++n) sum += Ball(w(n, a)) * m[n];
        found[set.first + a] = radcert::bounded(sum * points_[set.first + a].weight);
      }
    }
  });
  return found;
}

std::vector<BoundedDouble> EnclosedCouplings::couple(const std::vector<BoundedDouble>& weights) const {
  std::vector<BoundedDouble> values(points_.size());
  parallel_for(sets_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const NodeSet& set = sets_[i];
      const std::size_t k = mode_count(set.degree);
      for (std::size_t a = 0; a < k; ++a) {
        const Point& p = points_[set.first + a];
        const Vector<BoundedDouble> minus_normal = -p.normal;
        BoundedDouble sum = 0;
        for (const std::uint32_t other : set.others) {
          const std::size_t from = sets_[other].first;
          for (std::size_t b = from; b < from + k; ++b)
            sum = sum +
                  kernel_terms<BoundedDouble>(p.at - points_[b].at, minus_normal, points_[b].normal).value() *
                      weights[b];
        }
        values[set.first + a] = sum;
      }
    }
  });
  return values;
}

std::vector<BoundedDouble> EnclosedCouplings::product(Density density, std::span<const double> x) const {
  const std::size_t leaves = levels_.back().clusters;
  expects(x.size() == leaves * tables_.unknowns, "a number for each unknown", named("size", x.size()));
  std::vector<BoundedDouble> y(x.size());
  if (sets_.empty()) return y;
  const std::vector<BoundedDouble> values = couple(weights(moments(density, x)));
  const long bits = BallPrecision::current();

  // Modes of the midpoints, and what a row below a cluster may be off by beside them.
  std::vector<Modes> modes(levels_.size());
  std::vector<std::vector<double>> off(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const std::size_t k = levels_[l].degree < 0 ? 0 : mode_count(levels_[l].degree);
    modes[l].assign(levels_[l].clusters, std::vector<Ball>(k));
    off[l].assign(levels_[l].clusters, 0.0);
  }
  // The sets of a level follow each other; those of one cluster are added in their order.
  std::vector<std::vector<std::vector<std::size_t>>> of_cluster(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) of_cluster[l].resize(levels_[l].clusters);
  for (std::size_t i = 0; i < sets_.size(); ++i) of_cluster[sets_[i].level][sets_[i].cluster].push_back(i);
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (levels_[l].degree < 0) continue;
    parallel_for(levels_[l].clusters, clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
      const BallPrecision inside(bits);
      for (std::size_t i = begin; i < end; ++i) {
        std::vector<Ball>& to = modes[l][i];
        if (l > 0) {
          const std::vector<Ball>& of_parent = modes[l - 1][i / 4];
          const Matrix<Ball>& t = tables_.transfer[i % 4];
          for (std::size_t m = 0; m < of_parent.size(); ++m)
            for (std::size_t n = 0; n < of_parent.size(); ++n)
              if (!certainly_zero(t(n, m))) to[m] += t(n, m) * of_parent[n];
          off[l][i] = off[l - 1][i / 4];
        }
        for (const std::size_t which : of_cluster[l][i]) {
          const NodeSet& set = sets_[which];
          const Matrix<double>& w = ModeTables::instance().interpolation(set.degree).modes_of_values;
          const std::size_t k = mode_count(set.degree);
          double largest = 0;
          for (std::size_t a = 0; a < k; ++a) {
            const BoundedDouble& value = values[set.first + a];
            const Ball exact(value.value());
            for (std::size_t n = 0; n < k; ++n) to[n] += Ball(w(n, a)) * exact;
            largest = larger_bound(largest, value.error());
          }
          off[l][i] = (off[l][i] + interpolation_bounds(set.degree).stored * largest) * up;
        }
      }
    });
  }
  parallel_for(leaves, clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<Ball>& of_leaf = modes.back()[i];
      for (std::size_t j = 0; j < tables_.unknowns; ++j) {
        Ball sum = 0;
        for (std::size_t n = 0; n < of_leaf.size(); ++n) sum += tables_.values(j, n) * of_leaf[n];
        const BoundedDouble value = radcert::bounded(sum);
        y[i * tables_.unknowns + j] = {value.value(), (value.error() + off.back()[i]) * up};
      }
    }
  });
  return y;
}

void EnclosedCouplings::count(MemoryPlan& plan) const {
  plan.add("enclosed interpolation nodes", points_.size(), sizeof(Point) + 2 * sizeof(BoundedDouble));
  std::size_t modes = 0;
  for (const Level& level : levels_)
    if (level.degree >= 0) modes += level.clusters * mode_count(level.degree);
  plan.add("enclosed moments and modes", modes, 2 * sizeof(Ball));
}

}  // namespace radcert
