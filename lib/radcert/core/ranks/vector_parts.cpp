// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/ranks/vector_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

double dot_of_block(std::span<const double> a, std::span<const double> b) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> sum{};
  std::size_t i = 0;
  for (; i + lanes <= a.size(); i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) sum[lane] += a[i + lane] * b[i + lane];
  for (std::size_t lane = 0; i < a.size(); ++i, ++lane) sum[lane] += a[i] * b[i];
  double total = 0;
  for (const double lane : sum) total += lane;
  return total;
}

}  // namespace

VectorParts::VectorParts(const Ranks& ranks, std::size_t blocks, std::size_t block)
    : ranks_(&ranks), block_(block), size_(blocks * block), whole_(0) {
  expects(blocks > 0 && block > 0, "a block on every rank", named("blocks", blocks), named("block", block));
  const auto own = static_cast<double>(size_);  // far below 2^53
  const std::vector<double> sizes = ranks.gather_numbers({&own, 1});
  for (std::size_t rank = 0; rank < sizes.size(); ++rank) {
    if (rank == ranks.here()) first_ = whole_;
    whole_ += static_cast<std::size_t>(sizes[rank]);
  }
}

double VectorParts::dot(std::span<const double> a, std::span<const double> b) const {
  expects(a.size() == size_ && b.size() == size_, "vectors of as many entries as there are here",
          named("a", a.size()), named("b", b.size()));
  if (size_ == block_ && whole_ == size_) return dot_of_block(a, b);
  std::vector<double> of_blocks(size_ / block_);
  parallel_for(of_blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      of_blocks[k] = dot_of_block(a.subspan(k * block_, block_), b.subspan(k * block_, block_));
  });
  double total = 0;
  for (const double each : ranks_->gather_numbers(of_blocks)) total += each;
  return total;
}

std::vector<double> VectorParts::at_first(std::span<const double> x) const {
  return ranks_->gather_numbers_at_first(x);
}

std::optional<std::vector<double>> VectorParts::from_first(std::span<const double> all) const {
  const std::vector<double> given = ranks_->numbers_from_first(all);
  if (given.size() != whole_) return std::nullopt;
  const auto begin = given.begin() + static_cast<std::ptrdiff_t>(first_);
  return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size_));
}

double VectorParts::size_of(std::span<const double> x) const {
  double size = 0;
  for (const double value : x) size = std::max(size, std::abs(value));
  return ranks_->largest(size);
}

}  // namespace radcert
