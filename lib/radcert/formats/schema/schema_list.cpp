// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view list_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "What radcert list prints",
  "type": "object",
  "required": ["schema", "radcert", "command", "list", "entries"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/list/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "list": {"enum": ["surfaces", "bases", "claims", "references"]},
    "entries": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "summary", "parameters"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "summary": {"type": "string"},
          "parameters": {
            "type": "array",
            "items": {
              "type": "object",
              "required": ["name", "allowed", "default"],
              "additionalProperties": false,
              "properties": {
                "name": {"type": "string"},
                "allowed": {"type": "string"},
                "default": {"description": "null: there is none.", "type": ["string", "null"]}
              }
            }
          }
        }
      }
    }
  }
}
)json";
}

}  // namespace radcert
