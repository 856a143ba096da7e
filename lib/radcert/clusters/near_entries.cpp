// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/near_entries.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/clusters/vanishing.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/quadrature/collocation_point_block.h"
#include "radcert/quadrature/element_integrator.h"

namespace radcert {
namespace {

/// The largest number of unknowns of a leaf, padded.
constexpr std::size_t most_rows = 256;

/// Sums of products, row by row.
class PlainSums {
public:
  void start(std::span<const double> from) { std::copy(from.begin(), from.end(), value_.begin()); }
  void add(const double* column, std::size_t rows, double factor) {
    for (std::size_t i = 0; i < rows; i += Pack::lanes)
      fma(Pack::load(column + i), Pack(factor), Pack::load(&value_[i])).store(&value_[i]);
  }
  [[nodiscard]] double sum(std::size_t i) const { return value_[i]; }

private:
  std::array<double, most_rows> value_{};
};

/// Sums of the products' sizes.
class SizeSums {
public:
  void start(std::span<const double> from) { std::copy(from.begin(), from.end(), value_.begin()); }
  void add(const double* column, std::size_t rows, double factor) {
    for (std::size_t i = 0; i < rows; i += Pack::lanes)
      fma(abs(Pack::load(column + i)), Pack(factor), Pack::load(&value_[i])).store(&value_[i]);
  }
  [[nodiscard]] double sum(std::size_t i) const { return value_[i]; }

private:
  std::array<double, most_rows> value_{};
};

/// Sums of a value and a much smaller error: Ogita, Rump, Oishi (2005), algorithm Dot2.
class AccurateRowSums {
public:
  void start(std::span<const double> from) { std::copy(from.begin(), from.end(), value_.begin()); }
  void add(const double* column, std::size_t rows, double factor) {
    for (std::size_t i = 0; i < rows; i += Pack::lanes) {
      const Pack entry = Pack::load(column + i);
      const Pack product = entry * Pack(factor);
      const Pack before = Pack::load(&value_[i]);
      const Pack after = before + product;
      const Pack back = after - before;
      after.store(&value_[i]);
      const Pack rest = fma(entry, Pack(factor), -product) + ((before - (after - back)) + (product - back));
      (Pack::load(&error_[i]) + rest).store(&error_[i]);
    }
  }
  [[nodiscard]] double sum(std::size_t i) const { return value_[i] + error_[i]; }

private:
  std::array<double, most_rows> value_{};
  std::array<double, most_rows> error_{};
};

}  // namespace

NearEntries::NearEntries(const ClusterPart& part, const std::vector<NearPair>& pairs,
                         std::size_t unknowns_of_leaf)
    : part_(part),
      leaves_(part.leaves().size()),
      unknowns_(unknowns_of_leaf),
      rows_(padded<double>(unknowns_of_leaf)),
      first_(leaves_ + 1) {
  expects(rows_ <= most_rows, "at most 256 unknowns a leaf", named("unknowns", unknowns_));
  const ClusterRange here = part.leaves();
  const auto for_each_row = [&](const auto& row) {
    for (const NearPair& pair : pairs) {
      if (here.contains(pair.a)) row(pair.a - here.begin, pair.b);
      if (pair.a != pair.b && here.contains(pair.b)) row(pair.b - here.begin, pair.a);
    }
  };
  for_each_row([&](std::size_t target, std::uint32_t source) {
    ++first_[target + 1];
    if (!here.contains(source)) foreign_.push_back(source);
  });
  std::sort(foreign_.begin(), foreign_.end());
  foreign_.erase(std::unique(foreign_.begin(), foreign_.end()), foreign_.end());
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf) first_[leaf + 1] += first_[leaf];
  sources_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for_each_row([&](std::size_t target, std::uint32_t source) { sources_[next[target]++] = source; });
  const auto slot = [&](std::uint32_t leaf) {
    if (here.contains(leaf)) return static_cast<std::uint32_t>(leaf - here.begin);
    const auto place = std::lower_bound(foreign_.begin(), foreign_.end(), leaf) - foreign_.begin();
    return static_cast<std::uint32_t>(leaves_ + static_cast<std::size_t>(place));
  };
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
    const auto begin = sources_.begin() + static_cast<std::ptrdiff_t>(first_[leaf]);
    const auto end = sources_.begin() + static_cast<std::ptrdiff_t>(first_[leaf + 1]);
    std::sort(begin, end);
    std::transform(begin, end, begin, slot);
  }
  std::vector<RemoteNumber> wanted;
  wanted.reserve(foreign_.size() * unknowns_);
  for (const std::uint32_t leaf : foreign_) {
    const std::size_t owner = part.owner(part.leaf_level(), leaf);
    const std::size_t place = (leaf - part.range(part.leaf_level(), owner).begin) * unknowns_;
    for (std::size_t j = 0; j < unknowns_; ++j)
      wanted.push_back({.rank = static_cast<std::uint32_t>(owner), .place = place + j});
  }
  exchange_ = part.ranks().exchange(leaves_ * unknowns_, wanted);
}

