// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/scoreboard_table.h"

#include <vector>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

/// An error, marked where no method has a smaller one with no more unknowns.
std::string error_text(const BoardPoint& point, std::size_t error) {
  const std::optional<double>& value = point.errors[error];
  if (!value) return "-";
  return nearest_text(*value, DecimalForm::scientific(3)) + (point.on_frontier[error][0] ? " *" : "");
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr double million = 1e6;
  return nearest_text(static_cast<double>(bytes) / million, DecimalForm::general(3));
}

}  // namespace

std::string scoreboard_table(std::span<const BoardProblem> problems) {
  std::string out;
  for (const BoardProblem& problem : problems) {
    out += problem.name + ": " + problem.words + "\n";
    std::vector<std::vector<std::string>> rows = {
        {"method", "level", "unknowns", "MB", "seconds", "maximum", "mean square", "means"}};
    std::string refusals;
    for (const BoardCell& cell : problem.cells) {
      if (cell.points.empty()) {
        refusals += "  " + cell.method + ": " + cell.refusal + "\n";
        continue;
      }
      const BoardPoint& last = cell.points.back();
      rows.push_back({cell.method, std::to_string(last.level), std::to_string(last.unknowns),
                      bytes_text(last.bytes), nearest_text(last.seconds, DecimalForm::general(2)),
                      error_text(last, 0), error_text(last, 1), error_text(last, 2)});
    }
    out += aligned(rows);
    if (!refusals.empty()) out += "Not served:\n" + refusals;
    if (problem.truth_radius)
      out += "The means are known within " + upper_text(*problem.truth_radius) + ".\n";
    out += "\n";
  }
  return out +
         "The finest level of each method; all of them with --out. * on the frontier: no method has at any "
         "level "
         "a smaller error with no more unknowns.\nmaximum: over a sample of S, of iterated solutions over "
         "check points; means: the largest error of the mean over a piece. MB: as planned.\n";
}

}  // namespace radcert::app
