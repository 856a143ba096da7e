// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/cluster_couplings.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "radcert/clusters/mode_products.h"
#include "radcert/clusters/vanishing.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/triangle_modes.h"

namespace radcert {
namespace {

/// The doubles that the values of a batch of couplings take at most: they stay in the cache of the last
/// level.
constexpr std::size_t most_slots = std::size_t{1} << 21U;
/// The clusters that a task takes at a time, in groups that share the loads of a matrix.
constexpr std::size_t clusters_at_a_time = 32;
constexpr std::size_t couplings_at_a_time = 16;

/// The largest degree on each level and those above it, of the couplings of all ranks; -1: none.
std::vector<int> degrees_of_levels(const ClusterPart& part, const std::vector<std::vector<FarPair>>& pairs) {
  std::vector<double> own(pairs.size(), -1);
  for (std::size_t l = 0; l < pairs.size(); ++l)
    for (const FarPair& pair : pairs[l]) own[l] = std::max(own[l], static_cast<double>(pair.coupling.degree));
  const std::vector<double> all = part.ranks().gather_numbers(own);
  std::vector<int> degrees(pairs.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i)
    degrees[i % pairs.size()] = std::max(degrees[i % pairs.size()], static_cast<int>(all[i]));
  for (std::size_t l = 1; l < degrees.size(); ++l) degrees[l] = std::max(degrees[l], degrees[l - 1]);
  return degrees;
}

/// Vectors that one small matrix is multiplied with.
struct VectorGroup {
  std::array<const double*, clusters_at_a_time> x{};
  std::array<double*, clusters_at_a_time> y{};
  std::size_t count = 0;

  void add(const double* from, double* to) {
    x[count] = from;
    y[count++] = to;
  }
  void multiply(const Matrix<double>& a, std::size_t rows, std::size_t columns) {
    if (count == 0) return;
    add_mode_product(a, rows, columns, std::span(x).first(count), std::span(y).first(count));
    count = 0;
  }
};

}  // namespace

ClusterCouplings::ClusterCouplings(const std::vector<Chart>& charts, const ClusterTree& tree,
                                   const ClusterPart& part, const std::vector<std::vector<FarPair>>& pairs,
                                   const TriangleBasis<double>& basis)
    : part_(part),
      levels_(placed_levels(part, degrees_of_levels(part, pairs))),
      modes_(levels_.back().place(levels_.back().held.end)),
      transfers_(tree, basis, degrees_of(levels_)),
      unknowns_(tree.elements_of_leaf() * basis.size()) {
  expects(pairs.size() == tree.levels(), "pairs of each level of the tree", named("levels", pairs.size()));
  place_node_sets(charts, tree, pairs);
  list_foreign_moments();
  list_batches();
}

std::vector<int> ClusterCouplings::degrees_of(const std::vector<Level>& levels) {
  std::vector<int> degrees;
  for (const Level& level : levels) degrees.push_back(level.degree);
  return degrees;
}

std::vector<ClusterCouplings::Level> ClusterCouplings::placed_levels(const ClusterPart& part,
                                                                     const std::vector<int>& degrees) {
  std::vector<Level> levels(degrees.size());
  std::size_t place = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    Level& level = levels[l];
    level.held = l <= part.cut() ? ClusterRange{0, part.count(l)} : part.range(l);
    level.degree = degrees[l];
    level.stride = level.degree < 0 ? 0 : padded<double>(mode_count(level.degree));
    level.first = place;
    place += level.held.size() * level.stride;
  }
  return levels;
}

