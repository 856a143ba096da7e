// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view factors_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "What radcert factors writes with --json",
  "description": "Area-to-area configuration factors of plane triangles, or of unions of them. A number with a point or an exponent means the nearest double, and radii and bounds hold for those doubles.",
  "type": "object",
  "required": [
    "schema", "radcert", "command", "name", "by", "triangles", "open", "facets_only", "guaranteed", "pairs", "largest_radius",
    "reciprocity_defect", "closure_defect", "surfaces", "factors", "warnings", "comparison"
  ],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/factors/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "name": {"type": "string"},
    "by": {"description": "What a row stands for.", "enum": ["triangle", "piece", "group"]},
    "triangles": {"$ref": "#/$defs/count"},
    "open": {"description": "Whether light can leave: then to_space is what reaches no front of a surface.", "type": "boolean"},
    "facets_only": {
      "description": "A piece has triangles of several planes: the factors are those of the facets, not of what they may stand for.",
      "type": "boolean"
    },
    "guaranteed": {"description": "Whether every radius is proved, or estimated.", "type": "boolean"},
    "pairs": {
      "description": "Pairs of triangles that face each other: seen wholly, hidden wholly, or not decided to be either.",
      "type": "object",
      "required": ["whole", "hidden", "mixed"],
      "additionalProperties": false,
      "properties": {
        "whole": {"$ref": "#/$defs/count"},
        "hidden": {"$ref": "#/$defs/count"},
        "mixed": {"$ref": "#/$defs/count"}
      }
    },
    "largest_radius": {"$ref": "#/$defs/radius"},
    "reciprocity_defect": {"description": "Bounds |A_i F_ij - A_j F_ji| / sqrt(A_i A_j) of the doubles given here.", "$ref": "#/$defs/radius"},
    "closure_defect": {"description": "Bounds |row_sum - 1| of the doubles given here; null: open.", "type": ["number", "null"], "minimum": 0},
    "surfaces": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "area", "row_sum", "row_radius", "to_space"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "area": {"type": "number", "exclusiveMinimum": 0},
          "row_sum": {"type": "number"},
          "row_radius": {"$ref": "#/$defs/radius"},
          "to_space": {"type": ["number", "null"]},
          "area_radius": {"description": "Bounds the distance of area from the area of the triangles, proved.", "$ref": "#/$defs/radius"},
          "to_space_radius": {"type": ["number", "null"], "minimum": 0}
        }
      }
    },
    "factors": {
      "description": "Those that are not exactly zero.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["from", "to", "factor", "radius", "guaranteed"],
        "additionalProperties": false,
        "properties": {
          "from": {"type": "string"},
          "to": {"type": "string"},
          "factor": {"type": "number"},
          "radius": {"$ref": "#/$defs/radius"},
          "guaranteed": {"type": "boolean"}
        }
      }
    },
    "warnings": {"type": "array", "items": {"type": "string"}},
    "comparison": {
      "description": "Against --compare; null: not asked for.",
      "type": ["object", "null"],
      "required": ["agrees", "differs", "undecided", "worst"],
      "additionalProperties": false,
      "properties": {
        "agrees": {"$ref": "#/$defs/count"},
        "differs": {"$ref": "#/$defs/count"},
        "undecided": {"$ref": "#/$defs/count"},
        "worst": {
          "description": "The largest differences first, at most 100.",
          "type": "array",
          "maxItems": 100,
          "items": {
            "type": "object",
            "required": ["from", "to", "ours", "radius", "theirs", "halfwidth", "verdict"],
            "additionalProperties": false,
            "properties": {
              "from": {"type": "string"},
              "to": {"type": "string"},
              "ours": {"type": "number"},
              "radius": {"$ref": "#/$defs/radius"},
              "theirs": {"type": "number"},
              "halfwidth": {"$ref": "#/$defs/radius"},
              "verdict": {"enum": ["agrees", "differs", "undecided"]}
            }
          }
        }
      }
    }
  },
  "$defs": {
    "count": {"type": "integer", "minimum": 0},
    "radius": {"type": "number", "minimum": 0}
  }
}
)json";
}

}  // namespace radcert
