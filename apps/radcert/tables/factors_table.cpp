// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/factors_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

constexpr int digits_of_factors = 16;
constexpr int digits_of_areas = 10;

/// As many digits as the radius leaves a meaning, and two more.
void push(std::vector<std::string>& row, const Approximation& number, int digits) {
  if (number.value != 0 && number.radius > 0) {
    const double known = std::log10(std::abs(number.value)) - std::log10(number.radius);
    digits = static_cast<int>(std::clamp(std::ceil(known) + 2, 2.0, static_cast<double>(digits)));
  }
  const EnclosingText text = enclosing_text(number.value, number.radius, DecimalForm::general(digits));
  row.insert(row.end(), {text.value, text.radius});
}

/// The columns that hold a radius: each stays with the number before it.
std::set<std::size_t> radii_of(const std::vector<std::string>& head) {
  std::set<std::size_t> out;
  for (std::size_t column = 0; column < head.size(); ++column)
    if (head[column] == "+-") out.insert(column);
  return out;
}

}  // namespace

std::string factors_table(const FactorReport& report) {
  const FactorMatrix& matrix = report.matrix;
  std::string out =
      fmt::format("{}: {} triangles, {} surfaces by {}{}\n", report.name, report.triangles,
                  report.names.size(), report.by, report.front ? ", front " + *report.front : std::string());
  std::vector<std::vector<std::string>> rows{
      {"surface", report.unit ? "area (" + *report.unit + "^2)" : "area", "+-", "row sum", "+-"}};
  if (report.open) rows.front().insert(rows.front().end(), {"to space", "+-"});
  constexpr std::size_t most_rows = 20;
  for (std::size_t i = 0; i < std::min(matrix.rows.size(), most_rows); ++i) {
    const FactorRow& row = matrix.rows[i];
    rows.push_back({report.names[i]});
    push(rows.back(), row.area, digits_of_areas);
    push(rows.back(), row.sum, digits_of_factors);
    if (row.to_space) push(rows.back(), *row.to_space, digits_of_factors);
  }
  out += aligned(rows, radii_of(rows.front()));
  if (matrix.rows.size() > most_rows) out += fmt::format("... and {} more\n", matrix.rows.size() - most_rows);
  out += matrix.rays > 0
             ? fmt::format("{} rays\n", matrix.rays)
             : fmt::format("pairs of triangles facing each other: {} wholly seen, {} hidden, {} mixed\n",
                           matrix.whole_pairs, matrix.hidden_pairs, matrix.mixed_pairs);
  out += "largest radius of a factor: " + upper_text(matrix.largest_radius()) + ", " +
         (matrix.guaranteed ? "guaranteed" : "estimated") + "\n";
  if (!report.open)
    out += "closure: the row sums as given are within " + upper_text(closure_bound(matrix)) +
           " of 1, the worst is " + report.names[matrix.worst_row()] + "\n";
  out += "reciprocity: |A_i F_ij - A_j F_ji| <= " + upper_text(matrix.largest_reciprocity_defect) +
         " sqrt(A_i A_j) as given; nothing was adjusted\n";
  out += matrix.guaranteed
             ? "The radii (+-) are proved; they include the rounding of the printed digits.\n"
             : "The radii (+-) of areas are proved, the others are estimates, not proofs; they include the "
               "rounding of the printed digits.\n";
  if (report.facets_only)
    out += std::string(matrix.guaranteed ? "certified" : "computed") +
           " for these facets: what they may stand for is another surface\n";
  for (const std::string& warning : report.warnings) out += "warning: " + warning + "\n";
  return out;
}

std::string comparison_table(const std::vector<FactorComparison>& pairs) {
  std::vector<std::size_t> count(3, 0);
  for (const FactorComparison& pair : pairs) ++count[static_cast<std::size_t>(pair.agreement)];
  std::string out = fmt::format("compared: {} agree, {} differ, {} undecided; the largest differences\n",
                                count[0], count[1], count[2]);
  std::vector<std::vector<std::string>> rows{
      {"from", "to", "ours", "+-", "theirs", "+-", "apart at most", "verdict", "cause"}};
  constexpr std::size_t most_rows = 10;
  for (std::size_t k = 0; k < std::min(pairs.size(), most_rows); ++k) {
    const FactorComparison& pair = pairs[k];
    rows.push_back({pair.from, pair.to});
    push(rows.back(), pair.ours, digits_of_factors);
    const EnclosingText theirs =
        enclosing_text(pair.theirs.value, pair.theirs.halfwidth, DecimalForm::general(digits_of_factors));
    const Rational apart = abs(Rational::exactly(pair.ours.value) - pair.theirs.value);
    rows.back().insert(rows.back().end(), {theirs.value, theirs.radius, upper_text(apart),
                                           agreement_word(pair.agreement), pair.cause});
  }
  return out + aligned(rows, radii_of(rows.front()));
}

}  // namespace radcert::app
