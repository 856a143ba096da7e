// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/factor_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/formats/plot/svg_elements.h"
#include "radcert/formats/table/csv.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

Agreement agreement_of(const Approximation& ours, const ClaimedFactor& theirs,
                       const FactorTolerance& tolerance) {
  if (!ours.has_radius()) return Agreement::undecided;
  const Rational value = Rational::exactly(ours.value);
  const Rational radius = Rational::exactly(ours.radius);
  const Rational distance = abs(value - theirs.value);
  const Rational fixed = std::max(theirs.halfwidth, Rational::exactly(tolerance.absolute));
  const Rational relative = Rational::exactly(tolerance.relative);
  if (distance + radius <= std::max(fixed, relative * (abs(value) - radius))) return Agreement::agrees;
  if (distance - radius > std::max(fixed, relative * (abs(value) + radius))) return Agreement::differs;
  return Agreement::undecided;
}

/// Both matrices by the numbers of the rows, in doubles: causes are guesses.
class TwoMatrices {
public:
  TwoMatrices(const FactorMatrix& matrix, std::span<const std::string> names, const ClaimedFactors& claimed)
      : matrix_(matrix) {
    for (std::size_t i = 0; i < names.size(); ++i) numbers_.emplace(names[i], i);
    for (const ConfigurationFactor& entry : matrix.entries) ours_[{entry.from, entry.to}] = entry.factor;
    for (const auto& [pair, claim] : claimed)
      theirs_[{number(pair.first), number(pair.second)}] = claim.in_double();
  }

  [[nodiscard]] std::size_t size() const { return matrix_.rows.size(); }
  [[nodiscard]] std::size_t number(const std::string& name) const { return numbers_.at(name); }
  [[nodiscard]] double area(std::size_t i) const { return matrix_.rows[i].area.value; }
  [[nodiscard]] double total_area() const {
    double sum = 0;
    for (const FactorRow& row : matrix_.rows) sum += row.area.value;
    return sum;
  }
  [[nodiscard]] Approximation ours(std::size_t i, std::size_t j) const {
    const auto found = ours_.find({i, j});
    return found == ours_.end() ? Approximation::exact(0) : found->second;
  }
  [[nodiscard]] Approximation theirs(std::size_t i, std::size_t j) const {
    const auto found = theirs_.find({i, j});
    return found == theirs_.end() ? Approximation::exact(0) : found->second;
  }

  /// Whether the claim would be this number, up to what is left of the difference.
  [[nodiscard]] bool fits(std::size_t i, std::size_t j, double number, double radius) const {
    constexpr double part = 0.02;
    const Approximation claim = theirs(i, j);
    return std::abs(claim.value - number) <=
           std::max(claim.radius + radius, part * std::abs(claim.value - ours(i, j).value));
  }

  /// Whether the rows of two surfaces fit once these have changed places, with their columns or without.
  [[nodiscard]] bool fit_swapped(std::size_t one, std::size_t other, bool with_columns) const {
    const auto swapped = [&](std::size_t k) { return k == one ? other : k == other ? one : k; };
    constexpr double part = 0.02;
    double largest = 0;
    for (const std::size_t row : {one, other})
      for (std::size_t k = 0; k < size(); ++k)
        largest = std::max(largest, std::abs(theirs(row, k).value - ours(row, k).value));
    for (const std::size_t row : {one, other})
      for (std::size_t k = 0; k < size(); ++k) {
        const Approximation expected = ours(swapped(row), with_columns ? swapped(k) : k);
        const Approximation claim = theirs(row, k);
        if (std::abs(claim.value - expected.value) > std::max(claim.radius + expected.radius, part * largest))
          return false;
      }
    return true;
  }

private:
  const FactorMatrix& matrix_;
  std::map<std::string, std::size_t> numbers_;
  std::map<std::pair<std::size_t, std::size_t>, Approximation> ours_;
  std::map<std::pair<std::size_t, std::size_t>, Approximation> theirs_;
};

using Swaps = std::map<std::size_t, std::size_t>;

/// For each surface the one with which it may have been swapped.
Swaps swapped_surfaces(const TwoMatrices& both, const std::set<std::size_t>& of, bool with_columns) {
  constexpr std::size_t most = 300;
  Swaps out;
  if (both.size() > most) return out;
  for (const std::size_t one : of)
    for (std::size_t other = 0; other < both.size() && !out.contains(one); ++other)
      if (one != other && both.fit_swapped(one, other, with_columns)) out.emplace(one, other);
  return out;
}

/// What is true of many pairs together.
struct CommonCauses {
  Swaps surfaces;
  Swaps rows;
  std::optional<double> unit_of_area;  ///< of exchange areas A_I F_IJ
};

