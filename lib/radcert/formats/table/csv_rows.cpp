// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/csv_rows.h"

#include <algorithm>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"

namespace radcert {

std::string line_text(std::size_t line) { return "line " + std::to_string(line); }

CsvRows::CsvRows(std::string_view text) : text_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

std::optional<std::vector<std::string>> CsvRows::next() {
  while (at_ < text_.size()) {
    line_ = next_line_;
    std::vector<std::string> cells = row();
    if (cells.size() > 1 || !cells.front().empty()) return cells;
  }
  return std::nullopt;
}

std::vector<std::string> CsvRows::row() {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') ++next_line_;
    if (quoted) {
      if (c != '"')
        cells.back() += c;
      else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"')
        cells.back() += text_[++at_];
      else
        quoted = false;
    } else if (c == '"' && cells.back().empty()) {
      quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++at_;
      return cells;
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  if (quoted)
    throw InputError(
        {.pointer = line_text(line_), .problem = "a quoted cell does not end", .allowed = "RFC 4180"});
  return cells;
}

std::optional<std::size_t> csv_column(const std::optional<std::vector<std::string>>& head,
                                      std::string_view name) {
  if (!head) return std::nullopt;
  const auto found = std::find(head->begin(), head->end(), name);
  if (found == head->end()) return std::nullopt;
  return static_cast<std::size_t>(found - head->begin());
}

double csv_number(std::string_view cell, std::size_t line) {
  const std::optional<double> number = parse_double(cell);
  if (!number)
    throw InputError({.pointer = line_text(line), .value = std::string(cell), .allowed = "a decimal number"});
  return *number;
}

void require_cells(const std::vector<std::string>& row, std::size_t cells, std::size_t line) {
  if (row.size() != cells)
    throw InputError({.pointer = line_text(line),
                      .value = std::to_string(row.size()) + " cells",
                      .allowed = std::to_string(cells) + ", as in the first line"});
}

}  // namespace radcert
