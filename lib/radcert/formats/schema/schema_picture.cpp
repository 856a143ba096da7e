// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view picture_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "What radcert picture says of a picture",
  "type": "object",
  "required": ["schema", "radcert", "command", "picture", "shows", "file", "width", "height", "facts"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/picture/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "picture": {"description": "Its name.", "type": "string"},
    "shows": {"description": "What is to be seen; the file has it as its description.", "type": "string"},
    "file": {"description": "The PNG file.", "type": "string"},
    "width": {"description": "Pixels.", "type": "integer", "minimum": 1},
    "height": {"description": "Pixels.", "type": "integer", "minimum": 1},
    "facts": {
      "description": "What it was made with, and what the rays found.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "value"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "value": {"type": ["string", "number"]}
        }
      }
    }
  }
}
)json";
}

}  // namespace radcert
