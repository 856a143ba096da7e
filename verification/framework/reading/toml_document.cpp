// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/reading/toml_document.h"

#include <algorithm>
#include <cmath>
#include <toml++/toml.h>
#include <utility>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"

namespace radcert::verification {
namespace {

bool stands_before(const toml::node& a, const toml::node& b) {
  const toml::source_position& x = a.source().begin;
  const toml::source_position& y = b.source().begin;
  return std::pair(x.line, x.column) < std::pair(y.line, y.column);
}

class Conversion {
public:
  Conversion(TomlDocument& document, const std::string& source) : lines_(document.lines), source_(source) {}

  JsonValue value(const toml::node& node, const std::string& pointer) {
    lines_[pointer] = static_cast<int>(node.source().begin.line);
    if (const auto* table = node.as_table()) return object(*table, pointer);
    if (const auto* array = node.as_array()) {
      JsonValue out = JsonValue::array();
      std::size_t place = 0;
      for (const toml::node& element : *array) out.push(value(element, pointer_below(pointer, place++)));
      return out;
    }
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* number = node.as_floating_point(); number != nullptr && std::isfinite(number->get()))
      return number->get();
    throw InputError({.source = source_ + ", line " + std::to_string(lines_[pointer]),
                      .pointer = pointer,
                      .problem = node.is_floating_point() ? "is not finite" : "is a date or time",
                      .allowed = "texts, finite numbers, true and false, arrays and tables"});
  }

private:
  JsonValue object(const toml::table& table, const std::string& pointer) {
    std::vector<std::pair<std::string, const toml::node*>> members;
    for (const auto& [key, node] : table) members.emplace_back(key.str(), &node);
    std::stable_sort(members.begin(), members.end(),
                     [](const auto& a, const auto& b) { return stands_before(*a.second, *b.second); });
    JsonValue out = JsonValue::object();
    for (const auto& [key, node] : members) out.set(key, value(*node, pointer_below(pointer, key)));
    return out;
  }

  std::map<std::string, int>& lines_;
  const std::string& source_;
};

}  // namespace

int TomlDocument::line_of(std::string pointer) const {
  for (;;) {
    if (const auto found = lines.find(pointer); found != lines.end()) return found->second;
    if (pointer.empty()) return 1;
    pointer.erase(pointer.rfind('/'));
  }
}

TomlDocument parse_toml(std::string_view text, const std::string& source) {
  try {
    TomlDocument document;
    document.value = Conversion(document, source).value(toml::parse(text, source), "");
    return document;
  } catch (const toml::parse_error& error) {
    throw InputError({.source = source + ", line " + std::to_string(error.source().begin.line) + ", column " +
                                std::to_string(error.source().begin.column),
                      .problem = std::string(error.description()),
                      .allowed = "TOML 1.0"});
  }
}

}  // namespace radcert::verification
