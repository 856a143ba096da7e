// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/collocation/solution_level.h"

namespace radcert {

/// A point at which a solution is asked for: parameters of a chart, or of the one chart of a piece, or a
/// point in space.
struct AskedPoint {
  std::string where;  ///< of it in its source: "line 3"
  std::optional<std::string> chart = std::nullopt;
  std::optional<std::string> piece = std::nullopt;
  ParameterPoint<double> at = {};  ///< with chart or piece
  Vector<double> point = {};       ///< without
};

/// The points that a CSV file asks for; its first line decides how.
/// Source    RFC 4180, the columns chart, s, t; else piece, s, t; else x, y, z; other columns are passed
///           over, so that what points_csv writes is read too
/// Result    InputError with the line for a file without such columns or without a point, for a row of
///           another length, a cell that is no finite number, and for more than a million points
[[nodiscard]] std::vector<AskedPoint> read_points(std::string_view text);

/// The points of a CSV file with the columns x, y, z, exactly: decimals or fractions.
/// Result    InputError as read_points
[[nodiscard]] std::vector<Vector<Rational>> read_exact_points(std::string_view text);

/// Values of a solution at points, as CSV.
/// Source    the columns piece, chart, s, t, x, y, z, distance, u_n, u_n_radius, iterated, iterated_radius,
///           u, u_n_error, iterated_error
/// Result    a row a point; what is not known is an empty cell. Radii are estimates but for those of a solver
///           that proves
[[nodiscard]] std::string points_csv(std::span<const ValueAt> values);

/// The same as the part `points` of radcert/solution/1.
[[nodiscard]] JsonValue points_json(std::span<const ValueAt> values);

}  // namespace radcert
