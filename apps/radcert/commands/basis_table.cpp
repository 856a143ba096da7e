// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/basis_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "origin.h"
#include "output.h"
#include "progress.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/interrupt.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/result/basis_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/formats/table/csv.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/study.h"
#include "radcert/triangulation/triangulation.h"
#include "records/basis_records.h"

namespace radcert::app {

namespace {

/// Of the finest level that is measured: a matrix of 160 MB.
constexpr std::uint64_t most_table_unknowns = 4608;
/// It varies as much as the degree resolves.
std::string table_solution(const std::string& degree) { return "exp(" + degree + "*(x/2 + y/4 - z/8))"; }

/// Nodes as the text of a file, and what is known of them.
struct KnownNodes {
  std::string text;
  BasisRecord record;
  std::optional<TriangleBasisChoice> basis;  ///< of a degree that problems are solved with
};

/// What the names of the files begin with.
std::string files_of(const BasisSearchOptions& search) { return symmetry_asked(search) ? "nodes" : "free"; }

std::string file_name(const BasisSearchOptions& search, int degree) {
  return files_of(search) + "_" + std::to_string(degree) + ".json";
}

KnownNodes known_nodes(std::string text, const std::string& name) {
  NodeFile file = parse_nodes(text, name);
  BasisRecord record = basis_record(name, file);
  KnownNodes nodes{.text = std::move(text), .record = std::move(record), .basis = std::nullopt};
  if (nodes.record.facts.degree <= InsetBasis<double>::largest_degree)
    nodes.basis = node_file_basis(std::move(file), name);
  return nodes;
}

bool is_better(const BasisRecord& a, const BasisRecord& b) {
  const PredictedOrders one = a.orders();
  const PredictedOrders other = b.orders();
  if (one.curved != other.curved) return one.curved > other.curved;
  if (one.curved_has_logarithm != other.curved_has_logarithm) return other.curved_has_logarithm;
  return a.facts.norm.upper < b.facts.norm.upper;
}

/// The best nodes of a degree; nothing where none are known.
std::optional<KnownNodes> best_nodes(const Common& common, const std::filesystem::path& folder, int degree,
                                     const BasisSearchOptions& search, const Outputs& outputs) {
  std::optional<KnownNodes> best;
  const auto look_at = [&](std::string text) {
    KnownNodes nodes = known_nodes(std::move(text), file_name(search, degree));
    if (!best || is_better(nodes.record, best->record)) best = std::move(nodes);
  };
  const std::filesystem::path kept = folder / file_name(search, degree);
  if (std::filesystem::exists(kept)) look_at(read_input(kept, json_size_limit).text);
  if (symmetry_asked(search) && degree <= largest_symmetric_degree)
    look_at(node_file(common, nodes_json(symmetric_nodes(degree), symmetric_radius())));
  if (!search.starts.empty())
    if (const auto found = searched_basis(common, search, degree, outputs, {}))
      look_at(node_file(common, found->nodes));
  return best;
}

/// The surfaces on which orders are measured, by their names in the columns.
std::vector<std::pair<std::string, SurfaceChoice>> table_surfaces() {
  return {{"sphere", {.name = "sphere", .parameters = {}}},
          {"ellipsoid",
           {.name = "ellipsoid", .parameters = {{"a", 1}, {"b", Rational(5, 4)}, {"c", Rational(3, 2)}}}},
          {"two_piece", {.name = "two_piece", .parameters = {{"p", 2}}}}};
}

PiecewiseExpression everywhere(const std::string& text) {
  return {.cases = {{"*", parse_expression(text).value()}}};
}

Problem table_problem(const SurfaceChoice& surface, const TriangleBasisChoice& basis) {
  Problem problem;
  problem.surface = surface;
  problem.method = Collocation{basis};
  problem.reflectivity = everywhere("1/2");
  problem.solution = everywhere(table_solution(std::to_string(basis.degree)));
  std::uint64_t unknowns = triangle_count(surface_of(problem), 0).value() * function_count(basis);
  for (int level = 0; unknowns <= most_table_unknowns; ++level, unknowns *= 4)
    problem.triangulation.levels.push_back(level);
  return problem;
}

/// The fitted order at the nodes.
OrderFit measured(const Problem& problem, std::uint64_t memory, StoredLevels& levels) {
  check(problem, memory);
  std::vector<LevelResult> results;
  std::vector<LevelTiming> timing;
  for (const int level : problem.triangulation.levels) {
    const LevelOutcome outcome = levels.level(problem, level);
    results.push_back(outcome.result);
    timing.push_back(outcome.timing);
  }
  for (const OrderFit& fit : collect(problem, std::move(results), std::move(timing)).orders)
    if (fit.quantity == "node_error") return fit;
  return {};
}

struct Row {
  KnownNodes nodes;
  std::vector<OrderFit> measured;  ///< by surface
};

std::string levels_text(const std::vector<int>& levels) {
  std::string out;
  for (const int level : levels) out += (out.empty() ? "" : " ") + std::to_string(level);
  return out;
}

std::string csv_of(const std::vector<Row>& rows, const BasisSearchOptions& search) {
  std::vector<std::string> names{"degree",      "nodes",      "precision_triangle", "precision_parallelogram",
                                 "norm_lower",  "norm_upper", "negative_weights",   "order_everywhere",
                                 "order_nodes", "logarithm",  "order_smooth_kernel"};
  for (const auto& [surface, choice] : table_surfaces())
    for (const char* column : {"_order", "_halfwidth", "_levels"}) names.push_back(surface + column);
  names.emplace_back("file");
  const std::vector<std::string_view> columns(names.begin(), names.end());
  CsvTable table(columns);
  for (const Row& row : rows) {
    const BasisFacts& facts = row.nodes.record.facts;
    const PredictedOrders orders = row.nodes.record.orders();
    const auto negative = std::count_if(facts.weights.begin(), facts.weights.end(),
                                        [](const Rational& w) { return w.sign() < 0; });
    std::vector<JsonValue> cells{facts.degree,
                                 static_cast<std::int64_t>(facts.nodes.size()),
                                 facts.triangle.degree,
                                 facts.parallelogram.degree,
                                 Ball(facts.norm.lower).lower_double(),
                                 Ball(facts.norm.upper).upper_double(),
                                 static_cast<std::int64_t>(negative),
                                 orders.everywhere,
                                 orders.curved,
                                 orders.curved_has_logarithm,
                                 orders.smooth_kernel};
    for (const OrderFit& fit : row.measured) {
      cells.push_back(finite_or_null(fit.order));
      cells.push_back(finite_or_null(fit.halfwidth));
      cells.emplace_back(levels_text(fit.levels));
    }
    cells.emplace_back(file_name(search, facts.degree));
    table.add(cells);
  }
  return table.text();
}

std::string order_cell(const OrderFit& fit) {
  if (!fit.order || !std::isfinite(*fit.order)) return "-";
  std::string out = nearest_text(*fit.order, DecimalForm::fixed(2));
  if (fit.halfwidth && std::isfinite(*fit.halfwidth))
    out += " +- " + upper_text(*fit.halfwidth, DecimalForm::fixed(2));
  return out;
}

std::string text_of(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> lines{
      {"degree", "triangle", "parallelogram", "norm of P_n", "at nodes"}};
  for (const auto& [surface, choice] : table_surfaces()) lines.front().push_back(surface);
  constexpr int digits = 6;
  for (const Row& row : rows) {
    const BasisFacts& facts = row.nodes.record.facts;
    const PredictedOrders orders = row.nodes.record.orders();
    lines.push_back({std::to_string(facts.degree), std::to_string(facts.triangle.degree),
                     std::to_string(facts.parallelogram.degree), norm_text(facts.norm, digits).value,
                     order_text(orders.curved, orders.curved_has_logarithm)});
    for (const OrderFit& fit : row.measured) lines.back().push_back(order_cell(fit));
  }
  return aligned(lines) +
         "Precision and norm are proved; orders on surfaces are fitted to max |u - u_n| over the nodes, u "
         "= " +
         table_solution("r") + ", r the degree.\nThat no nodes are better is not said.\n";
}

}  // namespace

ExitCode show_basis_table(const Common& common, const std::string& folder, int first, int last,
                          const BasisSearchOptions& search) {
  if (folder.empty())
    throw InputError({.source = "--out", .problem = "is missing", .allowed = "a folder for nodes.csv"});
  Outputs outputs(common);
  const std::string csv_name = files_of(search) + ".csv";
  std::vector<std::string> names{csv_name};
  for (int degree = first; degree <= last; ++degree) names.push_back(file_name(search, degree));
  outputs.folder("--out", folder, names);
  const auto limit = common.limit_threads();
  const std::uint64_t memory = common.memory_limit();
  ResultStore store = common.store();
  StoredLevels levels(store, solve_with(reference::applied_operator, memory));
  std::vector<Row> rows;
  std::vector<BasisRecord> records;
  Files files;
  ProgressDisplay progress(common.quiet);
  const double all = last - first + 1;
  for (int degree = first; degree <= last; ++degree) {
    throw_if_interrupted();
    const double before = (degree - first) / all;
    progress.at(before, "degree " + std::to_string(degree) + ", proof of precision and norm");
    std::optional<KnownNodes> best = best_nodes(common, folder, degree, search, outputs);
    if (!best) {
      complain("no nodes of degree " + std::to_string(degree) + " are known: --starts looks for some");
      continue;
    }
    Row row{.nodes = *std::move(best), .measured = {}};
    for (const auto& [surface, choice] : table_surfaces()) {
      progress.at(before, "degree " + std::to_string(degree) + " on " + surface);
      row.measured.push_back(
          row.nodes.basis ? measured(table_problem(choice, *row.nodes.basis), memory, levels) : OrderFit());
    }
    files.emplace_back(std::filesystem::path(folder) / file_name(search, degree), row.nodes.text);
    records.push_back(row.nodes.record);
    rows.push_back(std::move(row));
  }
  files.emplace_back(std::filesystem::path(folder) / csv_name, csv_of(rows, search));
  print_result(common, outputs, text_of(rows), basis_record_json(records, common.command).pretty() + "\n",
               std::move(files));
  return rows.size() == static_cast<std::size_t>(last - first + 1) ? ExitCode::done : ExitCode::differs;
}

}  // namespace radcert::app
