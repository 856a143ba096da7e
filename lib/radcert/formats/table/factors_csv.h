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

namespace radcert {

/// The factors of a matrix as CSV.
/// Source    the columns from, to, factor, radius, guaranteed
/// Requires  a name for each row
/// Result    RFC 4180; a row for each factor that is not exactly zero, in the shortest form that reads back
///           as the same double: the radius holds for that double
[[nodiscard]] std::string factors_csv(const FactorMatrix& matrix, std::span<const std::string> names);

/// The rows of a matrix as CSV: the columns name, area, row_sum, row_radius, to_space; the last is empty
/// unless asked for, and the radius is that of both, the wider.
[[nodiscard]] std::string factor_surfaces_csv(const FactorMatrix& matrix, std::span<const std::string> names);

/// A factor from another source, to be compared.
/// Maths     what is claimed: value +- halfwidth
/// Result    halfwidth: the radius given, else half a unit of the last printed digit
struct ClaimedFactor {
  double value = 0;
  double halfwidth = 0;
};

/// Factors by the names of both surfaces; what is not there is zero.
using ClaimedFactors = std::map<std::pair<std::string, std::string>, ClaimedFactor>;

/// A file of factors.
/// Source    CSV with columns from, to, factor and, if there, radius, in any order, others ignored; or the
///           text output of View3D: a line "View3D <version> 0 <...> <surfaces>", the areas, the square
///           matrix by rows, emissivities
/// Requires  `names`: whose rows View3D's are, in this order
/// Result    InputError with the file, the line, the value and what is allowed
/// Limits    1 GiB; of View3D its text with a square matrix, format 0
[[nodiscard]] ClaimedFactors read_factors(const std::filesystem::path& path,
                                          std::span<const std::string> names);

/// The same from a text; `source` names it in messages.
[[nodiscard]] ClaimedFactors parse_factors(std::string_view text, const std::string& source,
                                           std::span<const std::string> names);

/// How a claimed value compares with a number with a radius.
enum class Agreement {
  agrees,     ///< all that our factor may be lies within the claim
  differs,    ///< none of it does
  undecided,  ///< our radius is too large to tell, or the claim's digits are finer than it
};

/// One pair of surfaces in two matrices.
struct FactorComparison {
  std::string from;
  std::string to;
  Approximation ours = Approximation::exact(0);  ///< zero where the matrix has no entry
  ClaimedFactor theirs;
  Agreement agreement = Agreement::undecided;
  [[nodiscard]] double difference() const;
};

/// Every pair that either matrix has, the largest differences first.
/// Maths     with d = |ours - theirs|, r our radius, h their halfwidth: agrees if d + r <= h, differs if d -
///           r > h, else undecided
/// Requires  a name for each row
/// Result    InputError, without a source, for a name that no surface has
/// Limits    the comparison of the doubles is proved; a claim is the doubles nearest to its decimals
[[nodiscard]] std::vector<FactorComparison> compared(const FactorMatrix& matrix,
                                                     std::span<const std::string> names,
                                                     const ClaimedFactors& claimed);

/// "agrees", "differs", "undecided".
[[nodiscard]] std::string agreement_word(Agreement agreement);

}  // namespace radcert
