// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/experiment_json.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/problem/problem_words.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/formats/table/csv.h"

namespace radcert {

namespace {

using Points = std::vector<CostPoint> (*)(const Result& result, const ErrorKind& kind);

/// For each question its combinations, and of each error their ranking at equal cost.
JsonValue equal_cost_json(const Experiment& experiment, std::span<const Result> results,
                          const std::string& cost_name, Points points) {
  return json_array(questions(experiment), [&](const std::vector<std::size_t>& question) {
    JsonValue out = JsonValue::object();
    out.set("combinations", json_array(question));
    for (const ErrorKind& kind : error_kinds()) {
      std::vector<std::vector<CostPoint>> methods;
      for (const std::size_t i : question) methods.push_back(points(results[i], kind));
      const auto equal = at_equal_cost(methods);
      out.set(kind.name,
              JsonValue::object(
                  {{cost_name, equal ? JsonValue(equal->cost) : JsonValue()},
                   {"ranking",
                    json_array(equal ? equal->order : std::vector<std::size_t>{}, [&](std::size_t method) {
                      return JsonValue::object(
                          {{"combination", question[method]}, {"error", equal->errors[method]}});
                    })}}));
    }
    return out;
  });
}

JsonValue choice_json(const Combination& combination) {
  JsonValue out = JsonValue::object();
  for (const auto& [key, place] : combination.choice) out.set(key, place);
  return out;
}

/// Without commas, as columns of a CSV have it.
std::string words_of(const Problem& problem, const std::string& key) {
  std::string out;
  for (const std::string& word : part_words(problem, key)) out += (out.empty() ? "" : "; ") + word;
  return out;
}

/// An expression as it is, several as JSON.
JsonValue function_cell(const PiecewiseExpression& function) {
  const JsonValue json = piecewise_json(function);
  return json.members() == nullptr ? json : JsonValue(json.compact());
}

}  // namespace

JsonValue experiment_json(const Experiment& experiment, std::span<const Result> results,
                          const std::string& command) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  JsonValue combinations = JsonValue::array();
  JsonValue seconds = JsonValue::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const JsonValue result = result_json(results[i], command);
    JsonValue entry = JsonValue::object();
    entry.set("combination", i);
    entry.set("name", experiment.combinations[i].name);
    entry.set("choice", choice_json(experiment.combinations[i]));
    for (const char* key : {"problem", "levels", "orders"}) entry.set(key, *result.find(key));
    entry.set("orders_in_unknowns", orders_json(orders_in_unknowns(results[i])));
    combinations.push(std::move(entry));
    seconds.push(JsonValue::object({{"combination", i}, {"levels", *result.find("timing")->find("levels")}}));
  }
  JsonValue timing = JsonValue::object();
  timing.set("at_equal_seconds", equal_cost_json(experiment, results, "seconds", error_against_seconds));
  timing.set("combinations", std::move(seconds));

  JsonValue out = document_head("experiment_result", command);
  out.set("name", experiment.name);
  out.set("varied", json_array(experiment.varied));
  out.set("combinations", std::move(combinations));
  out.set("at_equal_unknowns", equal_cost_json(experiment, results, "unknowns", error_against_unknowns));
  out.set("timing", std::move(timing));
  return out;
}

std::string experiment_errors_csv(const Experiment& experiment, std::span<const Result> results) {
  std::vector<std::string_view> columns = {"combination", "name",         "surface",  "triangulation",
                                           "geometry",    "basis",        "degree",   "alpha",
                                           "grading",     "reflectivity", "solution", "quadrature_tolerance",
                                           "solver"};
  columns.insert(columns.end(), level_columns().begin(), level_columns().end());
  columns.insert(columns.end(), {"fitted_discretisation_order", "fitted_discretisation_halfwidth",
                                 "fitted_node_order", "fitted_node_halfwidth"});
  CsvTable table(columns);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Problem& problem = results[i].problem;
    const TriangleBasisChoice* basis = find_triangle_basis(problem.method);
    for (const LevelResult& level : results[i].levels) {
      std::vector<JsonValue> row = {i, experiment.combinations[i].name};
      for (const char* part : {"surface", "triangulation", "geometry", "basis"})
        row.emplace_back(words_of(problem, part));
      row.push_back(basis != nullptr ? JsonValue(basis->degree) : JsonValue());
      row.push_back(basis != nullptr && basis->alpha ? JsonValue(basis->alpha->to_double()) : JsonValue());
      row.emplace_back(problem.triangulation.grading.to_double());
      row.push_back(function_cell(problem.reflectivity));
      row.push_back(problem.solution ? function_cell(*problem.solution) : JsonValue());
      row.emplace_back(problem.quadrature.tolerance.to_double());
      row.emplace_back(words_of(problem, "solver"));
      const std::vector<JsonValue> cells = level_cells(level);
      row.insert(row.end(), cells.begin(), cells.end());
      for (const OrderFit& fit : std::span(results[i].orders).first(2))
        row.insert(row.end(), {finite_or_null(fit.order), finite_or_null(fit.halfwidth)});
      table.add(row);
    }
  }
  return table.text();
}

std::string experiment_timing_csv(const Experiment& experiment, std::span<const Result> results) {
  static constexpr std::array<std::string_view, 6> columns = {
      "combination", "name", "level", "assembly_seconds", "operator_seconds", "solve_seconds"};
  CsvTable table(columns);
  for (std::size_t i = 0; i < results.size(); ++i)
    for (std::size_t k = 0; k < results[i].levels.size(); ++k) {
      const LevelTiming& timing = results[i].timing[k];
      const std::array<JsonValue, columns.size()> row = {i,
                                                         experiment.combinations[i].name,
                                                         results[i].levels[k].level,
                                                         timing.assembly_seconds,
                                                         timing.operator_seconds,
                                                         timing.solve_seconds};
      table.add(row);
    }
  return table.text();
}

}  // namespace radcert
