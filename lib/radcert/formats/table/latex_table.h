// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/study/experiment.h"
#include "radcert/study/result.h"

namespace radcert {

/// A text for LaTeX, with its special characters as they print.
/// Source    the ten special characters of LaTeX
/// Requires  UTF-8
/// Result    as plain text of a paragraph; underscores and slashes are places where a line may end
/// Limits    letters beyond ASCII need a font that has them
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// A number as siunitx reads it.
/// Maths     with a radius an enclosure, `digits` digits of the midpoint or as many as the radius leaves a
///           meaning: parenthesised_text. Without one, or with an infinite one, rounded to nearest
/// Requires  1 <= digits <= 100; a finite value; radius >= 0, else ContractViolation
/// Result    "1.483(2)e-3" is 1.483e-3 +- 0.002e-3; "1.483e-3" where no radius is known
[[nodiscard]] std::string latex_number(double value, std::optional<double> radius, int digits);

/// A column of a table: its head as LaTeX, and its letter or S[...] of siunitx.
struct LatexColumn {
  std::string head;
  std::string format;
};

/// A table for LaTeX with booktabs and siunitx.
/// Source    the packages array, booktabs, siunitx, and longtable for one that goes over pages
/// Requires  a row has as many cells as there are columns, else ContractViolation; cells are LaTeX
/// Result    a tabular in a paragraph of its own, or a longtable with its head on every page, without float
///           and caption
class LatexTable {
public:
  explicit LatexTable(std::vector<LatexColumn> columns, bool over_pages = false);
  void add(std::span<const std::string> cells);
  /// A line across all columns.
  void add_line(const std::string& latex);
  /// The same for a text that may be too long for one line.
  void add_paragraph(const std::string& latex);
  void add_rule();
  [[nodiscard]] std::string text() const;

private:
  std::vector<LatexColumn> columns_;
  bool over_pages_;
  std::string rows_;
};

/// The levels of a result as a table: unknowns, h, errors with their observed orders, the fitted orders
/// below.
/// Source    the tables of [ac98], with orders in place of ratios
/// Requires  nothing
/// Result    four significant digits with the radius in parentheses, fewer where it leaves fewer; without a
///           solution the means over the pieces
/// Limits    all digits are in errors.csv
[[nodiscard]] std::string levels_latex(const Result& result);

/// The combinations of an experiment as a table, level by level: unknowns, h, errors with their observed
/// orders, below each combination its fitted orders.
/// Requires  a result of collect for each combination, in their order
/// Result    the combinations in their order, each under its name; over pages where one would not hold it
[[nodiscard]] std::string combinations_latex(const Experiment& experiment, std::span<const Result> results);

}  // namespace radcert
