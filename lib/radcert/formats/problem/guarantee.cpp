// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

std::vector<std::string> guaranteed_quantities() { return {"means", "values", "function"}; }

std::string name_of(EnclosedQuantity quantity) {
  return guaranteed_quantities()[static_cast<std::size_t>(quantity)];
}

namespace {

constexpr const char* by_piece = "by piece";

std::vector<NamedEmission> read_emissions(const JsonReader& emissions, std::span<const std::string> pieces) {
  if (emissions.value().members() == nullptr) {
    const std::vector<std::string> words{by_piece};
    static_cast<void>(emissions.word(words));
    return emissions_by_piece({pieces.begin(), pieces.end()});
  }
  std::vector<NamedEmission> out;
  for (const auto& [name, emission] : emissions.members("an object"))
    out.push_back({name, read_piecewise(emission, pieces)});
  if (out.empty()) emissions.refuse("has no emission", "one emission or more, each by its name");
  return out;
}

/// As the schema has it.
constexpr std::size_t most_points = 1000;

}  // namespace

Guarantee read_guarantee(const JsonReader& guarantee, std::span<const std::string> pieces) {
  guarantee.require_object({"width", "of", "points", "outside", "emissions"});
  const std::string allowed = "a positive decimal or fraction in a string";
  const JsonReader width = guarantee.at("width", allowed);
  Guarantee out{.width = width.rational(allowed)};
  if (out.width.sign() <= 0) width.refuse("is not positive", allowed);
  const std::vector<std::string> quantities = guaranteed_quantities();
  if (const auto of = guarantee.find("of")) {
    const auto at = std::find(quantities.begin(), quantities.end(), of->word(quantities));
    out.of = static_cast<EnclosedQuantity>(at - quantities.begin());
  }
  if (const auto points = guarantee.find("points")) {
    const std::string triple = "three coordinates, each a decimal or fraction in a string";
    const std::vector<JsonReader> listed = points->elements("a list of points");
    if (listed.size() > most_points)
      points->refuse(
          "has " + std::to_string(listed.size()) + " points, each of which asks for functions of its own",
          "at most " + std::to_string(most_points));
    for (const JsonReader& point : listed) {
      const std::vector<JsonReader> coordinates = point.elements(triple);
      if (coordinates.size() != 3) point.refuse("is not a point", triple);
      out.points.push_back({coordinates[0].rational(triple), coordinates[1].rational(triple),
                            coordinates[2].rational(triple)});
    }
    if (out.points.empty()) points->refuse("has no point", "one point or more");
  }
  if (const auto outside = guarantee.find("outside")) {
    const std::string distance = "a distance from the vertices, a decimal or fraction in a string, 0 or more";
    out.outside = outside->rational(distance);
    if (out.outside->sign() < 0) outside->refuse("is negative", distance);
  }
  if (const auto emissions = guarantee.find("emissions")) out.emissions = read_emissions(*emissions, pieces);
  return out;
}

JsonValue point_json(const Vector<Rational>& point) {
  JsonValue out = JsonValue::array();
  for (const Rational& coordinate : {point.x, point.y, point.z}) out.push(coordinate.to_text());
  return out;
}

JsonValue guarantee_json(const Guarantee& guarantee) {
  JsonValue out = JsonValue::object();
  out.set("width", exact_json(guarantee.width));
  out.set("of", name_of(guarantee.of));
  if (guarantee.outside) out.set("outside", exact_json(*guarantee.outside));
  if (!guarantee.points.empty()) {
    JsonValue points = JsonValue::array();
    for (const Vector<Rational>& p : guarantee.points) points.push(point_json(p));
    out.set("points", std::move(points));
  }
  if (guarantee.emissions.empty()) return out;
  JsonValue emissions = JsonValue::object();
  for (const NamedEmission& further : guarantee.emissions)
    emissions.set(further.name, piecewise_json(further.emission));
  out.set("emissions", std::move(emissions));
  return out;
}

}  // namespace radcert
