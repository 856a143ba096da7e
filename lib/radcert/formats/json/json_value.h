// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "radcert/scalar/approximation.h"

namespace radcert {

/// A JSON value whose objects keep the order of their keys.
/// Source    RFC 8259
/// Requires  a number is finite, else ContractViolation; a key is set once
/// Result    plain data; whole numbers of 64 bits are kept exactly, all others are doubles
/// Limits    looking up a key is linear in their number
class JsonValue {
public:
  struct Null {};
  using Array = std::vector<JsonValue>;
  struct Member;
  using Object = std::vector<Member>;

  JsonValue() = default;
  JsonValue(bool value);
  template <std::integral Integer>
    requires(!std::same_as<Integer, bool>)
  JsonValue(Integer value);
  JsonValue(double value);
  JsonValue(std::string value);
  JsonValue(std::string_view value);
  JsonValue(const char* value);
  template <class T>
  JsonValue(const std::optional<T>& value);
  [[nodiscard]] static JsonValue array();
  [[nodiscard]] static JsonValue array(Array elements);
  [[nodiscard]] static JsonValue object();
  [[nodiscard]] static JsonValue object(Object members);

  [[nodiscard]] bool is_null() const { return std::holds_alternative<Null>(content_); }
  [[nodiscard]] const bool* boolean() const { return std::get_if<bool>(&content_); }
  [[nodiscard]] const std::string* string() const { return std::get_if<std::string>(&content_); }
  [[nodiscard]] const Array* elements() const { return std::get_if<Array>(&content_); }
  [[nodiscard]] const Object* members() const { return std::get_if<Object>(&content_); }
  /// The nearest double of a number.
  [[nodiscard]] std::optional<double> number() const;
  /// A number that is whole and fits.
  [[nodiscard]] std::optional<std::int64_t> signed_whole() const;
  [[nodiscard]] std::optional<std::uint64_t> unsigned_whole() const;
  /// The value of a key of an object, or null.
  [[nodiscard]] const JsonValue* find(std::string_view key) const;

  /// Appends to an array.
  void push(JsonValue element);
  /// Appends a key to an object.
  void set(std::string key, JsonValue value);

  /// "an object", "a string", ...
  [[nodiscard]] std::string kind() const;
  /// On one line, doubles in their shortest exact form, bytes that are not UTF-8 replaced.
  [[nodiscard]] std::string compact() const;
  /// Indented, what fits on a line kept on it.
  [[nodiscard]] std::string pretty() const;
  /// The same after a text whose last line has that indentation.
  void append_pretty(std::string& out, std::size_t indent) const;

private:
  using Content = std::variant<Null, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object>;
  template <std::integral Integer>
  static Content whole(Integer value);
  void write_compact(std::string& out) const;

  Content content_;
};

/// A key of an object with its value.
struct JsonValue::Member {
  std::string key;
  JsonValue value;
};

inline JsonValue::JsonValue(bool value) : content_(value) {}
template <std::integral Integer>
  requires(!std::same_as<Integer, bool>)
JsonValue::JsonValue(Integer value) : content_(whole(value)) {}
inline JsonValue::JsonValue(std::string value) : content_(std::move(value)) {}
inline JsonValue::JsonValue(std::string_view value) : content_(std::string(value)) {}
inline JsonValue::JsonValue(const char* value) : content_(std::string(value)) {}
template <class T>
JsonValue::JsonValue(const std::optional<T>& value) : JsonValue(value ? JsonValue(*value) : JsonValue()) {}
inline JsonValue JsonValue::array() { return array(Array{}); }
inline JsonValue JsonValue::object() { return object(Object{}); }

template <std::integral Integer>
JsonValue::Content JsonValue::whole(Integer value) {
  if constexpr (std::signed_integral<Integer>)
    return static_cast<std::int64_t>(value);
  else
    return static_cast<std::uint64_t>(value);
}

/// A number that JSON has: null for none, and for one that is not finite.
[[nodiscard]] JsonValue finite_or_null(const std::optional<double>& value);

/// A number with its radius, as every file has it: value, radius, guaranteed.
/// Requires  a finite value, else ContractViolation
/// Result    a radius that is not known is null; null for none
[[nodiscard]] JsonValue approximation_json(const std::optional<Approximation>& number);

/// A list as a JSON array, each element by `make`.
template <class List, class Make>
[[nodiscard]] JsonValue json_array(const List& list, const Make& make) {
  JsonValue out = JsonValue::array();
  for (const auto& element : list) out.push(make(element));
  return out;
}

/// A list of what JSON has: texts, numbers.
template <class List>
[[nodiscard]] JsonValue json_array(const List& list) {
  return json_array(list, [](const auto& element) { return JsonValue(element); });
}

}  // namespace radcert
