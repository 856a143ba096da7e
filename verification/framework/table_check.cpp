// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/table_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/triangulation/triangulation.h"
#include "verification/framework/cell.h"
#include "verification/framework/reading/printed_table.h"

namespace radcert::verification {
namespace {

// One cell of the printed table.
struct Cell {
  std::string label;
  std::string figure;
  PrintedNumber printed;
  std::size_t row = 0;  // of its series
};

// The rows of one series with their cells, and the problem behind them.
struct Series {
  const TableSeries* declared;
  Problem problem;
  Problem control;
  std::vector<std::string> elements;  // by row, as printed
  std::vector<int> levels;            // by row
  std::vector<Cell> cells;
};

bool is_ratio(const std::string& figure) { return figure.ends_with("_ratio"); }
std::string error_of(const std::string& figure) {
  return is_ratio(figure) ? figure.substr(0, figure.size() - std::string("ratio").size()) + "error" : figure;
}

std::size_t required_column(const PrintedTable& table, const std::string& name, const std::string& source) {
  const std::optional<std::size_t> column = table.column(name);
  if (column) return *column;
  std::string names;
  for (const std::string& each : table.columns) names += (names.empty() ? "" : ", ") + each;
  throw InputError(
      {.source = source, .value = name, .problem = "is no column of the table", .allowed = names});
}

std::vector<Cell> cells_of(const PrintedTable& table, const TableSeries& declared, const TableClaim& claim,
                           const std::string& label, const std::string& source,
                           std::vector<std::string>& elements) {
  const std::size_t rows = required_column(table, claim.rows, source);
  std::vector<Cell> cells;
  for (const PrintedTable::Row& row : table.rows) {
    const bool belongs =
        std::all_of(declared.where.begin(), declared.where.end(), [&](const auto& condition) {
          return row.cells[required_column(table, condition.first, source)] == condition.second;
        });
    if (!belongs) continue;
    const std::string& n = row.cells[rows];
    for (const FigureColumn& figure : declared.figures) {
      const std::string& text = row.cells[required_column(table, figure.column, source)];
      if (text.empty()) continue;
      const Outcome<PrintedNumber> printed = parse_printed(text);
      if (!printed)
        throw InputError({.source = source + ", line " + std::to_string(row.line),
                          .pointer = "/" + figure.column,
                          .value = text,
                          .problem = "is no number",
                          .allowed = "digits as printed, as in 1.48E-3"});
      cells.push_back({.label = label + (declared.name.empty() ? "" : "." + declared.name) + ".n" + n + "." +
                                figure.figure,
                       .figure = figure.figure,
                       .printed = *printed,
                       .row = elements.size()});
    }
    elements.push_back(n);
  }
  if (elements.empty())
    throw InputError({.source = source,
                      .problem = "has no row of the series " + quotation(declared.name),
                      .allowed = "rows with the texts that `where` names"});
  return cells;
}

const CellRecord* record_of(const TableClaim& claim, const std::string& label) {
  for (const CellRecord& record : claim.cells)
    if (record.label == label) return &record;
  return nullptr;
}

// The printed numbers of all series, held against the records in both directions.
std::vector<Series> printed_series(const Paper& paper, const Claim& claim) {
  const TableClaim& table = claim.table.value();
  const std::string source = paper.source(table.file);
  const PrintedTable printed = parse_printed_table(paper.file(table.file), source);
  const std::string claims = paper.source("claims.toml");
  std::vector<Series> all;
  std::vector<std::string> labels;
  for (const TableSeries& declared : table.series) {
    Series series{
        .declared = &declared, .problem = {}, .control = {}, .elements = {}, .levels = {}, .cells = {}};
    series.cells = cells_of(printed, declared, table, claim.label, source, series.elements);
    for (const Cell& cell : series.cells) {
      if (record_of(table, cell.label) == nullptr)
        throw InputError({.source = claims + ", line " + std::to_string(claim.line),
                          .pointer = "/" + cell.label,
                          .problem = "is missing",
                          .allowed = "a verdict for every cell that the table prints"});
      if (std::find(labels.begin(), labels.end(), cell.label) != labels.end())
        throw InputError({.source = claims + ", line " + std::to_string(declared.line),
                          .pointer = "/" + cell.label,
                          .problem = "is the label of two cells",
                          .allowed = "series with names of their own"});
      labels.push_back(cell.label);
    }
    all.push_back(std::move(series));
  }
  for (const CellRecord& record : table.cells)
    if (std::find(labels.begin(), labels.end(), record.label) == labels.end())
      throw InputError({.source = claims + ", line " + std::to_string(record.line),
                        .pointer = "/" + record.label,
                        .problem = "is a verdict for a cell that the table does not print",
                        .allowed = "the cells of " + source});
  return all;
}

// The level of each row: the one that has so many elements.
void read_problems(const Paper& paper, Series& series) {
  const std::string source = paper.source(series.declared->problem);
  series.problem = parse_problem(paper.file(series.declared->problem), source);
  series.control =
      parse_problem(paper.file(series.declared->control), paper.source(series.declared->control));
  if (!series.problem.solution || !series.control.solution)
    throw InputError({.source = source,
                      .pointer = "/solution",
                      .problem = "is missing",
                      .allowed = "a problem whose errors can be known"});
  const Surface surface = surface_of(series.problem);
  for (const std::string& elements : series.elements) {
    const auto level = std::find_if(series.problem.triangulation.levels.begin(),
                                    series.problem.triangulation.levels.end(), [&](int each) {
                                      const std::optional<std::uint64_t> count =
                                          triangle_count(surface, each);
                                      return count && std::to_string(*count) == elements;
                                    });
    if (level == series.problem.triangulation.levels.end())
      throw InputError({.source = source,
                        .pointer = "/triangulation/levels",
                        .problem = "has no level of " + elements + " elements",
                        .allowed = "a level for each row of the table"});
    series.levels.push_back(*level);
  }
  for (const int level : series.control.triangulation.levels)
    if (std::find(series.levels.begin(), series.levels.end(), level) == series.levels.end())
      throw InputError({.source = paper.source(series.declared->control),
                        .pointer = "/triangulation/levels",
                        .value = std::to_string(level),
                        .problem = "is no level of the table",
                        .allowed = "levels that the table prints"});
}

Approximation or_unknown(const std::optional<Approximation>& figure) {
  return figure.value_or(Approximation::without_radius(std::numeric_limits<double>::quiet_NaN()));
}

Approximation error_figure(const LevelResult& result, const std::string& error) {
  return or_unknown(error == "node_error" ? result.node_error : result.discretisation_error);
}

Verdict verdict_of(const PrintedNumber& printed, const Approximation& ours) {
  if (!std::isfinite(ours.value) || !std::isfinite(ours.radius)) return Verdict::undecided;
  return decide(printed, ours.value, ours.radius, ours.guaranteed);
}

// The solved levels of one problem, each asked for once; those of up to `proved_elements` elements with a
// proof.
class Errors {
public:
  Errors(const Problem& problem, LevelSource& levels, int proved_elements)
      : problem_(problem), proved_(problem), levels_(&levels) {
    proved_.solver = {.name = "verified", .tolerance = std::nullopt};
    // Of numbers of order 1: beyond the third digit of errors of 1e-8, the least that the tables print.
    const Rational enough = Rational(1) / power(Rational(10), 11);
    proved_.quadrature.tolerance = std::max(proved_.quadrature.tolerance, enough);
    const Surface surface = surface_of(problem);
    for (const int level : problem.triangulation.levels)
      if (triangle_count(surface, level).value() <= static_cast<std::uint64_t>(proved_elements))
        proved_levels_.insert(level);
  }
  Approximation at(int level, const std::string& error) {
    auto found = results_.find(level);
    if (found == results_.end()) {
      const Problem& problem = proved_levels_.contains(level) ? proved_ : problem_;
      found = results_.emplace(level, levels_->level(problem, level).result).first;
    }
    return error_figure(found->second, error);
  }

private:
  Problem problem_;
  Problem proved_;
  LevelSource* levels_;
  std::set<int> proved_levels_;
  std::map<int, LevelResult> results_;
};

std::string allowed_text(const PrintedNumber& printed) {
  return printed.text + " +- " + nearest_text(printed.half_unit, DecimalForm::general(1));
}

Evidence control_evidence(const Series& series, const Bench& bench) {
  Errors errors(series.control, bench.levels, series.declared->verified.at(bench.budget));
  Evidence evidence{.what = "a problem that is not the table's: no printed error contradicted",
                    .value = "",
                    .radius = std::nullopt,
                    .allowed = "at least one contradicted",
                    .standing = Standing::holds,
                    .role = Role::control,
                    .proved = false};
  for (const Cell& cell : series.cells) {
    const int level = series.levels[cell.row];
    const std::vector<int>& controlled = series.control.triangulation.levels;
    if (is_ratio(cell.figure) || std::find(controlled.begin(), controlled.end(), level) == controlled.end())
      continue;
    const Approximation other = errors.at(level, cell.figure);
    if (verdict_of(cell.printed, other) != Verdict::contradicted) continue;
    const EnclosingText text = enclosing_text(other.value, other.radius, DecimalForm::scientific(4));
    evidence.what = "control: a problem that is not the table's, n = " + series.elements[cell.row];
    evidence.value = text.value;
    evidence.radius = text.radius;
    evidence.allowed = allowed_text(cell.printed);
    evidence.standing = Standing::violated;
    break;
  }
  return evidence;
}

Standing standing_of(Verdict verdict) {
  if (verdict == Verdict::contradicted) return Standing::violated;
  return verdict == Verdict::undecided ? Standing::open : Standing::holds;
}

// Ours against a figure by other means. Both radii are estimates: agreement is asked for within their sum.
Evidence second_evidence(const Approximation& ours, const Approximation& other, const std::string& what) {
  Evidence evidence{.what = what,
                    .value = shortest(other.value),
                    .radius = std::nullopt,
                    .allowed = "",
                    .standing = Standing::open,
                    .role = Role::requirement,
                    .proved = false};
  if (!std::isfinite(other.value) || !std::isfinite(other.radius) || !std::isfinite(ours.value) ||
      !std::isfinite(ours.radius))
    return evidence;
  const EnclosingText text = enclosing_text(other.value, other.radius, DecimalForm::scientific(9));
  evidence.value = text.value;
  evidence.radius = text.radius;
  const EnclosingText mine = enclosing_text(ours.value, ours.radius, DecimalForm::scientific(9));
  evidence.allowed = "agrees with " + mine.value + " +- " + mine.radius;
  if (std::abs(ours.value - other.value) <= ours.radius + other.radius) evidence.standing = Standing::holds;
  return evidence;
}

}  // namespace

Approximation ratio(const Approximation& numerator, const Approximation& denominator) {
  Approximation out{.value = numerator.value / denominator.value,
                    .radius = std::numeric_limits<double>::infinity(),
                    .guaranteed = numerator.guaranteed && denominator.guaranteed};
  const double least = std::abs(denominator.value) - denominator.radius;
  if (!std::isfinite(out.value) || !(least > 0) || !std::isfinite(numerator.radius)) return out;
  // |a'/b' - a/b| <= (ra + |a/b| rb) / (|b| - rb); a few roundings are far below the factor.
  constexpr double above_rounding = 1 + 1e-14;
  out.radius = ((numerator.radius + std::abs(out.value) * denominator.radius) / least) * above_rounding +
               std::abs(out.value) * std::numeric_limits<double>::epsilon();
  return out;
}

std::vector<std::string> cell_labels(const Paper& paper, const Claim& claim) {
  std::vector<std::string> labels;
  for (const Series& series : printed_series(paper, claim))
    for (const Cell& cell : series.cells) labels.push_back(cell.label);
  return labels;
}

std::vector<ClaimReport> check_table(const Paper& paper, const Claim& claim, const Bench& bench,
                                     const SecondRoute& second_route,
                                     const std::function<bool(const std::string& label)>& wanted,
                                     const std::function<void(const std::string& label)>& starting) {
  using Clock = std::chrono::steady_clock;
  std::vector<Series> all = printed_series(paper, claim);
  for (Series& series : all) read_problems(paper, series);
  std::vector<ClaimReport> reports;
  for (const Series& series : all) {
    if (std::none_of(series.cells.begin(), series.cells.end(),
                     [&](const Cell& cell) { return wanted(cell.label); }))
      continue;
    Errors errors(series.problem, bench.levels, series.declared->verified.at(bench.budget));
    std::optional<Evidence> control;
    for (const Cell& cell : series.cells) {
      if (!wanted(cell.label)) continue;
      if (starting) starting(cell.label);
      const auto start = Clock::now();
      const CellRecord& record = *record_of(*claim.table, cell.label);
      ClaimReport report{.paper = paper.key,
                         .label = cell.label,
                         .says = claim.says,
                         .covers = claim.covers,
                         .page = claim.page,
                         .needs = claim.needs,
                         .recorded = record.verdict.at(bench.budget),
                         .ours = std::nullopt,
                         .printed = cell.printed.text,
                         .note = record.note,
                         .evidence = {},
                         .remarks = {},
                         .failure = std::nullopt};
      const std::string error = error_of(cell.figure);
      // The figure of this cell by some means: an error at its level, or the ratio of two.
      const auto figure_by = [&](auto&& error_at) -> Approximation {
        const Approximation here = error_at(series.levels[cell.row]);
        if (!is_ratio(cell.figure)) return here;
        if (cell.row == 0) return or_unknown(std::nullopt);
        return ratio(error_at(series.levels[cell.row - 1]), here);
      };
      const Approximation ours = figure_by([&](int level) { return errors.at(level, error); });
      if (!control) control = control_evidence(series, bench);
      report.found = verdict_of(cell.printed, ours);
      Evidence own{.what = ours.guaranteed ? "enclosed by the pipeline" : "by the pipeline",
                   .value = shortest(ours.value),
                   .radius = std::nullopt,
                   .allowed = allowed_text(cell.printed),
                   .standing = standing_of(report.found),
                   .role = Role::requirement,
                   .proved = ours.guaranteed};
      if (std::isfinite(ours.value) && std::isfinite(ours.radius)) {
        report.ours = ours;
        const EnclosingText text = enclosing_text(ours.value, ours.radius, DecimalForm::scientific(9));
        own.value = text.value;
        own.radius = text.radius;
      }
      report.evidence.push_back(std::move(own));
      if (record.second_route) {
        if (!second_route) {
          report.found = Verdict::failed;
          report.failure = "a second route is asked for, and this paper has none";
        } else {
          const Approximation other =
              figure_by([&](int level) { return second_route(bench, series.problem, level, error); });
          report.evidence.push_back(second_evidence(ours, other, "by a second route"));
          // Two computations that disagree, or of which one alone settles the cell, settle nothing.
          if (report.evidence.back().standing != Standing::holds ||
              standing_of(verdict_of(cell.printed, other)) != standing_of(report.found))
            report.found = Verdict::undecided;
        }
      }
      report.evidence.push_back(*control);
      if (control->standing != Standing::violated) {
        report.found = Verdict::failed;
        report.failure = "the control was not rejected";
      }
      report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
      reports.push_back(std::move(report));
    }
  }
  return reports;
}

}  // namespace radcert::verification
