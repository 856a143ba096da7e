// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/reading/toml_document.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// The most parts of a dotted key but for digits, each of which is a table within the one before.
constexpr int most_dots = 32;

bool is_digit(char c) { return (c >= '0' && c <= '9') || c == '_'; }

/// Whether a dot parts a number from its decimals: digits about it, and no further dot about these.
bool is_decimal_point(std::string_view line, std::size_t dot) {
  std::size_t begin = dot;
  while (begin > 0 && is_digit(line[begin - 1])) --begin;
  std::size_t end = dot + 1;
  while (end < line.size() && is_digit(line[end])) ++end;
  return begin < dot && end > dot + 1 && (begin == 0 || line[begin - 1] != '.') &&
         (end == line.size() || line[end] != '.');
}

/// The tables of a key with very many dots would be read, and taken apart, one on the stack of the other. A
/// key does not go over a line's end, and of two dots of one at most one looks like a decimal point.
void refuse_before_parsing(std::string_view text, const std::string& source) {
  int number = 1;
  // U+FEFD, which is no character: the parser's table of letters has no answer for it.
  constexpr std::string_view unanswered = "\xEF\xBB\xBD";
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    int dots = 0;
    for (std::size_t at = line.find('.'); at != std::string_view::npos; at = line.find('.', at + 1))
      if (!is_decimal_point(line, at)) ++dots;
    if (line.find(unanswered) != std::string_view::npos)
      throw InputError({.source = source + ", line " + std::to_string(number),
                        .problem = "has U+FEFD, which is no character",
                        .allowed = "characters of Unicode"});
    if (dots > most_dots)
      throw InputError({.source = source + ", line " + std::to_string(number),
                        .problem = "has " + std::to_string(dots) + " dots that are no decimal points",
                        .allowed = "at most " + std::to_string(most_dots) + " in a line"});
    begin = end + 1;
  }
}

class Conversion {
public:
  Conversion(TomlDocument& document, const std::string& source) : lines_(document.lines), source_(source) {}

  JsonValue value(const toml::node& node, const std::string& pointer) {
    lines_[pointer] = static_cast<int>(node.source().begin.line);
    const Depth here(*this, pointer);
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
  /// How deep the conversion is, while it lives.
  class Depth {
  public:
    Depth(Conversion& conversion, const std::string& pointer) : conversion_(conversion) {
      if (++conversion_.depth_ > json_depth_limit)
        throw InputError(
            {.source = conversion.source_ + ", line " + std::to_string(conversion.lines_[pointer]),
             .problem = "is nested too deeply",
             .allowed =
                 "at most " + std::to_string(json_depth_limit) + " arrays and tables inside one another"});
    }
    ~Depth() { --conversion_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

  private:
    Conversion& conversion_;
  };

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
  std::size_t depth_ = 0;
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
  refuse_before_parsing(text, source);
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
