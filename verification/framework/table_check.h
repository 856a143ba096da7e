// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/framework/check.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/report.h"

namespace radcert::verification {

/// A ratio of two measured numbers.
/// Maths     a/b with every a', b' within the radii: radius >= |a'/b' - a/b|, rounding of the quotient
///           included
/// Source    interval division
/// Requires  nothing
/// Result    guaranteed where both are; no finite radius where b +- its radius contains 0
/// Limits    takes the two errors as independent
[[nodiscard]] Approximation ratio(const Approximation& numerator, const Approximation& denominator);

/// The labels of a table's cells, as the printed table has them.
/// Maths     <claim>[.<series>].n<elements>.<figure>, a label for each cell that is not empty
/// Requires  a claim with a table
/// Result    in the order series, row, figure; InputError where the table and the records do not match: a
///           missing column, a cell without a record, a record without a cell
[[nodiscard]] std::vector<std::string> cell_labels(const Paper& paper, const Claim& claim);

/// Every cell of a printed table against the study of its problem.
/// Maths     the rule of cell.h; the control, a problem that should not be the table's, must have a printed
///           error contradicted, else every cell of its series is `failed`; with second_route the other
///           figure must agree within both radii and settle the cell alike, else `undecided`
/// Requires  a claim with a table
/// Result    a report a cell that `wanted` accepts, in the order of cell_labels; InputError for files that do
///           not fit
/// Limits    levels below a wanted cell are not solved unless a ratio needs them. Levels of at most as many
///           elements as the series states in `verified` for the budget are solved by the verified solver:
///           their cells are certified or contradicted by proof
[[nodiscard]] std::vector<ClaimReport> check_table(
    const Paper& paper, const Claim& claim, const Bench& bench, const SecondRoute& second_route,
    const std::function<bool(const std::string& label)>& wanted,
    const std::function<void(const std::string& label)>& starting = {});

}  // namespace radcert::verification
