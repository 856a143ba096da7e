// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_reader.h"

#include <algorithm>
#include <cmath>

#include "radcert/formats/json/json_document.h"

namespace radcert {

namespace {

/// What stands at a place, for a message; nothing where that is long.
std::optional<std::string> shown(const JsonValue& value) {
  if (value.members() != nullptr || value.elements() != nullptr) {
    std::string text = value.compact();
    if (text.size() > 60) return std::nullopt;
    return text;
  }
  if (value.string() != nullptr) return *value.string();
  return value.compact();
}

/// Insertions, deletions, substitutions and exchanges of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string without_quotes(std::string reason) {
  std::erase(reason, '\\');
  std::replace(reason.begin(), reason.end(), '"', '\'');
  return reason;
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> words) {
  constexpr std::size_t longest = 64;
  if (word.size() > longest) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = longest;
  for (const std::string& candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least && 3 * distance <= std::max(word.size(), candidate.size())) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string with_nearest_word(const std::string& problem, std::string_view word,
                              std::span<const std::string> words) {
  const std::optional<std::string> near = nearest_word(word, words);
  return near ? problem + "; did you mean " + *near + "?" : problem;
}

void JsonReader::refuse(const std::string& problem, const std::string& allowed) const {
  throw InputError({.pointer = pointer_, .value = shown(*value_), .problem = problem, .allowed = allowed});
}

void JsonReader::refuse_kind(const std::string& what) const { refuse("is " + value_->kind(), what); }

void JsonReader::require_object(std::initializer_list<std::string_view> allowed_keys) const {
  const std::vector<std::string> keys(allowed_keys.begin(), allowed_keys.end());
  require_object(std::span<const std::string>(keys));
}

void JsonReader::require_object(std::span<const std::string> allowed_keys) const {
  const auto* members = value_->members();
  if (members == nullptr) refuse_kind("an object");
  for (const auto& [key, value] : *members) {
    if (std::find(allowed_keys.begin(), allowed_keys.end(), key) != allowed_keys.end()) continue;
    const JsonReader there(value, pointer_below(pointer_, key));
    there.refuse(with_nearest_word("belongs to an unknown key", key, allowed_keys),
                 "the keys " + listed(allowed_keys));
  }
}

void JsonReader::require_schema(const std::string& schema, const std::string& what) const {
  if (value_->members() == nullptr) refuse_kind(what);
  (void)at("schema", schema).word(std::vector<std::string>{schema});
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members(const std::string& what) const {
  if (value_->members() == nullptr) refuse_kind(what);
  std::vector<std::pair<std::string, JsonReader>> out;
  for (const auto& [key, value] : *value_->members())
    out.emplace_back(key, JsonReader(value, pointer_below(pointer_, key)));
  return out;
}

JsonReader JsonReader::at(std::string_view key, const std::string& what) const {
  auto found = find(key);
  if (!found)
    throw InputError({.pointer = pointer_below(pointer_, key), .problem = "is missing", .allowed = what});
  return *found;
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
  const JsonValue* found = value_->find(key);
  if (found == nullptr) return std::nullopt;
  return JsonReader(*found, pointer_below(pointer_, key));
}

std::vector<JsonReader> JsonReader::elements(const std::string& what) const {
  if (value_->elements() == nullptr) refuse_kind(what);
  std::vector<JsonReader> out;
  for (const JsonValue& element : *value_->elements())
    out.push_back(JsonReader(element, pointer_below(pointer_, out.size())));
  return out;
}

const std::string& JsonReader::string(const std::string& what) const {
  if (value_->string() == nullptr) refuse_kind(what);
  return *value_->string();
}

double JsonReader::number(const std::string& what) const {
  const auto number = value_->number();
  if (!number) refuse_kind(what);
  return *number;
}

bool JsonReader::boolean(const std::string& what) const {
  if (value_->boolean() == nullptr) refuse_kind(what);
  return *value_->boolean();
}

std::int64_t JsonReader::whole(std::int64_t least, std::int64_t largest, const std::string& what) const {
  const double size = number(what);
  if (size != std::floor(size)) refuse("is not a whole number", what);
  const auto whole = value_->signed_whole();
  if (!whole || *whole < least || *whole > largest) refuse("is outside the range", what);
  return *whole;
}

std::uint64_t JsonReader::unsigned_whole(const std::string& what) const {
  if (!value_->number()) refuse_kind(what);
  const auto whole = value_->unsigned_whole();
  if (!whole) refuse("is no whole number >= 0", what);
  return *whole;
}

Rational JsonReader::rational(const std::string& what) const {
  if (const auto number = value_->number()) {
    if (const auto whole = value_->signed_whole(); whole && std::abs(*number) <= 9007199254740992.0)
      return Rational(*whole);
    return Rational::exactly(*number);
  }
  if (value_->string() == nullptr) refuse_kind(what);
  auto parsed = Rational::parse(*value_->string());
  if (!parsed) refuse("is not a number: " + without_quotes(parsed.reason()), what);
  return std::move(parsed).value();
}

const std::string& JsonReader::word(std::span<const std::string> available,
                                    std::span<const std::string> planned) const {
  const std::string& text = string("one of " + listed(available));
  const auto among = [&](std::span<const std::string> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
  };
  if (among(available)) return text;
  if (among(planned)) refuse("is not available in this version", listed(available));
  refuse(with_nearest_word("is unknown", text, available), listed(available));
}

}  // namespace radcert
