// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radcert/core/ranks/ranks.h"

namespace radcert {

/// How the entries of a long vector lie on ranks, and what is told of all of them.
/// Maths     entries in blocks of one length, each block on one rank, in the order of the ranks
/// Requires  as Ranks: called by all of them together; vectors of size() entries
/// Result    the same on every rank, and the same bits for every number of ranks and threads
class VectorParts {
public:
  /// All entries here, in one block.
  explicit VectorParts(std::size_t entries = 0) : block_(entries), size_(entries), whole_(entries) {}
  /// So many blocks of that length here. The ranks outlive this. Requires a block on every rank, else
  /// ContractViolation.
  VectorParts(const Ranks& ranks, std::size_t blocks, std::size_t block);

  [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
  /// The entries here, those before them, and those of all ranks.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t whole() const { return whole_; }

  /// sum a_i b_i: of each block in eight lanes, folded in a fixed order, then block by block.
  [[nodiscard]] double dot(std::span<const double> a, std::span<const double> b) const;
  /// All entries on the first rank, none elsewhere; and back: those here of what the first rank gives, which
  /// has all entries or none, and then nothing.
  [[nodiscard]] std::vector<double> at_first(std::span<const double> x) const;
  [[nodiscard]] std::optional<std::vector<double>> from_first(std::span<const double> all) const;
  /// max |x_i| over all numbers that are one.
  [[nodiscard]] double size_of(std::span<const double> x) const;

private:
  const Ranks* ranks_ = &one_rank();
  std::size_t block_;
  std::size_t size_;
  std::size_t first_ = 0;
  std::size_t whole_;
};

}  // namespace radcert
