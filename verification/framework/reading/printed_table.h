// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radcert::verification {

/// A table as a paper prints it, read from CSV.
/// Source    RFC 4180, and lines that begin with # are comments
/// Requires  at most 10,000 rows
/// Result    the texts exactly as they stand; an empty cell is one that the paper leaves empty; InputError
///           with source and line for rows of another length than the header, columns named twice, an open
///           quote, text that is not UTF-8
/// Limits    a quoted cell does not go over a line's end
struct PrintedTable {
  std::vector<std::string> columns;
  struct Row {
    std::vector<std::string> cells;
    int line = 0;
  };
  std::vector<Row> rows;

  /// The place of a column.
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
};

[[nodiscard]] PrintedTable parse_printed_table(std::string_view text, const std::string& source);

}  // namespace radcert::verification
