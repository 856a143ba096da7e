// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/formats/problem/problem_parts.h"

namespace radcert {

namespace {

/// 4^30 triangles are more than any machine holds; what is possible below that, the memory plan decides.
constexpr int largest_level = 30;
constexpr const char* published = "published";
constexpr const char* levels_allowed =
    "a list, not empty, of whole numbers from 0 to 30, strictly ascending: numbers of symmetric refinements";

Diagonal diagonal_of(const std::string& word) { return word == "main" ? Diagonal::main : Diagonal::anti; }
std::string word_of(Diagonal diagonal) { return diagonal == Diagonal::main ? "main" : "anti"; }

std::vector<int> read_levels(const JsonReader& levels) {
  std::vector<int> out;
  for (const JsonReader& element : levels.elements(levels_allowed)) {
    const int level = static_cast<int>(element.whole(0, largest_level, levels_allowed));
    if (!out.empty() && level <= out.back()) element.refuse("does not ascend", levels_allowed);
    out.push_back(level);
  }
  if (out.empty()) levels.refuse("is empty", levels_allowed);
  return out;
}

std::vector<std::pair<std::string, Diagonal>> read_pattern(const JsonReader& pattern,
                                                           std::span<const std::string> pieces) {
  std::vector<std::pair<std::string, Diagonal>> out;
  if (pattern.value().string() != nullptr) {
    const std::string& word = pattern.word(pattern_names());
    if (word != published) out.emplace_back("*", diagonal_of(word));
    return out;
  }
  const auto members = pattern.members("published, main, anti, or main or anti by piece");
  require_pieces(pattern, pieces);
  for (const auto& [piece, word] : members) out.emplace_back(piece, diagonal_of(word.word(diagonal_names())));
  return out;
}

}  // namespace

std::vector<std::string> diagonal_names() { return {word_of(Diagonal::main), word_of(Diagonal::anti)}; }

std::vector<std::string> pattern_names() {
  return {published, word_of(Diagonal::main), word_of(Diagonal::anti)};
}

bool is_edge_grading(const JsonReader& grading) {
  const std::string* const word = grading.value().string();
  return word != nullptr && *word == "edges";
}

std::optional<WantedEvents> read_events(const JsonReader& events) {
  const std::string allowed = "true, false, or an object with secondary";
  if (const bool* const wanted = events.value().boolean()) {
    if (!*wanted) return std::nullopt;
    return WantedEvents{};
  }
  if (events.value().members() == nullptr) events.refuse("is " + events.value().kind(), allowed);
  events.require_object({"secondary"});
  const JsonReader secondary = events.at("secondary", "a number above 0");
  const Rational part = secondary.rational("a number above 0, or a decimal or fraction in a string");
  if (part.sign() <= 0) secondary.refuse("is outside the range", "a number above 0");
  return WantedEvents{.secondary = part};
}

TriangulationChoice read_triangulation(const JsonReader& triangulation, std::span<const std::string> pieces) {
  triangulation.require_object({"levels", "pattern", "grading", "events"});
  TriangulationChoice choice;
  choice.levels = read_levels(triangulation.at("levels", levels_allowed));
  if (const auto pattern = triangulation.find("pattern")) choice.pattern = read_pattern(*pattern, pieces);
  if (const auto grading = triangulation.find("grading")) {
    const std::string allowed = "a number >= 1, or a decimal or fraction in a string, or edges";
    // What the edges ask for depends on the whole problem: see read_edge_grading.
    if (is_edge_grading(*grading)) return choice;
    choice.grading = grading->rational(allowed);
    if (choice.grading < Rational(1)) grading->refuse("is outside the range", allowed);
  }
  return choice;
}

JsonValue triangulation_json(const TriangulationChoice& triangulation) {
  JsonValue out = JsonValue::object();
  out.set("levels", json_array(triangulation.levels));
  const auto& pattern = triangulation.pattern;
  if (pattern.empty()) {
    out.set("pattern", published);
  } else if (pattern.size() == 1 && pattern.front().first == "*") {
    out.set("pattern", word_of(pattern.front().second));
  } else {
    JsonValue by_piece = JsonValue::object();
    for (const auto& [piece, diagonal] : pattern) by_piece.set(piece, word_of(diagonal));
    out.set("pattern", std::move(by_piece));
  }
  out.set("grading", exact_json(triangulation.grading));
  // As it was before there were events, so that what has been stored is still found.
  if (triangulation.events) {
    const std::optional<Rational>& secondary = triangulation.events->secondary;
    out.set("events",
            secondary ? JsonValue::object({{"secondary", exact_json(*secondary)}}) : JsonValue(true));
  }
  return out;
}

}  // namespace radcert
