// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/points_table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"
#include "tables/number_cells.h"

namespace radcert::app {

namespace {

constexpr std::size_t most_rows = 20;

std::string coordinate(double x) { return nearest_text(x, DecimalForm::general(5)); }

/// The iterated solution at a point, and its error; none on an edge.
std::optional<Approximation> value_of(const ValueAt& at) {
  if (!at.iterated) return std::nullopt;
  return at.iterated->value;
}
std::optional<Approximation> error_of(const ValueAt& at) {
  if (!at.iterated) return std::nullopt;
  return at.iterated->error;
}

/// The largest of an error over the points that have one.
template <class Error>
std::optional<Approximation> largest(std::span<const ValueAt> values, const Error& error) {
  std::optional<Approximation> out;
  for (const ValueAt& at : values) {
    const std::optional<Approximation> now = error(at);
    if (now && (!out || now->value > out->value)) out = now;
  }
  return out;
}

}  // namespace

std::string points_table(std::span<const ValueAt> values, int level) {
  const bool with_errors = !values.empty() && values.front().u;
  std::vector<std::vector<std::string>> rows = {{"piece", "x", "y", "z", "u_n", "+-", "v", "+-"}};
  const bool moved =
      std::any_of(values.begin(), values.end(), [](const ValueAt& at) { return at.distance > 0; });
  if (with_errors) rows.front().insert(rows.front().end(), {"|u-u_n|", "+-", "|u-v|", "+-"});
  if (moved) rows.front().emplace_back("distance");
  for (const ValueAt& at : values.first(std::min(values.size(), most_rows))) {
    std::vector<std::string> row = {at.piece, coordinate(at.point.x), coordinate(at.point.y),
                                    coordinate(at.point.z)};
    push(row, at.u_n, DecimalForm::general(8));
    push(row, value_of(at), DecimalForm::general(8));
    if (with_errors) {
      push(row, at.u_n_error, DecimalForm::scientific(4));
      push(row, error_of(at), DecimalForm::scientific(4));
    }
    if (moved) row.push_back(nearest_text(at.distance, DecimalForm::general(3)));
    rows.push_back(row);
  }
  std::string out = "u_n and the iterated solution v = E + K u_n at " + std::to_string(values.size()) +
                    (values.size() == 1 ? " point" : " points") + " of level " + std::to_string(level) +
                    ", radii estimated:\n" + aligned(rows);
  if (values.size() > most_rows)
    out +=
        "and " + std::to_string(values.size() - most_rows) + " more: --json, --points or --out writes all.\n";
  if (with_errors) {
    const auto say = [&](const std::string& name, const std::optional<Approximation>& error) {
      if (!error) return;
      std::vector<std::string> number;
      push(number, error, DecimalForm::scientific(4));
      out += "Largest " + name + ": " + number[0] + " +- " + number[1] + "\n";
    };
    say("|u-u_n|", largest(values, [](const ValueAt& at) { return at.u_n_error; }));
    say("|u-v|", largest(values, error_of));
  }
  const auto on_edge =
      std::count_if(values.begin(), values.end(), [](const ValueAt& at) { return !at.iterated; });
  if (on_edge > 0)
    out += std::to_string(on_edge) + (on_edge == 1 ? " point lies" : " points lie") +
           " on the border of a chart where charts may meet at an angle, and E + K u_n is not taken.\n";
  double farthest = 0;
  for (const ValueAt& at : values) farthest = std::max(farthest, at.distance);
  if (farthest > 0) out += "Points were moved onto the surface, by at most " + upper_text(farthest) + ".\n";
  return out;
}

}  // namespace radcert::app
