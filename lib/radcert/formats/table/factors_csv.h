// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/factors/factor_matrix.h"
#include "radcert/formats/table/csv.h"
#include "radcert/scalar/approximation.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// The factors of a matrix as CSV.
/// Source    the columns from, to, factor, radius, guaranteed
/// Requires  a name for each row
/// Result    RFC 4180; a row for each factor that is not exactly zero, in the shortest form that reads back
///           as the same double: the radius holds for that double
[[nodiscard]] std::string factors_csv(const FactorMatrix& matrix, std::span<const std::string> names);

/// The same, row by row.
class FactorsCsv {
public:
  explicit FactorsCsv(std::span<const std::string> names);
  /// The text of these factors, before the first ones the header line.
  [[nodiscard]] std::string rows(std::span<const ConfigurationFactor> factors);

private:
  std::span<const std::string> names_;
  CsvTable table_;
};

/// The rows of a matrix as CSV: the columns name, area, row_sum, row_radius, to_space, area_unit; to_space is
/// empty unless asked for, and the radius is that of both sums, the wider. area_unit is the square of the
/// unit of lengths, "mm^2", empty where it is not known.
[[nodiscard]] std::string factor_surfaces_csv(const FactorMatrix& matrix, std::span<const std::string> names,
                                              const std::optional<std::string>& unit);

/// A factor from another source, to be compared.
/// Maths     what is claimed: value +- halfwidth
/// Result    exact: value is the decimal in the file, halfwidth half a unit of its last digit. Where a radius
///           is given, halfwidth is that and what value differs by from the nearest double, since a number
///           that radcert writes means that double
struct ClaimedFactor {
  Rational value = 0;
  Rational halfwidth = 0;
  /// Value and radius in doubles, the radius so wide that all of the claim is within it.
  [[nodiscard]] Approximation in_double() const;
};

/// Factors by the names of both surfaces; what is not there is zero.
using ClaimedFactors = std::map<std::pair<std::string, std::string>, ClaimedFactor>;

/// A file of factors.
/// Source    CSV with columns from, to, factor and, if there, radius, in any order, others ignored; CSV as a
///           matrix: a line with a cell that is ignored and the names of columns, then lines with the name of
///           a row and its factors, an empty cell being 0; or the text output of View3D: a line "View3D
///           <version> 0 <...> <surfaces>", the areas, the square matrix by rows, emissivities
/// Requires  `names`: whose rows View3D's are, in this order
/// Result    InputError with the file, the line, the value and what is allowed
/// Limits    1 GiB; of View3D its text with a square matrix, format 0
[[nodiscard]] ClaimedFactors read_factors(const std::filesystem::path& path,
                                          std::span<const std::string> names);

/// The same from a text; `source` names it in messages.
[[nodiscard]] ClaimedFactors parse_factors(std::string_view text, const std::string& source,
                                           std::span<const std::string> names);

}  // namespace radcert
