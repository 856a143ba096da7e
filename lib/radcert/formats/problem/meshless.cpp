// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/expression/parse.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

/// The values of an enumeration, by their words.
template <class Choice>
std::vector<std::string> words_of(std::initializer_list<Choice> choices) {
  std::vector<std::string> words;
  for (const Choice choice : choices) words.emplace_back(name(choice));
  return words;
}

template <class Choice>
Choice read_choice(const JsonReader& place, std::initializer_list<Choice> choices) {
  const std::string& word = place.word(words_of(choices));
  for (const Choice choice : choices)
    if (name(choice) == word) return choice;
  return *choices.begin();
}

constexpr auto named_families = {MeshlessFamily::shepard, MeshlessFamily::gaussian, MeshlessFamily::lehtinen};
constexpr auto families = {MeshlessFamily::shepard, MeshlessFamily::gaussian, MeshlessFamily::lehtinen,
                           MeshlessFamily::meshless};
constexpr auto distances = {SiteDistance::normal_sensitive, SiteDistance::euclidean_with_normal_factor,
                            SiteDistance::euclidean};
constexpr auto normalisations = {Normalisation::none, Normalisation::partition_of_unity};
constexpr auto too_few_rules = {TooFewNeighbours::refuse, TooFewNeighbours::farthest};
constexpr auto weight_rules = {WeightRule::integrated, WeightRule::plane, WeightRule::neighbours,
                               WeightRule::mean_density};
constexpr auto coefficient_rules = {CoefficientRule::as_values, CoefficientRule::interpolated};

MotherFunction read_mother(const JsonReader& basis) {
  const std::string allowed = "gaussian, spline, shepard, or an expression in r, as exp(-r^2/2)";
  const JsonReader mother = basis.at("mother", allowed);
  const std::string& text = mother.string(allowed);
  const auto support = basis.find("support");
  if (text == "spline" || text == "shepard") {
    if (support) support->refuse("is not for the mother function " + text, "no such key");
    return text == "spline" ? spline_mother() : shepard_mother();
  }
  const std::string support_allowed = "a number > 0, beyond which the elements are 0, or none";
  std::optional<Rational> cut = text == "gaussian" ? std::optional<Rational>(4) : std::nullopt;
  if (support) {
    const std::string* word = support->value().string();
    if (word != nullptr && *word == "none") {
      cut = std::nullopt;
    } else {
      cut = support->rational(support_allowed);
      if (cut->sign() <= 0) support->refuse("is outside the range", support_allowed);
    }
  }
  if (text == "gaussian") return gaussian_mother(std::move(cut));
  auto expression = parse_expression(text, ExpressionVariables::radius);
  if (!expression)
    mother.refuse("is no expression in r: " + without_quotes(expression.reason().to_text()), allowed);
  return expression_mother(*std::move(expression), std::move(cut));
}

RadiusRule read_radius(const JsonReader& radius, bool may_be_absolute) {
  const std::string allowed =
      std::string(may_be_absolute ? "absolute, or " : "") + R"(an object as {"neighbour": 10})";
  if (may_be_absolute && radius.value().string() != nullptr) {
    const std::vector<std::string> words = {"absolute"};
    (void)radius.word(words);
    return {.neighbour = std::nullopt};
  }
  if (radius.value().members() == nullptr) radius.refuse("is " + radius.value().kind(), allowed);
  radius.require_object({"neighbour", "too_few"});
  const std::string range = "a whole number from 1 to 1000000";
  constexpr std::int64_t largest = 1'000'000;
  RadiusRule rule;
  rule.neighbour = static_cast<std::size_t>(radius.at("neighbour", range).whole(1, largest, range));
  if (const auto too_few = radius.find("too_few")) rule.too_few = read_choice(*too_few, too_few_rules);
  return rule;
}

SiteLevels read_sites(const JsonReader& sites) {
  const std::string allowed = R"(an object as {"poisson_disk": 3, "seed": 1} or {"uniform": 400, "seed": 1})";
  if (sites.value().members() == nullptr) sites.refuse("is " + sites.value().kind(), allowed);
  sites.require_object({"poisson_disk", "uniform", "seed"});
  const auto separation = sites.find("poisson_disk");
  const auto count = sites.find("uniform");
  if (separation.has_value() == count.has_value())
    sites.refuse(separation ? "states both poisson_disk and uniform" : "states no sites", allowed);
  std::uint64_t seed = 1;
  if (const auto given = sites.find("seed")) seed = given->unsigned_whole("a whole number >= 0, below 2^64");
  if (count) {
    const std::string range = "a whole number from 1 to 2^53: the number of sites at level 0";
    constexpr std::int64_t largest = std::int64_t{1} << 53U;
    return UniformLevels{.count = static_cast<std::uint64_t>(count->whole(1, largest, range)), .seed = seed};
  }
  const std::string range = "a number > 0: the least distance of two sites at level 0";
  PoissonDiskLevels apart{.separation = separation->rational(range), .seed = seed};
  if (apart.separation.sign() <= 0) separation->refuse("is outside the range", range);
  return apart;
}