void ClusterCouplings::place_node_sets(const std::vector<Chart>& charts, const ClusterTree& tree,
                                       const std::vector<std::vector<FarPair>>& pairs) {
  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  for (std::size_t l = 0; l < pairs.size(); ++l) {
    if (pairs[l].empty()) continue;
    const std::size_t clusters = tree.level(l).size();
    const std::size_t degrees = static_cast<std::size_t>(levels_[l].degree) + 1;
    std::vector<std::uint32_t> set(clusters * degrees, none);
    const auto place_of = [&](std::uint32_t cluster, int degree) -> std::uint32_t& {
      return set[static_cast<std::size_t>(degree) * clusters + cluster];
    };
    for (const FarPair& pair : pairs[l])
      place_of(pair.a, pair.coupling.degree) = place_of(pair.b, pair.coupling.degree) = 0;
    for (std::size_t degree = 0; degree < degrees; ++degree) {
      NodeGroup group{.level = l, .degree = static_cast<int>(degree), .begin = sets_.size(), .end = 0};
      const std::size_t nodes = mode_count(group.degree);
      for (std::uint32_t cluster = 0; cluster < clusters; ++cluster) {
        std::uint32_t& place = place_of(cluster, group.degree);
        if (place == none) continue;
        expects(sets_.size() < none, "fewer than 2^32 node sets", named("sets", sets_.size()));
        place = static_cast<std::uint32_t>(sets_.size());
        const bool is_held = levels_[l].held.contains(cluster);
        sets_.push_back({.cluster = cluster,
                         .is_held = is_held,
                         .is_here = part_.range(l).contains(cluster),
                         .first = 0,
                         .moments = is_held ? levels_[l].place(cluster) : 0});
      }
      group.end = sets_.size();
      if (group.begin == group.end) continue;
      const std::size_t stride = padded<double>(nodes);
      const std::size_t first = points_.add((group.end - group.begin) * stride);
      const ModeInterpolation& interpolation = ModeTables::instance().interpolation(group.degree);
      parallel_for(group.end - group.begin, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          NodeSet& now = sets_[group.begin + i];
          now.first = first + i * stride;
          const ParameterTriangle& triangle = tree.level(l)[now.cluster];
          points_.place(now.first, charts[triangle.chart], triangle, interpolation.nodes);
        }
      });
      groups_.push_back(group);
    }
    for (const FarPair& pair : pairs[l]) {
      const std::size_t nodes = mode_count(pair.coupling.degree);
      couplings_.push_back({.a = place_of(pair.a, pair.coupling.degree),
                            .b = place_of(pair.b, pair.coupling.degree),
                            .slot = 0,
                            .nodes = static_cast<std::uint32_t>(nodes)});
      evaluations_ += nodes * nodes;
    }
  }
}

/// Asks for the moments of clusters that other ranks hold, of each as many as the largest degree takes.
void ClusterCouplings::list_foreign_moments() {
  // Where another rank holds the moments of a level: it lays out its levels as this one does.
  const auto first_of = [this](std::size_t rank, std::size_t level) {
    std::size_t first = 0;
    for (std::size_t l = 0; l < level; ++l) {
      const ClusterRange held = l <= part_.cut() ? ClusterRange{0, part_.count(l)} : part_.range(l, rank);
      first += held.size() * levels_[l].stride;
    }
    return first;
  };
  struct Wanted {
    std::size_t level;
    std::uint32_t cluster;
    std::size_t set;
    std::size_t modes;
  };
  std::vector<Wanted> sets;
  for (const NodeGroup& group : groups_)
    for (std::size_t i = group.begin; i < group.end; ++i)
      if (!sets_[i].is_held) sets.push_back({group.level, sets_[i].cluster, i, mode_count(group.degree)});
  // Of a cluster's sets that of the largest degree comes first.
  std::sort(sets.begin(), sets.end(), [](const Wanted& p, const Wanted& q) {
    return std::tie(p.level, p.cluster, q.modes) < std::tie(q.level, q.cluster, p.modes);
  });
  std::vector<RemoteNumber> wanted;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const auto& [level, cluster, set, modes] = sets[i];
    const bool is_new = i == 0 || sets[i - 1].level != level || sets[i - 1].cluster != cluster;
    if (!is_new) {
      sets_[set].moments = sets_[sets[i - 1].set].moments;
      continue;
    }
    sets_[set].moments = wanted.size();
    const std::size_t owner = part_.owner(level, cluster);
    const std::size_t place =
        first_of(owner, level) + (cluster - part_.range(level, owner).begin) * levels_[level].stride;
    for (std::size_t n = 0; n < modes; ++n)
      wanted.push_back({.rank = static_cast<std::uint32_t>(owner), .place = place + n});
  }
  brought_ = wanted.size();
  exchange_ = part_.ranks().exchange(modes_, wanted);
}

std::uint64_t ClusterCouplings::bytes_sent() const {
  const Level& cut = levels_[part_.cut()];
  const std::uint64_t at_cut = part_.range(part_.cut()).size() * cut.stride * sizeof(double);
  return exchange_->bytes_sent() + (part_.ranks().count() - 1) * at_cut;
}

