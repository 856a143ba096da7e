// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "radcert/study/study.h"

namespace radcert {

class ResultStore;

/// Where those who compare levels get them from.
/// Requires  a problem that check() lets pass
/// Result    what solve_level gives
class LevelSource {
public:
  virtual ~LevelSource() = default;
  virtual LevelOutcome level(const Problem& problem, int level) = 0;
};

/// Solved levels, each computed once and kept.
/// Source    level_record.h for the key and the text
/// Requires  the store outlives the source
/// Result    a level found in the store is not computed; one that is computed is stored at once, so that an
///           interrupted run goes on where it was. computed() counts the computations of this object.
///           Of several ranks the first one's store decides for all; the others are given its numbers,
///           without nodes and elements, and their stores are not asked. A level that is kept without nodes
///           and elements is computed again where they are wanted
/// Limits    a store that is off computes each time, and so does one of a problem with an own_function or an
///           own_mother: its text does not say what that is
class StoredLevels final : public LevelSource {
public:
  using Solve = std::function<LevelOutcome(const Problem& problem, int level)>;
  StoredLevels(ResultStore& store, Solve solve, const LevelSharing& sharing = {})
      : store_(&store), solve_(std::move(solve)), ranks_(&sharing.ranks), fields_(sharing.fields) {}
  LevelOutcome level(const Problem& problem, int level) override;
  [[nodiscard]] std::size_t computed() const { return computed_; }

private:
  /// The level as it is kept, or computed and kept now; empty on ranks but the first.
  [[nodiscard]] LevelOutcome kept_or_computed(const Problem& problem, int level);

  ResultStore* store_;
  Solve solve_;
  const Ranks* ranks_;
  bool fields_;
  std::size_t computed_ = 0;
};

/// solve_level with a route, after check() within so many bytes. With a store, what a level keeps on its way
/// is kept there, and what another run has kept is found.
[[nodiscard]] StoredLevels::Solve solve_with(OperatorRoute route, std::uint64_t memory_limit,
                                             const LevelSharing& sharing = {}, ResultStore* store = nullptr);

}  // namespace radcert
