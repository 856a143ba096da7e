// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/csv.h"

#include <array>
#include <vector>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

std::string quoted_cell(std::string_view cell) {
  if (cell.find_first_of("\",\r\n") == std::string_view::npos) return std::string(cell);
  std::string out = "\"";
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

std::string cell_text(const JsonValue& cell) {
  expects(cell.elements() == nullptr && cell.members() == nullptr, "a cell is a scalar",
          named("kind", cell.kind()));
  if (cell.is_null()) return {};
  return cell.string() != nullptr ? quoted_cell(*cell.string()) : cell.compact();
}

void push(std::vector<JsonValue>& row, const std::optional<Approximation>& figure) {
  if (!figure) {
    row.resize(row.size() + 3);
    return;
  }
  row.emplace_back(figure->value);
  row.push_back(finite_or_null(figure->radius));
  row.emplace_back(figure->guaranteed);
}

}  // namespace

CsvTable::CsvTable(std::span<const std::string_view> columns) : columns_(columns.size()) {
  std::vector<JsonValue> names(columns.begin(), columns.end());
  add(names);
}

void CsvTable::add(std::span<const JsonValue> row) {
  expects(row.size() == columns_ && columns_ > 0, "as many cells as columns", named("cells", row.size()),
          named("columns", columns_));
  std::string_view before;
  for (const JsonValue& cell : row) {
    text_ += before;
    text_ += cell_text(cell);
    before = ",";
  }
  text_ += "\r\n";
}

std::string nodes_csv(std::span<const LevelOutcome> levels) {
  static constexpr std::array<std::string_view, 14> columns = {
      "level",    "piece",    "element",  "node", "x",      "y", "z",
      "normal_x", "normal_y", "normal_z", "u_n",  "radius", "u", "emission"};
  CsvTable table(columns);
  for (const LevelOutcome& level : levels)
    for (const NodeValue& node : level.nodes) {
      const JsonValue proved_radius = node.u_n.guaranteed ? JsonValue(node.u_n.radius) : JsonValue();
      const std::array<JsonValue, columns.size()> row = {
          level.result.level, node.piece,    node.element,  node.index_in_element, node.point.x,
          node.point.y,       node.point.z,  node.normal.x, node.normal.y,         node.normal.z,
          node.u_n.value,     proved_radius, node.u,        node.emission};
      table.add(row);
    }
  return table.text();
}

std::string enclosure_csv(const SolutionEnclosure& enclosure) {
  std::vector<std::string_view> columns{"piece", "x", "y", "z", "radiosity", "radius"};
  const bool has_emissions = !enclosure.emissions.empty();
  if (has_emissions) columns.emplace_back("emission");
  CsvTable table(columns);
  const auto add = [&](const std::string& piece, const Vector<double>& at, double value, double radius,
                       const std::string& emission = "") {
    std::vector<JsonValue> row{piece, at.x, at.y, at.z, value, radius};
    if (has_emissions) row.emplace_back(emission);
    table.add(row);
  };
  const auto add_values = [&](const std::vector<EnclosedValue>& points, const std::string& emission) {
    for (const EnclosedValue& point : points)
      add(point.piece, {point.at.x.to_double(), point.at.y.to_double(), point.at.z.to_double()},
          point.value.value, point.value.radius, emission);
  };
  add_values(enclosure.points, "");
  for (const SolutionEnclosure::OfEmission& further : enclosure.emissions)
    add_values(further.points, further.emission);
  for (const EnclosedPatch& patch : enclosure.patches)
    for (std::size_t k = 0; k < patch.corners.size(); ++k)
      add(patch.piece, patch.corners[k], patch.values[k], patch.bound);
  return table.text();
}

std::span<const std::string_view> level_columns() {
  static constexpr std::array<std::string_view, 41> columns = {"level",
                                                               "elements",
                                                               "unknowns",
                                                               "mesh_size",
                                                               "discretisation_error",
                                                               "discretisation_error_radius",
                                                               "discretisation_error_guaranteed",
                                                               "node_error",
                                                               "node_error_radius",
                                                               "node_error_guaranteed",
                                                               "uniform_error",
                                                               "uniform_error_radius",
                                                               "uniform_error_guaranteed",
                                                               "discretisation_ratio",
                                                               "node_ratio",
                                                               "discretisation_order",
                                                               "node_order",
                                                               "norm_k",
                                                               "norm_k_guaranteed",
                                                               "planned_bytes",
                                                               "norm_k_radius",
                                                               "iterated_error",
                                                               "iterated_error_radius",
                                                               "iterated_error_guaranteed",
                                                               "iterated_order",
                                                               "u_n_error",
                                                               "u_n_error_radius",
                                                               "u_n_error_guaranteed",
                                                               "u_n_order",
                                                               "iterated_node_error",
                                                               "iterated_node_error_radius",
                                                               "iterated_node_error_guaranteed",
                                                               "check_points",
                                                               "l2_error",
                                                               "l2_error_radius",
                                                               "l2_error_guaranteed",
                                                               "mean_error",
                                                               "mean_error_radius",
                                                               "mean_error_guaranteed",
                                                               "iterated_l2_error",
                                                               "iterated_mean_error"};
  return columns;
}

std::vector<JsonValue> level_cells(const LevelResult& level) {
  std::vector<JsonValue> row = {level.level, level.elements, level.unknowns, level.mesh_size};
  push(row, level.discretisation_error);
  push(row, level.node_error);
  push(row, level.uniform_error);
  for (const auto& number :
       {level.discretisation_ratio, level.node_ratio, level.discretisation_order, level.node_order})
    row.push_back(finite_or_null(number));
  row.emplace_back(level.norm_K.value);
  row.emplace_back(level.norm_K.guaranteed);
  row.emplace_back(level.planned_bytes);
  row.push_back(finite_or_null(level.norm_K.radius));
  const IteratedReport iterated = level.iterated.value_or(IteratedReport{});
  push(row, level.iterated_error);
  row.push_back(finite_or_null(iterated.order));
  push(row, iterated.u_n_error);
  row.push_back(finite_or_null(iterated.u_n_order));
  push(row, iterated.node_error);
  row.push_back(level.iterated ? JsonValue(iterated.check_points) : JsonValue());
  push(row, level.l2_error);
  push(row, level.mean_error);
  for (const auto& number : {iterated.l2_error, iterated.mean_error}) row.push_back(finite_or_null(number));
  return row;
}

std::string errors_csv(const Result& result) {
  CsvTable table(level_columns());
  for (const LevelResult& level : result.levels) table.add(level_cells(level));
  return table.text();
}

}  // namespace radcert
