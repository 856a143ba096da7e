// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "radcert/formats/result/stored_levels.h"
#include "radcert/study/study.h"

namespace radcert::verification {

/// A problem that checks solved, level by level.
/// Result    levels ascending, by whichever solver; problem and text have the solver of the finest; orders:
///           fitted over them as collect() does; `elements` and `nodes` are those of `drawn_level`
struct ProblemTrace {
  Problem problem;
  std::string name;  ///< problem_title
  std::string text;  ///< the problem file
  std::vector<LevelResult> levels;
  std::vector<OrderFit> orders;
  int drawn_level = 0;
  std::vector<ElementValue> elements;
  std::vector<NodeValue> nodes;
};

/// Levels from another source, with a record of which problems were solved and what came out.
/// Requires  the source outlives it
/// Result    hands on what the source gives. problems(): each problem once, in the order of first use; those
///           that differ in the solver alone are one, a level with a proof in the place of one without.
///           used(): those asked for since the last begin(), by their index there; asked(): what was asked
///           for since then, in order
/// Limits    keeps nodes and elements of one level a problem: the finest with at most `most_drawn` elements,
///           else the coarsest
class RecordedLevels final : public LevelSource {
public:
  /// One level that was asked for.
  struct Asked {
    Problem problem;
    int level = 0;
  };

  explicit RecordedLevels(LevelSource& source) : source_(&source) {}
  LevelOutcome level(const Problem& problem, int level) override;

  void begin() {
    used_.clear();
    asked_.clear();
  }
  [[nodiscard]] const std::vector<std::size_t>& used() const { return used_; }
  [[nodiscard]] const std::vector<Asked>& asked() const { return asked_; }
  [[nodiscard]] std::vector<ProblemTrace> problems() const;

  /// As many triangles as a picture is clear with.
  static constexpr std::size_t most_drawn = 256;

private:
  std::size_t index_of(const Problem& problem);
  static void draw(ProblemTrace& trace, const LevelOutcome& outcome);

  LevelSource* source_;
  std::vector<std::size_t> used_;
  std::vector<Asked> asked_;
  std::vector<ProblemTrace> problems_;
};

/// A problem in a few words: surface and its parameters, basis, what is not the default.
[[nodiscard]] std::string problem_title(const Problem& problem);

}  // namespace radcert::verification
