// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/points_csv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/csv_rows.h"

namespace radcert {

namespace {

constexpr std::size_t most_points = 1'000'000;

double finite_number(const std::string& cell, std::size_t line) {
  const double number = csv_number(cell, line);
  if (!std::isfinite(number))
    throw InputError({.pointer = line_text(line),
                      .value = cell,
                      .problem = "is not finite",
                      .allowed = "finite coordinates"});
  return number;
}

JsonValue number_json(const std::optional<Approximation>& number) {
  return number ? approximation_json(*number) : JsonValue();
}

}  // namespace

std::vector<AskedPoint> read_points(std::string_view text) {
  CsvRows rows(text);
  const auto head = rows.next();
  const auto column = [&](std::string_view name) { return csv_column(head, name); };
  const auto s = column("s");
  const auto t = column("t");
  const auto chart = column("chart");
  const auto piece = column("piece");
  const auto x = column("x");
  const auto y = column("y");
  const auto z = column("z");
  const bool by_parameters = s && t && (chart || piece);
  if (!by_parameters && !(x && y && z))
    throw InputError({.pointer = line_text(1),
                      .problem = "has not the columns of a file of points",
                      .allowed = "x, y, z; or piece, s, t; or chart, s, t"});
  std::vector<AskedPoint> out;
  while (const auto row = rows.next()) {
    require_cells(*row, head->size(), rows.line());
    if (out.size() == most_points)
      throw InputError({.pointer = line_text(rows.line()),
                        .problem = "is one point too many",
                        .allowed = "at most " + std::to_string(most_points) + " points"});
    AskedPoint asked{.where = line_text(rows.line())};
    const auto number = [&](std::size_t place) { return finite_number((*row)[place], rows.line()); };
    if (by_parameters) {
      if (chart)
        asked.chart = (*row)[*chart];
      else
        asked.piece = (*row)[*piece];
      asked.at = {number(*s), number(*t)};
    } else {
      asked.point = {number(*x), number(*y), number(*z)};
    }
    out.push_back(std::move(asked));
  }
  if (out.empty())
    throw InputError(
        {.pointer = line_text(1), .problem = "is followed by no point", .allowed = "a line a point"});
  return out;
}

std::string points_csv(std::span<const ValueAt> values) {
  static constexpr std::array<std::string_view, 15> columns = {"piece",      "chart",     "s",
                                                               "t",          "x",         "y",
                                                               "z",          "distance",  "u_n",
                                                               "u_n_radius", "iterated",  "iterated_radius",
                                                               "u",          "u_n_error", "iterated_error"};
  CsvTable table(columns);
  const auto value = [](const Approximation* number) {
    return number != nullptr ? JsonValue(number->value) : JsonValue();
  };
  for (const ValueAt& at : values) {
    const Approximation* iterated = at.iterated ? &at.iterated->value : nullptr;
    const std::array<JsonValue, columns.size()> row = {
        at.piece,
        at.chart,
        at.at.s,
        at.at.t,
        at.point.x,
        at.point.y,
        at.point.z,
        at.distance,
        at.u_n.value,
        finite_or_null(at.u_n.radius),
        value(iterated),
        iterated != nullptr ? finite_or_null(iterated->radius) : JsonValue(),
        value(at.u ? &*at.u : nullptr),
        value(at.u_n_error ? &*at.u_n_error : nullptr),
        value(at.iterated && at.iterated->error ? &*at.iterated->error : nullptr)};
    table.add(row);
  }
  return table.text();
}

JsonValue points_json(std::span<const ValueAt> values) {
  JsonValue out = JsonValue::array();
  for (const ValueAt& at : values) {
    JsonValue terms;
    if (at.iterated) {
      const IteratedValue::Terms& of = at.iterated->terms;
      terms = JsonValue::object({{"quadrature", finite_or_null(of.quadrature)},
                                 {"nodes", finite_or_null(of.nodes)},
                                 {"data", finite_or_null(of.data)},
                                 {"rounding", finite_or_null(of.rounding)}});
    }
    out.push(
        JsonValue::object({{"piece", at.piece},
                           {"chart", at.chart},
                           {"s", at.at.s},
                           {"t", at.at.t},
                           {"at", JsonValue::array({at.point.x, at.point.y, at.point.z})},
                           {"distance", at.distance},
                           {"u_n", approximation_json(at.u_n)},
                           {"iterated", at.iterated ? approximation_json(at.iterated->value) : JsonValue()},
                           {"iterated_terms", std::move(terms)},
                           {"u", number_json(at.u)},
                           {"u_n_error", number_json(at.u_n_error)},
                           {"iterated_error", at.iterated ? number_json(at.iterated->error) : JsonValue()}}));
  }
  return out;
}

}  // namespace radcert