Meshless read_own(const JsonReader& basis) {
  basis.require_object(
      {"family", "mother", "support", "distance", "radius", "normalise", "sites", "weights", "coefficients"});
  Meshless choice;
  choice.basis = {.mother = read_mother(basis), .normalise = Normalisation::partition_of_unity};
  if (const auto distance = basis.find("distance")) choice.basis.distance = read_choice(*distance, distances);
  if (const auto radius = basis.find("radius")) choice.basis.radius = read_radius(*radius, true);
  if (const auto normalise = basis.find("normalise"))
    choice.basis.normalise = read_choice(*normalise, normalisations);
  return choice;
}

Meshless read_named(const JsonReader& basis, MeshlessFamily family) {
  Meshless choice = basis_of(family);
  if (choice.basis.radius.neighbour)
    basis.require_object({"family", "radius", "sites", "weights", "coefficients"});
  else
    basis.require_object({"family", "sites", "weights", "coefficients"});
  if (const auto radius = basis.find("radius")) choice.basis.radius = read_radius(*radius, false);
  return choice;
}

JsonValue sites_json(const SiteLevels& sites) {
  JsonValue out = JsonValue::object();
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&sites)) {
    out.set("poisson_disk", exact_json(apart->separation));
    out.set("seed", apart->seed);
  } else {
    const auto& anywhere = *std::get_if<UniformLevels>(&sites);
    out.set("uniform", anywhere.count);
    out.set("seed", anywhere.seed);
  }
  return out;
}

JsonValue radius_json(const RadiusRule& rule) {
  if (!rule.neighbour) return "absolute";
  JsonValue out = JsonValue::object();
  out.set("neighbour", *rule.neighbour);
  out.set("too_few", std::string(name(rule.too_few)));
  return out;
}

std::string sites_words(const SiteLevels& sites) {
  if (const auto* apart = std::get_if<PoissonDiskLevels>(&sites))
    return "sites " + apart->separation.to_text() + " apart, seed " + std::to_string(apart->seed);
  const auto& anywhere = *std::get_if<UniformLevels>(&sites);
  return std::to_string(anywhere.count) + " sites, seed " + std::to_string(anywhere.seed);
}

}  // namespace

std::vector<std::string> meshless_families() { return words_of(families); }
std::vector<std::string> named_meshless_families() { return words_of(named_families); }
std::vector<std::string> site_distance_names() { return words_of(distances); }
std::vector<std::string> normalisation_names() { return words_of(normalisations); }
std::vector<std::string> too_few_neighbours_names() { return words_of(too_few_rules); }
std::vector<std::string> weight_rule_names() { return words_of(weight_rules); }
std::vector<std::string> coefficient_rule_names() { return words_of(coefficient_rules); }

Meshless read_meshless(const JsonReader& basis) {
  if (basis.value().string() != nullptr) return basis_of(read_choice(basis, named_families));
  const MeshlessFamily family =
      read_choice(basis.at("family", "one of " + listed(words_of(families))), families);
  Meshless meshless = family == MeshlessFamily::meshless ? read_own(basis) : read_named(basis, family);
  if (const auto sites = basis.find("sites")) meshless.sites = read_sites(*sites);
  if (const auto weights = basis.find("weights")) meshless.weights = read_choice(*weights, weight_rules);
  if (const auto coefficients = basis.find("coefficients"))
    meshless.coefficients = read_choice(*coefficients, coefficient_rules);
  return meshless;
}

JsonValue meshless_json(const Meshless& basis) {
  JsonValue out = JsonValue::object();
  out.set("family", std::string(name(basis.family)));
  if (basis.family == MeshlessFamily::meshless) {
    const MotherFunction& mother = basis.basis.mother;
    out.set("mother", mother.to_text());
    if (mother.kind != MotherKind::spline && mother.kind != MotherKind::shepard)
      out.set("support", mother.support ? exact_json(*mother.support) : JsonValue("none"));
    out.set("distance", std::string(name(basis.basis.distance)));
  }
  if (basis.family == MeshlessFamily::meshless || basis.basis.radius.neighbour)
    out.set("radius", radius_json(basis.basis.radius));
  if (basis.family == MeshlessFamily::meshless)
    out.set("normalise", std::string(name(basis.basis.normalise)));
  out.set("sites", sites_json(basis.sites));
  out.set("weights", std::string(name(basis.weights)));
  out.set("coefficients", std::string(name(basis.coefficients)));
  return out;
}

std::vector<std::string> meshless_words(const Meshless& basis) {
  const RadialBasisChoice& radial = basis.basis;
  std::string kind(name(basis.family));
  if (basis.family == MeshlessFamily::meshless) {
    kind = radial.mother.to_text() + ", " + std::string(name(radial.distance)) + ", " +
           std::string(name(radial.normalise));
    if (!radial.radius.neighbour) kind += ", absolute radius";
  }
  if (radial.radius.neighbour) {
    kind += ", neighbour " + std::to_string(*radial.radius.neighbour);
    if (radial.radius.too_few == TooFewNeighbours::farthest) kind += " or farthest";
  }
  return {kind, sites_words(basis.sites), "weights " + std::string(name(basis.weights)),
          "coefficients " + std::string(name(basis.coefficients))};
}

}  // namespace radcert
