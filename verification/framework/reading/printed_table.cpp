// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/reading/printed_table.h"

#include <algorithm>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"

namespace radcert::verification {
namespace {

constexpr std::size_t most_rows = 10000;

InputError wrong(const std::string& source, int line, std::string problem, std::string allowed) {
  return InputError({.source = source + ", line " + std::to_string(line),
                     .problem = std::move(problem),
                     .allowed = std::move(allowed)});
}

std::vector<std::string> cells_of(std::string_view line, const std::string& source, int number) {
  std::vector<std::string> cells;
  std::size_t place = 0;
  while (true) {
    std::string cell;
    if (place < line.size() && line[place] == '"') {
      for (++place;; ++place) {
        if (place >= line.size())
          throw wrong(source, number, "a quote is not closed", "a closing quote on the same line");
        if (line[place] != '"') {
          cell += line[place];
        } else if (place + 1 < line.size() && line[place + 1] == '"') {
          cell += '"';
          ++place;
        } else {
          ++place;
          break;
        }
      }
      if (place < line.size() && line[place] != ',')
        throw wrong(source, number, "something follows a closing quote", "a comma");
    } else {
      const std::size_t end = std::min(line.find(',', place), line.size());
      cell = line.substr(place, end - place);
      place = end;
    }
    cells.push_back(std::move(cell));
    if (place >= line.size()) return cells;
    ++place;
  }
}

}  // namespace

std::optional<std::size_t> PrintedTable::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

PrintedTable parse_printed_table(std::string_view text, const std::string& source) {
  if (!is_utf8(text))
    throw InputError({.source = source, .problem = "is not UTF-8", .allowed = "a CSV table"});
  PrintedTable table;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> cells = cells_of(line, source, number);
    if (table.columns.empty()) {
      for (const std::string& name : cells)
        if (std::count(cells.begin(), cells.end(), name) > 1)
          throw wrong(source, number, "two columns are called " + quotation(name), "each name once");
      table.columns = std::move(cells);
      continue;
    }
    if (cells.size() != table.columns.size())
      throw wrong(source, number, "the row has " + std::to_string(cells.size()) + " cells",
                  std::to_string(table.columns.size()) + ", as the header has");
    if (table.rows.size() == most_rows)
      throw wrong(source, number, "the table is too long", std::to_string(most_rows) + " rows");
    table.rows.push_back({std::move(cells), number});
  }
  if (table.rows.empty())
    throw InputError({.source = source, .problem = "has no rows", .allowed = "a CSV table"});
  return table;
}

}  // namespace radcert::verification
