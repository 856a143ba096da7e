// SPDX-License-Identifier: GPL-3.0-or-later

// radcert schema NAME: the JSON Schema of a file type.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "output.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/schema/schemas.h"

namespace radcert::app {

namespace {

ExitCode print_schema(const Common& common, const std::string& name) {
  const std::vector<std::string> names = schema_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError({.source = "schema",
                      .value = name,
                      .problem = with_nearest_word("is no file type", name, names),
                      .allowed = listed(names)});
  }
  const std::string text = schema_text(name);
  print_result(common, text, text);
  return ExitCode::done;
}

}  // namespace

void add_schema(Program& program) {
  Subcommand command = program.add("schema", "The JSON Schema of a file type");
  auto name = std::make_shared<std::string>();
  command.word("NAME", *name, listed(schema_names()));
  command.runs([&common = program.common(), name] { return print_schema(common, *name); });
}

}  // namespace radcert::app
