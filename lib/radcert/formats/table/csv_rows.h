// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radcert {

/// A line of a file, as errors name it: "line 3".
[[nodiscard]] std::string line_text(std::size_t line);

/// The rows of a CSV file one after the other.
/// Source    RFC 4180; a byte order mark is passed over, and so are empty lines; a quoted cell may hold line
///           ends
/// Result    InputError at the line where a quoted cell does not end
class CsvRows {
public:
  explicit CsvRows(std::string_view text);
  /// The cells of the next line that is not empty; no value at the end.
  std::optional<std::vector<std::string>> next();
  /// That on which the last row begins, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }

private:
  std::vector<std::string> row();
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t next_line_ = 1;
};

/// The place of a column in the first line of a file; none where it is not there, or where there is no line.
[[nodiscard]] std::optional<std::size_t> csv_column(const std::optional<std::vector<std::string>>& head,
                                                    std::string_view name);

/// A cell as a number. Requires its line, for the InputError where it is none.
double csv_number(std::string_view cell, std::size_t line);

/// Refuses a row that has not as many cells as the first line.
void require_cells(const std::vector<std::string>& row, std::size_t cells, std::size_t line);

}  // namespace radcert
