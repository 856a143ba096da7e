// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

#include <string>

namespace radcert {

namespace {

// The members of a value's schema, and what they refer to at the document's root.
constexpr std::string_view one_value = R"json(  "type": "object",
  "required": ["schema", "radcert", "command", "name", "parameters", "digits", "midpoint", "radius", "guaranteed", "formula",
    "source", "routes", "precision_bits", "midpoint_binary", "radius_binary", "route_values"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/reference/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "name": {"type": "string", "pattern": "^[a-z0-9_/]+$"},
    "parameters": {
      "description": "Exactly, as whole numbers or fractions, or pi/2.",
      "type": "object",
      "additionalProperties": {"type": "string", "pattern": "^-?([0-9]+(/[0-9]+)?|pi/2)$"}
    },
    "digits": {"description": "The radius is at most 10^-digits.", "type": "integer", "minimum": 1, "maximum": 1000},
    "midpoint": {"$ref": "#/$defs/decimal"},
    "radius": {"$ref": "#/$defs/decimal"},
    "guaranteed": {
      "description": "Whether it is proved that the exact value lies within the radius of the midpoint; else the radius is an estimate.",
      "type": "boolean"
    },
    "formula": {"type": "string"},
    "source": {"type": "string"},
    "routes": {"description": "The first gave the value.", "type": "array", "minItems": 2, "items": {"type": "string"}},
    "precision_bits": {"description": "How many bits of the midpoint are known; null: all.", "type": ["integer", "null"]},
    "midpoint_binary": {"$ref": "#/$defs/binary"},
    "radius_binary": {"$ref": "#/$defs/binary"},
    "route_values": {
      "description": "What each route found; all of them contain the value.",
      "type": "array",
      "minItems": 2,
      "items": {
        "type": "object",
        "required": ["route", "midpoint", "radius"],
        "additionalProperties": false,
        "properties": {
          "route": {"type": "string"},
          "midpoint": {"$ref": "#/$defs/decimal"},
          "radius": {"$ref": "#/$defs/decimal"}
        }
      }
    }
  })json";

constexpr std::string_view definitions = R"json(  "$defs": {
    "decimal": {"type": "string", "pattern": "^-?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?$"},
    "binary": {
      "description": "Exactly mantissa * 2^exponent.",
      "type": "object",
      "required": ["mantissa", "exponent"],
      "additionalProperties": false,
      "properties": {
        "mantissa": {"type": "string", "pattern": "^-?[0-9]+$"},
        "exponent": {"type": "string", "pattern": "^-?[0-9]+$"}
      }
    }
  })json";

}  // namespace

std::string_view reference_schema() {
  static const std::string text = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "A reference value",
  "description": "A number with a radius, by two routes.",
)json" + std::string(one_value) + ",\n" +
                                  std::string(definitions) + "\n}\n";
  return text;
}

std::string_view references_schema() {
  static const std::string text = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Several reference values of one name",
  "type": "object",
  "required": ["schema", "radcert", "command", "values"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/references/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "values": {"type": "array", "minItems": 1, "items": {
)json" + std::string(one_value) + "\n    }}\n  },\n" +
                                  std::string(definitions) + "\n}\n";
  return text;
}

std::string_view manifest_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "The contents of a folder of reference values",
  "type": "object",
  "required": ["schema", "radcert", "command", "digits", "table", "values"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/manifest/1"},
    "radcert": {"description": "The version that wrote the files.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "digits": {"description": "All radii are at most 10^-digits.", "type": "integer", "minimum": 1, "maximum": 1000},
    "table": {"description": "The CSV file that has all values.", "type": "string"},
    "values": {
      "description": "A JSON file a value, see radcert schema reference.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "file"],
        "additionalProperties": false,
        "properties": {"name": {"type": "string"}, "file": {"type": "string"}}
      }
    }
  }
}
)json";
}

}  // namespace radcert
