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

NearEntries::NearEntries(const std::vector<NearPair>& pairs, std::size_t leaves, std::size_t unknowns_of_leaf)
    : leaves_(leaves),
      unknowns_(unknowns_of_leaf),
      rows_(padded<double>(unknowns_of_leaf)),
      first_(leaves + 1) {
  expects(rows_ <= most_rows, "at most 256 unknowns a leaf", named("unknowns", unknowns_));
  for (const NearPair& pair : pairs) {
    ++first_[pair.a + 1];
    if (pair.a != pair.b) ++first_[pair.b + 1];
  }
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) first_[leaf + 1] += first_[leaf];
  sources_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const NearPair& pair : pairs) {
    sources_[next[pair.a]++] = pair.b;
    if (pair.a != pair.b) sources_[next[pair.b]++] = pair.a;
  }
  for (std::size_t leaf = 0; leaf < leaves; ++leaf)
    std::sort(sources_.begin() + static_cast<std::ptrdiff_t>(first_[leaf]),
              sources_.begin() + static_cast<std::ptrdiff_t>(first_[leaf + 1]));
}

NearEntries::RowSums NearEntries::fill(const Schemes& schemes, const Triangulation& triangulation,
                                       std::span<const CollocationPoint<double>> nodes,
                                       std::span<const double> factors) {
  expects(!schemes.schemes.empty() && schemes.of_leaf.size() == leaves_, "a scheme for every leaf",
          named("leaves", leaves_));
  const std::size_t functions = schemes.schemes.front()->basis().size();
  const std::size_t elements = unknowns_ / functions;
  expects(nodes.size() == leaves_ * unknowns_ && factors.size() == nodes.size() &&
              triangulation.triangles.size() == leaves_ * elements,
          "nodes and elements of all leaves", named("nodes", nodes.size()));
  entries_.resize(size());
  std::vector<double> integral_of_block(sources_.size() * rows_, 0.0);
  std::vector<double> radius_of_block(sources_.size() * rows_, 0.0);
  const auto first_source = [this](std::size_t leaf) {
    return sources_.begin() + static_cast<std::ptrdiff_t>(first_[leaf]);
  };
  std::vector<std::vector<CollocationPointBlock<double>>> blocks(leaves_);
  parallel_for(leaves_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      blocks[leaf] = observer_blocks(nodes.subspan(leaf * unknowns_, unknowns_));
  });
  parallel_for(leaves_, 1, [&](std::size_t begin, std::size_t end) {
    BlockIntegral<double> integral;
    for (std::size_t source = begin; source < end; ++source) {
      const std::vector<std::uint32_t> targets(first_source(source), first_source(source + 1));
      for (std::size_t k = 0; k < elements; ++k) {
        std::vector<std::unique_ptr<ElementIntegrator<double>>> by_scheme(schemes.schemes.size());
        for (const std::uint32_t target : targets) {
          const std::size_t which = schemes.of_leaf[target];
          if (!by_scheme[which])
            by_scheme[which] = std::make_unique<ElementIntegrator<double>>(
                schemes.schemes[which], triangulation.triangles[source * elements + k]);
          ElementIntegrator<double>& element = *by_scheme[which];
          // Nearness is mutual, so that the source stands in the target's list.
          const auto number = static_cast<std::size_t>(
              std::lower_bound(first_source(target), first_source(target + 1), source) - sources_.begin());
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
  constexpr std::size_t leaves_at_a_time = 4;
  parallel_for(leaves_, leaves_at_a_time, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      Sums sums;
      sums.start(start.subspan(leaf * unknowns_, unknowns_));
      for (std::size_t number = first_[leaf]; number < first_[leaf + 1]; ++number) {
        const double* column = block(number);
        const std::span<const double> factor = x.subspan(sources_[number] * unknowns_, unknowns_);
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
  plan.add("near pairs of leaves", sources_.size(), sizeof(std::uint32_t) + 2 * rows_ * sizeof(double));
}

}  // namespace radcert
