// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/json/json_document.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/json_pointer.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_reader.h"

namespace radcert {

namespace {

/// Builds a JsonValue from the parser's events; the parser itself never recurses.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
  explicit Builder(std::string_view text) : text_(text) {}

  bool null() override { return add({}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& text) override {
    if (value == 0 && text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != string_t::npos)
      throw InputError({.pointer = pointer(),
                        .value = text,
                        .problem = "is nearer to zero than every double",
                        .allowed = "0, or numbers from 5e-324 on; in a string a number is exact"});
    return add(value);
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(true); }
  bool start_array(std::size_t /*size*/) override { return open(false); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    open_.back().key = std::move(key);
    if (!open_.back().keys.insert(open_.back().key).second)
      throw InputError({.pointer = pointer(), .problem = "occurs twice", .allowed = "each key once"});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last,
                   const nlohmann::json::exception& error) override {
    if (dynamic_cast<const nlohmann::json::out_of_range*>(&error) != nullptr)
      throw InputError({.pointer = pointer(),
                        .value = last,
                        .problem = "is too large for a double",
                        .allowed = "numbers of at most 1.7e308"});
    throw InputError({.problem = "is not JSON: " + place(position) + ": " + reason(error.what()),
                      .allowed = "JSON in UTF-8"});
  }

  JsonValue take() { return std::move(root_); }

private:
  /// An object or array that has not ended; `keys` are those that have come, `key` the last of them.
  struct Open {
    bool is_object = false;
    JsonValue::Object members{};
    JsonValue::Array elements{};
    std::string key{};
    std::unordered_set<std::string> keys{};
  };

  /// What follows the parser's own account of the place, up to the bytes that it repeats.
  static std::string reason(std::string text) {
    if (const std::size_t begin = text.find(": "); begin != std::string::npos) text.erase(0, begin + 2);
    if (const std::size_t end = text.find("; last read"); end != std::string::npos) text.erase(end);
    return without_quotes(std::move(text));
  }

  bool add(JsonValue value) {
    if (open_.empty())
      root_ = std::move(value);
    else if (open_.back().is_object)
      open_.back().members.push_back({open_.back().key, std::move(value)});
    else
      open_.back().elements.push_back(std::move(value));
    return true;
  }

  bool open(bool is_object) {
    if (open_.size() >= json_depth_limit)
      throw InputError({.pointer = pointer(),
                        .problem = "is nested too deeply",
                        .allowed = "at most " + std::to_string(json_depth_limit) +
                                   " arrays and objects inside one another"});
    open_.push_back({.is_object = is_object});
    return true;
  }

  bool close() {
    Open ended = std::move(open_.back());
    open_.pop_back();
    return add(ended.is_object ? JsonValue::object(std::move(ended.members))
                               : JsonValue::array(std::move(ended.elements)));
  }

  std::string pointer() const {
    std::string out;
    for (const Open& level : open_)
      out = level.is_object ? pointer_below(out, level.key) : pointer_below(out, level.elements.size());
    return out;
  }

  /// The parser counts the bytes that it has read, the offending one included.
  std::string place(std::size_t position) const {
    const std::string_view before = text_.substr(0, position == 0 ? 0 : std::min(position - 1, text_.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column =
        newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    return "line " + std::to_string(line) + ", column " + std::to_string(column) + " (byte " +
           std::to_string(before.size() + 1) + ")";
  }

  std::string_view text_;
  std::vector<Open> open_;
  JsonValue root_;
};

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& source) {
  return with_source(source, [&] {
    if (text.empty()) throw InputError({.problem = "is empty", .allowed = "JSON in UTF-8"});
    if (text.size() > json_size_limit)
      throw InputError({.value = std::to_string(text.size()) + " bytes",
                        .problem = "is too long",
                        .allowed = "at most " + std::to_string(json_size_limit) + " bytes"});
    Builder builder(text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
  });
}

JsonValue read_json(const std::filesystem::path& path) {
  return parse_json(with_source(path.string(), [&] { return read_file(path, json_size_limit); }),
                    path.string());
}

std::string as_utf8(std::string_view text) {
  constexpr std::size_t longest = 4;
  std::string out;
  while (!text.empty()) {
    std::size_t length = 1;
    while (length <= longest && !is_utf8(text.substr(0, length))) ++length;
    if (length > longest) {
      out += "\xEF\xBF\xBD";
      length = 1;
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::min(length, text.size()));
  }
  return out;
}

JsonValue document_head(const std::string& type, const std::string& command) {
  return JsonValue::object(
      {{"schema", "radcert/" + type + "/1"}, {"radcert", version()}, {"command", command}});
}

}  // namespace radcert