void ClusterCouplings::list_batches() {
  std::size_t slots = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < couplings_.size(); ++i) {
    const std::size_t more = 2 * padded<double>(couplings_[i].nodes);
    if (slots + more > most_slots) {
      batches_.push_back({.begin = begin, .end = 0, .slots = 0, .first_target = 0, .last_target = 0});
      close_batch(i, slots);
      begin = i;
      slots = 0;
    }
    couplings_[i].slot = static_cast<std::uint32_t>(slots);
    slots += more;
  }
  if (begin == couplings_.size()) return;
  batches_.push_back({.begin = begin, .end = 0, .slots = 0, .first_target = 0, .last_target = 0});
  close_batch(couplings_.size(), slots);
}

void ClusterCouplings::close_batch(std::size_t end, std::size_t slots) {
  Batch& batch = batches_.back();
  batch.end = end;
  batch.slots = slots;
  struct Entry {
    std::uint32_t set;
    std::uint32_t nodes;
    std::uint32_t slot;
  };
  std::vector<Entry> entries;
  for (std::size_t i = batch.begin; i < end; ++i) {
    const Coupling& c = couplings_[i];
    if (sets_[c.a].is_here) entries.push_back({c.a, c.nodes, c.slot});
    if (sets_[c.b].is_here)
      entries.push_back({c.b, c.nodes, c.slot + static_cast<std::uint32_t>(padded<double>(c.nodes))});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& p, const Entry& q) { return p.set < q.set; });
  batch.first_target = targets_.size();
  for (const Entry& entry : entries) {
    if (targets_.size() == batch.first_target || targets_.back().set != entry.set)
      targets_.push_back({entry.set, entry.nodes, slots_.size(), slots_.size()});
    slots_.push_back(entry.slot);
    targets_.back().last_slot = slots_.size();
  }
  batch.last_target = targets_.size();
}

void ClusterCouplings::count(MemoryPlan& plan) const {
  plan.add("interpolation nodes and values at them", points_.size(),
           ClusterPoints::bytes_each + 2 * sizeof(double));
  plan.add("moments and modes", modes_, 2 * sizeof(double));
  plan.add("moments that other ranks hold", brought_, sizeof(double) + 2 * sizeof(RemoteNumber));
  transfers_.count(plan);
  plan.add("lists of couplings", couplings_.size(),
           sizeof(Coupling) + sizeof(Target) + 2 * sizeof(std::uint32_t));
  std::size_t slots = 0;
  for (const Batch& batch : batches_) slots = std::max(slots, batch.slots);
  plan.add("values of couplings", slots, sizeof(double));
}

void ClusterCouplings::multiply(ClusterDensity density, std::span<const double> x,
                                std::span<double> y) const {
  const std::size_t unknowns = part_.leaves().size() * unknowns_;
  expects(y.size() == unknowns && (density == ClusterDensity::one || x.size() == unknowns),
          "vectors of as many entries as unknowns", named("x", x.size()), named("y", y.size()));
  if (levels_.back().degree < 0) {
    std::fill(y.begin(), y.end(), 0.0);
    return;
  }
  std::vector<double> modes(modes_, 0.0);
  std::vector<double> brought(brought_);
  std::vector<double> at_nodes(points_.size(), 0.0);
  std::vector<double> values(points_.size(), 0.0);
  moments_of_leaves(density, x, modes);
  moments_of_parents(modes);
  exchange_->bring(modes, brought);
  weights_of_nodes(modes, brought, at_nodes);
  couple(at_nodes, values);
  std::fill(modes.begin(), modes.end(), 0.0);
  modes_of_values(values, modes);
  modes_of_children(modes);
  values_at_leaves(modes, y);
}

void ClusterCouplings::moments_of_leaves(ClusterDensity density, std::span<const double> x,
                                         std::span<double> moments) const {
  const Level& level = levels_.back();
  const ClusterRange here = part_.leaves();
  const auto table = [&](std::size_t i) -> const Matrix<double>& {
    const LeafTables& leaf = transfers_.leaf(here.begin + i);
    return density == ClusterDensity::absolute_functions ? leaf.absolute_moments : leaf.moments;
  };
  parallel_for(here.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    VectorGroup group;
    for (std::size_t i = begin; i < end; ++i) {
      double* to = &moments[level.place(here.begin + i)];
      if (density == ClusterDensity::one) {
        const std::vector<double>& of_one = transfers_.leaf(here.begin + i).moments_of_one;
        std::copy(of_one.begin(), of_one.end(), to);
        continue;
      }
      group.add(&x[i * unknowns_], to);
      if (!transfers_.is_uniform()) group.multiply(table(i), level.stride, unknowns_);
    }
    group.multiply(table(begin), level.stride, unknowns_);
  });
}

