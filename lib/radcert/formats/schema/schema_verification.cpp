// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view verification_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "A report of radcert verify",
  "description": "Seconds live in timing alone: apart from timing and command, all is the same to the bit on every run. A number with a point or an exponent means the nearest double, and radii hold for those doubles.",
  "type": "object",
  "required": ["schema", "radcert", "command", "budget", "as_recorded", "claims", "problems", "timing"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/verification/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "budget": {"enum": ["quick", "standard", "full"]},
    "as_recorded": {"description": "Every verdict is the recorded one.", "type": "boolean"},
    "claims": {
      "description": "A statement or a cell of a table each, in the order of claims.toml.",
      "type": "array",
      "items": {"$ref": "#/$defs/claim"}
    },
    "problems": {
      "description": "What was solved for the claims: errors level by level. A claim names its problems by their place here, from 0.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["name", "problem", "levels", "orders"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "problem": {"description": "A problem file.", "type": "string"},
          "levels": {"description": "As in a result of solve: radcert schema solution.", "type": "array", "items": {"type": "object"}},
          "orders": {
            "description": "Of log error over log h, least squares; halfwidth is the spread of the slopes, no guarantee.",
            "type": "array",
            "items": {
              "type": "object",
              "required": ["quantity", "order", "halfwidth", "levels"],
              "additionalProperties": false,
              "properties": {
                "quantity": {"type": "string"},
                "order": {"type": ["number", "null"]},
                "halfwidth": {"type": ["number", "null"]},
                "levels": {"description": "Those that took part.", "type": "array", "items": {"type": "integer"}}
              }
            }
          }
        }
      }
    },
    "timing": {
      "type": "object",
      "required": ["total_seconds", "claims"],
      "additionalProperties": false,
      "properties": {
        "total_seconds": {"type": "number", "minimum": 0},
        "claims": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["paper", "label", "seconds"],
            "additionalProperties": false,
            "properties": {
              "paper": {"type": "string"},
              "label": {"type": "string"},
              "seconds": {"type": "number", "minimum": 0}
            }
          }
        }
      }
    }
  },
  "$defs": {
    "verdict": {
      "enum": [
        "certified", "reproduced", "supported", "contradicted", "undecided", "definition", "unchecked", "failed"
      ]
    },
    "claim": {
      "type": "object",
      "required": [
        "paper", "label", "says", "covers", "page", "needs", "verdict", "recorded", "as_recorded", "printed", "ours",
        "note", "failure", "evidence", "remarks", "formula", "met", "unchecked", "erratum", "problems"
      ],
      "additionalProperties": false,
      "properties": {
        "paper": {"type": "string"},
        "label": {"type": "string"},
        "says": {"type": "string"},
        "covers": {"description": "Numbered equations.", "type": "array", "items": {"type": "integer"}},
        "page": {"type": ["integer", "null"]},
        "needs": {"type": "array", "items": {"type": "string"}},
        "verdict": {"$ref": "#/$defs/verdict"},
        "recorded": {"$ref": "#/$defs/verdict"},
        "as_recorded": {"type": "boolean"},
        "printed": {"description": "The text of a printed cell.", "type": ["string", "null"]},
        "ours": {
          "oneOf": [
            {"type": "null"},
            {
              "type": "object",
              "required": ["value", "radius", "guaranteed"],
              "additionalProperties": false,
              "properties": {
                "value": {"type": "number"},
                "radius": {"type": "number", "minimum": 0},
                "guaranteed": {"description": "true: the radius is proved; false: an estimate.", "type": "boolean"}
              }
            }
          ]
        },
        "note": {"type": "string"},
        "failure": {"description": "What a check threw.", "type": ["string", "null"]},
        "evidence": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["what", "value", "radius", "allowed", "standing", "control", "proved"],
            "additionalProperties": false,
            "properties": {
              "what": {"type": "string"},
              "value": {"type": "string"},
              "radius": {"type": ["string", "null"]},
              "allowed": {"type": "string"},
              "standing": {"enum": ["holds", "violated", "open"]},
              "control": {"description": "An observation that the statement must reject.", "type": "boolean"},
              "proved": {"type": "boolean"}
            }
          }
        },
        "remarks": {"type": "array", "items": {"type": "string"}},
        "formula": {"description": "The statement in TeX; may be empty.", "type": "string"},
        "met": {
          "description": "How each of `needs` is met where it was checked, in the same order; or empty.",
          "type": "array",
          "items": {"type": "string"}
        },
        "unchecked": {"description": "What the evidence does not reach; empty: nothing is said.", "type": "string"},
        "erratum": {"description": "The place of its line in the paper's errata; empty: none.", "type": "string"},
        "problems": {"description": "Places in `problems`.", "type": "array", "items": {"type": "integer", "minimum": 0}}
      }
    }
  }
}
)json";
}

}  // namespace radcert