NearEntries::RowSums NearEntries::fill(const Schemes& schemes, const ClusterTree& tree,
                                       std::span<const CollocationPoint<double>> nodes,
                                       std::span<const double> factors) {
  expects(!schemes.schemes.empty() && schemes.of_leaf.size() == leaves_, "a scheme for every leaf",
          named("leaves", leaves_));
  const std::size_t functions = schemes.schemes.front()->basis().size();
  const std::size_t elements = unknowns_ / functions;
  expects(nodes.size() == leaves_ * unknowns_ && factors.size() == nodes.size() &&
              tree.elements_of_leaf() == elements,
          "nodes of all leaves here, and the elements of a leaf", named("nodes", nodes.size()),
          named("elements", tree.elements_of_leaf()));
  entries_.resize(size());
  std::vector<double> integral_of_block(sources_.size() * rows_, 0.0);
  std::vector<double> radius_of_block(sources_.size() * rows_, 0.0);
  // The rows of blocks, ordered by their columns' leaf.
  struct Target {
    std::uint32_t leaf;
    std::size_t number;  ///< of the block
  };
  std::vector<std::vector<Target>> targets_of(leaves_ + foreign_.size());
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf)
    for (std::size_t number = first_[leaf]; number < first_[leaf + 1]; ++number)
      targets_of[sources_[number]].push_back({static_cast<std::uint32_t>(leaf), number});
  std::vector<std::vector<CollocationPointBlock<double>>> blocks(leaves_);
  parallel_for(leaves_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      blocks[leaf] = observer_blocks(nodes.subspan(leaf * unknowns_, unknowns_));
  });
  parallel_for(targets_of.size(), 1, [&](std::size_t begin, std::size_t end) {
    BlockIntegral<double> integral;
    for (std::size_t source = begin; source < end; ++source) {
      const std::size_t leaf = source < leaves_ ? part_.leaves().begin + source : foreign_[source - leaves_];
      for (std::size_t k = 0; k < elements; ++k) {
        const ParameterTriangle triangle = tree.element(leaf * elements + k);
        std::vector<std::unique_ptr<ElementIntegrator<double>>> by_scheme(schemes.schemes.size());
        for (const auto& [target, number] : targets_of[source]) {
          const std::size_t which = schemes.of_leaf[target];
          if (!by_scheme[which])
            by_scheme[which] = std::make_unique<ElementIntegrator<double>>(schemes.schemes[which], triangle);
          ElementIntegrator<double>& element = *by_scheme[which];
          double* to = entries_.data() + number * rows_ * unknowns_ + k * functions * rows_;
          const auto of_leaf = nodes.subspan(target * unknowns_, unknowns_);
          const double* factor = &factors[target * unknowns_];
          for (const CollocationPointBlock<double>& block : blocks[target]) {
            element.integrate(block, of_leaf, integral);
            for (std::size_t lane = 0; lane < block.count; ++lane) {
              const std::size_t i = block.first + lane;
              double radius = 0;
              for (std::size_t j = 0; j < functions; ++j) {
                to[j * rows_ + i] = factor[i] * integral.value[j].lane(lane);
                radius += integral.radius[j].lane(lane);
              }
              integral_of_block[number * rows_ + i] += integral.absolute.lane(lane);
              radius_of_block[number * rows_ + i] += factor[i] * radius;
            }
          }
          for (std::size_t j = 0; j < functions; ++j)
            std::fill(to + j * rows_ + unknowns_, to + (j + 1) * rows_, 0.0);
        }
      }
    }
  });
  RowSums sums{std::vector<double>(nodes.size(), 0.0), std::vector<double>(nodes.size(), 0.0)};
  parallel_for(leaves_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      for (std::size_t number = first_[leaf]; number < first_[leaf + 1]; ++number)
        for (std::size_t i = 0; i < unknowns_; ++i) {
          sums.kernel_integral[leaf * unknowns_ + i] += integral_of_block[number * rows_ + i];
          sums.radius[leaf * unknowns_ + i] += radius_of_block[number * rows_ + i];
        }
  });
  return sums;
}

