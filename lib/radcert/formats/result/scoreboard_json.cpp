// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/scoreboard_json.h"

#include <string_view>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/csv.h"

namespace radcert {

namespace {

constexpr std::size_t seconds = 2;  // of board_costs

/// Of each error, whether the point is on the frontier against each cost from `first` to before `end`.
JsonValue frontier_json(const BoardPoint& point, std::size_t first, std::size_t end) {
  JsonValue out = JsonValue::object();
  for (std::size_t error = 0; error < board_errors.size(); ++error) {
    JsonValue of_error = JsonValue::object();
    for (std::size_t cost = first; cost < end; ++cost)
      of_error.set(board_costs[cost], static_cast<bool>(point.on_frontier[error][cost]));
    out.set(board_errors[error], std::move(of_error));
  }
  return out;
}

JsonValue point_json(const BoardPoint& point) {
  JsonValue out =
      JsonValue::object({{"level", point.level}, {"unknowns", point.unknowns}, {"bytes", point.bytes}});
  for (std::size_t error = 0; error < board_errors.size(); ++error)
    out.set(board_errors[error], finite_or_null(point.errors[error]));
  out.set("frontier", frontier_json(point, 0, seconds));
  return out;
}

JsonValue timed_json(const BoardPoint& point) {
  return JsonValue::object({{"level", point.level},
                            {"seconds", point.seconds},
                            {"frontier", frontier_json(point, seconds, board_costs.size())}});
}

/// The cells of all problems, each with what `of_point` makes of its levels.
template <class OfPoint>
JsonValue cells_json(std::span<const BoardProblem> problems, bool with_refusal, const OfPoint& of_point) {
  JsonValue out = JsonValue::array();
  for (const BoardProblem& problem : problems)
    for (const BoardCell& cell : problem.cells) {
      JsonValue entry = JsonValue::object({{"problem", problem.name}, {"method", cell.method}});
      if (with_refusal) entry.set("refused", cell.refusal.empty() ? JsonValue() : JsonValue(cell.refusal));
      entry.set("levels", json_array(cell.points, of_point));
      out.push(std::move(entry));
    }
  return out;
}

}  // namespace

JsonValue scoreboard_json(std::span<const BoardProblem> problems, const std::string& command) {
  JsonValue of_problems = JsonValue::array();
  for (const BoardProblem& problem : problems)
    of_problems.push(JsonValue::object({{"name", problem.name},
                                        {"words", problem.words},
                                        {"truth", problem.truth},
                                        {"truth_radius", finite_or_null(problem.truth_radius)}}));
  JsonValue out = document_head("scoreboard", command);
  out.set("problems", std::move(of_problems));
  out.set("cells", cells_json(problems, true, point_json));
  out.set("timing", JsonValue::object({{"cells", cells_json(problems, false, timed_json)}}));
  return out;
}

std::string scoreboard_csv(std::span<const BoardProblem> problems) {
  std::vector<std::string> names = {"problem", "method", "level", "unknowns", "bytes"};
  for (const char* error : board_errors) names.emplace_back(error);
  for (const char* error : board_errors)
    for (std::size_t cost = 0; cost < seconds; ++cost)
      names.push_back(std::string(error) + "_" + board_costs[cost] + "_frontier");
  names.emplace_back("refused");
  const std::vector<std::string_view> columns(names.begin(), names.end());
  CsvTable table(columns);
  for (const BoardProblem& problem : problems)
    for (const BoardCell& cell : problem.cells) {
      if (cell.points.empty()) {
        std::vector<JsonValue> row(columns.size());
        row[0] = problem.name;
        row[1] = cell.method;
        row.back() = cell.refusal;
        table.add(row);
      }
      for (const BoardPoint& point : cell.points) {
        std::vector<JsonValue> row = {problem.name, cell.method, point.level, point.unknowns, point.bytes};
        for (const std::optional<double>& error : point.errors) row.push_back(finite_or_null(error));
        for (const auto& of_error : point.on_frontier)
          for (std::size_t cost = 0; cost < seconds; ++cost)
            row.emplace_back(static_cast<bool>(of_error[cost]));
        row.emplace_back();
        table.add(row);
      }
    }
  return table.text();
}

std::string scoreboard_timing_csv(std::span<const BoardProblem> problems) {
  std::vector<std::string> names = {"problem", "method", "level", "seconds"};
  for (const char* error : board_errors) names.push_back(std::string(error) + "_seconds_frontier");
  const std::vector<std::string_view> columns(names.begin(), names.end());
  CsvTable table(columns);
  for (const BoardProblem& problem : problems)
    for (const BoardCell& cell : problem.cells)
      for (const BoardPoint& point : cell.points) {
        std::vector<JsonValue> row = {problem.name, cell.method, point.level, point.seconds};
        for (const auto& of_error : point.on_frontier) row.emplace_back(static_cast<bool>(of_error[seconds]));
        table.add(row);
      }
  return table.text();
}

}  // namespace radcert
