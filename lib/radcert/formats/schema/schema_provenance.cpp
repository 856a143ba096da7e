// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view provenance_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "How the files of a folder were made",
  "description": "No time and no name of a machine: the same run on the same machine gives the same bytes.",
  "type": "object",
  "required": [
    "schema", "radcert", "sources", "command", "inputs", "compiler", "architecture", "libraries", "machine", "seed"
  ],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/provenance/1"},
    "radcert": {"description": "The version that wrote the files.", "type": "string"},
    "sources": {"description": "A digest of the sources that radcert was built from.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "inputs": {
      "description": "The files that were read: those of the command line, then what they name.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "digest"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "digest": {
            "description": "SHA-256 of the bytes.",
            "type": "string",
            "pattern": "^sha256-[0-9a-f]{64}$"
          }
        }
      }
    },
    "compiler": {"type": "string"},
    "architecture": {"description": "What code was generated for, as in -march; empty: the compiler's default.", "type": "string"},
    "libraries": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "version"],
        "additionalProperties": false,
        "properties": {"name": {"type": "string"}, "version": {"type": "string"}}
      }
    },
    "machine": {
      "type": "object",
      "required": ["system", "threads", "cpu_features"],
      "additionalProperties": false,
      "properties": {
        "system": {"type": "string"},
        "threads": {"description": "At most so many; the numbers do not depend on it.", "type": "integer", "minimum": 1},
        "cpu_features": {"type": "array", "items": {"type": "string"}}
      }
    },
    "seed": {"description": "Of random numbers; null: none were drawn.", "type": ["integer", "null"]}
  }
}
)json";
}

}  // namespace radcert
