// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/factors_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/text.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/csv_rows.h"
#include "radcert/scalar/ball.h"

namespace radcert {

namespace {

/// A cell that csv_number takes, as the decimal that it is.
Rational exact_number(std::string_view cell, std::size_t line) {
  csv_number(cell, line);
  const Outcome<Rational> number = Rational::parse(cell);
  if (!number)
    throw InputError({.pointer = line_text(line),
                      .value = std::string(cell),
                      .problem = "is not read: " + number.reason(),
                      .allowed = "a decimal number"});
  return *number;
}

/// Half a unit of the last digit of a decimal text that exact_number takes.
Rational half_a_unit(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = text.substr(e + 1);
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = mantissa.find('.');
  if (point != std::string_view::npos) exponent -= static_cast<long>(mantissa.size() - point - 1);
  return power(Rational(10), exponent) / Rational(2);
}

/// A number without a radius.
ClaimedFactor claim_of(std::string_view cell, std::size_t line) {
  return {.value = exact_number(cell, line), .halfwidth = half_a_unit(cell)};
}

/// What a number differs by from the nearest double.
Rational off_double(const Rational& value) { return abs(value - Rational::exactly(value.to_double())); }

/// A matrix with names about it, of which the first line was read.
ClaimedFactors parse_matrix(CsvRows& rows, const std::vector<std::string>& head) {
  ClaimedFactors out;
  while (const auto row = rows.next()) {
    require_cells(*row, head.size(), rows.line());
    for (std::size_t k = 1; k < head.size(); ++k) {
      const std::string& cell = (*row)[k];
      const ClaimedFactor claim = cell.empty() ? ClaimedFactor{} : claim_of(cell, rows.line());
      if (!out.emplace(std::pair(row->front(), head[k]), claim).second)
        throw InputError({.pointer = line_text(rows.line()),
                          .value = row->front() + " to " + head[k],
                          .problem = "occurs twice"});
    }
  }
  return out;
}

/// Why a first line begins no file of factors.
InputError no_columns(const std::optional<std::vector<std::string>>& head, bool is_of_pairs,
                      const std::set<std::string>& known) {
  InputFault fault{.pointer = line_text(1),
                   .problem = "has not the columns of a file of factors",
                   .allowed =
                       "from, to, factor and, if known, radius; a matrix whose first line has the "
                       "names of the surfaces; or the output of View3D"};
  if (!head) {
    fault.problem = "is empty";
  } else if (head->size() == 1) {
    fault.value = head->front();
    fault.problem = "has one cell: cells are parted by commas";
  } else if (!is_of_pairs) {
    const auto unknown = std::find_if(head->begin() + 1, head->end(),
                                      [&](const std::string& name) { return !known.contains(name); });
    fault.value = *unknown;
    fault.problem = parse_double(*unknown) ? "is a number, and no name of a surface" : "is no surface here";
    fault.allowed =
        "of a matrix, the names of the rows of --out in the first line and column; of pairs, the "
        "columns from, to, factor";
  }
  return InputError(std::move(fault));
}

ClaimedFactors parse_csv(std::string_view text, std::span<const std::string> names) {
  CsvRows rows(text);
  const auto head = rows.next();
  const auto column = [&](std::string_view name) { return csv_column(head, name); };
  const auto from = column("from");
  const auto to = column("to");
  const auto factor = column("factor");
  const auto radius = column("radius");
  if (!from || !to || !factor) {
    const std::set<std::string> known(names.begin(), names.end());
    if (head && head->size() > 1 && std::all_of(head->begin() + 1, head->end(), [&](const std::string& name) {
          return known.contains(name);
        }))
      return parse_matrix(rows, *head);
    throw no_columns(head, to || factor, known);
  }
  ClaimedFactors out;
  while (const auto row = rows.next()) {
    require_cells(*row, head->size(), rows.line());
    ClaimedFactor claim = claim_of((*row)[*factor], rows.line());
    if (radius && !(*row)[*radius].empty()) {
      const Rational given = exact_number((*row)[*radius], rows.line());
      if (given.sign() < 0)
        throw InputError({.pointer = line_text(rows.line()),
                          .value = (*row)[*radius],
                          .problem = "is a radius below 0",
                          .allowed = "0 or more"});
      claim.halfwidth = given + off_double(claim.value);
    }
    if (!out.emplace(std::pair((*row)[*from], (*row)[*to]), claim).second)
      throw InputError({.pointer = line_text(rows.line()),
                        .value = (*row)[*from] + " to " + (*row)[*to],
                        .problem = "occurs twice"});
  }
  return out;
}

/// Words parted by white space, with their lines.
class Words {
public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next(const std::string& what) {
    while (at_ < text_.size() && is_blank(text_[at_])) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    if (begin == at_)
      throw InputError({.pointer = line_text(line_), .problem = "the file ends too early", .allowed = what});
    return text_.substr(begin, at_ - begin);
  }
  [[nodiscard]] std::size_t line() const { return line_; }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

ClaimedFactors parse_view3d(std::string_view text, std::span<const std::string> names) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::vector<std::string> head;
  {
    Words words(text.substr(0, end));
    try {
      for (;;) head.emplace_back(words.next(""));
    } catch (const InputError&) {
    }
  }
  constexpr std::size_t least_words = 4;
  if (head.size() < least_words || head[2] != "0")
    throw InputError(
        {.pointer = line_text(1),
         .value = std::string(text.substr(0, end)),
         .allowed = "View3D's text output with a square matrix: \"View3D <version> 0 ... <surfaces>\""});
  if (head.back() != std::to_string(names.size()))
    throw InputError({.pointer = line_text(1),
                      .value = head.back() + " surfaces",
                      .allowed = std::to_string(names.size()) + ", as many as here"});
  Words words(text.substr(end));
  const std::string what = "areas, factors by rows, emissivities";
  for (std::size_t k = 0; k < names.size(); ++k) csv_number(words.next(what), words.line());
  ClaimedFactors out;
  for (const std::string& from : names)
    for (const std::string& to : names) {
      const std::string_view word = words.next(what);
      out[{from, to}] = claim_of(word, words.line());
    }
  return out;
}

}  // namespace

namespace {

constexpr std::array<std::string_view, 5> factor_columns = {"from", "to", "factor", "radius", "guaranteed"};

}  // namespace

FactorsCsv::FactorsCsv(std::span<const std::string> names) : names_(names), table_(factor_columns) {}

std::string FactorsCsv::rows(std::span<const ConfigurationFactor> factors) {
  for (const ConfigurationFactor& entry : factors) {
    const std::array<JsonValue, factor_columns.size()> row = {names_[entry.from], names_[entry.to],
                                                              entry.factor.value, entry.factor.radius,
                                                              entry.factor.guaranteed};
    table_.add(row);
  }
  return table_.take();
}

std::string factors_csv(const FactorMatrix& matrix, std::span<const std::string> names) {
  return FactorsCsv(names).rows(matrix.entries);
}

std::string factor_surfaces_csv(const FactorMatrix& matrix, std::span<const std::string> names,
                                const std::optional<std::string>& unit) {
  constexpr std::array<std::string_view, 6> columns = {"name",       "area",     "row_sum",
                                                       "row_radius", "to_space", "area_unit"};
  CsvTable table(columns);
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    const FactorRow& line = matrix.rows[i];
    const std::array<JsonValue, columns.size()> row = {
        names[i],
        line.area.value,
        line.sum.value,
        line.to_space ? std::max(line.sum.radius, line.to_space->radius) : line.sum.radius,
        line.to_space ? JsonValue(line.to_space->value) : JsonValue(),
        unit ? JsonValue(*unit + "^2") : JsonValue()};
    table.add(row);
  }
  return table.text();
}

Approximation ClaimedFactor::in_double() const {
  return {.value = value.to_double(), .radius = Ball(halfwidth + off_double(value)).upper_double()};
}

ClaimedFactors parse_factors(std::string_view text, const std::string& source,
                             std::span<const std::string> names) {
  return with_source(source, [&] {
    ClaimedFactors found = text.starts_with("View3D") ? parse_view3d(text, names) : parse_csv(text, names);
    if (found.empty()) throw InputError({.problem = "has no factor", .allowed = "a line for each pair"});
    return found;
  });
}

ClaimedFactors read_factors(const std::filesystem::path& path, std::span<const std::string> names) {
  constexpr std::uint64_t largest = std::uint64_t{1} << 30;
  return parse_factors(read_file(path, largest), path.string(), names);
}

}  // namespace radcert
