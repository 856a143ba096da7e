// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/json/json_value.h"
#include "radcert/scalar/rational.h"

namespace radcert {

/// A place in a JSON document that is read with an expectation.
/// Requires  the document outlives the reader
/// Result    what was asked for; otherwise InputError with the JSON pointer, what stands there and what is
///           allowed
/// Limits    the error names no source: see with_source
class JsonReader {
public:
  explicit JsonReader(const JsonValue& document) : JsonReader(document, "") {}

  [[nodiscard]] const JsonValue& value() const { return *value_; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

  /// Requires an object that has no other keys than these.
  void require_object(std::span<const std::string> allowed_keys) const;
  void require_object(std::initializer_list<std::string_view> allowed_keys) const;
  /// Requires an object whose key `schema` has that word; `what` says what the object is.
  void require_schema(const std::string& schema, const std::string& what) const;
  /// The keys of an object and their values; `what` says what belongs there.
  [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members(const std::string& what) const;
  /// The value of a key; `what` says what belongs there if it is missing.
  [[nodiscard]] JsonReader at(std::string_view key, const std::string& what) const;
  /// The value of a key, if it is there.
  [[nodiscard]] std::optional<JsonReader> find(std::string_view key) const;
  /// The elements of an array; `what` says what belongs there.
  [[nodiscard]] std::vector<JsonReader> elements(const std::string& what) const;
  [[nodiscard]] const std::string& string(const std::string& what) const;
  [[nodiscard]] double number(const std::string& what) const;
  [[nodiscard]] bool boolean(const std::string& what) const;
  [[nodiscard]] std::int64_t whole(std::int64_t least, std::int64_t largest, const std::string& what) const;
  [[nodiscard]] std::uint64_t unsigned_whole(const std::string& what) const;
  /// A decimal or a fraction in a string, exactly; or a number, which means the nearest double.
  [[nodiscard]] Rational rational(const std::string& what) const;
  /// One of several words; `planned` are words of the format that this version cannot serve, and says so.
  [[nodiscard]] const std::string& word(std::span<const std::string> available,
                                        std::span<const std::string> planned = {}) const;

  [[noreturn]] void refuse(const std::string& problem, const std::string& allowed) const;

private:
  JsonReader(const JsonValue& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}
  [[noreturn]] void refuse_kind(const std::string& what) const;

  const JsonValue* value_;
  std::string pointer_;
};

/// A reason from elsewhere as part of a message, which is quoted as a whole where it has quotes of its own.
/// Requires  nothing
/// Result    double quotes have become single ones, backslashes are left out
[[nodiscard]] std::string without_quotes(std::string reason);

/// The word of a list that is nearest to a misspelt one.
/// Maths     least edit distance (insertions, deletions, substitutions, exchanges of neighbours), at most a
///           third of the longer word
/// Source    Damerau and Levenshtein, optimal string alignment
/// Requires  nothing
/// Result    the first nearest word, or none that is near enough
/// Limits    counts bytes
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      std::span<const std::string> words);

/// A problem with a word that is none of a list, and what somebody may have meant.
/// Requires  nothing
/// Result    "<problem>; did you mean <nearest_word>?", or the problem alone where no word is near enough
[[nodiscard]] std::string with_nearest_word(const std::string& problem, std::string_view word,
                                            std::span<const std::string> words);

}  // namespace radcert
