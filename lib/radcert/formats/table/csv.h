// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/study/study.h"

namespace radcert {

/// A table as CSV.
/// Source    RFC 4180
/// Requires  a row has as many cells as there are columns, else ContractViolation
/// Result    one header line, lines end with CR LF, cells quoted where needed; doubles in their shortest
///           exact form, null as an empty cell
/// Limits    arrays and objects are no cells: ContractViolation
class CsvTable {
public:
  explicit CsvTable(std::span<const std::string_view> columns);
  void add(std::span<const JsonValue> row);
  [[nodiscard]] const std::string& text() const { return text_; }
  /// What has been added since the last call, the header line first: for tables that are written as they
  /// grow.
  [[nodiscard]] std::string take() { return std::exchange(text_, {}); }

private:
  std::size_t columns_;
  std::string text_;
};

/// The values at the nodes of several levels.
/// Source    the columns level, piece, element, node, x, y, z, normal_x, normal_y, normal_z, u_n, radius, u,
///           emission
/// Requires  nothing
/// Result    a row a node, in the order of the levels and of their unknowns; normals point inwards
/// Limits    `u` is empty where the problem gives no solution
std::string nodes_csv(std::span<const LevelOutcome> levels);

/// What is proved of a solution at points.
/// Maths     |u - radiosity| <= radius: at points where values are asked for; of a function at the corners of
///           its patches, where radiosity is v rounded and radius bounds |u - v|
/// Source    the columns piece, x, y, z, radiosity, radius, and where there are further emissions, emission
/// Requires  an enclosure of a function or of values
/// Result    a row a point, then those of each further emission by its name, which the problem's own has
///           none of; coordinates rounded, exact ones are in the JSON file
std::string enclosure_csv(const SolutionEnclosure& enclosure);

/// The columns of one level's figures, and the cells below them.
/// Source    the file format radcert/solution/1
/// Requires  nothing
/// Result    figures as three columns value, radius, guaranteed; piece means are left to the JSON file
/// Limits    what is null there is an empty cell
std::span<const std::string_view> level_columns();
std::vector<JsonValue> level_cells(const LevelResult& level);

/// The levels of a result, a row each, with the columns of the JSON file's levels.
/// Source    the file format radcert/solution/1
/// Requires  nothing
/// Result    the columns of level_columns
/// Limits    what is null there is empty here
std::string errors_csv(const Result& result);

}  // namespace radcert
