// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schemas.h"

#include <array>

#include "radcert/formats/schema_texts.h"

namespace radcert {

std::span<const Schema> schemas() {
  static const std::array<Schema, 4> all = {
      Schema{"problem", "what radcert solve reads: a surface, a basis, the data, the levels",
             problem_schema()},
      Schema{"solution", "what radcert solve writes: errors, ratios and orders, level by level",
             solution_schema()},
      Schema{"verification", "what radcert verify writes: verdicts and their evidence",
             verification_schema()},
      Schema{"list", "what radcert list writes with --json", list_schema()}};
  return all;
}

const Schema* find_schema(std::string_view name) {
  for (const Schema& schema : schemas())
    if (schema.name == name) return &schema;
  return nullptr;
}

}  // namespace radcert
