// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/enclosure_table.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

DecimalForm form_of(const Approximation& number) {
  constexpr int most = 17;
  if (!(number.radius > 0)) return DecimalForm::general(most);
  const double size = std::max(std::abs(number.value), number.radius);
  const double digits = std::floor(std::log10(size)) - std::floor(std::log10(number.radius)) + 2;
  return DecimalForm::general(static_cast<int>(std::clamp(digits, 1.0, static_cast<double>(most))));
}

namespace {

std::string coordinates(const Vector<Rational>& p) {
  return p.x.to_text() + "," + p.y.to_text() + "," + p.z.to_text();
}

/// Every octave of the distance, and what was asked for; one number where the bound holds everywhere alike.
void add_function(std::vector<std::vector<std::string>>& rows, const FunctionBound& bound) {
  if (bound.by_distance.empty()) {
    rows.push_back({upper_text(bound.sup)});
    return;
  }
  const auto add = [&](double sup, double outside) {
    rows.push_back({upper_text(sup),
                    outside > 0 ? nearest_text(outside, DecimalForm::general(15)) + " or more" : "any"});
  };
  constexpr std::size_t shells_an_octave = 4;
  for (std::size_t k = 0; k + 1 < bound.by_distance.size(); k += shells_an_octave) {
    const FunctionBound::AtDistance& at = bound.by_distance[k];
    if (!(at.outside > bound.outside)) break;
    add(at.sup, at.outside);
  }
  add(bound.sup, bound.outside);
  if (bound.outside > 0) add(bound.by_distance.back().sup, 0);
}

}  // namespace

std::string enclosure_table(const SolutionEnclosure& enclosure) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](std::vector<std::string> row, const Approximation& number) {
    const EnclosingText text = enclosing_text(number.value, number.radius, form_of(number));
    row.push_back(text.value);
    row.push_back(text.radius);
    rows.push_back(std::move(row));
  };
  std::string what;
  switch (enclosure.wanted.of) {
    case EnclosedQuantity::means:
      rows.push_back({"piece", "mean of u", "+-"});
      what = "the means of the solution u of the equation itself lie within these radii.";
      break;
    case EnclosedQuantity::values:
      rows.push_back({"piece", "at", "u", "+-"});
      what = "the values of the solution u of the equation itself lie within these radii.";
      break;
    case EnclosedQuantity::function:
      if (enclosure.function && enclosure.function->by_distance.empty())
        rows.push_back({"sup |u - v|"});
      else
        rows.push_back({"sup |u - v|", std::string("at a distance from the corners of faces") +
                                           (enclosure.function && enclosure.function->faces_are_cut
                                                ? ", cut along the planes of all, of"
                                                : " of")});
      what = "the solution u of the equation itself is v within these bounds, a piecewise polynomial.";
      break;
  }
  const bool are_several = !enclosure.emissions.empty();
  if (are_several) rows.front().insert(rows.front().begin(), "emission");
  const auto add_all = [&](const std::string& emission, const auto& pieces, const auto& points) {
    std::vector<std::string> first;
    if (are_several) first.push_back(emission);
    const auto row = [&](std::initializer_list<std::string> more) {
      std::vector<std::string> out = first;
      out.insert(out.end(), more);
      return out;
    };
    for (const auto& [piece, mean] : pieces) add(row({piece}), mean);
    for (const EnclosedValue& point : points) add(row({point.piece, coordinates(point.at)}), point.value);
  };
  add_all("(own)", enclosure.pieces, enclosure.points);
  for (const SolutionEnclosure::OfEmission& further : enclosure.emissions)
    add_all(further.emission, further.pieces, further.points);
  if (enclosure.function) add_function(rows, *enclosure.function);
  return aligned(rows) + "\nProved: " + what + " Width " + upper_text(enclosure.width) + ", asked for " +
         enclosing_text(enclosure.wanted.width, 0, DecimalForm::general(17)).value + ".\n";
}

}  // namespace radcert::app