template <class Sums>
void NearEntries::sum_rows(std::span<const double> x, std::span<const double> start,
                           std::span<double> y) const {
  expects(x.size() == leaves_ * unknowns_ && y.size() == x.size() && start.size() == x.size(),
          "vectors of as many entries as unknowns", named("x", x.size()), named("y", y.size()));
  std::vector<double> foreign(foreign_.size() * unknowns_);
  exchange_->bring(x, foreign);
  constexpr std::size_t leaves_at_a_time = 4;
  parallel_for(leaves_, leaves_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      Sums sums;
      sums.start(start.subspan(leaf * unknowns_, unknowns_));
      for (std::size_t number = first_[leaf]; number < first_[leaf + 1]; ++number) {
        const double* column = block(number);
        const std::size_t source = sources_[number];
        const std::span<const double> factor =
            source < leaves_
                ? x.subspan(source * unknowns_, unknowns_)
                : std::span<const double>(foreign).subspan((source - leaves_) * unknowns_, unknowns_);
        if (vanishes(factor)) continue;
        for (std::size_t j = 0; j < unknowns_; ++j, column += rows_) sums.add(column, rows_, factor[j]);
      }
      for (std::size_t i = 0; i < unknowns_; ++i) y[leaf * unknowns_ + i] = sums.sum(i);
    }
  });
}

void NearEntries::add_product(std::span<const double> x, std::span<double> y) const {
  sum_rows<PlainSums>(x, y, y);
}

void NearEntries::add_sizes(std::span<const double> x, std::span<double> y) const {
  sum_rows<SizeSums>(x, y, y);
}

void NearEntries::add_accurately(std::span<const double> x, std::span<double> y) const {
  sum_rows<AccurateRowSums>(x, y, y);
}

double NearEntries::entry(std::size_t i, std::size_t j) const {
  const auto begin = sources_.begin() + static_cast<std::ptrdiff_t>(first_[i / unknowns_]);
  const auto end = sources_.begin() + static_cast<std::ptrdiff_t>(first_[i / unknowns_ + 1]);
  const auto source = std::lower_bound(begin, end, j / unknowns_);
  if (source == end || *source != j / unknowns_) return 0;
  return block(static_cast<std::size_t>(source - sources_.begin()))[(j % unknowns_) * rows_ + i % unknowns_];
}

std::size_t NearEntries::longest_row() const {
  std::size_t longest = 0;
  for (std::size_t leaf = 0; leaf < leaves_; ++leaf)
    longest = std::max(longest, first_[leaf + 1] - first_[leaf]);
  return longest * unknowns_;
}

void NearEntries::count(MemoryPlan& plan) const {
  plan.add("near entries", size(), sizeof(double));
  // Their row sums by blocks, while they are made.
  plan.add("near pairs of leaves", sources_.size(),
           3 * sizeof(std::size_t) + sizeof(std::uint32_t) + 2 * rows_ * sizeof(double));
  plan.add("vectors at leaves of other ranks", foreign_.size() * unknowns_,
           sizeof(double) + 2 * sizeof(RemoteNumber));
}

}  // namespace radcert
