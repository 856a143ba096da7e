// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/factor_remarks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "radcert/core/text.h"

namespace radcert {

namespace {

/// The rows, worst first, of which something is to be said: their number, and the names of the first.
std::string worst_rows(const FactorReport& report, std::vector<std::pair<double, std::size_t>> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t most_names = 3;
  std::string out = std::to_string(rows.size()) + " of " + std::to_string(report.names.size()) + " rows";
  for (std::size_t k = 0; k < std::min(rows.size(), most_names); ++k)
    out += (k == 0 ? ": " : ", ") + report.names[rows[k].second];
  return out + (rows.size() > most_names ? ", ..." : "");
}

}  // namespace

std::vector<std::string> factor_warnings(const FactorReport& report, OptionStyle style) {
  std::vector<std::string> out;
  const FactorMatrix& matrix = report.matrix;
  const bool has_space = !matrix.rows.empty() && matrix.rows.front().to_space.has_value();
  if (matrix.entry_count == 0 && report.front)
    out.push_back(std::string(has_space ? "nothing sees anything but space" : "nothing sees anything") +
                  " with front " + *report.front + "; " + option_name(style, "front") + " " +
                  (*report.front == "right-hand" ? "left-hand" : "right-hand") +
                  " reads the file the other way");
  for (std::size_t i = 0; i < matrix.rows.size(); ++i)
    if (matrix.rows[i].sum.value == 0 && matrix.rows[i].sum.radius == 0)
      out.push_back(report.names[i] +
                    (matrix.rows[i].to_space
                         ? " sees nothing but space: as it should, or its normals are reversed"
                         : " sees nothing: its normals are probably reversed"));
  return out;
}

std::vector<std::string> factor_failures(const FactorReport& report, const std::optional<double>& demanded,
                                         OptionStyle style) {
  std::vector<std::string> out;
  const FactorMatrix& matrix = report.matrix;
  std::vector<std::pair<double, std::size_t>> unclosed;
  std::vector<std::pair<double, std::size_t>> wide;
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    const double off = matrix.closure_defect(i) - matrix.rows[i].sum.radius;
    if (!report.open && off > 0) unclosed.emplace_back(off, i);
    if (demanded && matrix.rows[i].sum.radius > *demanded) wide.emplace_back(matrix.rows[i].sum.radius, i);
  }
  if (!unclosed.empty())
    out.push_back("rows of a closed scene that do not sum to 1 within their radius: " +
                  worst_rows(report, std::move(unclosed)));
  if (!wide.empty()) {
    // By pairs, estimated: the two others go further, each on its kind of scene.
    const std::string further = matrix.guaranteed || matrix.rays > 0
                                    ? ""
                                    : "; with few triangles " + option_name(style, "certified") +
                                          " goes further, with thousands " + option_name(style, "rays");
    out.push_back("incomplete: the row sums' radius is above the accuracy asked for, " + shortest(*demanded) +
                  ", in " + worst_rows(report, std::move(wide)) + further);
  }
  return out;
}

}  // namespace radcert