void ClusterCouplings::moments_of_parents(std::span<double> moments) const {
  for (std::size_t l = levels_.size(); l-- > 0;) {
    if (levels_[l].degree < 0) return;
    if (l + 1 < levels_.size()) moments_of_level(l, moments);
    if (l == part_.cut()) gather_at_cut(moments);
  }
}

/// From their children to the clusters of a level: to those of the part, above the cut to all.
void ClusterCouplings::moments_of_level(std::size_t l, std::span<double> moments) const {
  const Level& parents = levels_[l];
  const Level& children = levels_[l + 1];
  const ClusterRange here = l < part_.cut() ? parents.held : part_.range(l);
  parallel_for(here.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    VectorGroup group;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto multiply = [&](std::size_t i) {
        group.multiply(transfers_.up(l + 1, 4 * i + c), parents.stride, mode_count(parents.degree));
      };
      for (std::size_t i = here.begin + begin; i < here.begin + end; ++i) {
        group.add(&moments[children.place(4 * i + c)], &moments[parents.place(i)]);
        if (!transfers_.is_uniform()) multiply(i);
      }
      multiply(here.begin + begin);
    }
    for (std::size_t i = parents.place(here.begin + begin); i < parents.place(here.begin + end); ++i)
      moments[i] *= transfers_.share_of_area();
  });
}

void ClusterCouplings::gather_at_cut(std::span<double> moments) const {
  if (part_.ranks().count() == 1) return;
  const Level& level = levels_[part_.cut()];
  const ClusterRange here = part_.range(part_.cut());
  const std::vector<double> all =
      part_.ranks().gather_numbers(moments.subspan(level.place(here.begin), here.size() * level.stride));
  std::copy(all.begin(), all.end(), moments.begin() + static_cast<std::ptrdiff_t>(level.first));
}

void ClusterCouplings::weights_of_nodes(std::span<const double> moments, std::span<const double> brought,
                                        std::span<double> weights) const {
  for (const NodeGroup& nodes : groups_) {
    const ModeInterpolation& interpolation = ModeTables::instance().interpolation(nodes.degree);
    const std::size_t k = interpolation.nodes.size();
    const std::size_t stride = padded<double>(k);
    parallel_for(nodes.end - nodes.begin, clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
      VectorGroup group;
      for (std::size_t i = nodes.begin + begin; i < nodes.begin + end; ++i)
        group.add(&(sets_[i].is_held ? moments : brought)[sets_[i].moments], &weights[sets_[i].first]);
      group.multiply(interpolation.values_of_modes_transposed, stride, k);
      const std::size_t first = sets_[nodes.begin + begin].first;
      for (std::size_t q = first; q < first + (end - begin) * stride; q += Pack::lanes)
        (Pack::load(&weights[q]) * points_.weights(q)).store(&weights[q]);
    });
  }
}

/// G between all nodes of two sets, times the weights of either set, summed over it: at the nodes of a, of b
/// or of both, whatever is wanted, with the same bits.
template <bool at_a, bool at_b>
void ClusterCouplings::evaluate(const Coupling& coupling, std::span<const double> weights, double* values,
                                std::vector<double>& scratch) const {
  const std::size_t a = sets_[coupling.a].first;
  const std::size_t b = sets_[coupling.b].first;
  const std::size_t k = coupling.nodes;
  const std::size_t stride = padded<double>(k);
  // Where light comes from one lamp, or from one element, most pairs send nothing.
  if ((!at_b || vanishes(weights.subspan(a, k))) && (!at_a || vanishes(weights.subspan(b, k)))) {
    std::fill_n(values, 2 * stride, 0.0);
    return;
  }
  if (scratch.size() < k * Pack::lanes) scratch.resize(k * Pack::lanes);
  std::fill_n(scratch.begin(), k * Pack::lanes, 0.0);
  for (std::size_t j = 0; j < stride; j += Pack::lanes) {
    const Vector<Pack> q = points_.points(b + j);
    const Vector<Pack> normal_q = points_.normals(b + j);
    const Pack weight_q = Pack::load(&weights[b + j]);
    Pack at_q(0.0);
    for (std::size_t i = 0; i < k; ++i) {
      const Vector<double> p = points_.point(a + i);
      const Vector<double> n = points_.normal(a + i);
      // The sign of one normal is taken into the weights: (P-Q).n_P instead of (Q-P).n_P.
      const Pack g = kernel_terms<Pack>({Pack(p.x) - q.x, Pack(p.y) - q.y, Pack(p.z) - q.z},
                                        {Pack(n.x), Pack(n.y), Pack(n.z)}, normal_q)
                         .value();
      if constexpr (at_b) at_q = fma(g, Pack(weights[a + i]), at_q);
      if constexpr (at_a) {
        double* at_p = &scratch[i * Pack::lanes];
        fma(g, weight_q, Pack::load(at_p)).store(at_p);
      }
    }
    if constexpr (at_b) (-at_q).store(values + stride + j);
  }
  if constexpr (at_a) {
    for (std::size_t i = 0; i < k; ++i) values[i] = -Pack::load(&scratch[i * Pack::lanes]).sum();
    for (std::size_t i = k; i < stride; ++i) values[i] = 0;
  }
}

