// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/reference_json.h"

#include <array>
#include <cmath>
#include <string_view>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/csv.h"

namespace radcert {

namespace {

/// The digits before the point of numbers in the ball, at least 1; for numbers below 1 as if they were 1.
int whole_digits(const Ball& value) {
  const double size = std::max(std::abs(value.lower_double()), std::abs(value.upper_double()));
  return size < 10 ? 1 : 1 + static_cast<int>(std::floor(std::log10(size)));
}

JsonValue binary_json(const BinaryNumber& number) {
  return JsonValue::object({{"mantissa", number.mantissa}, {"exponent", number.exponent}});
}

/// Mantissa and exponent as one cell, "m*2^e".
std::string binary_text(const BinaryNumber& number) { return number.mantissa + "*2^" + number.exponent; }

std::string parameters_text(const ReferenceRecord& record) {
  std::string text;
  for (const auto& [name, value] : record.parameters) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

}  // namespace

BallDecimal reference_decimal(const Ball& value, int digits) {
  expects(digits >= 1, "digits >= 1", named("digits", digits));
  // Two digits more than asked for: rounding the midpoint adds half a unit of the last one.
  return value.decimal(digits + whole_digits(value) + 2);
}

JsonValue reference_json(const ReferenceRecord& record, const std::string& command) {
  expects(!record.routes.empty(), "at least one route", named("name", record.name));
  const Ball& value = record.routes.front().value;
  const BallDecimal decimal = reference_decimal(value, record.digits);
  JsonValue out = document_head("reference", command);
  out.set("name", record.name);
  JsonValue parameters = JsonValue::object();
  for (const auto& [name, text] : record.parameters) parameters.set(name, text);
  out.set("parameters", std::move(parameters));
  out.set("digits", record.digits);
  out.set("midpoint", decimal.midpoint);
  out.set("radius", decimal.radius);
  out.set("guaranteed", record.guaranteed);
  out.set("formula", record.formula);
  out.set("source", record.source);
  out.set("routes", json_array(record.routes, [](const ReferenceRoute& route) { return route.how; }));
  out.set("precision_bits", value.is_exact() ? JsonValue() : JsonValue(value.accurate_bits()));
  out.set("midpoint_binary", binary_json(value.midpoint_binary()));
  out.set("radius_binary", binary_json(value.radius_binary()));
  out.set("route_values", json_array(record.routes, [&record](const ReferenceRoute& route) {
            const BallDecimal found = reference_decimal(route.value, record.digits);
            JsonValue entry = JsonValue::object(
                {{"route", route.how}, {"midpoint", found.midpoint}, {"radius", found.radius}});
            if (!route.certificate.empty()) entry.set("certificate", route.certificate);
            return entry;
          }));
  return out;
}

JsonValue references_json(std::span<const ReferenceRecord> records, const std::string& command) {
  JsonValue out = document_head("references", command);
  out.set("values", json_array(records, [&command](const ReferenceRecord& record) {
            return reference_json(record, command);
          }));
  return out;
}

std::string reference_csv(std::span<const ReferenceRecord> records) {
  static constexpr std::array<std::string_view, 11> columns = {
      "name",           "parameters",   "digits",  "midpoint", "radius",     "guaranteed",
      "midpoint_exact", "radius_exact", "formula", "source",   "first_route"};
  CsvTable table(columns);
  for (const ReferenceRecord& record : records) {
    const Ball& value = record.routes.front().value;
    const BallDecimal decimal = reference_decimal(value, record.digits);
    const std::array<JsonValue, columns.size()> row = {record.name,
                                                       parameters_text(record),
                                                       record.digits,
                                                       decimal.midpoint,
                                                       decimal.radius,
                                                       record.guaranteed,
                                                       binary_text(value.midpoint_binary()),
                                                       binary_text(value.radius_binary()),
                                                       record.formula,
                                                       record.source,
                                                       record.routes.front().how};
    table.add(row);
  }
  return table.text();
}

}  // namespace radcert
