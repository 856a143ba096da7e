// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/scalar/ball.h"

namespace radcert {

/// One way to a reference value, and what it found.
struct ReferenceRoute {
  std::string how;
  Ball value;
  std::string certificate = {};  ///< the name of the file that proves it, where there is one
};

/// A reference value, ready to be written.
/// Maths     routes[0].value has a radius <= 10^-digits; every route's ball contains the value: proved if
///           guaranteed, else estimated
/// Requires  at least one route; balls that are finite
/// Result    plain data
struct ReferenceRecord {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< exactly, as fractions
  int digits = 0;
  std::string formula;
  std::string source;
  std::vector<ReferenceRoute> routes;
  bool guaranteed = true;
};

/// A ball in decimal, so that what is printed encloses it with a radius <= 10^-digits.
/// Maths     |midpoint text - midpoint| + radius <= radius text
/// Requires  a finite ball of radius <= 10^-digits, digits >= 1, else ContractViolation
/// Result    as many significant digits as it takes, and no more than the radius leaves a meaning
/// Limits    a ball whose radius exceeds 10^-digits / 2 may print with a larger one: leave room
[[nodiscard]] BallDecimal reference_decimal(const Ball& value, int digits);

/// A reference value as JSON.
/// Source    the file format radcert/reference/1
/// Requires  as ReferenceRecord
/// Result    midpoint and radius in decimal, rounded outwards, and exactly as mantissa 2^exponent (decimal
///           integers, as strings); the other routes' values beside; the same bits on every run, apart from
///           `command`
[[nodiscard]] JsonValue reference_json(const ReferenceRecord& record, const std::string& command);

/// Several reference values of one name as JSON.
/// Source    the file format radcert/references/1
/// Requires  as ReferenceRecord, each
/// Result    the documents of reference_json, one after the other
[[nodiscard]] JsonValue references_json(std::span<const ReferenceRecord> records, const std::string& command);

/// All values of a data set, a row each: name, parameters, digits, midpoint, radius, exact midpoint and
/// radius, formula, source, routes.
[[nodiscard]] std::string reference_csv(std::span<const ReferenceRecord> records);

}  // namespace radcert