/// The factor by which claims are A_I F_IJ, one for four in five of those that differ.
std::optional<double> unit_of_area(const TwoMatrices& both, std::span<const FactorComparison> pairs) {
  constexpr std::size_t fewest = 4;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  std::vector<double> quotients;
  for (const FactorComparison& pair : pairs) {
    const std::size_t i = both.number(pair.from);
    if (pair.agreement != Agreement::differs || !pair.is_claimed || pair.ours.value <= 10 * pair.ours.radius)
      continue;
    places.emplace_back(i, both.number(pair.to));
    quotients.push_back(pair.theirs.value.to_double() / (both.area(i) * pair.ours.value));
  }
  if (quotients.size() < fewest) return std::nullopt;
  std::vector<double> sorted = quotients;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double middle = sorted[sorted.size() / 2];
  const auto fit =
      static_cast<std::size_t>(std::count_if(places.begin(), places.end(), [&](const auto& place) {
        const auto [i, j] = place;
        const double scale = middle * both.area(i);
        const Approximation ours = both.ours(i, j);
        return both.fits(i, j, scale * ours.value, scale * ours.radius);
      }));
  return middle > 0 && 5 * fit >= 4 * places.size() ? std::optional(middle) : std::nullopt;
}

std::string cause_of(const TwoMatrices& both, const FactorComparison& pair, const CommonCauses& common,
                     std::span<const std::string> names, const UnoccludedFactor& unoccluded) {
  const std::size_t i = both.number(pair.from);
  const std::size_t j = both.number(pair.to);
  if (!pair.is_claimed) return "not in the file";
  if (pair.theirs.value.sign() < 0) return "below 0";
  for (const std::size_t one : {i, j})
    if (const auto found = common.surfaces.find(one); found != common.surfaces.end())
      return names[one] + " and " + names[found->second] + " swapped";
  if (const auto found = common.rows.find(i); found != common.rows.end())
    return "rows " + names[i] + " and " + names[found->second] + " swapped";
  const Approximation ours = both.ours(i, j);
  const Approximation back = both.ours(j, i);
  const auto fits = [&](double number, double radius) { return both.fits(i, j, number, radius); };
  if (i != j && fits(back.value, back.radius)) return "transposed";
  if (fits(both.area(i) * ours.value, both.area(i) * ours.radius))
    return "exchange area: not divided by the area";
  const double share = both.area(i) / both.total_area();
  if (fits(share * ours.value, share * ours.radius)) return "divided by the area of the scene";
  if (common.unit_of_area) {
    const double scale = *common.unit_of_area * both.area(i);
    if (fits(scale * ours.value, scale * ours.radius))
      return "exchange area in another unit: A F times " +
             nearest_text(*common.unit_of_area, DecimalForm::general(3));
  }
  if (fits(std::numbers::pi * ours.value, std::numbers::pi * ours.radius)) return "without 1/pi";
  if (const auto seen = unoccluded(i, j); seen && fits(*seen, 1e-9 * *seen)) return "occlusion missed";
  const Approximation there = both.theirs(i, j);
  const Approximation and_back = both.theirs(j, i);
  if (std::abs(both.area(i) * there.value - both.area(j) * and_back.value) >
      1.01 * (both.area(i) * there.radius + both.area(j) * and_back.radius))
    return "reciprocity broken";
  return {};
}

}  // namespace

double FactorComparison::difference() const {
  return abs(Rational::exactly(ours.value) - theirs.value).to_double();
}

std::vector<FactorComparison> compared(const FactorMatrix& matrix, std::span<const std::string> names,
                                       const ClaimedFactors& claimed, const FactorTolerance& tolerance) {
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& [pair, claim] : claimed)
    for (const std::string& name : {pair.first, pair.second})
      if (!known.contains(name))
        throw InputError(
            {.value = name, .problem = "is no surface here", .allowed = "the names of the rows of --out"});
  std::map<std::pair<std::string, std::string>, FactorComparison> pairs;
  const auto place = [&](const std::string& from, const std::string& to) -> FactorComparison& {
    FactorComparison& pair = pairs[{from, to}];
    pair.from = from;
    pair.to = to;
    return pair;
  };
  for (const ConfigurationFactor& entry : matrix.entries)
    place(names[entry.from], names[entry.to]).ours = entry.factor;
  for (const auto& [names_of_pair, claim] : claimed) {
    FactorComparison& pair = place(names_of_pair.first, names_of_pair.second);
    pair.theirs = claim;
    pair.is_claimed = true;
  }
  std::vector<std::pair<double, FactorComparison*>> by_difference;
  for (auto& [key, pair] : pairs) {
    pair.agreement = agreement_of(pair.ours, pair.theirs, tolerance);
    by_difference.emplace_back(pair.difference(), &pair);
  }
  std::stable_sort(by_difference.begin(), by_difference.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<FactorComparison> out;
  for (const auto& [difference, pair] : by_difference) out.push_back(std::move(*pair));
  return out;
}

