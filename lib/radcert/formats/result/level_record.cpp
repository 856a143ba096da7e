// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/level_record.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/result_json.h"

namespace radcert {

namespace {

constexpr std::size_t node_columns = 14;
constexpr std::size_t element_columns = 16;
constexpr std::size_t mean_columns = 4;

void push(JsonValue& row, const Vector<double>& v) {
  row.push(v.x);
  row.push(v.y);
  row.push(v.z);
}

// An infinite radius is null.
void push(JsonValue& row, const Approximation& number) {
  row.push(number.value);
  row.push(finite_or_null(number.radius));
  row.push(number.guaranteed);
}

JsonValue mean_row(const std::pair<std::string, Approximation>& mean) {
  JsonValue row = JsonValue::array();
  row.push(mean.first);
  push(row, mean.second);
  return row;
}

JsonValue node_row(const NodeValue& node) {
  JsonValue row = JsonValue::array();
  row.push(node.piece);
  row.push(node.element);
  row.push(node.index_in_element);
  push(row, node.point);
  push(row, node.normal);
  push(row, node.u_n);
  row.push(node.emission);
  row.push(node.u);
  return row;
}

JsonValue element_row(const ElementValue& element) {
  JsonValue row = JsonValue::array();
  row.push(element.piece);
  for (const Vector<double>& corner : element.corners) push(row, corner);
  for (const double value : element.corner_values) row.push(value);
  for (std::size_t c = 0; c < 3; ++c)
    row.push(element.iterated ? JsonValue((*element.iterated)[c]) : JsonValue());
  return row;
}

/// Reads the cells of a row one after the other.
class Row {
public:
  Row(const JsonReader& row, std::size_t columns) : row_(row), cells_(row.elements("a row")) {
    if (cells_.size() != columns) row_.refuse("has another length", std::to_string(columns) + " cells");
  }
  std::string text() { return next().string("text"); }
  std::size_t index() { return next().unsigned_whole("an index"); }
  double number() { return next().number("a number"); }
  std::optional<double> number_or_null() {
    const JsonReader cell = next();
    if (cell.value().is_null()) return std::nullopt;
    return cell.number("a number");
  }
  Vector<double> vector() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  Approximation approximation() {
    const double value = number();
    const double radius = number_or_null().value_or(std::numeric_limits<double>::infinity());
    return {.value = value, .radius = radius, .guaranteed = next().boolean("a truth value")};
  }

private:
  JsonReader next() { return cells_[place_++]; }
  JsonReader row_;
  std::vector<JsonReader> cells_;
  std::size_t place_ = 0;
};

NodeValue read_node(const JsonReader& reader) {
  Row row(reader, node_columns);
  NodeValue node;
  node.piece = row.text();
  node.element = row.index();
  node.index_in_element = row.index();
  node.point = row.vector();
  node.normal = row.vector();
  node.u_n = row.approximation();
  node.emission = row.number();
  node.u = row.number_or_null();
  return node;
}

ElementValue read_element(const JsonReader& reader) {
  Row row(reader, element_columns);
  ElementValue element;
  element.piece = row.text();
  for (Vector<double>& corner : element.corners) corner = row.vector();
  for (double& value : element.corner_values) value = row.number();
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<double> value = row.number_or_null();
    if (!value) continue;
    if (!element.iterated) element.iterated.emplace();
    (*element.iterated)[c] = *value;
  }
  return element;
}

double number_at(const JsonReader& object, std::string_view key) {
  return object.at(key, "a number").number("a number");
}

std::optional<double> number_or_null_at(const JsonReader& object, std::string_view key) {
  const JsonReader place = object.at(key, "a number or null");
  if (place.value().is_null()) return std::nullopt;
  return place.number("a number or null");
}

Approximation read_approximation(const JsonReader& number) {
  return {.value = number_at(number, "value"),
          .radius = number_or_null_at(number, "radius").value_or(std::numeric_limits<double>::infinity()),
          .guaranteed = number.at("guaranteed", "a truth value").boolean("a truth value")};
}

std::optional<Approximation> read_figure(const JsonReader& figure) {
  if (figure.value().is_null()) return std::nullopt;
  return read_approximation(figure);
}

std::optional<IterationReport> read_iteration(const JsonReader& iteration) {
  if (iteration.value().is_null()) return std::nullopt;
  return IterationReport{.iterations = iteration.at("iterations", "a number").unsigned_whole("a number"),
                         .contraction = number_at(iteration, "contraction"),
                         .error_bound = number_at(iteration, "error_bound")};
}

std::pair<std::string, Approximation> read_mean(const JsonReader& reader) {
  Row row(reader, mean_columns);
  std::string piece = row.text();
  return {std::move(piece), row.approximation()};
}

std::optional<VerifiedReport> read_verified(const JsonReader& verified) {
  if (verified.value().is_null()) return std::nullopt;
  return VerifiedReport{.theta = number_at(verified, "theta")};
}

void read_iterated(const JsonReader& iterated, LevelResult& level) {
  if (iterated.value().is_null()) return;
  level.iterated_error = read_figure(iterated.at("error", "a figure"));
  level.iterated = {.check_points = iterated.at("check_points", "a number").unsigned_whole("a number"),
                    .u_n_error = read_figure(iterated.at("u_n_error", "a figure")),
                    .node_error = read_figure(iterated.at("node_error", "a figure")),
                    .difference = read_approximation(iterated.at("difference", "a figure")),
                    .l2_error = number_or_null_at(iterated, "l2_error"),
                    .mean_error = number_or_null_at(iterated, "mean_error"),
                    .ratio = number_or_null_at(iterated, "ratio"),
                    .u_n_ratio = number_or_null_at(iterated, "u_n_ratio"),
                    .order = number_or_null_at(iterated, "order"),
                    .u_n_order = number_or_null_at(iterated, "u_n_order")};
  for (const auto& [piece, mean] : iterated.at("piece_means", "an object").members("an object"))
    level.iterated->piece_means.emplace_back(piece, mean.number("a number"));
}

LevelResult read_level_result(const JsonReader& level) {
  LevelResult out;
  out.level = static_cast<int>(level.at("level", "a number").whole(0, 1000, "a level"));
  out.elements = level.at("elements", "a number").unsigned_whole("a number");
  out.unknowns = level.at("unknowns", "a number").unsigned_whole("a number");
  out.mesh_size = number_at(level, "mesh_size");
  out.discretisation_error = read_figure(level.at("discretisation_error", "a figure"));
  out.node_error = read_figure(level.at("node_error", "a figure"));
  out.uniform_error = read_figure(level.at("uniform_error", "a figure"));
  out.l2_error = read_figure(level.at("l2_error", "a figure"));
  out.mean_error = read_figure(level.at("mean_error", "a figure"));
  out.discretisation_ratio = number_or_null_at(level, "discretisation_ratio");
  out.node_ratio = number_or_null_at(level, "node_ratio");
  out.discretisation_order = number_or_null_at(level, "discretisation_order");
  out.node_order = number_or_null_at(level, "node_order");
  out.norm_K = read_approximation(level.at("norm_K", "a norm"));
  out.planned_bytes = level.at("planned_bytes", "a number").unsigned_whole("a number");
  out.matrix_form = level.at("operator", "a name").string("a name");
  out.solver = level.at("solver", "a name").string("a name");
  out.iteration = read_iteration(level.at("iteration", "a report or null"));
  out.verified = read_verified(level.at("verified", "a report or null"));
  out.solution_radius = number_or_null_at(level, "solution_radius");
  read_iterated(level.at("iterated", "a report or null"), out);
  return out;
}

LevelOutcome read(const JsonReader& record) {
  LevelOutcome out;
  out.result = read_level_result(record.at("result", "a level"));
  const JsonReader timing = record.at("timing", "seconds");
  out.timing.assembly_seconds = number_at(timing, "assembly_seconds");
  out.timing.operator_seconds = number_at(timing, "operator_seconds");
  out.timing.solve_seconds = number_at(timing, "solve_seconds");
  out.timing.iterated_seconds = number_at(timing, "iterated_seconds");
  for (const JsonReader& row : record.at("means", "rows").elements("rows"))
    out.result.piece_means.push_back(read_mean(row));
  for (const JsonReader& row : record.at("nodes", "rows").elements("rows"))
    out.nodes.push_back(read_node(row));
  for (const JsonReader& row : record.at("elements", "rows").elements("rows"))
    out.elements.push_back(read_element(row));
  return out;
}

}  // namespace

std::string level_record(const LevelOutcome& level) {
  JsonValue out = JsonValue::object();
  out.set("result", level_json(level.result));
  out.set("timing", timing_json(level.timing));
  out.set("means", json_array(level.result.piece_means, mean_row));
  out.set("nodes", json_array(level.nodes, node_row));
  out.set("elements", json_array(level.elements, element_row));
  return out.compact();
}

Outcome<LevelOutcome> read_level_record(std::string_view text) {
  try {
    const JsonValue document = parse_json(text, "a stored level");
    return read(JsonReader(document));
  } catch (const InputError& error) {
    return because(std::string(error.what()));
  }
}

std::string level_key(const Problem& problem, int level) {
  Problem alone = problem;
  alone.triangulation.levels = {level};
  alone.label.clear();
  alone.fit_from.reset();
  return "solve " + std::string(source_digest()) + " " + problem_json(alone).compact();
}

}  // namespace radcert
