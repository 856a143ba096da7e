// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schemas.h"

#include <array>

#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::span<const Schema> schemas() {
  static const std::array<Schema, 15> all = {
      Schema{"problem", "what radcert solve reads: a surface, a basis, the data, the levels",
             problem_schema()},
      Schema{"solution", "what radcert solve writes: errors, ratios and orders, level by level",
             solution_schema()},
      Schema{"experiment", "what radcert experiment reads: parts that problems share and lists of others",
             experiment_schema()},
      Schema{"experiment_result", "what radcert experiment writes: the combinations, compared at equal cost",
             experiment_result_schema()},
      Schema{"verification", "what radcert verify writes: verdicts and their evidence",
             verification_schema()},
      Schema{"provenance", "what solve, experiment and verify write with --out: how the files were made",
             provenance_schema()},
      Schema{"reference", "what radcert reference writes: a number with its radius, proved or estimated",
             reference_schema()},
      Schema{"references", "what radcert reference writes for more than one --at", references_schema()},
      Schema{"manifest", "what radcert reference --all writes beside the values", manifest_schema()},
      Schema{"surface", "what radcert surface writes with --json: pieces, defects, certificate",
             surface_schema()},
      Schema{"factors", "what radcert factors writes with --json: configuration factors with radii",
             factors_schema()},
      Schema{"nodes", "a file of nodes on a triangle: a basis of a user's own", nodes_schema()},
      Schema{"basis", "what radcert basis writes with --json", basis_schema()},
      Schema{"picture", "what radcert picture writes with --json: what is seen, and what it was made with",
             picture_schema()},
      Schema{"list", "what radcert list writes with --json", list_schema()}};
  return all;
}

const Schema* find_schema(std::string_view name) {
  for (const Schema& schema : schemas())
    if (schema.name == name) return &schema;
  return nullptr;
}

}  // namespace radcert
