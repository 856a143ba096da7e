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

/// The rows of a file of points, one a point.
class PointRows {
public:
  explicit PointRows(std::string_view text) : rows_(text), head_(rows_.next()) {}
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const {
    return csv_column(head_, name);
  }
  /// InputError for a row of another length, for a point too many, and where there is none.
  std::optional<std::vector<std::string>> next() {
    auto row = rows_.next();
    if (!row) {
      if (count_ > 0) return row;
      throw InputError(
          {.pointer = line_text(1), .problem = "is followed by no point", .allowed = "a line a point"});
    }
    require_cells(*row, head_->size(), rows_.line());
    if (count_++ == most_points)
      throw InputError({.pointer = line_text(rows_.line()),
                        .problem = "is one point too many",
                        .allowed = "at most " + std::to_string(most_points) + " points"});
    return row;
  }
  [[nodiscard]] std::size_t line() const { return rows_.line(); }
  [[noreturn]] static void refuse_columns(const std::string& allowed) {
    throw InputError(
        {.pointer = line_text(1), .problem = "has not the columns of a file of points", .allowed = allowed});
  }

private:
  CsvRows rows_;
  std::optional<std::vector<std::string>> head_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<AskedPoint> read_points(std::string_view text) {
  PointRows rows(text);
  const auto s = rows.column("s");
  const auto t = rows.column("t");
  const auto chart = rows.column("chart");
  const auto piece = rows.column("piece");
  const auto x = rows.column("x");
  const auto y = rows.column("y");
  const auto z = rows.column("z");
  const bool by_parameters = s && t && (chart || piece);
  if (!by_parameters && !(x && y && z)) PointRows::refuse_columns("x, y, z; or piece, s, t; or chart, s, t");
  std::vector<AskedPoint> out;
  while (const auto row = rows.next()) {
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
  return out;
}

std::vector<Vector<Rational>> read_exact_points(std::string_view text) {
  PointRows rows(text);
  const auto x = rows.column("x");
  const auto y = rows.column("y");
  const auto z = rows.column("z");
  if (!(x && y && z)) PointRows::refuse_columns("x, y, z");
  std::vector<Vector<Rational>> out;
  while (const auto row = rows.next()) {
    const auto coordinate = [&](std::size_t place) {
      Outcome<Rational> number = Rational::parse((*row)[place]);
      if (!number)
        throw InputError({.pointer = line_text(rows.line()),
                          .value = (*row)[place],
                          .problem = number.reason(),
                          .allowed = "decimals or fractions"});
      return std::move(number).value();
    };
    out.push_back({coordinate(*x), coordinate(*y), coordinate(*z)});
  }
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
