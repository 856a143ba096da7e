// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schemas.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/schema/catalogue_json.h"
#include "radcert/formats/schema/embedded_schemas.h"

namespace radcert {

namespace {

constexpr std::string_view ending = ".json";

/// A value of another schema by its name and a pointer without escapes: "problem#/properties/surface".
JsonValue part_of_schema(std::string_view place) {
  const std::size_t mark = place.find('#');
  const JsonValue schema = parse_json(schema_text(place.substr(0, mark)), std::string(place));
  const JsonValue* part = &schema;
  for (std::string_view rest = place.substr(mark + 1); !rest.empty();) {
    const std::string_view key = rest.substr(1, rest.find('/', 1) - 1);
    part = part->find(key);
    expects(part != nullptr, "a part of a schema", named("place", std::string(place)));
    rest.remove_prefix(1 + key.size());
  }
  return *part;
}

/// The text with a value in place of every gap: the beginning, a name, a quote and a brace.
std::string filled(std::string_view text, std::string_view beginning, JsonValue (*value)(std::string_view)) {
  std::string out;
  for (std::size_t gap = text.find(beginning); gap != std::string_view::npos; gap = text.find(beginning)) {
    out += text.substr(0, gap);
    text.remove_prefix(gap + beginning.size());
    const std::size_t end = text.find('"');
    const std::size_t line = out.rfind('\n') + 1;
    value(text.substr(0, end)).append_pretty(out, out.find_first_not_of(' ', line) - line);
    text.remove_prefix(end + 2);
  }
  return out += text;
}

}  // namespace

std::vector<std::string> schema_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_schemas())
    names.emplace_back(file.path.substr(0, file.path.size() - ending.size()));
  return names;
}

std::string schema_text(std::string_view name) {
  const auto files = embedded_schemas();
  const auto file = std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& f) {
    return f.path == std::string(name) + std::string(ending);
  });
  expects(file != files.end(), "the name of a schema", named("name", std::string(name)));
  return filled(filled(file->content, R"({"$catalogue": ")", catalogue_json), R"({"$part": ")",
                part_of_schema);
}

}  // namespace radcert