void ClusterCouplings::couple(std::span<const double> weights, std::span<double> values) const {
  std::vector<double> held;
  for (const Batch& batch : batches_) {
    if (held.size() < batch.slots) held.resize(batch.slots);
    parallel_for(batch.end - batch.begin, couplings_at_a_time, [&](std::size_t begin, std::size_t end) {
      std::vector<double> scratch;
      for (std::size_t i = batch.begin + begin; i < batch.begin + end; ++i) {
        const Coupling& now = couplings_[i];
        double* to = &held[now.slot];
        if (!sets_[now.b].is_here)
          evaluate<true, false>(now, weights, to, scratch);
        else if (!sets_[now.a].is_here)
          evaluate<false, true>(now, weights, to, scratch);
        else
          evaluate<true, true>(now, weights, to, scratch);
      }
    });
    parallel_for(batch.last_target - batch.first_target, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = batch.first_target + begin; t < batch.first_target + end; ++t) {
        const Target& target = targets_[t];
        double* to = &values[sets_[target.set].first];
        for (std::size_t i = 0; i < padded<double>(target.nodes); i += Pack::lanes) {
          Pack sum = Pack::load(to + i);
          for (std::size_t s = target.first_slot; s < target.last_slot; ++s)
            sum += Pack::load(&held[slots_[s]] + i);
          sum.store(to + i);
        }
      }
    });
  }
}

void ClusterCouplings::modes_of_values(std::span<const double> values, std::span<double> modes) const {
  for (const NodeGroup& nodes : groups_) {
    const ModeInterpolation& interpolation = ModeTables::instance().interpolation(nodes.degree);
    const std::size_t k = interpolation.nodes.size();
    parallel_for(nodes.end - nodes.begin, clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
      VectorGroup group;
      for (std::size_t i = nodes.begin + begin; i < nodes.begin + end; ++i)
        if (sets_[i].is_here) group.add(&values[sets_[i].first], &modes[sets_[i].moments]);
      group.multiply(interpolation.modes_of_values, padded<double>(k), k);
    });
  }
}

void ClusterCouplings::modes_of_children(std::span<double> modes) const {
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    const Level& parents = levels_[l];
    const Level& children = levels_[l + 1];
    if (parents.degree < 0) continue;
    const ClusterRange here = part_.range(l);
    parallel_for(here.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
      VectorGroup group;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto multiply = [&](std::size_t i) {
          group.multiply(transfers_.down(l + 1, 4 * i + c), parents.stride, mode_count(parents.degree));
        };
        for (std::size_t i = here.begin + begin; i < here.begin + end; ++i) {
          group.add(&modes[parents.place(i)], &modes[children.place(4 * i + c)]);
          if (!transfers_.is_uniform()) multiply(i);
        }
        multiply(here.begin + begin);
      }
    });
  }
}

void ClusterCouplings::values_at_leaves(std::span<const double> modes, std::span<double> y) const {
  const Level& level = levels_.back();
  const ClusterRange here = part_.leaves();
  parallel_for(here.size(), clusters_at_a_time, [&](std::size_t begin, std::size_t end) {
    const std::size_t rows = padded<double>(unknowns_);
    std::vector<double> padded_values(rows * (end - begin), 0.0);
    VectorGroup group;
    const auto multiply = [&](std::size_t i) {
      group.multiply(transfers_.leaf(here.begin + i).values, rows, mode_count(level.degree));
    };
    for (std::size_t i = begin; i < end; ++i) {
      group.add(&modes[level.place(here.begin + i)], &padded_values[(i - begin) * rows]);
      if (!transfers_.is_uniform()) multiply(i);
    }
    multiply(begin);
    for (std::size_t i = begin; i < end; ++i)
      std::copy_n(&padded_values[(i - begin) * rows], unknowns_, &y[i * unknowns_]);
  });
}

}  // namespace radcert
