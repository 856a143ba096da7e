// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {

namespace {

constexpr std::size_t line_width = 110;

std::string string_literal(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class Whole>
std::optional<Whole> whole_of_double(double value) {
  // 2^53: beyond it neighbouring whole numbers share a double.
  if (value != std::floor(value) || std::abs(value) > 9007199254740992.0) return std::nullopt;
  if (std::unsigned_integral<Whole> && value < 0) return std::nullopt;
  return static_cast<Whole>(value);
}

}  // namespace

JsonValue::JsonValue(double value) : content_(value) {
  expects(std::isfinite(value), "a JSON number is finite", named("value", value));
}

JsonValue JsonValue::array(Array elements) {
  JsonValue out;
  out.content_ = std::move(elements);
  return out;
}

JsonValue JsonValue::object(Object members) {
  JsonValue out;
  out.content_ = std::move(members);
  return out;
}

std::optional<double> JsonValue::number() const {
  if (const auto* value = std::get_if<double>(&content_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&content_)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&content_)) return static_cast<double>(*value);
  return std::nullopt;
}

std::optional<std::int64_t> JsonValue::signed_whole() const {
  if (const auto* value = std::get_if<double>(&content_)) return whole_of_double<std::int64_t>(*value);
  if (const auto* value = std::get_if<std::int64_t>(&content_)) return *value;
  if (const auto* value = std::get_if<std::uint64_t>(&content_); value != nullptr && *value <= INT64_MAX)
    return static_cast<std::int64_t>(*value);
  return std::nullopt;
}

std::optional<std::uint64_t> JsonValue::unsigned_whole() const {
  if (const auto* value = std::get_if<double>(&content_)) return whole_of_double<std::uint64_t>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&content_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&content_); value != nullptr && *value >= 0)
    return static_cast<std::uint64_t>(*value);
  return std::nullopt;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  const Object* object = members();
  if (object == nullptr) return nullptr;
  const auto place =
      std::find_if(object->begin(), object->end(), [&](const Member& m) { return m.key == key; });
  return place == object->end() ? nullptr : &place->value;
}

void JsonValue::push(JsonValue element) {
  auto* array = std::get_if<Array>(&content_);
  expects(array != nullptr, "only an array takes elements", named("kind", kind()));
  array->push_back(std::move(element));
}

void JsonValue::set(std::string key, JsonValue value) {
  auto* object = std::get_if<Object>(&content_);
  expects(object != nullptr && find(key) == nullptr, "an object takes each key once", named("key", key));
  object->push_back({std::move(key), std::move(value)});
}

std::string JsonValue::kind() const {
  static constexpr const char* names[] = {"null",     "true or false", "a number", "a number",
                                          "a number", "a string",      "an array", "an object"};
  return names[content_.index()];
}

std::string JsonValue::compact() const {
  std::string out;
  write_compact(out);
  return out;
}

std::string JsonValue::pretty() const {
  std::string out;
  append_pretty(out, 0);
  return out;
}

void JsonValue::write_compact(std::string& out) const {
  if (is_null()) out += "null";
  if (const bool* value = boolean()) out += *value ? "true" : "false";
  if (const auto* value = std::get_if<std::int64_t>(&content_)) out += std::to_string(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&content_)) out += std::to_string(*value);
  // "-0" would be read back as a whole number, which has no sign of zero.
  if (const auto* value = std::get_if<double>(&content_))
    out += *value == 0 && std::signbit(*value) ? "-0.0" : shortest(*value);
  if (const std::string* value = string()) out += string_literal(*value);
  if (const Array* array = elements()) {
    std::string_view before = "[";
    for (const JsonValue& element : *array) {
      out += before;
      element.write_compact(out);
      before = ", ";
    }
    out += array->empty() ? "[]" : "]";
  }
  if (const Object* object = members()) {
    std::string_view before = "{";
    for (const auto& [key, value] : *object) {
      out += before;
      out += string_literal(key) + ": ";
      value.write_compact(out);
      before = ", ";
    }
    out += object->empty() ? "{}" : "}";
  }
}

void JsonValue::append_pretty(std::string& out, std::size_t indent) const {
  const std::size_t last_line = out.rfind('\n');
  const std::size_t column = last_line == std::string::npos ? out.size() : out.size() - last_line - 1;
  const std::string line = compact();
  const bool scalar = elements() == nullptr && members() == nullptr;
  if (scalar || column + line.size() <= line_width) {
    out += line;
    return;
  }
  const std::string inner = "\n" + std::string(indent + 2, ' ');
  std::string_view before;
  if (const Array* array = elements()) {
    out += "[";
    for (const JsonValue& element : *array) {
      out += before;
      out += inner;
      element.append_pretty(out, indent + 2);
      before = ",";
    }
  }
  if (const Object* object = members()) {
    out += "{";
    for (const auto& [key, value] : *object) {
      out += before;
      out += inner + string_literal(key) + ": ";
      value.append_pretty(out, indent + 2);
      before = ",";
    }
  }
  out += "\n" + std::string(indent, ' ');
  out += elements() != nullptr ? "]" : "}";
}

JsonValue finite_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? JsonValue(*value) : JsonValue();
}

JsonValue approximation_json(const std::optional<Approximation>& number) {
  if (!number) return {};
  return JsonValue::object({{"value", number->value},
                            {"radius", finite_or_null(number->radius)},
                            {"guaranteed", number->guaranteed}});
}

}  // namespace radcert
