// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_files.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "plot_files.h"
#include "radcert/formats/plot/convergence_plot.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/latex_table.h"

namespace radcert::app {

namespace {

std::string problem_levels_csv(const verification::Report& report) {
  std::vector<std::string_view> columns = {"problem", "name"};
  columns.insert(columns.end(), level_columns().begin(), level_columns().end());
  CsvTable table(columns);
  for (std::size_t i = 0; i < report.problems.size(); ++i)
    for (const LevelResult& level : report.problems[i].levels) {
      std::vector<JsonValue> row = {i, report.problems[i].name};
      const std::vector<JsonValue> cells = level_cells(level);
      row.insert(row.end(), cells.begin(), cells.end());
      table.add(row);
    }
  return table.text();
}

std::string figure_cell(const std::optional<Approximation>& ours) {
  if (!ours || !std::isfinite(ours->value) || !std::isfinite(ours->radius)) return "--";
  constexpr int digits = 6;
  return "\\num{" + latex_number(ours->value, ours->radius, digits) + "}";
}

std::string verdicts_latex(const verification::Report& report) {
  using verification::ClaimReport;
  const bool pages = std::any_of(report.claims.begin(), report.claims.end(),
                                 [](const ClaimReport& claim) { return claim.page.has_value(); });
  const bool printed = std::any_of(report.claims.begin(), report.claims.end(),
                                   [](const ClaimReport& claim) { return claim.printed.has_value(); });
  std::vector<LatexColumn> columns = {
      {"Statement", ">{\\raggedright}p{0.42\\linewidth}"}, {"Verdict", "l"}, {"Ours", "r"}};
  if (printed) columns.push_back({"Printed", "r"});
  if (pages) columns.push_back({"Page", "r"});
  LatexTable table(std::move(columns), true);
  for (const ClaimReport& claim : report.claims) {
    std::vector<std::string> row = {latex_escaped(claim.paper + "/" + claim.label),
                                    std::string(name(claim.found)) + (claim.as_recorded() ? "" : " (!)"),
                                    figure_cell(claim.ours)};
    if (printed) row.push_back(claim.printed ? latex_escaped(*claim.printed) : "--");
    if (pages) row.push_back(claim.page ? std::to_string(*claim.page) : "--");
    table.add(row);
  }
  return table.text();
}

}  // namespace

Files verify_files(const verification::Report& report, const std::filesystem::path& folder) {
  Files files = {{folder / "errors.csv", problem_levels_csv(report)},
                 {folder / "table.tex", verdicts_latex(report)}};
  std::vector<NamedPlot> plots;
  for (std::size_t i = 0; i < report.problems.size(); ++i) {
    const verification::ProblemTrace& problem = report.problems[i];
    Plot plot = convergence_plot(problem.name,
                                 {.name = problem.name, .levels = problem.levels, .orders = problem.orders});
    if (!plot.curves.empty()) plots.push_back({"errors_of_problem_" + std::to_string(i), std::move(plot)});
  }
  for (auto& file : plot_files(folder, plots)) files.push_back(std::move(file));
  return files;
}

}  // namespace radcert::app