void explain(std::vector<FactorComparison>& pairs, const FactorMatrix& matrix,
             std::span<const std::string> names, const ClaimedFactors& claimed,
             const UnoccludedFactor& unoccluded) {
  const TwoMatrices both(matrix, names, claimed);
  std::set<std::size_t> differing;
  for (const FactorComparison& pair : pairs)
    if (pair.agreement == Agreement::differs) {
      differing.insert(both.number(pair.from));
      differing.insert(both.number(pair.to));
    }
  const CommonCauses common{.surfaces = swapped_surfaces(both, differing, true),
                            .rows = swapped_surfaces(both, differing, false),
                            .unit_of_area = unit_of_area(both, pairs)};
  for (FactorComparison& pair : pairs)
    if (pair.agreement == Agreement::differs) pair.cause = cause_of(both, pair, common, names, unoccluded);
}

std::string agreement_word(Agreement agreement) {
  switch (agreement) {
    case Agreement::agrees: return "agrees";
    case Agreement::differs: return "differs";
    case Agreement::undecided: return "undecided";
  }
  return {};
}

std::string comparison_csv(std::span<const FactorComparison> pairs) {
  constexpr std::array<std::string_view, 10> columns = {
      "from", "to", "ours", "radius", "guaranteed", "theirs", "halfwidth", "difference", "verdict", "cause"};
  CsvTable table(columns);
  for (const FactorComparison& pair : pairs) {
    const Approximation theirs = pair.theirs.in_double();
    const std::array<JsonValue, columns.size()> row = {
        pair.from,
        pair.to,
        pair.ours.value,
        pair.ours.radius,
        pair.ours.guaranteed,
        theirs.value,
        theirs.radius,
        pair.difference(),
        agreement_word(pair.agreement),
        pair.cause.empty() ? JsonValue() : JsonValue(pair.cause)};
    table.add(row);
  }
  return table.text();
}

std::string comparison_svg(std::span<const FactorComparison> pairs, std::span<const std::string> names) {
  expects(names.size() <= comparison_picture_rows, "a matrix that a picture can show",
          named("rows", names.size()));
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) numbers.emplace(names[i], i);
  constexpr double letters = 11;
  constexpr double most_of_matrix = 800;
  constexpr double largest_cell = 28;
  constexpr double gap = 8;
  const double cell =
      std::min(largest_cell, most_of_matrix / static_cast<double>(std::max<std::size_t>(1, names.size())));
  const bool named_rows = cell >= letters;
  double margin = gap;
  if (named_rows)
    for (const std::string& name : names) margin = std::max(margin, svg::text_width(name, letters) + 2 * gap);
  const double side = cell * static_cast<double>(names.size());
  double largest = 0;
  for (const FactorComparison& pair : pairs) largest = std::max(largest, pair.ours.value);
  std::string out = svg::head(
      margin + side + gap, margin + side + gap, "Configuration factors compared",
      "Rows are from, columns to. The darker, the larger the factor; red: differs, amber: undecided.",
      ".radcert .paper{fill:#fff}.radcert text{font:11px sans-serif}.radcert .differs{fill:#d62728}.radcert "
      ".undecided{fill:#ffbf00}"
      ".radcert .grid{fill:none;stroke:#888}");
  for (const FactorComparison& pair : pairs) {
    const std::size_t row = numbers.at(pair.from);
    const std::size_t column = numbers.at(pair.to);
    std::string colour;
    if (pair.agreement == Agreement::agrees) {
      constexpr double darkest = 180;
      const double share = largest > 0 ? std::clamp(pair.ours.value / largest, 0.0, 1.0) : 0;
      const std::string level = std::to_string(255 - static_cast<int>(darkest * share));
      colour = " fill=\"rgb(" + level + "," + level + ",255)\"";
    } else {
      colour = " class=\"" + agreement_word(pair.agreement) + "\"";
    }
    out += "  <rect" + svg::attribute("x", margin + cell * static_cast<double>(column)) +
           svg::attribute("y", margin + cell * static_cast<double>(row)) + svg::attribute("width", cell) +
           svg::attribute("height", cell) + colour + "><title>" +
           svg::escaped(pair.from + " to " + pair.to + ": " + JsonValue(pair.ours.value).compact() +
                        " here, " + JsonValue(pair.theirs.in_double().value).compact() + " there, " +
                        agreement_word(pair.agreement) + (pair.cause.empty() ? "" : ", " + pair.cause)) +
           "</title></rect>\n";
  }
  out += "  <rect class=\"grid\"" + svg::attribute("x", margin) + svg::attribute("y", margin) +
         svg::attribute("width", side) + svg::attribute("height", side) + "/>\n";
  if (named_rows)
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double at = margin + cell * (static_cast<double>(i) + 0.5);
      out += svg::text(gap, at + letters / 3, names[i]);
      out += svg::text(0, 0, names[i],
                       " transform=\"translate(" + svg::coordinate(at + letters / 3) + " " +
                           svg::coordinate(margin - gap) + ") rotate(-90)\"");
    }
  return out + std::string(svg::foot);
}

}  // namespace radcert
